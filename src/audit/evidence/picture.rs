//! The lineage as inline SVG 1.1: inputs at the left, the run and what worked in it in the middle, outputs at the right.
//!
//! Everything is laid out here, from the number of characters alone, so that the same record gives the same bytes. No colour
//! says anything: the page's own ink and paper are used, in print, in the dark and at high contrast.

use std::fmt::Write as _;

use super::html::escaped;
use super::lineage::{Item, Lineage};

/// Units of the picture; shown at its own size one is a CSS pixel.
pub(super) const WIDTH: f64 = 1060.0;
const MARGIN: f64 = 16.0;
const BOX: f64 = 296.0;
const PAD: f64 = 10.0;
/// Between two boxes of a column.
const GAP: f64 = 12.0;
/// From one line of text to the next.
const NAME_STEP: f64 = 18.0;
pub(super) const LINE_STEP: f64 = 16.0;
const BANNER: f64 = 30.0;
const HEADING: f64 = 24.0;
/// Characters of a name and of a line that fit a box: 13 and 11.5 units high, 0.6 of that wide.
const NAME_CELLS: usize = 35;
const LINE_CELLS: usize = 39;
/// Lines of a name before it is shortened.
const NAME_LINES: usize = 3;

pub(super) const STYLE: &str = "\
.lineage{margin:0}.lineage>div{overflow-x:auto}.lineage>div>svg{display:block;width:100%;min-width:56em;height:auto;\
color:var(--ink)}@media print{.lineage>div{overflow:visible}.lineage>div>svg{min-width:0;max-height:225mm}}\
.lineage text{fill:currentColor;font:11.5px ui-monospace,'DejaVu Sans Mono',Menlo,Consolas,monospace}\
.lineage .n{font-size:13px;font-weight:700}.lineage .m{text-anchor:middle}\
.lineage .h{font:700 14px system-ui,sans-serif}\
.lineage rect,.lineage path{fill:none;stroke:currentColor;stroke-width:1.2}.lineage .run{stroke-width:2.4}\
.lineage .seal{stroke-dasharray:7 4}.lineage .flaw{stroke-width:4}.lineage .tip{fill:currentColor;stroke:none}";

/// A box with its lines broken, and how high that makes it.
struct Laid<'a> {
    item: &'a Item,
    name: Vec<String>,
    lines: Vec<String>,
    height: f64,
}

fn laid(item: &Item) -> Laid<'_> {
    let name = broken(&item.name, NAME_CELLS, NAME_LINES);
    let lines: Vec<String> = item.lines.iter().flat_map(|line| broken(line, LINE_CELLS, 2)).collect();
    let height = 2.0 * PAD + NAME_STEP * name.len() as f64 + LINE_STEP * lines.len() as f64 - 3.0;
    Laid { item, name, lines, height }
}

fn column(items: &[Item]) -> Vec<Laid<'_>> {
    items.iter().map(laid).collect()
}

fn height_of(boxes: &[Laid<'_>]) -> f64 {
    boxes.iter().map(|b| b.height + GAP).sum::<f64>() - if boxes.is_empty() { 0.0 } else { GAP }
}

pub(super) fn render(lineage: &Lineage) -> String {
    let (inputs, outputs) = (column(&lineage.inputs), column(&lineage.outputs));
    let (run, models) = (laid(&lineage.run), column(&lineage.models));
    let not_used = match lineage.not_used.as_slice() {
        [] => Vec::new(),
        names => broken(&format!("not used: {}", names.join(", ")), LINE_CELLS, 6),
    };
    let not_used_height = if not_used.is_empty() { 0.0 } else { LINE_STEP * not_used.len() as f64 + GAP };
    let models_height = if models.is_empty() { 0.0 } else { height_of(&models) + PAD };
    let run_height = run.height + models_height + not_used_height;
    let seal: Vec<String> = lineage.seal.iter().flat_map(|line| broken(line, 138, 2)).collect();
    let body = [height_of(&inputs), run_height, height_of(&outputs)].into_iter().fold(0.0, f64::max);
    let top = BANNER + HEADING + GAP;
    let seal_top = top + body + 2.0 * GAP;
    let frame_bottom = seal_top + LINE_STEP * seal.len() as f64 + PAD;
    let height = frame_bottom + BANNER;
    let columns = [MARGIN + PAD, (WIDTH - BOX) / 2.0, WIDTH - MARGIN - PAD - BOX];

    let mut out = format!(
        "<figure class=\"lineage\">\n<div><svg viewBox=\"0 0 {WIDTH} {height}\" role=\"img\" \
         aria-labelledby=\"lineage-title lineage-words\">\n<title id=\"lineage-title\">Lineage: what was made of what</title>\n\
         <desc id=\"lineage-words\">{}</desc>\n",
        escaped(&in_words(lineage))
    );
    let middle = WIDTH / 2.0;
    text(&mut out, middle, 18.0, "h m", &lineage.banner);
    text(&mut out, middle, height - 10.0, "h m", &lineage.banner);
    rect(&mut out, "seal", [MARGIN, BANNER, WIDTH - 2.0 * MARGIN, frame_bottom - BANNER]);
    for (x, heading) in columns.iter().zip(["Inputs", "Made by", "Outputs"]) {
        text(&mut out, x + BOX / 2.0, BANNER + HEADING, "h m", heading);
    }
    let middle_of = |height: f64| top + (body - height) / 2.0;
    let run_top = middle_of(run_height);
    // The arrows first: what they meet lies over them.
    let sides = [(&inputs, columns[0] + BOX, columns[1], true), (&outputs, columns[1] + BOX, columns[2], false)];
    for (boxes, from, to, into) in sides {
        let mut y = middle_of(height_of(boxes));
        for (i, one) in boxes.iter().enumerate() {
            let of_box = y + one.height / 2.0;
            let of_run = run_top + run_height * (i as f64 + 0.5) / boxes.len() as f64;
            let (y0, y1) = if into { (of_box, of_run) } else { (of_run, of_box) };
            arrow(&mut out, [from, y0], [to, y1]);
            y += one.height + GAP;
        }
    }
    for (boxes, x) in [(&inputs, columns[0]), (&outputs, columns[2])] {
        let mut y = middle_of(height_of(boxes));
        for one in boxes {
            drawn(&mut out, one, [x, y, BOX], if one.item.flawed { "flaw" } else { "" });
            y += one.height + GAP;
        }
        if boxes.is_empty() {
            text(&mut out, x + BOX / 2.0, top + body / 2.0, "m", "none");
        }
    }
    rect(&mut out, "run", [columns[1], run_top, BOX, run_height]);
    words(&mut out, &run, columns[1], run_top);
    let mut y = run_top + run.height;
    for model in &models {
        drawn(&mut out, model, [columns[1] + PAD, y, BOX - 2.0 * PAD], "");
        y += model.height + GAP;
    }
    for (i, line) in not_used.iter().enumerate() {
        let at = run_top + run_height - not_used_height + LINE_STEP * (i as f64 + 0.8);
        text(&mut out, columns[1] + PAD, at, "", line);
    }
    for (i, line) in seal.iter().enumerate() {
        text(&mut out, columns[0], seal_top + LINE_STEP * (i as f64 + 0.6), "", line);
    }
    out.push_str("</svg></div>\n<figcaption>The dashed line is the record: whatever it encloses, it seals. It does not say which network read which file.</figcaption>\n</figure>\n");
    out
}

/// For who does not see it.
fn in_words(lineage: &Lineage) -> String {
    let parts: Vec<String> =
        lineage.words().into_iter().map(|(what, lines)| format!("{what}: {}.", lines.join(". "))).collect();
    format!("{}. {}", lineage.banner, parts.join(" "))
}

/// A box: clipped to itself, whatever a font makes of its words. Its title is the whole name.
fn drawn(out: &mut String, one: &Laid<'_>, [x, y, width]: [f64; 3], class: &str) {
    let _ = writeln!(
        out,
        "<svg x=\"{x}\" y=\"{y}\" width=\"{width}\" height=\"{}\"><title>{}</title>",
        one.height,
        escaped(&one.item.name)
    );
    let inset = if class == "flaw" { 2.0 } else { 0.6 };
    rect(out, class, [inset, inset, width - 2.0 * inset, one.height - 2.0 * inset]);
    words(out, one, 0.0, 0.0);
    out.push_str("</svg>\n");
}

fn words(out: &mut String, one: &Laid<'_>, x: f64, y: f64) {
    let mut at = y + PAD;
    for line in &one.name {
        text(out, x + PAD, at + 11.0, "n", line);
        at += NAME_STEP;
    }
    for line in &one.lines {
        text(out, x + PAD, at + 10.0, "", line);
        at += LINE_STEP;
    }
}

pub(super) fn text(out: &mut String, x: f64, y: f64, class: &str, words: &str) {
    let class = if class.is_empty() { String::new() } else { format!(" class=\"{class}\"") };
    let _ = writeln!(out, "<text x=\"{x}\" y=\"{y:.1}\"{class}>{}</text>", escaped(words));
}

fn rect(out: &mut String, class: &str, [x, y, width, height]: [f64; 4]) {
    let class = if class.is_empty() { String::new() } else { format!(" class=\"{class}\"") };
    let _ = writeln!(out, "<rect x=\"{x}\" y=\"{y:.1}\" width=\"{width}\" height=\"{height:.1}\" rx=\"5\"{class}/>");
}

fn arrow(out: &mut String, [x0, y0]: [f64; 2], [x1, y1]: [f64; 2]) {
    let (tip, bend) = (x1 - 8.0, (x1 - x0) / 2.0);
    let _ = writeln!(
        out,
        "<path d=\"M{x0} {y0:.1}C{} {y0:.1} {} {y1:.1} {tip} {y1:.1}\"/><path class=\"tip\" d=\"M{x1} {y1:.1}l-10 -4.5v9z\"/>",
        x0 + bend,
        x1 - bend
    );
}

/// Lines of at most `cells` characters' width, at most `most` of them; what is too long loses its middle.
pub(super) fn broken(text: &str, cells: usize, most: usize) -> Vec<String> {
    let mut text = text.to_owned();
    if width(&text) > cells * most {
        let half = (cells * most - 1) / 2;
        let head = fitting(text.chars(), half);
        let tail = fitting(text.chars().rev(), half);
        text = head.into_iter().chain(['…']).chain(tail.into_iter().rev()).collect();
    }
    let mut lines = vec![String::new()];
    for word in pieces(&text) {
        let last = lines.last().map_or(0, |l| width(l));
        if last + width(word.trim_end()) <= cells || last == 0 && width(word) <= cells {
            lines.last_mut().unwrap_or(&mut String::new()).push_str(word);
        } else if width(word.trim_end()) <= cells && lines.len() < most {
            lines.push(word.to_owned());
        } else {
            for c in word.chars() {
                if lines.last().map_or(0, |l| width(l)) + cell(c) > cells {
                    lines.push(String::new());
                }
                if let Some(line) = lines.last_mut() {
                    line.push(c);
                }
            }
        }
    }
    lines.retain(|l| !l.trim().is_empty());
    lines
}

/// A text in pieces that a line may end after.
fn pieces(text: &str) -> impl Iterator<Item = &str> {
    text.split_inclusive([' ', '/', '_'])
}

/// The first characters of a text that fit.
fn fitting(chars: impl Iterator<Item = char>, cells: usize) -> Vec<char> {
    let mut used = 0;
    chars
        .take_while(|c| {
            used += cell(*c);
            used <= cells
        })
        .collect()
}

fn width(text: &str) -> usize {
    text.chars().map(cell).sum()
}

/// Letters of Europe are one cell wide in a monospaced font; of others the widest is assumed.
fn cell(c: char) -> usize {
    match c as u32 {
        0..0x530 | 0x2010..=0x2027 => 1,
        _ => 2,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_fit_and_say_what_they_can() {
        assert_eq!(broken("short", 10, 3), ["short"]);
        assert_eq!(broken("one two three", 8, 3), ["one two ", "three"]);
        assert_eq!(broken("aaaaaaaaaaaaaaa", 10, 3), ["aaaaaaaaaa", "aaaaa"]);
        let long = "x".repeat(500) + "end.ply";
        let lines = broken(&long, 10, 3);
        assert!(lines.len() <= 3 && lines.iter().all(|l| width(l) <= 10), "{lines:?}");
        assert!(lines.concat().contains('…') && lines.concat().ends_with("end.ply"));
        for text in
            ["日本語の写真の名前はとても長い.jpg", "a_b/c d", "", "Ünïcödé/x_y z.tar.gz and then some more words"]
        {
            for cells in 4..20 {
                let lines = broken(text, cells, 50);
                assert!(lines.iter().all(|l| width(l.trim_end()) <= cells), "{cells} {lines:?}");
                assert_eq!(lines.concat(), text);
            }
        }
    }
}
