//! The attributes of a man-made point feature, as columns and as values.
//!
//! Source: OGC CDB 1.x Volume 1, "CDB attributes" and the allocation table of GSFeature man-made points.

use super::dbf::{Column, Value};
use super::model::{Kind, Model, Prepared};
use super::names::{self, Dataset, GS_FEATURE, GT_FEATURE};

/// An attribute of the instance table, the class table, or both.
#[derive(Debug, PartialEq)]
pub struct Attribute {
    pub name: &'static str,
    kind: u8,
    width: u8,
    decimals: u8,
    pub instance: bool,
    pub class: bool,
    /// Added to a table that lacks it; the others are written where a column is there.
    pub needed: bool,
    /// What the older features of a table get in an added column: the default, where blank would be read as another.
    older: Option<Older>,
}

#[derive(Debug, PartialEq)]
enum Older {
    False,
    Zero,
}

impl Attribute {
    pub fn column(&self) -> Column {
        Column::new(self.name, self.kind, self.width, self.decimals)
    }

    pub fn older(&self) -> Option<Value> {
        self.older.as_ref().map(|o| match o {
            Older::False => Value::Logical(false),
            Older::Zero => Value::Number(0.0),
        })
    }
}

const fn text(name: &'static str, width: u8) -> Attribute {
    Attribute { name, kind: b'C', width, decimals: 0, instance: true, class: true, needed: true, older: None }
}

const fn number(name: &'static str, width: u8, decimals: u8) -> Attribute {
    Attribute { name, kind: b'N', width, decimals, instance: true, class: true, needed: true, older: None }
}

impl Attribute {
    const fn instance_only(self) -> Attribute {
        Attribute { class: false, ..self }
    }

    const fn optional(self) -> Attribute {
        Attribute { needed: false, ..self }
    }

    const fn or(self, older: Older) -> Attribute {
        Attribute { older: Some(older), ..self }
    }
}

/// The tables of one kind of point feature.
#[derive(Debug, PartialEq)]
pub struct Layer {
    pub dataset: Dataset,
    /// Component selector 1.
    pub selector: u16,
    pub attributes: &'static [Attribute],
}

/// Man-made points that have models of their own.
pub static GEOSPECIFIC: Layer = Layer { dataset: GS_FEATURE, selector: 1, attributes: &MAN_MADE };
/// Man-made points that share models of a library.
pub static GEOTYPICAL: Layer = Layer { dataset: GT_FEATURE, selector: 1, attributes: &MAN_MADE };
/// Where moving models stand at the beginning.
pub static MOVING: Layer = Layer { dataset: GT_FEATURE, selector: 3, attributes: &MOVING_MODEL };

impl Layer {
    pub fn all() -> [&'static Layer; 3] {
        [&GEOSPECIFIC, &GEOTYPICAL, &MOVING]
    }

    pub fn of(kind: &Kind) -> &'static Layer {
        match kind {
            Kind::Geospecific => &GEOSPECIFIC,
            Kind::Geotypical => &GEOTYPICAL,
            Kind::Moving(_) => &MOVING,
        }
    }

    /// Points with their instance attributes.
    pub fn points(&self) -> (u16, u16) {
        (self.selector, 1)
    }

    /// Class attributes.
    pub fn classes(&self) -> (u16, u16) {
        (self.selector, 2)
    }

    /// Extended attributes.
    pub fn extended(&self) -> (u16, u16) {
        (self.selector, 16)
    }

    /// The attribute that names the model.
    pub fn model_name(&self) -> &'static str {
        if self.selector == MOVING.selector { "MMDC" } else { "MODL" }
    }
}

/// The columns in the order of a new table. FACC, FSC, MODL and the sizes stand in both tables, because clients differ in
/// which of the two they ask; MLOD, which changes from tile to tile, only in the instance's, so that a class has the same
/// attributes in all tiles.
static MAN_MADE: [Attribute; 22] = [
    text("CNAM", 32),
    Attribute { kind: b'L', width: 1, ..text("AHGT", 1) }.instance_only().or(Older::False),
    number("AO1", 7, 3).instance_only().or(Older::Zero),
    number("BBH", 9, 3).optional(),
    number("BBL", 9, 3).optional(),
    number("BBW", 9, 3).optional(),
    number("BSR", 9, 3),
    number("CMIX", 6, 0),
    number("DEP", 9, 3).optional(),
    text("FACC", 5),
    number("FSC", 3, 0),
    number("HGT", 7, 2),
    text("LNAM", 32).optional(),
    number("MLOD", 3, 0).instance_only(),
    text("MODL", 32),
    text("MODT", 1).optional(),
    number("RTAI", 3, 0).instance_only(),
    number("SCALx", 9, 5).instance_only().optional(),
    number("SCALy", 9, 5).instance_only().optional(),
    number("SCALz", 9, 5).instance_only().optional(),
    number("SSC", 3, 0).optional(),
    number("SSR", 3, 0).optional(),
];

/// The columns of moving model locations.
static MOVING_MODEL: [Attribute; 14] = [
    text("CNAM", 32),
    Attribute { kind: b'L', width: 1, ..text("AHGT", 1) }.instance_only().or(Older::False),
    number("AO1", 7, 3).instance_only().or(Older::Zero),
    number("BBH", 9, 3).optional(),
    number("BBL", 9, 3).optional(),
    number("BBW", 9, 3).optional(),
    number("BSR", 9, 3),
    number("DEP", 9, 3).optional(),
    text("FACC", 5),
    number("FSC", 3, 0),
    number("HGT", 7, 2),
    text("LNAM", 32).instance_only().optional(),
    text("MMDC", 29),
    number("RTAI", 3, 0).instance_only(),
];

/// CNAM: moving models have no other name than their code.
pub fn class_name(model: &Model, model_name: &str) -> String {
    match model.kind {
        Kind::Moving(_) => model_name.into(),
        _ => names::class_name(&model.facc, model.fsc, model_name),
    }
}

/// The value of an attribute for a model; `model_name` is its MODL or MMDC, `material` its index in the geocell's table, `lod` the
/// level of detail that the tile shows.
pub fn value(name: &str, model: &Model, prepared: &Prepared, model_name: &str, material: u32, lod: i8) -> Value {
    let size = &prepared.size;
    // Up, so that the stored sphere encloses the model.
    let up = |v: f64| (v * 1000.0 - 1e-6).ceil().max(0.0) / 1000.0;
    match name {
        "CNAM" => Value::Text(class_name(model, model_name)),
        // True: Z is the height above the ellipsoid. The place of the model was given so; a height above terrain would
        // need the terrain of the client.
        "AHGT" => Value::Logical(true),
        "AO1" => Value::Number(prepared.heading),
        "BBH" => Value::Number(up(size.height)),
        "BBL" => Value::Number(up(size.length)),
        "BBW" => Value::Number(up(size.width)),
        "BSR" => Value::Number(up(size.sphere)),
        "CMIX" => Value::Number(f64::from(material)),
        "DEP" => Value::Number(up(size.depth)),
        "FACC" => Value::Text(model.facc.clone()),
        "FSC" => Value::Number(f64::from(model.fsc)),
        "HGT" => Value::Number(size.height.max(0.0)),
        "LNAM" => Value::Text(prepared.name.clone()),
        "MLOD" => Value::Number(f64::from(lod)),
        "MODL" | "MMDC" => Value::Text(model_name.into()),
        "MODT" => Value::Text(if model.kind == Kind::Geospecific { "S" } else { "T" }.into()),
        // Relative tactical importance has no default and nothing measures it: the middle, assumed.
        "RTAI" => Value::Number(50.0),
        "SCALx" | "SCALy" | "SCALz" => Value::Number(1.0),
        // Structure and roof shape: 0 is unknown.
        _ => Value::Number(0.0),
    }
}
