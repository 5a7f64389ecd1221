//! Gaussians as OpenUSD's ParticleField3DGaussianSplat (`usdVol`, since 26.03).
//!
//! Scales are metres and opacities 0..1 in the file, both without the logarithms of training; the harmonics of a splat stand
//! together, basis by basis.

use super::FORMAT;
use super::layer::{Kind, Spec, Value};
use crate::splats::{BASES, logit, sigmoid, unit};
use crate::{Error, Result, Splats};

pub const TYPE: &str = "ParticleField3DGaussianSplat";
const DEGREE: &str = "radiance:sphericalHarmonicsDegree";
const COEFFICIENTS: &str = "radiance:sphericalHarmonicsCoefficients";
/// Opacity 0 and 1 read as these logits: beyond them a float is 0 or 1.
const LIMIT: f32 = 16.0;
/// What is drawn of a splat, in standard deviations: its extent.
const REACH: f32 = 3.0;

/// The prim; splats and file have the same axes.
pub fn write(splats: &Splats) -> Result<Spec> {
    splats.validate(FORMAT)?;
    if splats.positions.is_empty() {
        return Err(Error::unsupported(FORMAT, "no splats"));
    }
    let scales: Vec<[f32; 3]> = splats.log_scales.iter().map(|s| s.map(f32::exp)).collect();
    if let Some(i) = scales.iter().position(|s| !s.iter().all(|x| x.is_finite())) {
        return Err(Error::unsupported(FORMAT, format!("splat {i} is larger than a float holds")));
    }
    let turns = splats.rotations.iter().map(|&q| unit(q).unwrap_or([1.0, 0.0, 0.0, 0.0]));
    let edge = |sign: f32, pick: fn(f32, f32) -> f32| {
        let reached = splats.positions.iter().zip(&scales).map(|(p, s)| {
            let far = sign * REACH * s.iter().copied().fold(0.0, f32::max);
            p.map(|x| x + far)
        });
        reached.reduce(|a, b| std::array::from_fn(|i| pick(a[i], b[i]))).unwrap_or_default()
    };
    let extent = vec![edge(-1.0, f32::min), edge(1.0, f32::max)];
    let degree = splats.degree();
    let harmonics = splats.sh.iter().flat_map(|sh| &sh[..BASES[degree]]).copied().collect();
    let opacities = splats.logit_opacities.iter().map(|&o| sigmoid(o)).collect();
    let uniform = Spec::attribute(DEGREE, "int", Value::Int(degree as i32)).with("variability", Value::Variability(1));
    Ok(Spec::prim("Gaussians", TYPE)
        .child(Spec::attribute("extent", "float3[]", Value::Vec3fs(extent)))
        .child(Spec::attribute("opacities", "float[]", Value::Floats(opacities)))
        .child(Spec::attribute("orientations", "quatf[]", Value::Quatfs(turns.collect())))
        .child(Spec::attribute("positions", "point3f[]", Value::Vec3fs(splats.positions.clone())))
        .child(Spec::attribute(COEFFICIENTS, "float3[]", Value::Vec3fs(harmonics)))
        .child(uniform)
        .child(Spec::attribute("scales", "float3[]", Value::Vec3fs(scales))))
}

/// The splats of a prim of [`TYPE`] whose arrays are floats; what a field leaves out is what the schema says: degree 3.
///
/// # Errors
/// [`Error::Malformed`] for arrays that are missing or of other lengths; [`Error::Unsupported`] for numbers that are none.
pub fn read(spec: &Spec) -> Result<Splats> {
    let wrong = |expected: String, found: &str| Err(Error::malformed(FORMAT, 0, expected, found));
    let missing = |what: &str| wrong(format!("floats for {what} of {}", spec.name), "none");
    let Some(Value::Vec3fs(positions)) = spec.value("positions") else { return missing("positions") };
    let Some(Value::Vec3fs(scales)) = spec.value("scales") else { return missing("scales") };
    let Some(Value::Quatfs(rotations)) = spec.value("orientations") else { return missing("orientations") };
    let Some(Value::Floats(opacities)) = spec.value("opacities") else { return missing("opacities") };
    let Some(Value::Vec3fs(harmonics)) = spec.value(COEFFICIENTS) else { return missing(COEFFICIENTS) };
    let degree = match spec.value(DEGREE) {
        Some(Value::Int(degree)) => usize::try_from(*degree).unwrap_or(usize::MAX),
        _ => 3,
    };
    let Some(&bases) = BASES.get(degree) else { return wrong("harmonics of degree 0 to 3".into(), "others") };
    let count = positions.len();
    let lengths = [scales.len(), rotations.len(), opacities.len(), harmonics.len() / bases];
    if lengths != [count; 4] || harmonics.len() % bases != 0 {
        return wrong(format!("arrays for {count} splats"), &format!("{lengths:?}"));
    }
    let sh = harmonics.chunks_exact(bases).map(|row| {
        let mut sh = [[0.0; 3]; 16];
        sh[..bases].copy_from_slice(row);
        sh
    });
    let splats = Splats {
        positions: positions.clone(),
        // Flat splats are as thin as a float can tell.
        log_scales: scales.iter().map(|s| s.map(|x| x.max(f32::MIN_POSITIVE).ln())).collect(),
        rotations: rotations.clone(),
        logit_opacities: opacities.iter().map(|&o| logit(o.clamp(0.0, 1.0), LIMIT)).collect(),
        sh: sh.collect(),
    };
    splats.validate(FORMAT)?;
    Ok(splats)
}

/// Whether a prim is a field of Gaussians.
pub fn is_field(spec: &Spec) -> bool {
    spec.kind == Kind::Prim && spec.type_name() == TYPE
}
