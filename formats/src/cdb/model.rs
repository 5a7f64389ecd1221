//! A model: what a caller gives, checked and measured.

use super::dis::EntityType;
use super::geocell::Tile;
use super::lod::{self, Placed};
use super::material::Material;
use super::names;
use super::texture::Texture;
use crate::{Error, Image, Mesh, Result};

/// Where a model is kept, and what a store takes it for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Kind {
    /// One of its kind, in the tiles of its place (GSModel).
    #[default]
    Geospecific,
    /// One of a library, that any number of features refer to (GTModel).
    Geotypical,
    /// One that simulations move, known by its DIS entity type (MModel).
    Moving(EntityType),
}

/// A model and its place on the Earth.
#[derive(Clone, Debug, PartialEq)]
pub struct Model {
    pub kind: Kind,
    /// What the model should be called; made into a MODL.
    pub name: String,
    /// Feature code, two letters and three digits; `UA005` is any man-made object.
    pub facc: String,
    /// Feature subcode, 0–999.
    pub fsc: u16,
    /// Of the model's origin, WGS 84 degrees.
    pub latitude: f64,
    pub longitude: f64,
    /// Of the model's origin above the WGS 84 ellipsoid, metres.
    pub height: f64,
    /// Bearing of the model's +Y, degrees clockwise from true north.
    pub heading: f64,
    pub material: Material,
    /// Coarsest first.
    pub levels: Vec<Level>,
    /// The banner.
    pub marking: String,
    /// The OpenFlight header's date of last revision, at most 31 characters.
    pub date: String,
    /// Year, month, day of the tables.
    pub dbf_date: (u16, u8, u8),
    /// Free text for `Version.xml` of a new store and for the OpenFlight header.
    pub comment: String,
}

/// One level of detail.
#[derive(Clone, Debug, PartialEq)]
pub struct Level {
    /// Metres; Z up, +Y the front, Z = 0 the ground, the centre of the XY bounding rectangle at the origin.
    pub mesh: Mesh,
    /// Metres: the model's size for the coarsest level, else the largest difference to the next coarser one. Strictly
    /// decreasing.
    pub significant_size: f64,
    /// RGB, sides powers of two. Every level has its own.
    pub texture: Image,
}

/// Sizes that the feature's attributes tell, metres, over all levels.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Size {
    /// Along X.
    pub width: f64,
    /// Along Y.
    pub length: f64,
    /// Above the XY plane.
    pub height: f64,
    /// Below it.
    pub depth: f64,
    /// Of the hemisphere about the origin that holds what is above the XY plane.
    pub sphere: f64,
    /// Of the cylinder about the vertical through the origin.
    pub radius: f64,
}

impl Size {
    pub fn of<'a>(meshes: impl IntoIterator<Item = &'a Mesh>) -> Size {
        let mut size = Size::default();
        for mesh in meshes {
            let Some((lo, hi)) = mesh.bounds() else { continue };
            size.width = size.width.max(hi[0] - lo[0]);
            size.length = size.length.max(hi[1] - lo[1]);
            size.height = size.height.max(hi[2]);
            size.depth = size.depth.max(-lo[2]);
            for p in &mesh.positions {
                let radius = p[0].hypot(p[1]);
                size.radius = size.radius.max(radius);
                if p[2] >= 0.0 {
                    size.sphere = size.sphere.max(radius.hypot(p[2]));
                }
            }
        }
        size
    }

    /// The larger of two in every measure.
    pub fn max(self, o: Size) -> Size {
        Size {
            width: self.width.max(o.width),
            length: self.length.max(o.length),
            height: self.height.max(o.height),
            depth: self.depth.max(o.depth),
            sphere: self.sphere.max(o.sphere),
            radius: self.radius.max(o.radius),
        }
    }
}

/// A model that fits a CDB: its levels with their LODs, tiles and textures.
#[derive(Clone, Debug)]
pub struct Prepared {
    /// Sanitised; not yet unique.
    pub name: String,
    /// Of every level that is kept.
    pub levels: Vec<PreparedLevel>,
    pub size: Size,
    /// Degrees, 0 ≤ AO1 < 360 after rounding to thousandths.
    pub heading: f64,
    /// What the user should know.
    pub notes: Vec<String>,
}

/// One level of [`Prepared`], in the order of [`Model::levels`].
#[derive(Clone, Debug)]
pub struct PreparedLevel {
    pub placed: Placed,
    pub tile: Tile,
    pub texture: Texture,
}

impl Prepared {
    pub fn coarsest(&self) -> i8 {
        self.levels[0].placed.lod
    }

    pub fn finest(&self) -> i8 {
        self.levels[self.levels.len() - 1].placed.lod
    }
}

/// Checks a model against the content rules of CDB and measures it.
///
/// # Errors
/// [`Error::Unsupported`] naming the first rule that is broken and what was found.
pub fn prepare(model: &Model) -> Result<Prepared> {
    names::check_feature_code(&model.facc, model.fsc)?;
    let coarse = Tile::containing(model.latitude, model.longitude, -10)?;
    if !model.height.is_finite() || model.height.abs() > 1e6 {
        return refuse(format!("the height {} m above the ellipsoid is not within ±1000 km", model.height));
    }
    if !model.heading.is_finite() {
        return refuse(format!("the heading {} is no angle", model.heading));
    }
    let (year, month, day) = model.dbf_date;
    if !(1900..=2155).contains(&year) || !(1..=12).contains(&month) || !(1..=31).contains(&day) {
        return refuse(format!("the date {year}-{month}-{day} does not fit a dBASE table (1900-2155)"));
    }
    let sizes: Vec<f64> = model.levels.iter().map(|l| l.significant_size).collect();
    let mut placed = lod::place(&sizes)?;
    for (i, level) in model.levels.iter().enumerate() {
        level.mesh.validate()?;
        if level.mesh.triangles.is_empty() {
            return refuse(format!("level {i} has no triangles"));
        }
    }
    let size = Size::of(model.levels.iter().map(|l| &l.mesh));
    check_origin(&model.levels[model.levels.len() - 1].mesh)?;

    let mut notes = Vec::new();
    let tile = |lod| Tile::containing(model.latitude, model.longitude, lod);
    let overhangs = |p: &Placed| Ok(!lod::fits(tile(p.lod)?, model.latitude, size.radius));
    while let Some(finest) = placed.last().copied() {
        // Models of libraries are in no tile.
        if model.kind != Kind::Geospecific || !overhangs(&finest)? {
            break;
        }
        placed.pop();
        notes.push(format!(
            "The level for LOD {} is left out: {:.1} m around the point sticks out of that tile by more than half of it.",
            finest.lod, size.radius
        ));
    }
    if placed.is_empty() {
        return refuse(format!(
            "at latitude {} the meridians are too close: no tile of geocell {}{} takes {:.1} m around the point",
            model.latitude,
            coarse.cell.latitude_name(),
            coarse.cell.longitude_name(),
            size.radius
        ));
    }
    let size = Size::of(model.levels.iter().take(placed.len()).map(|l| &l.mesh));
    let levels = placed.into_iter().zip(&model.levels).map(|(placed, level)| {
        let texture = Texture::new(&level.mesh, &level.texture)?;
        Ok(PreparedLevel { placed, tile: tile(placed.lod)?, texture })
    });
    let heading = (model.heading.rem_euclid(360.0) * 1000.0).round() / 1000.0;
    Ok(Prepared {
        name: names::model_name(&model.name),
        levels: levels.collect::<Result<_>>()?,
        size,
        heading: if heading >= 360.0 { 0.0 } else { heading },
        notes,
    })
}

/// The origin is the centre of the XY bounding rectangle (Volume 6, Requirement 8), to a millimetre on the finest level:
/// coarser ones differ from it by their own coarseness.
fn check_origin(finest: &Mesh) -> Result<()> {
    let Some((lo, hi)) = finest.bounds() else { return refuse("the finest level has no vertices".into()) };
    let off = [0, 1].map(|a| 0.5 * (lo[a] + hi[a]));
    if off.iter().any(|o| o.abs() > 1e-3) {
        return refuse(format!(
            "the origin must be the centre of the finest level's XY bounding rectangle within 1 mm, found the centre at \
             ({:.4}, {:.4}) m; move the model and its place on the Earth",
            off[0], off[1]
        ));
    }
    Ok(())
}

fn refuse<T>(what: String) -> Result<T> {
    Err(Error::Unsupported { format: "CDB model", what })
}
