//! One page that needs nothing else: no script, no font, no address.

use std::fmt::Write as _;
use std::io::Cursor;

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use image::RgbImage;

use super::chart::{bar, radar};
use super::{Run, short, values};
use crate::bench::catalogue::{Domain, Status};
use crate::bench::evaluate::Evaluation;
use crate::bench::score;

/// Pixels across a picture of the page.
const ACROSS: u32 = 224;

const STYLE: &str = "\
body{font:15px/1.45 system-ui,sans-serif;color:#111;background:#fff;max-width:72em;margin:0 auto;padding:3.2em 1.5em}\
.banner{position:fixed;left:0;right:0;text-align:center;font-weight:700;letter-spacing:.06em;background:#111;color:#fff;\
padding:.35em;z-index:1}.top{top:0}.bottom{bottom:0}h1{font-size:1.6em}h2{font-size:1.2em;border-bottom:1px solid #999;margin-top:2em}\
table{border-collapse:collapse;width:100%;font-size:.88em}th,td{border:1px solid #ccc;padding:.3em .5em;text-align:left;\
vertical-align:middle}th{background:#eee}td.n{text-align:right;white-space:nowrap}tr.none td{color:#888}\
.score{font-size:2.6em;font-weight:700}.row{display:flex;flex-wrap:wrap;gap:2em;align-items:center}\
figure{display:inline-block;margin:.3em}figcaption{font-size:.8em;color:#444}img{display:block;border:1px solid #ccc;background:#fff}\
.set{margin:.6em 0}@media print{.banner{position:static}tr,.set{break-inside:avoid}}";

/// The page.
pub fn page(run: &Run) -> String {
    let banner = escaped(run.marking);
    let system = escaped(run.system);
    let mut out = format!(
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'unsafe-inline'; img-src data:\">\n\
         <meta name=\"viewport\" content=\"width=device-width\">\n<title>Orb-Bench: {system}: {banner}</title>\n\
         <style>{STYLE}</style>\n</head>\n<body>\n<div class=\"banner top\">{banner}</div>\n<h1>Orb-Bench: {system}</h1>\n"
    );
    let total = run.scores.total.map_or("–".into(), |t| format!("{t:.1}"));
    let _ = write!(
        out,
        "<div class=\"row\"><div><div class=\"score\">{total}</div><div>of 100, over {} scenes; {:.0} % of the weight was measured</div>\
         <p>{}.</p></div>\n{}</div>\n",
        run.scenes.len(),
        run.scores.coverage,
        escaped(&score::weighting()),
        radar(run.scores)
    );
    domains(&mut out, run);
    metrics(&mut out, run);
    out.push_str("<h2>Scenes</h2>\n<p>Error maps: white where both pictures agree, over yellow and red to black for half of the full scale.</p>\n");
    for scene in run.scenes {
        pictures(&mut out, scene);
    }
    let _ = write!(out, "<div class=\"banner bottom\">{banner}</div>\n</body>\n</html>\n");
    out
}

fn domains(out: &mut String, run: &Run) {
    out.push_str("<h2>Domains</h2>\n<table>\n<tr><th>Domain</th><th>Weight</th><th>Score</th><th>Score of what is covered</th><th>Covered</th></tr>\n");
    for (d, (score, coverage)) in Domain::ALL.iter().zip(run.scores.domains) {
        let _ = writeln!(
            out,
            "<tr><td>{} {}</td><td class=\"n\">{} %</td><td class=\"n\">{}</td><td>{}</td><td class=\"n\">{coverage:.0} %</td></tr>",
            d.code(),
            d.name(),
            d.weight(),
            score.map_or("–".into(), |s| format!("{s:.1}")),
            bar(score, coverage)
        );
    }
    out.push_str("</table>\n");
}

fn metrics(out: &mut String, run: &Run) {
    out.push_str("<h2>Metrics</h2>\n<table>\n<tr><th></th><th>Metric</th><th>Weight</th><th>Value</th><th>Score</th><th>Scenes</th><th>Status</th><th>Source</th></tr>\n");
    for m in Domain::ALL.iter().flat_map(|d| d.metrics()) {
        let status = if m.status == Status::Verified { "verified" } else { "speculative" };
        let (class, value, score, scenes) = match run.scores.of(m.id) {
            Some(f) => ("", format!("{} {}", values(m, &f.values), m.unit()), short(100.0 * f.score), f.scenes),
            None => (" class=\"none\"", format!("not measured: {}", run.why(m)), "–".into(), 0),
        };
        let _ = writeln!(
            out,
            "<tr{class}><td>{}</td><td>{}</td><td class=\"n\">{} %</td><td>{}</td><td class=\"n\">{score}</td><td class=\"n\">{scenes}</td>\
             <td>{status}</td><td>{}</td></tr>",
            m.domain.code(),
            m.id,
            m.weight,
            escaped(&value),
            escaped(m.source)
        );
    }
    out.push_str("</table>\n");
}

fn pictures(out: &mut String, scene: &Evaluation) {
    let value =
        |id: &str, name: &str, unit: &str| scene.values.get(id).map(|v| format!("{name} {}{unit}", short(v[0])));
    let facts: Vec<String> = [
        value("psnr", "PSNR", " dB"),
        value("ssim_ms_ssim", "SSIM", ""),
        value("chamfer", "Chamfer", " %"),
        value("volume_iou", "volume IoU", ""),
        value("gravity_adherence", "tilt", "°"),
    ]
    .into_iter()
    .flatten()
    .collect();
    let _ = writeln!(out, "<div class=\"set\"><h3>{}</h3><p>{}</p>", escaped(&scene.scene), facts.join(", "));
    if let Some(photo) = &scene.photo {
        figure(out, photo, "photo");
        out.push_str("<br>\n");
    }
    for c in &scene.pictures {
        for (picture, what) in [(&c.truth, "truth"), (&c.found, "result"), (&c.error, "error")] {
            figure(out, picture, &format!("{} {what}", c.name));
        }
        out.push_str("<br>\n");
    }
    out.push_str("</div>\n");
}

fn figure(out: &mut String, picture: &RgbImage, caption: &str) {
    let larger = picture.width().max(picture.height()).max(1);
    let side = |n: u32| (n * ACROSS / larger).max(1);
    let small = match larger > ACROSS {
        true => image::imageops::thumbnail(picture, side(picture.width()), side(picture.height())),
        false => picture.clone(),
    };
    let mut bytes = Cursor::new(Vec::new());
    // Writing to memory cannot fail; a picture that did would only be missing.
    if small.write_to(&mut bytes, image::ImageFormat::Png).is_err() {
        return;
    }
    let _ = write!(
        out,
        "<figure><img alt=\"{0}\" width=\"{1}\" height=\"{2}\" src=\"data:image/png;base64,{3}\"><figcaption>{0}</figcaption></figure>",
        escaped(caption),
        side(picture.width()),
        side(picture.height()),
        STANDARD.encode(bytes.into_inner())
    );
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}
