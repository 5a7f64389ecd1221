//! Ground told from what stands on it, where the truth is known.

use super::BRIEF;
use crate::bench::make::photos::written_world;
use crate::bench::make::site;
use crate::pipeline::scene::ground::{Filter, separated};

#[test]
fn the_ground_of_a_made_place_is_found() {
    let s = &*BRIEF;
    let near = s.gaussians.len() - s.sky;
    let (terrain, ground) = separated(&s.gaussians, near, &Filter::default()).unwrap();
    // Where Gaussians are in the place's own metres: its ground is Z = 0.
    let (own, back) = (written_world().inverse(), s.to_unit.inverse());
    let boxes = site::boxes(0, super::PLAIN.seed);
    let (mut both, mut either, mut wrong, mut objects) = (0u32, 0u32, 0u32, 0u32);
    for i in (0..near).filter(|i| s.gaussians.logit_opacities[*i] > 0.0) {
        let p = s.gaussians.positions[i];
        let m = own.apply(back.apply(p.as_dvec3()));
        let within = boxes.iter().any(|(low, high)| {
            (0..2).all(|k| m[k] > f64::from(low[k]) - 0.2 && m[k] < f64::from(high[k]) + 0.2)
                && m.z < f64::from(high.z) + 0.5
        });
        // On the ground; on something; or in the air, where nothing is.
        let known = match (m.z.abs() < 0.3, within && m.z > 0.3) {
            _ if p.truncate().length() > 1.0 => continue,
            (true, _) => true,
            (_, true) => false,
            _ => continue,
        };
        both += u32::from(ground[i] && known);
        either += u32::from(ground[i] || known);
        objects += u32::from(!known);
        wrong += u32::from(ground[i] && !known);
    }
    let iou = f64::from(both) / f64::from(either);
    eprintln!("IoU of ground {iou:.4}; {wrong} of {objects} taken for ground");
    assert!(iou > 0.9 && 5 * wrong < objects, "{iou} {wrong} {objects}");
    // Its heights, metres, below what the cameras look at.
    let off = |k: usize| {
        let (x, y) = ((k % 5) as f32 * 0.3 - 0.6, (k / 5) as f32 * 0.3 - 0.6);
        own.apply(back.apply(glam::Vec3::new(x, y, terrain.height(x, y)).as_dvec3())).z.abs()
    };
    let mut all: Vec<f64> = (0..25).map(off).collect();
    all.sort_by(f64::total_cmp);
    eprintln!("heights off by {:.2} m in the median, {:.2} m at most", all[12], all[24]);
    assert!(all[12] < 0.5 && all[24] < 1.5, "{all:?}");
}
