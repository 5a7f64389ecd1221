//! A document as one HTML page that needs nothing else.

use std::fmt::Write as _;

use super::cell::{Cell, Piece};
use super::{Block, Document, picture, timeline_picture, visible};

const STYLE: &str = "\
:root{color-scheme:light dark;--ink:#111;--paper:#fff;--line:#999;--head:#eee;--soft:#f4f4f4}\
@media (prefers-color-scheme:dark){:root{--ink:#eee;--paper:#151515;--line:#777;--head:#2b2b2b;--soft:#202020}}\
@media print{:root{color-scheme:light;--ink:#000;--paper:#fff;--line:#777;--head:#eee;--soft:#f4f4f4}}\
body{font:15px/1.45 system-ui,sans-serif;color:var(--ink);background:var(--paper);max-width:75em;margin:0 auto;padding:3.2em 1.5em}\
.banner{position:fixed;left:0;right:0;text-align:center;font-weight:700;letter-spacing:.06em;background:var(--ink);\
color:var(--paper);padding:.35em;z-index:1}.top{top:0}.bottom{bottom:0}h1{font-size:1.6em}\
h2{font-size:1.15em;border-bottom:1px solid var(--line);margin-top:2em}\
table{border-collapse:collapse;width:100%;font-size:.88em}th,td{border:1px solid var(--line);padding:.3em .5em;text-align:left;\
vertical-align:top;overflow-wrap:anywhere}td.code{overflow-wrap:normal;white-space:nowrap}th{background:var(--head);white-space:nowrap}\
pre{background:var(--soft);padding:1em;font-size:.8em;white-space:pre-wrap;overflow-wrap:anywhere}figcaption{font-size:.88em}\
a{color:inherit}td[id]{scroll-margin-top:3.5em}td:target{outline:3px solid var(--ink)}.wide{overflow-x:auto}td{min-width:4.5em}td.code{min-width:0}\
@media print{body{max-width:none;padding:0}.page{display:table;table-layout:fixed;width:100%}main{display:table-row-group}\
.banner{position:static;background:none;color:#000;padding:.2em}.top{display:table-header-group;break-inside:avoid}\
.bottom{display:table-footer-group;break-inside:avoid}.wide{overflow:visible}tr,figure{break-inside:avoid}h2{break-after:avoid}}";

pub(super) fn render(document: &Document) -> String {
    let banner = escaped(&document.banner);
    let title = escaped(&document.title);
    let mut out = format!(
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'unsafe-inline'\">\n\
         <meta name=\"viewport\" content=\"width=device-width\">\n<title>{title}: {banner}</title>\n\
         <style>{STYLE}{}</style>\n</head>\n<body>\n<div class=\"page\">\n<div class=\"banner top\">{banner}</div>\n<main>\n<h1>{title}</h1>\n",
        [picture::STYLE, timeline_picture::STYLE].concat()
    );
    for section in &document.sections {
        let _ = writeln!(out, "<h2>{}</h2>", escaped(section.title));
        for block in &section.blocks {
            match block {
                Block::Text(text) => {
                    let _ = writeln!(out, "<p>{}</p>", escaped(text));
                }
                Block::Commands(text) => {
                    let _ = writeln!(out, "<pre>{}</pre>", escaped(text));
                }
                Block::Lineage(lineage) => out.push_str(&picture::render(lineage)),
                Block::Timeline(timeline) => out.push_str(&timeline_picture::render(timeline)),
                Block::Table { head, rows } => table(&mut out, head, rows),
            }
        }
    }
    let _ = write!(out, "</main>\n<div class=\"banner bottom\">{banner}</div>\n</div>\n</body>\n</html>\n");
    out
}

fn table(out: &mut String, head: &[&str], rows: &[Vec<Cell>]) {
    out.push_str("<div class=\"wide\"><table>\n<thead><tr>");
    for cell in head {
        let _ = write!(out, "<th>{}</th>", escaped(cell));
    }
    out.push_str("</tr></thead>\n");
    for row in rows {
        out.push_str("<tr>");
        for cell in row {
            let place = cell.place_of.map(|n| format!(" id=\"record-{n}\"")).unwrap_or_default();
            let class = if is_code(&cell.text) { " class=\"code\"" } else { "" };
            let _ = write!(out, "<td{place}{class}>");
            for piece in cell.pieces() {
                let _ = match piece {
                    Piece::Words(words) => write!(out, "{}", escaped(&words)),
                    Piece::Record(n) => write!(out, "<a href=\"#record-{n}\">{n}</a>"),
                };
            }
            out.push_str("</td>");
        }
        out.push_str("</tr>\n");
    }
    out.push_str("</table></div>\n");
}

/// What must not be broken: the code of a finding, a number, a short word.
fn is_code(cell: &str) -> bool {
    let is_short = cell.len() < 20 && cell.bytes().all(|b| b.is_ascii_alphanumeric());
    is_short || cell.len() < 32 && cell.bytes().all(|b| b.is_ascii_uppercase() || b == b'_')
}

pub(super) fn escaped(text: &str) -> String {
    visible(text).replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}
