//! The archive entries of a model: geometry, descriptors, textures in both layouts.
//!
//! Textures are filed twice. By texel size, as the standard has it: each mip in the archive of its own LOD. And beside the
//! geometry, one file a level, which that level's palette names: clients exist that open only the texture archive of the
//! geometry's own tile.

use std::collections::BTreeMap;

use super::archive::{self, Archive};
use super::descriptor::{self, Identification, TextureEntry};
use super::geocell::Tile;
use super::lod;
use super::model::{Kind, Model, Prepared};
use super::names::{self, Dataset, GS_MODEL_DESCRIPTOR, GS_MODEL_GEOMETRY, GS_MODEL_TEXTURE};
use super::store::{self, Store};
use super::xml;
use crate::{Error, Result, openflight, sgi};

/// GSModel archives have one component.
pub const SELECTOR: (u16, u16) = (1, 1);
/// Volume 7's advice for one geometry file.
const GEOMETRY_ADVICE: usize = 4_000_000;
/// Larger side of the texture beside the coarsest geometry; it doubles with every finer level, and the finest has its
/// whole texture. A coarse tile holds many models in one archive, so what it shows from afar must be small.
const COARSEST_SIDE: u32 = 128;
/// The smallest side that a texture beside its geometry is cut to when the archive is nearly full.
const SMALLEST_SIDE: u32 = 32;
/// A switch-in distance beyond any view: CDB clients switch by significant size.
pub const FAR: f64 = 1e7;

/// The key of an archive.
pub type Place = (u16, Tile);

/// The archives that a model touches, as they are now.
pub struct Archives {
    map: BTreeMap<Place, Archive>,
}

/// The entries of a model under one name.
pub struct Entries {
    pub map: BTreeMap<Place, Vec<(String, Vec<u8>)>>,
    pub notes: Vec<String>,
}

/// The name of a model's entry in an archive.
pub fn entry_name(tile: Tile, dataset: Dataset, code: &str, model_name: &str, extension: &str) -> String {
    format!("{}_{code}_{model_name}.{extension}", names::base(tile, dataset, SELECTOR))
}

/// The name of a texture's entry.
pub fn texture_entry_name(tile: Tile, texture_name: &str) -> String {
    format!("{}_{texture_name}.rgb", names::base(tile, GS_MODEL_TEXTURE, SELECTOR))
}

impl Archives {
    /// Reads the archives at a model's place, of all its LODs and of its textures'.
    ///
    /// # Errors
    /// When one of them cannot be read or kept.
    pub fn read(store: &dyn Store, model: &Model, prepared: &Prepared) -> Result<Archives> {
        let mut map = BTreeMap::new();
        for level in &prepared.levels {
            for dataset in [GS_MODEL_GEOMETRY, GS_MODEL_DESCRIPTOR, GS_MODEL_TEXTURE] {
                map.insert((dataset.code, level.tile), Archive::default());
            }
            for (lod, _) in level.texture.filed() {
                let tile = Tile::containing(model.latitude, model.longitude, lod)?;
                map.insert((GS_MODEL_TEXTURE.code, tile), Archive::default());
            }
        }
        for (place, archive) in &mut map {
            let path = path(place);
            if let Some(bytes) = store::read(store, &path)? {
                *archive = Archive::read(bytes, &path)?;
            }
        }
        Ok(Archives { map })
    }

    /// Whether any entry of these names is there.
    pub fn collide(&self, entries: &Entries) -> bool {
        entries.map.iter().any(|(place, new)| new.iter().any(|(name, _)| self.map[place].contains(name)))
    }

    /// Whether every geometry and descriptor entry is there, byte for byte.
    pub fn hold(&self, entries: &Entries) -> bool {
        let models = entries.map.iter().filter(|((code, _), _)| *code != GS_MODEL_TEXTURE.code);
        models.into_iter().all(|(place, new)| new.iter().all(|(n, b)| self.map[place].get(n).as_ref() == Some(b)))
    }

    /// The archives with the entries: paths and bytes.
    ///
    /// # Errors
    /// When an archive would exceed the limit.
    pub fn with(&self, entries: &Entries, marking: &str) -> Result<Vec<(String, Vec<u8>)>> {
        let grown = entries.map.iter().map(|(place, new)| {
            let path = path(place);
            self.map[place].with(new, marking, &path).map(|bytes| (path, bytes))
        });
        grown.collect()
    }

    fn length(&self, place: &Place) -> usize {
        self.map.get(place).map_or(0, Archive::length)
    }
}

fn path(&(code, tile): &Place) -> String {
    let dataset = names::DATASETS.into_iter().find(|d| d.code == code).unwrap_or(GS_MODEL_GEOMETRY);
    names::path(tile, dataset, SELECTOR, "zip")
}

impl Entries {
    /// The entries of a model called `name`.
    ///
    /// # Errors
    /// When a level has too many vertices for its LOD, or its texture fits no archive.
    pub fn build(model: &Model, prepared: &Prepared, archives: &Archives, name: &str) -> Result<Entries> {
        let mut entries = Entries { map: BTreeMap::new(), notes: Vec::new() };
        for (i, level) in prepared.levels.iter().enumerate() {
            for (lod, mip) in level.texture.filed() {
                let tile = Tile::containing(model.latitude, model.longitude, lod)?;
                let file = texture_entry_name(tile, &names::texture_name(name, i));
                entries.push((GS_MODEL_TEXTURE.code, tile), file, sgi::write(mip, &image_name(&model.marking), false)?);
            }
        }
        for (i, level) in prepared.levels.iter().enumerate() {
            let side = entries.push_tile_texture(model, prepared, archives, name, i)?;
            entries.push_geometry(model, prepared, name, i)?;
            let (image, resolution) = level.texture.within(side);
            let power = super::texture::log2(image);
            let textures = [
                TextureEntry {
                    name: names::texture_name(name, i),
                    mipmap: level.texture.mipmap(),
                    resolution: level.texture.resolution,
                },
                TextureEntry { name: names::tile_texture_name(name, i), mipmap: (power, power), resolution },
            ];
            let feature = Identification::Feature { facc: model.facc.clone(), fsc: model.fsc };
            let text = descriptor::write(name, &feature, (301, &textures), &model.material, &model.marking);
            let code = names::feature_code(&model.facc, model.fsc);
            let file = entry_name(level.tile, GS_MODEL_DESCRIPTOR, &code, name, "xml");
            entries.push((GS_MODEL_DESCRIPTOR.code, level.tile), file, text.into_bytes());
        }
        Ok(entries)
    }

    fn push(&mut self, place: Place, name: String, bytes: Vec<u8>) {
        self.map.entry(place).or_default().push((name, bytes));
    }

    /// Files a level's texture beside its geometry, as large as the archive takes, and returns the side it was cut to.
    fn push_tile_texture(
        &mut self,
        model: &Model,
        prepared: &Prepared,
        archives: &Archives,
        name: &str,
        i: usize,
    ) -> Result<u32> {
        let level = &prepared.levels[i];
        let place = (GS_MODEL_TEXTURE.code, level.tile);
        let file = texture_entry_name(level.tile, &names::tile_texture_name(name, i));
        let there = self.map.get(&place).into_iter().flatten().map(|(n, b)| Archive::cost(n, b)).sum::<usize>();
        // The end record and a longer comment.
        let used = archives.length(&place) + there + 22 + model.marking.len() + 1;
        let finest = level.placed.lod == prepared.finest();
        let wanted = if finest { super::texture::side(&level.texture.mips[0]) } else { COARSEST_SIDE << i };
        let mut side = wanted;
        loop {
            let (image, _) = level.texture.within(side);
            let bytes = sgi::write(image, &image_name(&model.marking), false)?;
            let total = used + Archive::cost(&file, &bytes);
            if total <= archive::MAX_BYTES {
                if side < wanted && level.texture.within(wanted).0.width > image.width {
                    self.notes.push(format!(
                        "The texture beside the geometry of LOD {} is cut to {} × {} texels: its archive is nearly full.",
                        level.placed.lod, image.width, image.height
                    ));
                }
                self.push(place, file, bytes);
                return Ok(side);
            }
            if side <= SMALLEST_SIDE {
                return Err(archive::too_large(&path(&place), total));
            }
            side /= 2;
        }
    }

    fn push_geometry(&mut self, model: &Model, prepared: &Prepared, name: &str, i: usize) -> Result<()> {
        let level = &prepared.levels[i];
        let texture = texture_entry_name(level.tile, &names::tile_texture_name(name, i));
        // From 300_GSModelGeometry/L07/U70 up to the geocell: three levels.
        let texture = format!(
            "../../../{}/{}/U{}/{texture}",
            GS_MODEL_TEXTURE.name,
            names::lod_folder(level.placed.lod),
            level.tile.up
        );
        let bytes = level_file(model, prepared, name, i, texture)?;
        if bytes.len() > GEOMETRY_ADVICE {
            self.notes.push(format!(
                "The geometry of LOD {} takes {} bytes, more than the {GEOMETRY_ADVICE} that the standard advises.",
                level.placed.lod,
                bytes.len()
            ));
        }
        let code = names::feature_code(&model.facc, model.fsc);
        let file = entry_name(level.tile, GS_MODEL_GEOMETRY, &code, name, "flt");
        self.push((GS_MODEL_GEOMETRY.code, level.tile), file, bytes);
        Ok(())
    }
}

/// A level in an OpenFlight file of its own, its one texture at `texture`.
///
/// # Errors
/// What the writer refuses, and more vertices than the level may have.
pub fn level_file(model: &Model, prepared: &Prepared, name: &str, i: usize, texture: String) -> Result<Vec<u8>> {
    let whole = openflight::Level { switch_in: FAR, texture: Some(0), ..level(model, prepared, name, i) };
    let bytes = openflight::write(&openflight::Model {
        // A geotypical model stands at many places, so it has none of its own.
        origin: (model.kind == Kind::Geospecific).then_some((model.latitude, model.longitude)),
        textures: vec![texture],
        levels: vec![whole],
        ..frame(model, name)
    })?;
    check_vertices(vertex_records(&bytes), &prepared.levels[i].placed, i)?;
    Ok(bytes)
}

/// The file around the levels: names, date, marking and zone.
pub fn frame(model: &Model, name: &str) -> openflight::Model {
    openflight::Model {
        name: name.into(),
        date: model.date.clone(),
        header_comment: Some(marking_element(&model.marking, &model.comment)),
        zone_comment: Some(format!("<CDB:Zone name=\"{name}\"><Material>1</Material></CDB:Zone>")),
        ..openflight::Model::default()
    }
}

/// A level as it is placed, still without texture and distances.
pub fn level(model: &Model, prepared: &Prepared, name: &str, i: usize) -> openflight::Level {
    let placed = &prepared.levels[i].placed;
    openflight::Level {
        name: format!("{name}_{}", names::lod_name(placed.lod)),
        switch_in: 0.0,
        switch_out: 0.0,
        transition: 0.0,
        significant_size: placed.significant_size,
        center: [0.0, 0.0, prepared.size.height / 2.0],
        texture: None,
        mesh: model.levels[i].mesh.clone(),
    }
}

/// Whether a level has no more vertices than Table 6-25 allows it.
pub fn check_vertices(found: usize, placed: &lod::Placed, i: usize) -> Result<()> {
    let limit = lod::max_vertices(i);
    if found <= limit {
        return Ok(());
    }
    Err(Error::Unsupported {
        format: "CDB model",
        what: format!("level {i} has {found} vertices, LOD {} takes {limit}; simplify it", placed.lod),
    })
}

/// Vertices of an OpenFlight file: records of the vertex palette (68–71) and of local vertex pools (85).
pub fn vertex_records(flt: &[u8]) -> usize {
    let (mut at, mut count) = (0, 0);
    while let Some(&[a, b, c, d]) = flt.get(at..).and_then(|rest| rest.first_chunk::<4>()) {
        let (opcode, length) = (u16::from_be_bytes([a, b]), usize::from(u16::from_be_bytes([c, d])));
        match opcode {
            68..=71 => count += 1,
            85 => {
                let n = flt.get(at + 4..at + 8).and_then(|b| b.first_chunk().copied());
                count += n.map_or(0, u32::from_be_bytes) as usize;
            }
            _ => {}
        }
        at += length.max(4);
    }
    count
}

/// The marking as an XML element of Orb's own namespace, in ASCII, for a comment record.
fn marking_element(marking: &str, text: &str) -> String {
    let ascii = |t: &str| -> String {
        let coded = |c: char| if c.is_ascii() { c.to_string() } else { format!("&#{};", c as u32) };
        xml::escape(t).replace(['\r', '\n', '\t'], " ").chars().map(coded).collect()
    };
    format!("<orb:Marking xmlns:orb=\"urn:orb:marking\" comment=\"{}\">{}</orb:Marking>", ascii(text), ascii(marking))
}

/// The marking as the name of an SGI image: printable ASCII, at most 79 bytes.
pub fn image_name(marking: &str) -> String {
    marking.chars().map(|c| if (' '..='~').contains(&c) { c } else { '?' }).take(79).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn markings_fit_their_fields() {
        let element = xml::parse(&marking_element("VS – <NUR> \"x\"", "a & b\nc")).unwrap();
        assert_eq!((element.text.as_str(), element.attribute("comment")), ("VS – <NUR> \"x\"", Some("a & b c")));
        assert!(marking_element("–", "é").is_ascii());
        assert_eq!(image_name("SECRET–"), "SECRET?");
        assert_eq!(image_name(&"x".repeat(100)).len(), 79);
    }

    #[test]
    fn vertices_are_counted_in_both_kinds_of_record() {
        let mut flt = vec![];
        for (opcode, length) in [(1u16, 8usize), (70, 64), (68, 40), (85, 12)] {
            let start = flt.len();
            flt.extend(opcode.to_be_bytes());
            flt.extend((length as u16).to_be_bytes());
            flt.resize(start + length, 0);
        }
        let n = flt.len();
        flt[n - 8..n - 4].copy_from_slice(&7u32.to_be_bytes());
        assert_eq!(vertex_records(&flt), 9);
        assert_eq!(vertex_records(&[0, 70, 0, 0]), 1, "a length of zero does not hang");
    }
}
