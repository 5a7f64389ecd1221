//! A document as Markdown.

use std::fmt::Write as _;

use super::cell::{Cell, Piece};
use super::{Block, Document, visible};

pub(super) fn render(document: &Document) -> String {
    let mut out = format!("**{}**\n\n# {}\n", document.banner, escaped(&document.title));
    for section in &document.sections {
        let _ = write!(out, "\n## {}\n", escaped(section.title));
        for block in &section.blocks {
            match block {
                Block::Text(text) => {
                    let _ = write!(out, "\n{}\n", escaped(text));
                }
                Block::Commands(text) => {
                    // The fence that ends them stands on a line of its own.
                    let end = if text.ends_with('\n') { "" } else { "\n" };
                    let _ = write!(out, "\n```\n{}{end}```\n", text.replace("```", "` ` `"));
                }
                Block::Lineage(lineage) => {
                    out.push('\n');
                    for (what, lines) in lineage.words() {
                        let _ = writeln!(out, "* {what}");
                        for line in lines {
                            let _ = writeln!(out, "  * {}", escaped(&line));
                        }
                    }
                }
                Block::Timeline(timeline) => {
                    out.push('\n');
                    for line in timeline.words() {
                        let _ = writeln!(out, "* {}", escaped(&line));
                    }
                }
                Block::Table { head, rows } => {
                    let _ = write!(out, "\n| {} |\n|{}\n", head.join(" | "), "---|".repeat(head.len()));
                    for row in rows {
                        let cells: Vec<String> = row.iter().map(written).collect();
                        let _ = writeln!(out, "| {} |", cells.join(" | "));
                    }
                }
            }
        }
    }
    let _ = write!(out, "\n**{}**\n", document.banner);
    out
}

fn written(cell: &Cell) -> String {
    let place = cell.place_of.map(|n| format!("<a id=\"record-{n}\"></a>")).unwrap_or_default();
    let pieces = cell.pieces().into_iter().map(|piece| match piece {
        Piece::Words(words) => escaped(&words),
        Piece::Record(n) => format!("[{n}](#record-{n})"),
    });
    std::iter::once(place).chain(pieces).collect()
}

/// What Markdown would read as its own, and HTML that it would pass on.
fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in visible(text).chars() {
        match c {
            '<' => out.push_str("&lt;"),
            '&' => out.push_str("&amp;"),
            '\\' | '`' | '*' | '_' | '|' | '[' | ']' | '#' => out.extend(['\\', c]),
            _ => out.push(c),
        }
    }
    out
}
