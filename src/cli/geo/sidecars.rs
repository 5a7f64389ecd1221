//! The sidecars of a published model.

use super::place::{Placed, outline};
use crate::Result;
use crate::audit::{Marking, Publication};
use crate::geo::sidecar::{self, Asset, Georeference};
use crate::pipeline::Reconstruction;

/// Writes all of them; call it last, for the catalogue entry lists what is there.
///
/// # Errors
/// As [`Publication::add`].
pub fn publish(
    publication: &mut Publication,
    stem: &str,
    marking: Marking,
    utc: &str,
    placed: &Placed,
    done: &Reconstruction,
) -> Result<()> {
    let (low, high) = done.model.levels[0].mesh.bounds();
    // A store is one asset, not its thousand tiles.
    let single = publication.outputs().filter(|(path, _, _)| !path.contains('/') && !path.contains(':'));
    let assets = single
        .map(|(path, media_type, role)| Asset { path: path.into(), media_type: media_type.into(), role: role.into() })
        .collect();
    let georeference = Georeference {
        name: stem.to_owned(),
        banner: marking.banner().to_owned(),
        utc: utc.to_owned(),
        placement: placed.placement,
        uncertainty: placed.uncertainty,
        footprint: outline(done, &placed.to_metres, &placed.placement),
        size: ((high - low) * placed.to_metres.scale).as_dvec3().to_array(),
        lineage: placed.lineage.clone(),
        assets,
    };
    for file in sidecar::all(&georeference) {
        publication.add(&file.path, &file.bytes, file.media_type, "metadata")?;
    }
    Ok(())
}
