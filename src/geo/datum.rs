//! What a height is above.

use super::geoid;
use crate::{Error, Result};

/// `--alt-datum`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum AltDatum {
    /// The WGS84 ellipsoid: what a GNSS receiver computes, what simulators store.
    Ellipsoid,
    /// Mean sea level: the EGM96 geoid.
    Msl,
    /// The terrain at the point.
    Ground,
}

impl AltDatum {
    pub fn label(self) -> &'static str {
        match self {
            AltDatum::Ellipsoid => "ellipsoid",
            AltDatum::Msl => "msl",
            AltDatum::Ground => "ground",
        }
    }

    /// Behind "above".
    pub fn words(self) -> &'static str {
        match self {
            AltDatum::Ellipsoid => "the ellipsoid",
            AltDatum::Msl => "the sea (EGM96)",
            AltDatum::Ground => "the ground",
        }
    }
}

/// A height above the ellipsoid and its standard deviation, metres.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Height {
    pub ellipsoidal: f64,
    pub sigma: f64,
}

/// From what was written to the ellipsoid. `ground` is the terrain's ellipsoidal height there, where it is known.
///
/// # Errors
/// Heights above ground without terrain.
pub fn to_ellipsoid(
    (latitude, longitude): (f64, f64),
    height: f64,
    sigma: f64,
    datum: AltDatum,
    ground: Option<Height>,
) -> Result<Height> {
    match (datum, ground) {
        (AltDatum::Ellipsoid, _) => Ok(Height { ellipsoidal: height, sigma }),
        (AltDatum::Msl, _) => Ok(Height {
            ellipsoidal: height + geoid::undulation(latitude, longitude),
            sigma: sigma.hypot(geoid::SIGMA),
        }),
        (AltDatum::Ground, Some(ground)) => {
            Ok(Height { ellipsoidal: ground.ellipsoidal + height, sigma: sigma.hypot(ground.sigma) })
        }
        (AltDatum::Ground, None) => Err(Error::usage("--alt-datum ground")
            .expected("a terrain that the height is above")
            .found("none")
            .advice("Give --dem FILE, or a height above the ellipsoid or the sea.")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn one_height_above_three_things() {
        let at = (34.5523, -118.4712);
        let n = geoid::undulation(at.0, at.1);
        assert!((-40.0..-28.0).contains(&n), "{n}");
        let h = |d, g| to_ellipsoid(at, 740.0, 0.0, d, g).map(|h| h.ellipsoidal);
        assert_eq!(h(AltDatum::Ellipsoid, None).unwrap(), 740.0);
        assert_eq!(h(AltDatum::Msl, None).unwrap(), 740.0 + n);
        assert_eq!(h(AltDatum::Ground, Some(Height { ellipsoidal: 700.0, sigma: 1.0 })).unwrap(), 1440.0);
        assert!(h(AltDatum::Ground, None).unwrap_err().to_string().contains("--dem"));
    }
}
