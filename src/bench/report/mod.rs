//! What a run of the benchmark tells: a table for the terminal, JSON, CSV, and one page of HTML.

mod chart;
mod html;

use std::fmt::Write as _;

use serde_json::{Value, json};

use super::catalogue::{Better, Domain, METRICS, Metric};
use super::evaluate::Evaluation;
use super::score::{self, Scores};

pub use html::page;

/// Everything a report is made of.
pub struct Run<'a> {
    pub scores: &'a Scores,
    pub scenes: &'a [Evaluation],
    /// Whose results these are.
    pub system: &'a str,
    /// The banner of what was measured.
    pub marking: &'a str,
}

impl Run<'_> {
    /// Why a metric was not measured in any scene.
    fn why(&self, metric: &Metric) -> &str {
        self.scenes.iter().find_map(|s| s.missing.get(metric.id)).map_or("", String::as_str)
    }
}

/// `0.123`, `12.3`, `123`: three digits that matter.
pub fn short(v: f64) -> String {
    match v.abs() {
        a if a >= 100.0 => format!("{v:.0}"),
        a if a >= 10.0 => format!("{v:.1}"),
        a if a >= 1.0 => format!("{v:.2}"),
        _ => format!("{v:.3}"),
    }
}

fn values(m: &Metric, values: &[f64]) -> String {
    let one = |(measure, v): (&super::catalogue::Measure, &f64)| match m.measures.len() {
        1 => short(*v),
        _ => format!("{} {}", measure.name, short(*v)),
    };
    m.measures.iter().zip(values).map(one).collect::<Vec<_>>().join(", ")
}

/// Lines for a person.
pub fn table(run: &Run) -> String {
    let mut out = String::new();
    let mut line = |text: String| {
        // Writing to a string cannot fail.
        let _ = writeln!(out, "{text}");
    };
    line(format!("{}\n{} over {} scenes\n", run.marking, run.system, run.scenes.len()));
    for (domain, (score, coverage)) in Domain::ALL.iter().zip(run.scores.domains) {
        let score = score.map_or("  –  ".into(), |s| format!("{s:5.1}"));
        line(format!(
            "{} {score}  {} (weight {} %, covered {coverage:.0} %)",
            domain.code(),
            domain.name(),
            domain.weight()
        ));
        for m in domain.metrics() {
            match run.scores.of(m.id) {
                Some(f) => {
                    let scenes =
                        if f.scenes == run.scenes.len() { String::new() } else { format!(", {} scenes", f.scenes) };
                    let unit = if m.measures.len() == 1 || m.measures[0].unit == m.measures[1].unit {
                        m.measures[0].unit
                    } else {
                        ""
                    };
                    line(format!("   {:5.1}  {:<26} {} {unit}{scenes}", 100.0 * f.score, m.id, values(m, &f.values)));
                }
                None => line(format!("     –    {:<26} not measured: {}", m.id, run.why(m))),
            }
        }
    }
    let total = run.scores.total.map_or("none".into(), |t| format!("{t:.1} of 100"));
    line(format!("\nscore {total}, coverage {:.0} % of the weight\n{}", run.scores.coverage, score::weighting()));
    out
}

/// The object of `--json` and of `scores.json`.
pub fn json(run: &Run) -> Value {
    let scene = |s: &Evaluation| {
        let values: serde_json::Map<String, Value> =
            METRICS.iter().filter_map(|m| Some((m.id.to_owned(), score::named(m, s.values.get(m.id)?)))).collect();
        json!({ "name": s.scene, "values": values, "not_measured": s.missing })
    };
    json!({
        "marking": run.marking, "system": run.system,
        "scores": run.scores.to_json(), "scenes": run.scenes.iter().map(scene).collect::<Vec<_>>(),
    })
}

/// One row a scene and measure (RFC 4180).
pub fn csv(run: &Run) -> String {
    let quoted = |text: &str| match text.contains([',', '"', '\n']) {
        true => format!("\"{}\"", text.replace('"', "\"\"")),
        false => text.to_owned(),
    };
    let mut out = String::from("marking,system,scene,domain,metric,measure,unit,better,value,score\r\n");
    for s in run.scenes {
        for m in &METRICS {
            let found = s.values.get(m.id);
            for (k, measure) in m.measures.iter().enumerate() {
                let (value, score) = match found {
                    Some(v) => (v[k].to_string(), (100.0 * measure.score(v[k])).to_string()),
                    None => (String::new(), String::new()),
                };
                let better = if measure.better() == Better::Higher { "higher" } else { "lower" };
                let row = [
                    run.marking,
                    run.system,
                    &s.scene,
                    m.domain.code(),
                    m.id,
                    measure.name,
                    measure.unit,
                    better,
                    &value,
                    &score,
                ];
                out += &row.map(quoted).join(",");
                out += "\r\n";
            }
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bench::score::{Values, add_up};

    #[test]
    fn every_form_tells_values_marking_and_what_is_missing() {
        let values: Values = [("psnr", vec![31.25]), ("f_score_1_2_percent", vec![0.5, 0.75])].into();
        let missing = [("lpips", "no weights: <name> them".to_owned())].into();
        let pixel = image::RgbImage::from_pixel(2, 2, image::Rgb([9, 99, 199]));
        let compared = crate::bench::evaluate::Compared {
            name: "00".into(),
            truth: pixel.clone(),
            found: pixel.clone(),
            error: pixel.clone(),
        };
        let scene =
            Evaluation { scene: "a, \"b\"".into(), values, missing, pictures: vec![compared], photo: Some(pixel) };
        let scenes = [scene];
        let scores = add_up(&[scenes[0].values.clone()]);
        let run = Run { scores: &scores, scenes: &scenes, system: "someone's", marking: "SECRET//NOFORN" };
        let text = table(&run);
        assert!(
            text.contains("31.2 dB") && text.contains("not measured: no weights") && text.starts_with("SECRET"),
            "{text}"
        );
        assert!(text.contains("coverage 7 % of the weight"), "{text}");
        let j = json(&run);
        assert_eq!(j["scenes"][0]["values"]["psnr"]["PSNR"], 31.25);
        assert_eq!(j["scores"]["metrics"].as_array().unwrap().len(), 30);
        let c = csv(&run);
        assert!(c.contains("SECRET//NOFORN,someone's,\"a, \"\"b\"\"\",PQ,psnr,PSNR,dB,higher,31.25,70.8"), "{c}");
        assert!(c.lines().all(|l| l.contains("lpips") || l.matches(',').count() >= 9));
        let h = page(&run);
        assert!(h.matches("SECRET//NOFORN").count() >= 3 && h.contains("&lt;name&gt;") && h.contains("<svg"));
        assert!(!h.contains("://") && h.matches("data:image/png;base64,").count() == 4, "self-contained");
    }
}
