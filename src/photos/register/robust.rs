//! Which fixes agree, and the fit over them.
//!
//! The model of least median residual among those of small samples (P. J. Rousseeuw, "Least median of squares regression", JASA
//! 1984); a residual beyond 3.5 robust standard deviations is an outlier's. Surveyed points are judged among themselves, and where they
//! are too few for that, none is left out: a receiver's many rough places do not outvote one exact point.

use glam::DVec3;

use super::Fix;
use crate::geo::similarity::{self, Pair, Similarity, Turn};
use crate::splat::train::random::Random;

/// Samples tried where there are more.
const SAMPLES: usize = 1000;
/// A residual beyond so many robust deviations is an outlier's.
pub const OUTLIER: f64 = 3.5;
/// Residuals may be this part of what their deviations say, not less: the median of few is often small by chance.
const LEAST_DEVIATION: f64 = 0.5;
/// Of three numbers a fix, half lie within so many deviations.
const HALF: f64 = 1.54;

/// Fixes that a fit needs at least.
fn least(turn: Turn) -> usize {
    if turn == Turn::Free { 3 } else { 2 }
}

fn unknowns(turn: Turn) -> usize {
    if turn == Turn::Free { 7 } else { 5 }
}

/// Length of a residual in its own deviations.
fn in_deviations(d: DVec3, fix: &Fix) -> f64 {
    (d.truncate().length() / fix.horizontal.max(1e-6)).hypot(d.z / fix.vertical.max(1e-6))
}

/// What the receivers are off by together, by the control points' median, metres; taken out of their pairs. A receiver's height is off
/// for a whole flight, and heights above geoid and ellipsoid are mixed up easily. `None`, and nothing is changed, without
/// control points or with too few receivers.
pub fn receivers_off(fixes: &[Fix], pairs: &mut [Pair], turn: Turn, seed: u64) -> Option<DVec3> {
    let (receivers, own): (Vec<Fix>, Vec<Pair>) =
        fixes.iter().zip(&*pairs).filter(|(f, _)| !f.control).map(|(f, p)| (f.clone(), *p)).unzip();
    let (by_receivers, _) = fit(&receivers, &own, turn, seed)?;
    let off: Vec<DVec3> =
        fixes.iter().zip(&*pairs).filter(|(f, _)| f.control).map(|(_, p)| by_receivers.apply(p.from) - p.to).collect();
    let median = |axis: fn(&DVec3) -> f64| {
        let mut all: Vec<f64> = off.iter().map(axis).collect();
        all.sort_by(f64::total_cmp);
        all.get(all.len() / 2).copied()
    };
    let off = DVec3::new(median(|d| d.x)?, median(|d| d.y)?, median(|d| d.z)?);
    for (pair, _) in pairs.iter_mut().zip(fixes).filter(|(_, f)| !f.control) {
        pair.to -= off;
    }
    Some(off)
}

/// Samples of `size` of the jury: all of them, or so many by chance.
fn samples(jury: &[usize], size: usize, seed: u64) -> Vec<Vec<usize>> {
    let n = jury.len();
    let count = if size == 2 { n * (n - 1) / 2 } else { n * (n - 1) * (n - 2) / 6 };
    let mut all: Vec<Vec<usize>> = Vec::new();
    if count > SAMPLES {
        let mut random = Random::new(seed);
        all.extend((0..SAMPLES).map(|_| (0..size).map(|_| jury[(random.next() % n as u64) as usize]).collect()));
        return all;
    }
    for a in 0..n {
        for b in 0..a {
            if size == 2 {
                all.push(vec![jury[a], jury[b]]);
            } else {
                all.extend((0..b).map(|c| vec![jury[a], jury[b], jury[c]]));
            }
        }
    }
    all
}

/// The fit over the fixes that agree, and which do. `None` for too few.
pub fn fit(fixes: &[Fix], pairs: &[Pair], turn: Turn, seed: u64) -> Option<(Similarity, Vec<bool>)> {
    let (n, size) = (pairs.len(), least(turn));
    if n < size {
        return None;
    }
    let off = |s: &Similarity| -> Vec<f64> {
        fixes.iter().zip(pairs).map(|(f, p)| in_deviations(s.apply(p.from) - p.to, f)).collect()
    };
    let all = || Some((similarity::fit(pairs, turn)?, vec![true; n]));
    // As many unknowns as there are numbers: nothing can disagree.
    if n <= size + 1 {
        return all();
    }
    let surveyed: Vec<usize> = (0..n).filter(|i| fixes[*i].control).collect();
    let survey_judges = surveyed.len() > size + 1;
    let jury = if survey_judges { surveyed } else { (0..n).collect() };
    let median = |r: &[f64], of: &dyn Fn(usize) -> bool| {
        let mut all: Vec<f64> = (0..n).filter(|i| of(*i)).map(|i| r[i]).collect();
        all.sort_by(f64::total_cmp);
        all.get(all.len() / 2).copied()
    };
    let mut best: Option<(f64, Similarity)> = None;
    for sample in samples(&jury, size, seed) {
        let chosen: Vec<Pair> = sample.iter().map(|i| pairs[*i]).collect();
        let Some(s) = similarity::fit(&chosen, turn) else { continue };
        let r = off(&s);
        let mut judged: Vec<f64> = jury.iter().map(|i| r[*i]).collect();
        judged.sort_by(f64::total_cmp);
        let median = judged[judged.len() / 2];
        if best.as_ref().is_none_or(|(least, _)| median < *least) {
            best = Some((median, s));
        }
    }
    let (_, mut s) = best?;
    // Rousseeuw's factor for few observations.
    let few = |count: usize| 1.0 + 5.0 / (3 * count).saturating_sub(size).max(1) as f64;
    let count = |control: bool| fixes.iter().filter(|f| f.control == control).count();
    let r = off(&s);
    // Of receivers, and of surveyed points, which are all kept where they cannot be judged.
    let mut deviation = [false, true].map(|control| {
        let own = median(&r, &|i| fixes[i].control == control).unwrap_or(0.0);
        (own / HALF * few(count(control))).max(LEAST_DEVIATION)
    });
    if !survey_judges {
        deviation[1] = f64::INFINITY;
    }
    let mut kept = vec![true; n];
    for _ in 0..4 {
        let r = off(&s);
        kept = (0..n).map(|i| r[i] <= OUTLIER * deviation[usize::from(fixes[i].control)]).collect();
        let inliers: Vec<Pair> = pairs.iter().zip(&kept).filter(|(_, k)| **k).map(|(p, _)| *p).collect();
        if inliers.len() < size {
            return all();
        }
        s = similarity::fit(&inliers, turn)?;
        let r = off(&s);
        for control in [false, true] {
            let own: Vec<f64> = (0..n).filter(|i| kept[*i] && fixes[*i].control == control).map(|i| r[i]).collect();
            if own.is_empty() || deviation[usize::from(control)].is_infinite() {
                continue;
            }
            // The unknowns are shared out by how many fixes there are of each kind.
            let share = unknowns(turn) * own.len() / inliers.len();
            let free = (3 * own.len()).saturating_sub(share).max(1);
            let square: f64 = own.iter().map(|r| r * r).sum();
            deviation[usize::from(control)] = (square / free as f64).sqrt().max(LEAST_DEVIATION) * 1.2;
        }
    }
    Some((s, kept))
}
