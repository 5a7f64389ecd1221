//! From values to scores: a metric's over the scenes, a domain's over its metrics, the whole over the domains.

use std::collections::BTreeMap;

use serde_json::{Value, json};

use super::catalogue::{Domain, METRICS, Metric};

/// Values of one scene by metric, one a measure; what is not measured is not there.
pub type Values = BTreeMap<&'static str, Vec<f64>>;

/// A metric over all scenes that measured it.
#[derive(Clone, Debug, PartialEq)]
pub struct MetricScore {
    pub metric: &'static str,
    /// Means of the values, one a measure.
    pub values: Vec<f64>,
    /// Mean of the scenes' scores, 0 to 1.
    pub score: f64,
    pub scenes: usize,
}

/// The benchmark's result.
#[derive(Clone, Debug, PartialEq)]
pub struct Scores {
    pub metrics: Vec<MetricScore>,
    /// Score and coverage of each domain, in the order of [`Domain::ALL`]; no score where nothing is measured.
    pub domains: [(Option<f64>, f64); 7],
    /// 0 to 100, of what was measured, weighted by the metrics' weights.
    pub total: Option<f64>,
    /// Per cent of the weight that was measured.
    pub coverage: f64,
}

/// Adds up. A metric counts with the share of the scenes that measured it; what is not measured lowers the coverage and
/// nothing else.
pub fn add_up(scenes: &[Values]) -> Scores {
    let one = |m: &'static Metric| {
        let found: Vec<&Vec<f64>> = scenes.iter().filter_map(|s| s.get(m.id)).collect();
        let n = found.len();
        (n > 0).then(|| MetricScore {
            metric: m.id,
            values: (0..m.measures.len()).map(|k| found.iter().map(|v| v[k]).sum::<f64>() / n as f64).collect(),
            score: found.iter().map(|v| m.score(v)).sum::<f64>() / n as f64,
            scenes: n,
        })
    };
    let metrics: Vec<MetricScore> = METRICS.iter().filter_map(one).collect();
    let share = |m: &MetricScore| m.scenes as f64 / scenes.len().max(1) as f64;
    let over = |of: &dyn Fn(&Metric) -> bool| {
        let (mut sum, mut measured, mut whole) = (0.0, 0.0, 0.0);
        for m in METRICS.iter().filter(|m| of(m)) {
            whole += m.weight;
            if let Some(found) = metrics.iter().find(|f| f.metric == m.id) {
                let weight = m.weight * share(found);
                sum += weight * found.score;
                measured += weight;
            }
        }
        ((measured > 0.0).then(|| 100.0 * sum / measured), 100.0 * measured / whole)
    };
    let domains = Domain::ALL.map(|d| over(&|m| m.domain == d));
    let (total, coverage) = over(&|_| true);
    Scores { metrics, domains, total, coverage }
}

/// How the total came about, in words.
pub fn weighting() -> String {
    let weights: Vec<String> = Domain::ALL.iter().map(|d| format!("{} {}", d.code(), d.weight())).collect();
    format!(
        "weighted mean of what was measured; weights in per cent: {}; a metric's part in its domain is in `orb bench --list`",
        weights.join(", ")
    )
}

impl Scores {
    pub fn of(&self, id: &str) -> Option<&MetricScore> {
        self.metrics.iter().find(|m| m.metric == id)
    }

    /// The object under `scores` of `--json`.
    pub fn to_json(&self) -> Value {
        let domains: Vec<Value> = Domain::ALL
            .iter()
            .zip(self.domains)
            .map(|(d, (score, coverage))| {
                json!({ "domain": d.code(), "weight": d.weight(), "score": score, "coverage_percent": coverage })
            })
            .collect();
        let metrics: Vec<Value> = METRICS
            .iter()
            .map(|m| match self.of(m.id) {
                Some(f) => {
                    json!({ "id": m.id, "values": named(m, &f.values), "score": 100.0 * f.score, "scenes": f.scenes })
                }
                None => json!({ "id": m.id, "values": null, "score": null, "scenes": 0 }),
            })
            .collect();
        json!({
            "total": self.total, "coverage_percent": self.coverage, "weighting": weighting(),
            "domains": domains, "metrics": metrics,
        })
    }
}

/// Values by their measures' names.
pub fn named(m: &Metric, values: &[f64]) -> Value {
    m.measures.iter().zip(values).map(|(m, v)| (m.name.to_owned(), json!(v))).collect::<serde_json::Map<_, _>>().into()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_missing_lowers_the_coverage_alone() {
        let perfect = |m: &Metric| m.measures.iter().map(|v| v.best).collect::<Vec<f64>>();
        let all: Values = METRICS.iter().map(|m| (m.id, perfect(m))).collect();
        let s = add_up(std::slice::from_ref(&all));
        assert_eq!((s.total, s.coverage), (Some(100.0), 100.0));
        assert!(s.domains.iter().all(|d| *d == (Some(100.0), 100.0)));
        let mut fewer = all.clone();
        fewer.remove("lpips");
        let s = add_up(std::slice::from_ref(&fewer));
        assert_eq!((s.total, s.coverage, s.domains[0]), (Some(100.0), 97.0, (Some(100.0), 80.0)));
        let s = add_up(&[all, fewer.clone()]);
        assert_eq!((s.coverage, s.of("lpips").unwrap().scenes), (98.5, 1));
        fewer.insert("psnr", vec![25.0]);
        let s = add_up(&[fewer]);
        assert!((s.total.unwrap() - 100.0 * (97.0 - 1.5) / 97.0).abs() < 1e-9);
        assert_eq!((add_up(&[]).total, add_up(&[]).coverage), (None, 0.0));
    }
}
