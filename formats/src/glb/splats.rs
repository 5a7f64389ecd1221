//! Splats as `KHR_gaussian_splatting`: points with attributes of their own.
//!
//! Scales are metres and opacities 0..1 in the file, both without the logarithms of training; rotations have w last.

use std::collections::BTreeMap;

use serde_json::{Map, Value, json};

use super::accessors::Accessors;
use super::write::Buffer;
use super::{FORMAT, SPLATTING};
use crate::splats::{BASES, logit, sigmoid, unit};
use crate::{Error, Result, Splats};

/// Y_0^0 = 1 / (2 √π).
const SH_C0: f32 = 0.282_094_8;
/// Opacity 0 and 1 read as these logits: beyond them a float is 0 or 1.
const LIMIT: f32 = 16.0;

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
    let positions: Vec<[f32; 3]> = accessors.vectors(column("POSITION")?)?;
    let rotations: Vec<[f32; 4]> = accessors.vectors(own("ROTATION")?)?;
    let scales: Vec<[f32; 3]> = accessors.vectors(own("SCALE")?)?;
    let opacities: Vec<[f32; 1]> = accessors.vectors(own("OPACITY")?)?;
    let mut sh = vec![[[0.0; 3]; 16]; positions.len()];
    for basis in 0..16 {
        let name = sh_name(basis);
        let Some(&accessor) = attributes.get(&name) else {
            column(if basis == 0 { &name } else { "POSITION" })?;
            break;
        };
        let values: Vec<[f32; 3]> = accessors.vectors(accessor)?;
        same(values.len(), positions.len())?;
        sh.iter_mut().zip(values).for_each(|(sh, rgb)| sh[basis] = rgb);
    }
    for count in [rotations.len(), scales.len(), opacities.len()] {
        same(count, positions.len())?;
    }
    Ok(Splats {
        positions,
        log_scales: scales.into_iter().map(|s| s.map(|x| x.max(f32::MIN_POSITIVE).ln())).collect(),
        rotations: rotations.into_iter().map(|[x, y, z, w]| [w, x, y, z]).collect(),
        logit_opacities: opacities.into_iter().map(|[o]| logit(o, LIMIT)).collect(),
        sh,
    })
}

fn same(found: usize, expected: usize) -> Result<()> {
    if found == expected {
        return Ok(());
    }
    Err(Error::malformed(FORMAT, 0, format!("{expected} values of each attribute"), found.to_string()))
}
