//! The thirty metrics as data: seven domains, what each metric is called, weighs and is measured in, which values count
//! as worst and best, and where it comes from. `docs/orb-bench.md` has the formulas; a test holds the two together.

use serde::Serialize;

/// A domain of Orb-Bench; its weight is the sum of its metrics'.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub enum Domain {
    /// Perceptual quality.
    PQ,
    /// Geometric fidelity.
    GF,
    /// Spatial consistency.
    SC,
    /// Physical correctness.
    PC,
    /// Temporal coherence.
    TC,
    /// Controllability and alignment.
    CA,
    /// Efficiency and edge readiness.
    EE,
}

impl Domain {
    pub const ALL: [Domain; 7] = [Domain::PQ, Domain::GF, Domain::SC, Domain::PC, Domain::TC, Domain::CA, Domain::EE];

    pub fn code(self) -> &'static str {
        ["PQ", "GF", "SC", "PC", "TC", "CA", "EE"][self as usize]
    }

    pub fn name(self) -> &'static str {
        [
            "perceptual quality",
            "geometric fidelity",
            "spatial consistency",
            "physical correctness",
            "temporal coherence",
            "controllability and alignment",
            "efficiency and edge readiness",
        ][self as usize]
    }

    pub fn metrics(self) -> impl Iterator<Item = &'static Metric> {
        METRICS.iter().filter(move |m| m.domain == self)
    }

    /// Per cent of the whole.
    pub fn weight(self) -> f64 {
        self.metrics().map(|m| m.weight).sum()
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Better {
    Higher,
    Lower,
}

/// How well founded a metric is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Status {
    /// An established metric with its source.
    Verified,
    /// Ours: defined here, used by nobody else yet.
    Speculative,
}

/// What one number is measured in, and how it becomes a score from 0 to 1: linear from worst to best, or linear in its
/// logarithm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measure {
    pub name: &'static str,
    pub unit: &'static str,
    pub worst: f64,
    pub best: f64,
    pub logarithmic: bool,
}

impl Measure {
    /// 0 at `worst` and beyond, 1 at `best` and beyond; 0 for what is no number.
    pub fn score(&self, value: f64) -> f64 {
        let of = |v: f64| if self.logarithmic { v.max(1e-12).ln() } else { v };
        let share = (of(value) - of(self.worst)) / (of(self.best) - of(self.worst));
        if share.is_nan() { 0.0 } else { share.clamp(0.0, 1.0) }
    }

    pub fn better(&self) -> Better {
        if self.best > self.worst { Better::Higher } else { Better::Lower }
    }
}

/// One of the thirty. Two measures count half each.
#[derive(Clone, Copy, Debug)]
pub struct Metric {
    pub id: &'static str,
    pub domain: Domain,
    /// Per cent of the whole.
    pub weight: f64,
    pub measures: &'static [Measure],
    pub status: Status,
    pub source: &'static str,
}

impl Metric {
    pub fn better(&self) -> Better {
        self.measures[0].better()
    }

    /// Of every measure, in their order.
    pub fn unit(&self) -> String {
        let mut units: Vec<&str> = self.measures.iter().map(|m| m.unit).collect();
        units.dedup();
        units.join(", ")
    }

    /// The mean of the measures' scores.
    pub fn score(&self, values: &[f64]) -> f64 {
        let scores = self.measures.iter().zip(values).map(|(m, v)| m.score(*v));
        scores.sum::<f64>() / self.measures.len() as f64
    }
}

/// The metric of this name.
pub fn metric(id: &str) -> Option<&'static Metric> {
    METRICS.iter().find(|m| m.id == id)
}

const fn linear(name: &'static str, unit: &'static str, worst: f64, best: f64) -> Measure {
    Measure { name, unit, worst, best, logarithmic: false }
}

const fn log(name: &'static str, unit: &'static str, worst: f64, best: f64) -> Measure {
    Measure { name, unit, worst, best, logarithmic: true }
}

const fn verified(
    id: &'static str,
    domain: Domain,
    weight: f64,
    measures: &'static [Measure],
    source: &'static str,
) -> Metric {
    Metric { id, domain, weight, measures, status: Status::Verified, source }
}

const fn ours(
    id: &'static str,
    domain: Domain,
    weight: f64,
    measures: &'static [Measure],
    source: &'static str,
) -> Metric {
    Metric { id, domain, weight, measures, status: Status::Speculative, source }
}

use Domain::{CA, EE, GF, PC, PQ, SC, TC};

pub const METRICS: [Metric; 30] = [
    verified("psnr", PQ, 3.0, &[linear("PSNR", "dB", 10.0, 40.0)], "ITU-T J.340 (2010)"),
    verified(
        "ssim_ms_ssim",
        PQ,
        3.0,
        &[linear("SSIM", "index", 0.5, 1.0), linear("MS-SSIM", "index", 0.5, 1.0)],
        "Wang et al. 2004, eq. 13; Wang et al. 2003, eq. 7",
    ),
    verified("lpips", PQ, 3.0, &[linear("LPIPS", "distance", 0.6, 0.0)], "Zhang et al. 2018, eq. 1"),
    verified(
        "delta_e_2000",
        PQ,
        3.0,
        &[linear("ΔE2000", "ΔE", 20.0, 0.0)],
        "CIE 142-2001; Sharma et al. 2005, eqs. 2–22",
    ),
    ours(
        "sharpness_ratio",
        PQ,
        3.0,
        &[linear("sharpness", "ratio", 0.0, 0.97)],
        "ours, over the variance of the Laplacian: Pech-Pacheco et al. 2000",
    ),
    verified(
        "chamfer",
        GF,
        4.0,
        &[linear("Chamfer distance", "% of the diagonal", 10.0, 0.1)],
        "Fan et al. 2017, with distances for their squares",
    ),
    verified(
        "f_score_1_2_percent",
        GF,
        4.0,
        &[linear("F-score at 1 %", "share", 0.0, 1.0), linear("F-score at 2 %", "share", 0.0, 1.0)],
        "Knapitsch et al. 2017; Tatarchenko et al. 2019",
    ),
    verified(
        "normal_consistency",
        GF,
        3.0,
        &[linear("normal consistency", "cosine", 0.0, 0.98)],
        "Mescheder et al. 2019, with signs",
    ),
    verified(
        "depth_abs_rel_delta",
        GF,
        3.0,
        &[linear("AbsRel", "ratio", 0.1, 0.002), linear("1 − δ<1.25", "share", 0.5, 0.0)],
        "Eigen et al. 2014",
    ),
    verified(
        "volume_iou",
        GF,
        3.0,
        &[linear("volume IoU", "share", 0.0, 0.98)],
        "Choy et al. 2016, by space carving: Kutulakos and Seitz 2000",
    ),
    ours("scale_error", GF, 3.0, &[linear("scale error", "%", 50.0, 0.5)], "ours, over the scale of Umeyama 1991"),
    ours(
        "photometric_consistency",
        SC,
        4.0,
        &[linear("colour left after warping", "share of full scale", 0.15, 0.02)],
        "ours, after Watson et al. 2023 (3D consistency scoring)",
    ),
    verified(
        "reprojection_error",
        SC,
        4.0,
        &[linear("reprojection error", "pixels", 8.0, 0.25)],
        "Hartley and Zisserman 2004, section 4.2; points of Shi and Tomasi 1994",
    ),
    verified(
        "silhouette_consistency",
        SC,
        4.0,
        &[linear("silhouette IoU", "share", 0.3, 0.98)],
        "Jaccard 1912; Kato et al. 2018",
    ),
    ours(
        "depth_consistency",
        SC,
        3.0,
        &[linear("depth left after warping", "% of the radius", 10.0, 1.0)],
        "ours, after Schönberger et al. 2016",
    ),
    ours("gravity_adherence", PC, 4.0, &[linear("tilt at rest", "degrees", 30.0, 2.0)], "ours, simulated by Rapier"),
    ours(
        "ground_penetration_gap",
        PC,
        4.0,
        &[linear("penetration", "% of the height", 10.0, 0.5), linear("gap", "% of the height", 10.0, 0.5)],
        "ours",
    ),
    ours(
        "static_stability",
        PC,
        4.0,
        &[linear("tipping angle", "degrees", 0.0, 5.0)],
        "ours, over the support polygon: McGhee and Frank 1968",
    ),
    verified(
        "watertightness",
        PC,
        4.0,
        &[linear("edges of two triangles", "share", 0.8, 1.0)],
        "the 2-manifold condition: Botsch et al. 2010",
    ),
    ours("plausible_scale", PC, 4.0, &[linear("outside the class's sizes", "octaves", 2.0, 0.0)], "ours"),
    ours(
        "smoothness_flicker",
        TC,
        5.0,
        &[
            linear("temporal smoothness", "share of full scale", 0.06, 0.02),
            linear("flicker", "share of full scale", 0.01, 0.001),
        ],
        "ours, second differences along a path",
    ),
    ours("loop_closure", TC, 5.0, &[linear("PSNR at the return", "dB", 10.0, 40.0)], "ours: memory recall"),
    verified("mask_alignment", CA, 4.0, &[linear("mask IoU", "share", 0.3, 0.98)], "Everingham et al. 2010"),
    verified(
        "trajectory_adherence",
        CA,
        3.0,
        &[linear("rotation off", "degrees", 45.0, 1.0)],
        "rotation part of Sturm et al. 2012",
    ),
    verified(
        "clip_score",
        CA,
        3.0,
        &[linear("CLIP cosine", "cosine", 0.5, 0.95)],
        "Radford et al. 2021; Hessel et al. 2021",
    ),
    verified("fps_1080p", EE, 2.0, &[log("pictures a second", "1/s", 1.0, 60.0)], "Kerbl et al. 2023"),
    verified(
        "peak_memory_file_size",
        EE,
        2.0,
        &[log("peak memory", "MiB", 16384.0, 1024.0), log("largest file", "MiB", 1024.0, 16.0)],
        "Kerbl et al. 2023",
    ),
    verified("wall_time", EE, 2.0, &[log("wall time", "s", 3600.0, 60.0)], "Kerbl et al. 2023"),
    ours(
        "ddil",
        EE,
        2.0,
        &[linear("made without a network", "share", 0.0, 1.0)],
        "ours: a network namespace without interfaces",
    ),
    ours(
        "export_conformance",
        EE,
        2.0,
        &[linear("files without findings", "share", 0.0, 1.0)],
        "ours, by the formats' own rules",
    ),
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn thirty_metrics_in_seven_domains_weigh_a_hundred() {
        let mut ids: Vec<&str> = METRICS.iter().map(|m| m.id).collect();
        ids.sort_unstable();
        ids.dedup();
        assert_eq!(ids.len(), 30);
        let weights = Domain::ALL.map(|d| (d.code(), d.weight()));
        let expected =
            [("PQ", 15.0), ("GF", 20.0), ("SC", 15.0), ("PC", 20.0), ("TC", 10.0), ("CA", 10.0), ("EE", 10.0)];
        assert_eq!(weights, expected);
        for m in &METRICS {
            assert!(m.measures.iter().all(|v| v.better() == m.better() && v.best != v.worst), "{}", m.id);
        }
    }

    #[test]
    fn scores_run_from_worst_to_best() {
        let psnr = metric("psnr").unwrap();
        assert_eq!([5.0, 10.0, 25.0, 40.0, 90.0, f64::NAN].map(|v| psnr.score(&[v])), [0.0, 0.0, 0.5, 1.0, 1.0, 0.0]);
        let size = metric("peak_memory_file_size").unwrap();
        assert!((size.score(&[4096.0, 128.0]) - 0.5).abs() < 1e-9, "half-way in the logarithm");
    }

    /// The table of the docs says what the program says.
    #[test]
    fn the_documents_table_is_this_table() {
        let text = include_str!("../../docs/orb-bench.md");
        for m in &METRICS {
            let row = text.lines().find(|l| l.starts_with(&format!("| `{}` |", m.id)));
            let cells: Vec<&str> = row.unwrap_or_else(|| panic!("no row {}", m.id)).split('|').map(str::trim).collect();
            let join = |f: &dyn Fn(&Measure) -> String| m.measures.iter().map(f).collect::<Vec<_>>().join("; ");
            let better = if m.better() == Better::Higher { "higher" } else { "lower" };
            let status = if m.status == Status::Verified { "verified" } else { "speculative" };
            let range = join(&|v| format!("{} … {}{}", v.worst, v.best, if v.logarithmic { " (log)" } else { "" }));
            let said = [cells[2], cells[4], cells[5], cells[6], cells[7], cells[8]];
            assert_eq!(said, [&m.weight.to_string(), &m.unit(), better, range.as_str(), status, m.source], "{}", m.id);
            assert!(cells[3].len() > 10, "{}: no formula", m.id);
        }
    }
}
