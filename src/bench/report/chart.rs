//! Charts as inline SVG.

use std::f64::consts::TAU;
use std::fmt::Write as _;

use crate::bench::catalogue::Domain;
use crate::bench::score::Scores;

/// Seven spokes, 0 in the middle and 100 at the rim; a domain of which nothing was measured leaves a gap.
pub fn radar(scores: &Scores) -> String {
    const R: f64 = 150.0;
    let at = |k: usize, r: f64| {
        let a = TAU * k as f64 / 7.0 - TAU / 4.0;
        (r * a.cos(), r * a.sin())
    };
    let mut out = String::from(
        "<svg viewBox=\"-250 -200 500 390\" width=\"500\" height=\"390\" role=\"img\" aria-label=\"Radar chart of the seven domains\">\n",
    );
    for ring in 1..=4 {
        let points: Vec<String> =
            (0..7).map(|k| at(k, R * f64::from(ring) / 4.0)).map(|(x, y)| format!("{x:.1},{y:.1}")).collect();
        let _ = writeln!(out, "<polygon points=\"{}\" fill=\"none\" stroke=\"#ccc\"/>", points.join(" "));
        let _ = writeln!(
            out,
            "<text x=\"3\" y=\"{:.1}\" font-size=\"9\" fill=\"#888\">{}</text>",
            -R * f64::from(ring) / 4.0 + 10.0,
            ring * 25
        );
    }
    for (k, domain) in Domain::ALL.iter().enumerate() {
        let (x, y) = at(k, R);
        let _ = writeln!(out, "<line x1=\"0\" y1=\"0\" x2=\"{x:.1}\" y2=\"{y:.1}\" stroke=\"#ccc\"/>");
        let (x, y) = at(k, R + 16.0);
        let anchor = if x > 20.0 {
            "start"
        } else if x < -20.0 {
            "end"
        } else {
            "middle"
        };
        let label = match scores.domains[k].0 {
            Some(s) => format!("{} {s:.0}", domain.code()),
            None => format!("{} –", domain.code()),
        };
        let _ = writeln!(
            out,
            "<text x=\"{x:.1}\" y=\"{:.1}\" text-anchor=\"{anchor}\" font-size=\"15\" font-weight=\"600\">{label}</text>",
            y + 5.0
        );
    }
    let known: Vec<(usize, f64)> = scores.domains.iter().enumerate().filter_map(|(k, d)| Some((k, d.0?))).collect();
    let points: Vec<String> =
        known.iter().map(|(k, s)| at(*k, R * s / 100.0)).map(|(x, y)| format!("{x:.1},{y:.1}")).collect();
    let _ = writeln!(
        out,
        "<polygon points=\"{}\" fill=\"#1f6feb\" fill-opacity=\"0.25\" stroke=\"#1f6feb\" stroke-width=\"2\"/>",
        points.join(" ")
    );
    for (k, s) in known {
        let (x, y) = at(k, R * s / 100.0);
        let _ = writeln!(out, "<circle cx=\"{x:.1}\" cy=\"{y:.1}\" r=\"3.5\" fill=\"#1f6feb\"/>");
    }
    out + "</svg>\n"
}

/// A bar from 0 to 100, what was not measured hatched at its end.
pub fn bar(score: Option<f64>, coverage: f64) -> String {
    let covered = 3.0 * coverage;
    let mut out = format!(
        "<svg viewBox=\"0 0 300 14\" width=\"300\" height=\"14\"><rect width=\"300\" height=\"14\" fill=\"#fff\" stroke=\"#ccc\"/>\
         <rect width=\"{covered:.1}\" height=\"14\" fill=\"#e6e6e6\"/>"
    );
    if let Some(s) = score {
        let _ = write!(out, "<rect width=\"{:.1}\" height=\"14\" fill=\"#1f6feb\"/>", covered * s / 100.0);
    }
    out + "</svg>"
}
