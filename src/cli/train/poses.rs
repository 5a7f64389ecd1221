//! By what poses were refined and by how much, as `orb train` tells it.

use std::collections::BTreeMap;

use serde_json::{Value, json};

use crate::audit::statement::Param;
use crate::pipeline::scene::{Moved, Refining, Scene};

/// How far each of those who moved the poses moved them.
fn parts(done: &Scene) -> Vec<(&'static str, Moved)> {
    let Some(r) = &done.refined else { return Vec::new() };
    let each = r.by_points.iter().flat_map(|p| [("points", *p), ("photos", r.by_photos)]);
    std::iter::once(("all", r.moved)).chain(each).collect()
}

fn words(m: &Moved) -> String {
    let [turned, shifted] = [m.turned, m.shifted.map(|s| 100.0 * s)];
    format!(
        "turned by {:.3}° (at most {:.3}°), shifted by {:.3} % of the distance (at most {:.3} %)",
        turned[0], turned[1], shifted[0], shifted[1]
    )
}

/// For a person: medians and the most.
pub fn lines(done: &Scene) -> Vec<String> {
    let by = |name: &str| match name {
        "points" => "by the points: ",
        "photos" => "by the photos: ",
        _ => "",
    };
    let moved = parts(done).into_iter().map(|(name, m)| format!("{}{}", by(name), words(&m)));
    done.refining.iter().map(Refining::words).chain(moved).collect()
}

/// For the record.
pub fn params(done: &Scene) -> BTreeMap<String, Param> {
    let text = |v: String| Param::Text(v);
    let mut all = BTreeMap::new();
    let Some(r) = &done.refining else { return all };
    all.insert("poses_refined_by".into(), text(r.by().into()));
    all.insert("poses_refined_how".into(), text(crate::audit::record::printable(&r.words())));
    all.insert("poses_common_observations".into(), Param::Int(r.common.observations as i64));
    all.insert("poses_common_points".into(), Param::Int(r.common.points as i64));
    if let Some(t) = r.trial() {
        all.insert("poses_trial_steps".into(), Param::Int(t.steps as i64));
        all.insert("poses_trial_gain_db".into(), text(format!("{:.3} ± {:.3}", t.gain, t.error)));
    }
    for (name, m) in parts(done) {
        let by = if name == "all" { String::new() } else { format!("_by_{name}") };
        for (k, of) in ["median", "most"].into_iter().enumerate() {
            all.insert(format!("poses_refined{by}_{of}_deg"), text(format!("{:.4}", m.turned[k])));
            all.insert(format!("poses_refined{by}_{of}_shift"), text(format!("{:.5}", m.shifted[k])));
        }
    }
    all
}

/// For programs; null where poses were to stay as they are.
pub fn json(done: &Scene) -> Value {
    let Some(r) = &done.refining else { return Value::Null };
    let moved: serde_json::Map<String, Value> = parts(done)
        .into_iter()
        .map(|(name, m)| {
            let value = json!({
                "median_deg": m.turned[0], "most_deg": m.turned[1],
                "median_shift": m.shifted[0], "most_shift": m.shifted[1],
            });
            (name.to_owned(), value)
        })
        .collect();
    json!({
        "by": r.by(), "how": r.words(), "observations": r.common.observations, "points": r.common.points,
        "trial": r.trial().map(|t| json!({"steps": t.steps, "gain_db": t.gain, "gain_sigma_db": t.error})),
        "moved": moved,
    })
}
