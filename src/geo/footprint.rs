//! The outline of a placed model on the ground.
//!
//! The hull is taken in the local frame, where it is exact: over a model's few metres the ellipsoid is a plane to
//! nanometres, while a hull of degrees would break at the antimeridian and the poles.

use geographiclib_rs::{Geodesic, PolygonArea, Winding};

use super::{Geodetic, Placement, convex_hull};

/// A ring on the ellipsoid.
#[derive(Clone, Debug, PartialEq)]
pub struct Footprint {
    /// Counter-clockwise seen from above, the first corner not repeated.
    pub corners: Vec<Geodetic>,
    /// On the ellipsoid, square metres and metres (Karney 2013).
    pub area: f64,
    pub perimeter: f64,
}

/// Of points in the subject frame, metres; the height of the corners is the ground's.
pub fn of(points: impl Iterator<Item = [f64; 3]>, placement: &Placement) -> Footprint {
    let hull = convex_hull(points.map(|[x, y, _]| [x, y]).collect());
    let corners: Vec<Geodetic> = hull.iter().map(|&[x, y]| placement.to_geodetic([x, y, 0.0])).collect();
    let wgs84 = Geodesic::wgs84();
    let mut polygon = PolygonArea::new(&wgs84, Winding::CounterClockwise);
    corners.iter().for_each(|c| polygon.add_point(c.latitude, c.longitude));
    let (perimeter, area, _) = polygon.compute(true);
    Footprint { corners, area, perimeter }
}

impl Footprint {
    /// Points for sampling terrain, degrees: an even grid inside the outline, and its corners.
    pub fn samples(&self) -> Vec<(f64, f64)> {
        const ACROSS: usize = 16;
        let Some(first) = self.corners.first() else { return Vec::new() };
        let flat = |c: &Geodetic| {
            let e = first.local(c.to_ecef());
            [e.east, e.north]
        };
        let ring: Vec<[f64; 2]> = self.corners.iter().map(flat).collect();
        let (mut low, mut high) = (ring[0], ring[0]);
        for p in &ring {
            low = [low[0].min(p[0]), low[1].min(p[1])];
            high = [high[0].max(p[0]), high[1].max(p[1])];
        }
        let inside = |p: [f64; 2]| {
            (0..ring.len()).all(|i| {
                let (a, b) = (ring[i], ring[(i + 1) % ring.len()]);
                (b[0] - a[0]) * (p[1] - a[1]) >= (b[1] - a[1]) * (p[0] - a[0])
            })
        };
        let at = |i: usize, axis: usize| low[axis] + (high[axis] - low[axis]) * (i as f64 + 0.5) / ACROSS as f64;
        let grid = (0..ACROSS * ACROSS).map(|i| [at(i % ACROSS, 0), at(i / ACROSS, 1)]).filter(|p| inside(*p));
        grid.chain(ring.iter().copied())
            .map(|[east, north]| first.offset(super::Enu { east, north, up: 0.0 }))
            .map(|g| (g.latitude, g.longitude))
            .collect()
    }

    /// Rings of longitude and latitude, closed, cut at the antimeridian (RFC 7946, section 3.1.9).
    pub fn rings(&self) -> Vec<Vec<[f64; 2]>> {
        let mut ring: Vec<[f64; 2]> = self.corners.iter().map(|c| [c.longitude, c.latitude]).collect();
        // Unrolled: each corner within half a turn of the one before.
        for i in 1..ring.len() {
            ring[i][0] = ring[i - 1][0] + super::normalised_longitude(ring[i][0] - ring[i - 1][0]);
        }
        let (low, high) = ring.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), p| (l.min(p[0]), h.max(p[0])));
        let pieces = if high > 180.0 {
            vec![clip(&ring, 180.0, true, 0.0), clip(&ring, 180.0, false, -360.0)]
        } else if low < -180.0 {
            vec![clip(&ring, -180.0, false, 0.0), clip(&ring, -180.0, true, 360.0)]
        } else {
            vec![ring]
        };
        let close = |mut r: Vec<[f64; 2]>| {
            r.extend(r.first().copied());
            r
        };
        pieces.into_iter().filter(|r| r.len() >= 3).map(close).collect()
    }
}

/// What of a convex ring lies west (or east) of a meridian, moved by `shift` degrees (Sutherland and Hodgman 1974).
fn clip(ring: &[[f64; 2]], at: f64, west: bool, shift: f64) -> Vec<[f64; 2]> {
    let inside = |p: [f64; 2]| if west { p[0] <= at } else { p[0] >= at };
    let mut out = Vec::new();
    for (i, &a) in ring.iter().enumerate() {
        let b = ring[(i + 1) % ring.len()];
        if inside(a) {
            out.push([a[0] + shift, a[1]]);
        }
        if inside(a) != inside(b) {
            let t = (at - a[0]) / (b[0] - a[0]);
            out.push([at + shift, a[1] + t * (b[1] - a[1])]);
        }
    }
    out
}

/// Shortest line on the ellipsoid (Karney 2013): metres, bearing at the start and at the end, degrees from north.
pub fn geodesic(a: (f64, f64), b: (f64, f64)) -> (f64, f64, f64) {
    use geographiclib_rs::InverseGeodesic;
    let (metres, start, end, _): (f64, f64, f64, f64) = Geodesic::wgs84().inverse(a.0, a.1, b.0, b.1);
    (metres, start.rem_euclid(360.0), end.rem_euclid(360.0))
}

#[cfg(test)]
mod tests {
    use super::super::HeadingSource;
    use super::*;

    fn square(latitude: f64, longitude: f64, heading: f64) -> Footprint {
        let origin = Geodetic { latitude, longitude, height: 0.0 };
        let placement = Placement { origin, heading, heading_source: HeadingSource::Given };
        let corners = [[-10.0, -5.0, 0.0], [10.0, -5.0, 1.0], [10.0, 5.0, 2.0], [-10.0, 5.0, 0.0], [0.0, 0.0, 9.0]];
        of(corners.into_iter(), &placement)
    }

    #[test]
    fn a_rectangle_keeps_its_area_anywhere() {
        for (lat, lon) in [(0.0, 0.0), (34.5, -118.5), (-60.0, 179.999_99), (89.9999, 10.0), (0.0, -180.0)] {
            for heading in [0.0, 33.0, 200.0] {
                let f = square(lat, lon, heading);
                assert_eq!(f.corners.len(), 4);
                assert!((f.area - 200.0).abs() < 5e-2 && (f.perimeter - 60.0).abs() < 1e-3, "{lat} {lon}: {f:?}");
                let samples = f.samples().len();
                assert!((90..=260).contains(&samples), "{samples}");
            }
        }
    }

    #[test]
    fn rings_are_cut_at_the_antimeridian() {
        assert_eq!(square(34.5, -118.5, 10.0).rings().len(), 1);
        for lon in [179.999_99, -179.999_99, 180.0] {
            let rings = square(-60.0, lon, 30.0).rings();
            assert_eq!(rings.len(), 2, "{lon}");
            for ring in rings {
                assert_eq!(ring.first(), ring.last());
                assert!(ring.iter().all(|p| (-180.0..=180.0).contains(&p[0])));
                let east = ring.iter().filter(|p| p[0] > 0.0).count();
                assert!(east == 0 || east == ring.len(), "{ring:?}");
            }
        }
    }

    /// `echo 34.5523 -118.4712 51.5 -0.12 | GeodSolve -i -p 6` (GeographicLib 2.1.2).
    #[test]
    fn distances_of_geographiclib() {
        let (metres, start, end) = geodesic((34.5523, -118.4712), (51.5, -0.12));
        assert!((metres - GEODSOLVE.0).abs() < 1e-6, "{metres}");
        assert!((start - GEODSOLVE.1).abs() < 1e-9 && (end - GEODSOLVE.2).abs() < 1e-9, "{start} {end}");
    }

    const GEODSOLVE: (f64, f64, f64) = (8_743_333.359_385, 34.008_305_108_40, 132.330_841_351_60);
}
