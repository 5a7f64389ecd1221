//! What the writers of self-describing formats put beside the geometry: the marking and the place on the Earth.

/// The marking and the place of a model.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Label {
    /// The marking's line, such as `CLASSIFICATION: UNCLASSIFIED`; empty for none.
    pub marking: String,
    pub place: Option<Place>,
}

/// Where the model's origin stands and how its Y axis points.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Place {
    /// WGS84 degrees.
    pub latitude: f64,
    /// WGS84 degrees.
    pub longitude: f64,
    /// Metres above the WGS84 ellipsoid.
    pub height: f64,
    /// Bearing of the model's +Y (as Orb holds it, Z up), degrees clockwise from true north.
    pub heading: f64,
}
