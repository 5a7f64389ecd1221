//! PC, physical correctness: whether the thing could stand there. Lengths metres, Z up; the ground is Z = 0 unless it is
//! given.

use std::collections::HashMap;

use glam::{Vec2, Vec3};

use crate::mesh::Surface;

/// How far the lowest point lies below the ground and above it, % of the height; None without a height.
pub fn ground_contact(surface: &Surface, ground: f32) -> Option<[f64; 2]> {
    let (low, high) = surface.bounds();
    let height = f64::from(high.z - low.z);
    (height > 0.0).then(|| {
        let above = 100.0 * f64::from(low.z - ground) / height;
        [(-above).max(0.0), above.max(0.0)]
    })
}

/// The share of edges that belong to exactly two triangles, vertices at one place (to 1e-5 of the diagonal) taken as one:
/// 1 for closed surfaces. None without triangles.
pub fn watertightness(surface: &Surface) -> Option<f64> {
    let (low, high) = surface.bounds();
    let cell = (high.distance(low) * 1e-5).max(f32::MIN_POSITIVE);
    let mut numbers: HashMap<[i64; 3], u32> = HashMap::new();
    let welded: Vec<u32> = surface
        .positions
        .iter()
        .map(|p| {
            let next = numbers.len() as u32;
            *numbers.entry(((*p - low) / cell).to_array().map(|v| v.round() as i64)).or_insert(next)
        })
        .collect();
    let mut edges: HashMap<[u32; 2], u32> = HashMap::new();
    for t in &surface.triangles {
        let t = t.map(|i| welded[i as usize]);
        if t[0] == t[1] || t[1] == t[2] || t[2] == t[0] {
            continue;
        }
        for (a, b) in [(t[0], t[1]), (t[1], t[2]), (t[2], t[0])] {
            *edges.entry([a.min(b), a.max(b)]).or_insert(0) += 1;
        }
    }
    (!edges.is_empty()).then(|| edges.values().filter(|n| **n == 2).count() as f64 / edges.len() as f64)
}

/// How far the longest side lies outside the class's range, metres, in octaves: 0 inside, 1 for twice or half.
pub fn plausible_scale(longest: f64, [least, most]: [f64; 2]) -> f64 {
    (longest / most).max(least / longest).max(1.0).log2()
}

/// What becomes of a body that is let go on the ground.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Standing {
    /// Angle between its up before and after it has come to rest, degrees.
    pub tilt: f64,
    /// How far it can be tilted before its centre of mass leaves its support: atan(m / h), degrees, with m the distance of
    /// the centre of mass from the support polygon's rim (negative outside) and h its height.
    pub tipping: f64,
    /// Convex parts that it was simulated as.
    pub parts: usize,
}

/// Convex hull, counter-clockwise (Andrew 1979).
fn hull(mut points: Vec<Vec2>) -> Vec<Vec2> {
    points.sort_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)));
    points.dedup();
    if points.len() < 3 {
        return points;
    }
    let mut chain: Vec<Vec2> = Vec::new();
    for pass in 0..2 {
        let start = chain.len();
        let mut one = |p: Vec2| {
            while chain.len() >= start + 2 {
                let [a, b] = [chain[chain.len() - 2], chain[chain.len() - 1]];
                if (b - a).perp_dot(p - a) > 0.0 {
                    break;
                }
                chain.pop();
            }
            chain.push(p);
        };
        if pass == 0 {
            points.iter().copied().for_each(&mut one)
        } else {
            points.iter().rev().copied().for_each(&mut one)
        }
        chain.pop();
    }
    chain
}

/// Distance of a point from the rim of the hull of points, positive inside.
fn margin(points: Vec<Vec2>, at: Vec2) -> f32 {
    let rim = hull(points);
    let n = rim.len();
    let segment = |a: Vec2, b: Vec2| {
        let t = ((at - a).dot(b - a) / (b - a).length_squared().max(1e-20)).clamp(0.0, 1.0);
        at.distance(a + t * (b - a))
    };
    let nearest = (0..n).map(|i| segment(rim[i], rim[(i + 1) % n])).fold(f32::INFINITY, f32::min);
    let inside = n >= 3 && (0..n).all(|i| (rim[(i + 1) % n] - rim[i]).perp_dot(at - rim[i]) >= 0.0);
    if inside { nearest } else { -nearest }
}

/// Vertices so far above the lowest one carry too, as a share of the height.
const CARRIES: f32 = 0.02;

/// See [`Standing::tipping`]; the centre of mass is the simulated body's.
pub fn tipping_angle(surface: &Surface, centre_of_mass: Vec3) -> Option<f64> {
    let (low, high) = surface.bounds();
    let used = surface.triangles.iter().flatten().map(|i| surface.positions[*i as usize]);
    let feet: Vec<Vec2> = used.filter(|p| p.z <= low.z + CARRIES * (high.z - low.z)).map(|p| p.truncate()).collect();
    let height = centre_of_mass.z - low.z;
    (!feet.is_empty() && height > 0.0)
        .then(|| f64::from(margin(feet, centre_of_mass.truncate()).atan2(height).to_degrees()))
}

#[cfg(feature = "physics")]
pub use simulated::stand;

/// None: this program was built without a physics engine.
#[cfg(not(feature = "physics"))]
pub fn stand(_: &Surface) -> Option<Standing> {
    None
}

#[cfg(feature = "physics")]
mod simulated {
    use rapier3d::parry::transformation::vhacd::{VHACD, VHACDParameters};
    use rapier3d::prelude::*;

    use super::{Standing, Surface, Vec3, tipping_angle};

    /// Seconds that it has to come to rest, and steps a second.
    const TIME: f32 = 4.0;
    const STEPS: f32 = 240.0;

    /// Lets a body go just above the ground, as it is turned, and waits: Rapier's rigid bodies on a plane, Coulomb friction
    /// 0.8, no restitution, even density, the shape by convex decomposition (Mamou's V-HACD at 48 voxels, 24 parts at most).
    /// The size does not matter: every body is made 2 m from corner to corner. Same surface, same answer, on every machine.
    ///
    /// None for what has no volume.
    pub fn stand(surface: &Surface) -> Option<Standing> {
        let (low, high) = surface.bounds();
        let scale = 2.0 / high.distance(low);
        let centre = (low + high) / 2.0;
        if !scale.is_finite() || (high - low).min_element() * scale < 1e-3 {
            return None;
        }
        let at = |p: &Vec3| (*p - Vec3::new(centre.x, centre.y, low.z)) * scale;
        let unit =
            Surface { positions: surface.positions.iter().map(at).collect(), triangles: surface.triangles.clone() };
        let shapes = parts(&unit);
        if shapes.is_empty() {
            return None;
        }
        let parts = shapes.len();
        let shape = SharedShape::compound(shapes);
        let mass = shape.mass_properties(1000.0);
        let tipping = tipping_angle(&unit, Vec3::from_array(mass.local_com.to_array()))?;
        let mut world = PhysicsWorld::new();
        world.gravity = Vector::new(0.0, 0.0, -9.81);
        world.integration_parameters.dt = 1.0 / STEPS;
        let plain = |shape: SharedShape| ColliderBuilder::new(shape).friction(0.8).restitution(0.0);
        world.insert(RigidBodyBuilder::fixed(), plain(SharedShape::halfspace(Vector::Z)));
        let body = RigidBodyBuilder::dynamic().translation(Vector::new(0.0, 0.0, 0.005));
        let (body, _) = world.insert(body, plain(shape).density(1000.0));
        for _ in 0..(TIME * STEPS) as usize {
            world.step();
            if world.bodies.get(body).is_none_or(RigidBody::is_sleeping) {
                break;
            }
        }
        let up = *world.bodies.get(body)?.rotation() * Vector::Z;
        let tilt = f64::from(up.x.hypot(up.y).atan2(up.z)).to_degrees();
        tilt.is_finite().then_some(Standing { tilt, tipping, parts })
    }

    fn parts(unit: &Surface) -> Vec<(Pose, SharedShape)> {
        let points: Vec<Vector> = unit.positions.iter().map(|p| Vector::from_array(p.to_array())).collect();
        let corner = |i: u32| unit.positions[i as usize];
        let has_area = |t: &&[u32; 3]| {
            let [a, b, c] = t.map(corner);
            (b - a).cross(c - a).length() > 1e-9
        };
        let triangles: Vec<[u32; 3]> = unit.triangles.iter().filter(has_area).copied().collect();
        if triangles.is_empty() {
            return Vec::new();
        }
        let parameters = VHACDParameters { resolution: 48, max_convex_hulls: 24, ..VHACDParameters::default() };
        let hulls =
            VHACD::decompose(&parameters, &points, &triangles, true).compute_exact_convex_hulls(&points, &triangles);
        let shape = |(points, triangles): (Vec<Vector>, Vec<[u32; 3]>)| SharedShape::convex_mesh(points, &triangles);
        let found: Vec<_> = hulls.into_iter().filter_map(shape).map(|s| (Pose::IDENTITY, s)).collect();
        if found.is_empty() {
            SharedShape::convex_hull(&points).map(|s| (Pose::IDENTITY, s)).into_iter().collect()
        } else {
            found
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::bench::surfaces::tests::block;

    fn standing(size: Vec3) -> Surface {
        let b = block(size);
        Surface { positions: b.positions.iter().map(|p| *p + Vec3::Z * size.z / 2.0).collect(), ..b }
    }

    #[cfg(feature = "physics")]
    fn turned(s: &Surface, degrees: f32) -> Surface {
        let turn = glam::Mat3::from_rotation_x(degrees.to_radians());
        let positions: Vec<Vec3> = s.positions.iter().map(|p| turn * *p).collect();
        let low = positions.iter().map(|p| p.z).fold(f32::INFINITY, f32::min);
        Surface { positions: positions.iter().map(|p| *p - low * Vec3::Z).collect(), triangles: s.triangles.clone() }
    }

    #[test]
    fn edges_contact_and_sizes_by_hand() {
        let b = standing(Vec3::new(2.0, 4.0, 1.0));
        assert_eq!((watertightness(&b), ground_contact(&b, 0.0)), (Some(1.0), Some([0.0, 0.0])));
        assert_eq!((ground_contact(&b, 0.25), ground_contact(&b, -0.5)), (Some([25.0, 0.0]), Some([0.0, 50.0])));
        let open = Surface { triangles: b.triangles[1..].to_vec(), ..b.clone() };
        assert_eq!(watertightness(&open), Some(15.0 / 18.0));
        // A copy of the corners for every face, as textured models have them.
        let split = Surface {
            positions: b.triangles.iter().flatten().map(|i| b.positions[*i as usize]).collect(),
            triangles: (0..12).map(|t| [3 * t, 3 * t + 1, 3 * t + 2]).collect(),
        };
        assert_eq!(watertightness(&split), Some(1.0));
        assert_eq!([3.0, 8.0, 0.5].map(|v| plausible_scale(v, [1.0, 4.0])), [0.0, 1.0, 1.0]);
        // Half as wide as its centre is high: atan(1 / 0.5) of the narrower side.
        let angle = tipping_angle(&b, Vec3::new(0.0, 0.0, 0.5)).unwrap();
        assert!((angle - (2.0f64).atan().to_degrees()).abs() < 1e-4, "{angle}");
        assert!(tipping_angle(&b, Vec3::new(3.0, 0.0, 0.5)).unwrap() < 0.0);
        assert_eq!(watertightness(&Surface::default()), None);
    }

    #[cfg(feature = "physics")]
    #[test]
    fn blocks_stand_lean_back_and_fall() {
        let b = standing(Vec3::new(1.0, 1.0, 2.0));
        let s = stand(&b).unwrap();
        assert!(s.tilt < 0.2 && (s.tipping - (0.5f64).atan().to_degrees()).abs() < 1.0, "{s:?}");
        // Tilted by 12°, less than it takes to tip: falls back onto its base.
        let s = stand(&turned(&b, 12.0)).unwrap();
        assert!((s.tilt - 12.0).abs() < 1.0 && s.tipping < 0.0, "{s:?}");
        let s = stand(&turned(&b, 35.0)).unwrap();
        assert!((s.tilt - 55.0).abs() < 2.0, "tips over onto its side: {s:?}");
        assert_eq!(stand(&turned(&b, 35.0)), stand(&turned(&b, 35.0)));
        assert_eq!(stand(&Surface::default()), None);
    }
}
