//! `orb bench --list`: the thirty metrics.

use std::fmt::Write as _;

use serde_json::json;

use crate::bench::catalogue::{Better, Domain, METRICS};
use crate::bench::score;

/// What is to be printed on stdout.
pub fn run(as_json: bool) -> String {
    if as_json {
        let rows: Vec<_> = METRICS
            .iter()
            .map(|m| {
                json!({
                    "id": m.id, "domain": m.domain.code(), "weight": m.weight, "unit": m.unit(),
                    "better": m.better(), "status": m.status, "source": m.source,
                })
            })
            .collect();
        return format!("{}\n", json!({ "metrics": rows }));
    }
    let mut out = String::new();
    for d in Domain::ALL {
        let _ = writeln!(out, "{} {}, {} %", d.code(), d.name(), d.weight());
        for m in d.metrics() {
            let better = if m.better() == Better::Higher { "higher" } else { "lower" };
            let status = format!("{:?}", m.status).to_lowercase();
            let measures: Vec<String> =
                m.measures.iter().map(|v| format!("{} in {}, {} … {}", v.name, v.unit, v.worst, v.best)).collect();
            let _ = writeln!(
                out,
                "   {:<26} {:>2} %  {better} is better, {status}\n      {}\n      {}",
                m.id,
                m.weight,
                measures.join("; "),
                m.source
            );
        }
    }
    let _ = writeln!(
        out,
        "\n{} metrics; a score is 0 at the first number and 100 at the second; {}",
        METRICS.len(),
        score::weighting()
    );
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn json_has_thirty_rows_of_seven_fields() {
        let value: serde_json::Value = serde_json::from_str(&run(true)).unwrap();
        let rows = value["metrics"].as_array().unwrap();
        assert_eq!((rows.len(), value.as_object().unwrap().len()), (30, 1));
        for r in rows {
            let fields: Vec<&str> = r.as_object().unwrap().keys().map(String::as_str).collect();
            assert_eq!(fields, ["better", "domain", "id", "source", "status", "unit", "weight"]);
            assert!(["higher", "lower"].contains(&r["better"].as_str().unwrap()));
            assert!(["verified", "speculative"].contains(&r["status"].as_str().unwrap()));
        }
        assert!(METRICS.iter().all(|m| run(false).contains(m.id)));
    }
}
