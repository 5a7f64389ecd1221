//! A document as one HTML page that needs nothing else.

use std::fmt::Write as _;

use super::{Block, Document};

const STYLE: &str = "\
body{font:15px/1.45 system-ui,sans-serif;color:#111;background:#fff;max-width:75em;margin:0 auto;padding:3.2em 1.5em}\
.banner{position:fixed;left:0;right:0;text-align:center;font-weight:700;letter-spacing:.06em;background:#111;color:#fff;\
padding:.35em}.top{top:0}.bottom{bottom:0}h1{font-size:1.6em}h2{font-size:1.15em;border-bottom:1px solid #999;margin-top:2em}\
table{border-collapse:collapse;width:100%;font-size:.88em}th,td{border:1px solid #bbb;padding:.3em .5em;text-align:left;\
vertical-align:top;overflow-wrap:anywhere}td.code{overflow-wrap:normal;white-space:nowrap}th{background:#eee;white-space:nowrap}pre{background:#f4f4f4;padding:1em;font-size:.8em;white-space:pre-wrap;overflow-wrap:anywhere}\
@media print{body{max-width:none}tr{break-inside:avoid}}";

pub(super) fn render(document: &Document) -> String {
    let banner = escaped(&document.banner);
    let title = escaped(&document.title);
    let mut out = format!(
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'unsafe-inline'\">\n\
         <meta name=\"viewport\" content=\"width=device-width\">\n<title>{title}: {banner}</title>\n\
         <style>{STYLE}</style>\n</head>\n<body>\n<div class=\"banner top\">{banner}</div>\n<h1>{title}</h1>\n"
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
                Block::Table { head, rows } => table(&mut out, head, rows),
            }
        }
    }
    let _ = write!(out, "<div class=\"banner bottom\">{banner}</div>\n</body>\n</html>\n");
    out
}

fn table(out: &mut String, head: &[&str], rows: &[Vec<String>]) {
    out.push_str("<table>\n<tr>");
    for cell in head {
        let _ = write!(out, "<th>{}</th>", escaped(cell));
    }
    out.push_str("</tr>\n");
    for row in rows {
        out.push_str("<tr>");
        for cell in row {
            let class = if is_code(cell) { " class=\"code\"" } else { "" };
            let _ = write!(out, "<td{class}>{}</td>", escaped(cell));
        }
        out.push_str("</tr>\n");
    }
    out.push_str("</table>\n");
}

/// A word that must not be broken: the code of a finding, a control's name.
fn is_code(cell: &str) -> bool {
    cell.len() > 4 && cell.len() < 32 && cell.contains('_') && cell.bytes().all(|b| b.is_ascii_uppercase() || b == b'_')
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}
