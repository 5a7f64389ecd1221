//! The sidecars of a published model.

use super::place::{Placed, outline};
use crate::Result;
use crate::audit::Publication;
use crate::export::{self, Labels};
use crate::geo::sidecar::{self, Asset, Georeference};
use crate::pipeline::Reconstruction;

/// Writes all of them, and the model as KMZ where it is wanted; call it last, for the catalogue entry lists what is there.
///
/// # Errors
/// As [`Publication::add`].
pub fn publish(
    publication: &mut Publication,
    labels: &Labels,
    placed: &Placed,
    done: &Reconstruction,
    kmz: bool,
) -> Result<()> {
    let (low, high) = done.model.levels[0].mesh.bounds();
    let mut georeference = Georeference {
        name: labels.stem.clone(),
        banner: labels.marking.banner(),
        utc: labels.utc.clone(),
        placement: placed.placement,
        uncertainty: placed.uncertainty,
        footprint: outline(done, &placed.to_metres, &placed.placement),
        size: ((high - low) * placed.to_metres.scale).as_dvec3().to_array(),
        lineage: placed.lineage.clone(),
        assets: vec![],
    };
    if kmz {
        let path = format!("models/{}.dae", labels.stem);
        let document = sidecar::kml_with_model(&georeference, &path);
        let file = export::kmz(&done.model.levels[0], &placed.to_metres, &document, labels)?;
        publication.add(&file.path, &file.bytes, file.media_type, "model")?;
    }
    // A store is one asset, not its thousand tiles.
    let single = publication.outputs().filter(|(path, _, _)| !path.contains('/') && !path.contains(':'));
    let asset = |(path, media_type, role): (&str, &str, &str)| Asset {
        path: path.into(),
        media_type: media_type.into(),
        role: role.into(),
    };
    georeference.assets = single.map(asset).collect();
    for file in sidecar::all(&georeference) {
        publication.add(&file.path, &file.bytes, file.media_type, "metadata")?;
    }
    Ok(())
}
