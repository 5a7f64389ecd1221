//! Splats as `KHR_gaussian_splatting`: points with attributes of their own.
//!
//! Scales are metres and opacities 0..1 in the file, both without the logarithms of training; rotations have w last.

use std::collections::BTreeMap;
use std::sync::atomic::{AtomicBool, Ordering};

use serde_json::{Map, Value, json};

use super::accessors::Accessors;
use super::write::Buffer;
use super::{FORMAT, SPLATTING};
use crate::splats::{BASES, logit, sigmoid, unit, whole};
use crate::{Error, Result, Splats, threads};

/// Y_0^0 = 1 / (2 √π).
const SH_C0: f32 = 0.282_094_8;
/// Opacity 0 and 1 read as these logits: beyond them a float is 0 or 1.
const LIMIT: f32 = 16.0;
/// Splats that are read together, so that their harmonics, which come column by column, stay in the nearest cache.
const BLOCK: usize = 128;

/// `SH_DEGREE_1_COEF_2` of the basis 3: degree 1 has the bases 1 to 3.
fn sh_name(basis: usize) -> String {
    let degree = BASES.iter().position(|&b| basis < b).unwrap_or(3);
    let first = if degree == 0 { 0 } else { BASES[degree - 1] };
    format!("{SPLATTING}:SH_DEGREE_{degree}_COEF_{}", basis - first)
}

/// Adds the attributes to the buffer; the primitive.
pub fn write(splats: &Splats, out: &mut Buffer) -> Result<Value> {
    splats.validate(FORMAT)?;
    if splats.positions.is_empty() {
        return Err(Error::unsupported(FORMAT, "no splats"));
    }
    let mut attributes = Map::new();
    let mut put = |name: String, accessor: usize| attributes.insert(name, accessor.into());
    put("POSITION".into(), out.floats(&splats.positions, true));
    let opacities: Vec<f32> = splats.logit_opacities.iter().map(|&o| sigmoid(o)).collect();
    // What a reader without the extension shows: points in the splats' own colours.
    let byte = |x: f32| (x.clamp(0.0, 1.0) * 255.0 + 0.5) as u8;
    let color = |(sh, &o): (&[[f32; 3]; 16], &f32)| {
        let [r, g, b] = sh[0].map(|c| byte(c * SH_C0 + 0.5));
        [r, g, b, byte(o)]
    };
    let colors: Vec<u8> = splats.sh.iter().zip(&opacities).flat_map(color).collect();
    let view = out.view(&colors, Some(34962));
    out.accessors.push(json!({
        "bufferView": view, "componentType": 5121, "normalized": true, "count": opacities.len(), "type": "VEC4",
    }));
    put("COLOR_0".into(), out.accessors.len() - 1);
    let rotations: Vec<[f32; 4]> = splats
        .rotations
        .iter()
        .map(|&q| unit(q).unwrap_or([1.0, 0.0, 0.0, 0.0]))
        .map(|[w, x, y, z]| [x, y, z, w])
        .collect();
    put(format!("{SPLATTING}:ROTATION"), out.floats(&rotations, false));
    let scales: Vec<[f32; 3]> = splats.log_scales.iter().map(|s| s.map(f32::exp)).collect();
    if let Some(i) = scales.iter().position(|s| !s.iter().all(|x| x.is_finite())) {
        return Err(Error::unsupported(FORMAT, format!("splat {i} is larger than a float holds")));
    }
    put(format!("{SPLATTING}:SCALE"), out.floats(&scales, false));
    let opacities: Vec<[f32; 1]> = opacities.into_iter().map(|o| [o]).collect();
    put(format!("{SPLATTING}:OPACITY"), out.floats(&opacities, false));
    for basis in 0..BASES[splats.degree()] {
        let column: Vec<[f32; 3]> = splats.sh.iter().map(|sh| sh[basis]).collect();
        put(sh_name(basis), out.floats(&column, false));
    }
    Ok(json!({
        "mode": 0,
        "attributes": attributes,
        "extensions": { SPLATTING: {
            "kernel": "ellipse",
            "colorSpace": "srgb_rec709_display",
            "projection": "perspective",
            "sortingMethod": "cameraDistance",
        } },
    }))
}

/// Reads a primitive's attributes.
pub fn read(attributes: &BTreeMap<String, usize>, accessors: &Accessors) -> Result<Splats> {
    let column = |name: &str| match attributes.get(name) {
        Some(&accessor) => Ok(accessor),
        None => Err(Error::malformed(FORMAT, 0, format!("the attribute {name} of splats"), "none")),
    };
    let own = |name: &str| column(&format!("{SPLATTING}:{name}"));
    let positions = accessors.rows(column("POSITION")?, 3)?;
    let rotations = accessors.rows(own("ROTATION")?, 4)?;
    let scales = accessors.rows(own("SCALE")?, 3)?;
    let opacities = accessors.rows(own("OPACITY")?, 1)?;
    let mut bases = Vec::new();
    for basis in 0..16 {
        let name = sh_name(basis);
        let Some(&accessor) = attributes.get(&name) else {
            column(if basis == 0 { &name } else { "POSITION" })?;
            break;
        };
        bases.push(accessors.rows(accessor, 3)?);
    }
    for rows in [&rotations, &scales, &opacities].into_iter().chain(&bases) {
        same(rows.count, positions.count)?;
    }
    let finite = AtomicBool::new(true);
    let splats = threads::splats(positions.count, |part| {
        let mut all = true;
        for start in (0..part.positions.len()).step_by(BLOCK) {
            let block = start..(start + BLOCK).min(part.positions.len());
            for i in block.clone() {
                let at = part.first + i;
                part.positions[i] = positions.row(at);
                let ([x, y, z, w], scale, [opacity]) = (rotations.row(at), scales.row::<3>(at), opacities.row(at));
                all &= whole(&scale) & opacity.is_finite();
                part.rotations[i] = [w, x, y, z];
                part.log_scales[i] = scale.map(|x| x.max(f32::MIN_POSITIVE).ln());
                part.logit_opacities[i] = logit(opacity, LIMIT);
            }
            for (basis, rows) in bases.iter().enumerate() {
                for i in block.clone() {
                    part.sh[i][basis] = rows.row(part.first + i);
                }
            }
            all &= whole(part.positions[block.clone()].as_flattened())
                & whole(part.rotations[block.clone()].as_flattened())
                & whole(part.sh[block].as_flattened().as_flattened());
        }
        if !all {
            finite.store(false, Ordering::Relaxed);
        }
    });
    if !finite.into_inner() {
        return Err(Error::malformed(FORMAT, 0, "finite numbers in the attributes of splats", "others"));
    }
    Ok(splats)
}

fn same(found: usize, expected: usize) -> Result<()> {
    if found == expected {
        return Ok(());
    }
    Err(Error::malformed(FORMAT, 0, format!("{expected} values of each attribute"), found.to_string()))
}
