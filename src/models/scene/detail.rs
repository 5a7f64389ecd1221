//! The mask drawn finely: the network for details looks at the part of the photo with the subject, and at its rough mask.
//!
//! The looks at the whole scene ([`super::looks`]) need room around the subject and show it on about a hundred of their 256
//! pixels; this one shows it on three hundred of its 384, so thin and pierced parts are seen at all.

use super::looks::Canvas;
use crate::Result;
use crate::models::region::{Bounds, dilated, eroded};
use crate::models::{Graph, Port, Tensor, check_contract, take};
use crate::photo::{Edge, Plane, Rect, sample_plane};

/// Of the network's square input and outputs.
pub(super) const SIZE: usize = 384;
/// On every side of the subject's box, in its longest sides.
const ROOM: f32 = 0.15;
/// What the rough mask counts beside the fine one, away from its own edge. On 18 ray-traced photos and 27 real ones the mean IoU,
/// before colours and edges, is 0.956 and 0.860 where it counts nothing, 0.954 and 0.871 where it counts this much everywhere,
/// about 0.956 and 0.868 like this (tried with a soft border); 0.938 and 0.866 for the rough mask alone. On real photographs the fine mask sometimes leaves out a
/// whole piece of the subject that looks like nothing the network knows.
const ROUGH: f32 = 0.35;
/// How far from its edge the rough mask counts nothing, in longest sides of the subject's box.
const BAND: f32 = 0.03;
/// The lowest part of the rough mask's box, in its heights: what is beside or below it there may be ground.
const FOOT: f32 = 0.15;
/// Half the width, in longest sides of the subject's box, from which a piece is broad. Without a bound an aeroplane and a forklift lose 0.02 of IoU
/// outdoors; with 0.02 the forklift has 0.016 less, with 0.018 the pyramid of Meidum, by version 0.4, 0.04 more and the forklift as little.
const BROAD: f32 = 0.0225;
/// The shorter side of what is looked at, at least, in longer sides.
const SLENDER: f32 = 0.6;

/// # Errors
/// A contract error when the graph is not of this network.
pub(super) fn check(graph: &dyn Graph) -> Result<()> {
    let plane = &[1, 1, SIZE, SIZE];
    check_contract(
        "detail network",
        graph,
        &[Port::new("image", &[1, 4, SIZE, SIZE])],
        &[Port::new("mask", plane), Port::new("inverse_depth", plane)],
    )
}

/// What is looked at for a subject in the box `found`: pixels of a plane of `width` by `height`.
fn part(found: Bounds, width: usize, height: usize) -> Rect {
    let [x0, y0, x1, y1] = found.map(|v| v as f32);
    let room = ROOM * (x1 - x0).max(y1 - y0);
    let least = SLENDER * ((x1 - x0).max(y1 - y0) + 2.0 * room);
    let side = |low: f32, high: f32, all: usize| {
        let more = room + ((least - (high - low + 2.0 * room)) / 2.0).max(0.0);
        ((low - more).max(0.0), (high + more).min(all as f32))
    };
    let ((left, right), (top, bottom)) = (side(x0, x1, width), side(y0, y1, height));
    Rect { x: left, y: top, width: right - left, height: bottom - top }
}

/// `rough` with the part around the box `found` as the network draws it; both of the working size. Returns how many pixels of
/// it one of the network's pixels covers, too.
///
/// # Errors
/// As the graph.
pub(super) fn drawn(canvas: &Canvas, rough: &Plane, found: Bounds, graph: &dyn Graph) -> Result<(Plane, f32)> {
    let rect = part(found, rough.width, rough.height);
    let colours = canvas.colours(canvas.on_photo(rect), SIZE);
    let before = sample_plane(rough, rect, SIZE, SIZE, Edge::Clamp);
    let mut data: Vec<f32> = (0..3).flat_map(|c| colours.iter().map(move |v| v[c])).collect();
    data.extend(&before.data);
    let image = Tensor::new(&[1, 4, SIZE, SIZE], data)?;
    let mut outputs = graph.run(&[("image", &image)])?;
    let answer = Plane { width: SIZE, height: SIZE, data: take(&mut outputs, "mask", SIZE * SIZE)? };
    Ok((laid(rough, found, &answer, rect), rect.width.max(rect.height) / SIZE as f32))
}

/// `answer` over `rect` of `rough`, whose subject is in the box `found`, and both as one there beyond [`BAND`] from the edge of `rough`. Broad
/// pieces that `answer` alone has at the foot stay as `rough` has them: the network that looks closely takes stones under an animal, or the plain
/// before a pyramid, for a part of it.
fn laid(rough: &Plane, found: Bounds, answer: &Plane, rect: Rect) -> Plane {
    let (w, h) = (rough.width, rough.height);
    let size = (found[2] - found[0]).max(found[3] - found[1]) as f32;
    let pixels = |share: f32| (share * size) as usize + 1;
    let subject = |i: usize| rough.data[i] > 0.5;
    let band = pixels(BAND);
    let (around, within) = (dilated(w, h, band, subject), eroded(w, h, band, subject));
    let (sx, sy) = (answer.width as f32 / rect.width, answer.height as f32 / rect.height);
    let source =
        Rect { x: -rect.x * sx, y: -rect.y * sy, width: rough.width as f32 * sx, height: rough.height as f32 * sy };
    let over = sample_plane(answer, source, rough.width, rough.height, Edge::Clamp);
    let inside = |i: usize| {
        let (x, y) = ((i % rough.width) as f32 + 0.5, (i / rough.width) as f32 + 0.5);
        (rect.x..=rect.x + rect.width).contains(&x) && (rect.y..=rect.y + rect.height).contains(&y)
    };
    let foot = found[3] as f32 - FOOT * (found[3] - found[1]) as f32;
    let added = |i: usize| inside(i) && over.data[i] > 0.5 && !subject(i) && (i / w) as f32 >= foot;
    let core = eroded(w, h, pixels(BROAD), added);
    // A little further than they were eroded, to their soft edges.
    let ground = dilated(w, h, pixels(1.25 * BROAD), |i| core[i]);
    let share = |i: usize| {
        if !inside(i) || ground[i] && !subject(i) {
            1.0
        } else if around[i] && !within[i] {
            0.0
        } else {
            ROUGH
        }
    };
    let data = (0..w * h).map(|i| share(i) * rough.data[i] + (1.0 - share(i)) * over.data[i]);
    Plane { width: w, height: h, data: data.map(|v| v.clamp(0.0, 1.0)).collect() }
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;

    /// Answers with the rough mask.
    pub struct Kept;
    impl Graph for Kept {
        fn inputs(&self) -> Vec<Port> {
            vec![Port::new("image", &[1, 4, SIZE, SIZE])]
        }
        fn outputs(&self) -> Vec<Port> {
            ["mask", "inverse_depth"].map(|name| Port::new(name, &[1, 1, SIZE, SIZE])).into()
        }
        fn run(&self, inputs: &[(&str, &Tensor)]) -> Result<Vec<(String, Tensor)>> {
            let rough = Tensor::new(&[1, 1, SIZE, SIZE], inputs[0].1.data[3 * SIZE * SIZE..].to_vec())?;
            Ok(vec![("inverse_depth".into(), rough.clone()), ("mask".into(), rough)])
        }
    }

    /// Answers with what is green.
    struct Green;
    impl Graph for Green {
        fn inputs(&self) -> Vec<Port> {
            Kept.inputs()
        }
        fn outputs(&self) -> Vec<Port> {
            Kept.outputs()
        }
        fn run(&self, inputs: &[(&str, &Tensor)]) -> Result<Vec<(String, Tensor)>> {
            let green = inputs[0].1.data[SIZE * SIZE..2 * SIZE * SIZE].iter().map(|v| f32::from(u8::from(*v > 0.5)));
            let mask = Tensor::new(&[1, 1, SIZE, SIZE], green.collect())?;
            Ok(vec![("mask".into(), mask)])
        }
    }

    #[test]
    fn what_is_looked_at_has_room_and_stays_in_the_photo() {
        let r = part([100, 200, 300, 260], 800, 600);
        assert_eq!((r.x, r.width), (70.0, 260.0));
        // A long subject is not shown longer than it is by more than the room.
        assert!((r.height - 156.0).abs() < 1e-3 && (r.y + r.height / 2.0 - 230.0).abs() < 1e-3, "{r:?}");
        let r = part([0, 0, 800, 590], 800, 600);
        assert_eq!((r.x, r.y, r.width, r.height), (0.0, 0.0, 800.0, 600.0));
    }

    #[test]
    fn a_thin_mast_that_the_rough_mask_has_not_is_drawn_where_it_stands() {
        let mast = |x: u32, y: u32| (300..306).contains(&x) && (40..420).contains(&y);
        let hull = |x: u32, y: u32| (180..420).contains(&x) && (240..420).contains(&y);
        let photo = image::RgbImage::from_fn(600, 450, |x, y| {
            image::Rgb(if mast(x, y) || hull(x, y) { [40, 220, 40] } else { [90, 60, 120] })
        });
        let whole = Rect { x: 0.0, y: 0.0, width: 600.0, height: 450.0 };
        let canvas = Canvas { photo: &photo, working: &photo, whole, width: 600, height: 450 };
        // The mast is doubted, but near enough to be looked at.
        let data = (0..600 * 450).map(|i| if hull(i % 600, i / 600) { 0.95 } else { 0.05 });
        let rough = Plane { width: 600, height: 450, data: data.collect() };
        let (drawn, pixel) = drawn(&canvas, &rough, [180, 60, 420, 420], &Green).unwrap();
        assert!(drawn.at(303, 100) > 0.6 && drawn.at(290, 100) < 0.1 && drawn.at(316, 100) < 0.1);
        assert!(drawn.at(200, 400) > 0.9 && drawn.at(200, 200) < 0.1);
        // Beyond what was looked at nothing changes.
        assert_eq!(drawn.at(20, 20), 0.05);
        assert!((pixel - 1.3 * 360.0 / 384.0).abs() < 0.1, "{pixel}");
    }

    #[test]
    fn a_head_and_legs_are_added_and_the_ground_is_not() {
        // All of it is in the part that is looked at, 93 to 327 across and 153 to 327 down.
        let body = |x: u32, y: u32| (120..300).contains(&x) && (180..300).contains(&y);
        let head = |x: u32, y: u32| (300..325).contains(&x) && (160..220).contains(&y);
        let leg = |x: u32, y: u32| (130..135).contains(&x) && (300..325).contains(&y);
        let stone = |x: u32, y: u32| (180..320).contains(&x) && (308..327).contains(&y);
        let photo = image::RgbImage::from_fn(600, 450, |x, y| {
            let green = [body, head].iter().any(|f| f(x, y)) || leg(x, y) || stone(x, y);
            image::Rgb(if green { [40, 220, 40] } else { [90, 60, 120] })
        });
        let whole = Rect { x: 0.0, y: 0.0, width: 600.0, height: 450.0 };
        let canvas = Canvas { photo: &photo, working: &photo, whole, width: 600, height: 450 };
        let data = (0..600 * 450).map(|i| if body(i % 600, i / 600) { 0.95 } else { 0.05 });
        let rough = Plane { width: 600, height: 450, data: data.collect() };
        let (drawn, _) = drawn(&canvas, &rough, [120, 180, 300, 300], &Green).unwrap();
        assert!(drawn.at(315, 190) > 0.6, "head: {}", drawn.at(315, 190));
        assert!(drawn.at(132, 318) > 0.6, "leg: {}", drawn.at(132, 318));
        assert!(drawn.at(240, 318) < 0.1, "stone: {}", drawn.at(240, 318));
    }

    #[test]
    fn the_rough_mask_is_shown_as_it_is() {
        let photo = image::RgbImage::from_pixel(400, 400, image::Rgb([90; 3]));
        let whole = Rect { x: 0.0, y: 0.0, width: 400.0, height: 400.0 };
        let canvas = Canvas { photo: &photo, working: &photo, whole, width: 400, height: 400 };
        let data = (0..400 * 400).map(|i| ((i % 400) as f32 / 400.0).powi(2)).collect();
        let rough = Plane { width: 400, height: 400, data };
        let (drawn, _) = drawn(&canvas, &rough, [100, 100, 300, 300], &Kept).unwrap();
        let off = drawn.data.iter().zip(&rough.data).map(|(a, b)| (a - b).abs()).fold(0.0, f32::max);
        assert!(off < 0.01, "{off}");
    }

    #[test]
    fn the_built_in_network_sharpens_a_mask_that_was_worn() {
        use crate::models::{Rten, prior};
        let decoded = |bytes: &[u8]| image::load_from_memory(bytes).unwrap();
        let photo = decoded(include_bytes!("../../../tests/data/container.jpg")).into_rgb8();
        let truth = decoded(include_bytes!("../../../tests/data/container_mask.png")).into_luma8();
        let (w, h) = (photo.width() as usize, photo.height() as usize);
        let whole = Rect { x: 0.0, y: 0.0, width: w as f32, height: h as f32 };
        let canvas = Canvas { photo: &photo, working: &photo, whole, width: w, height: h };
        let mask = Plane { width: w, height: h, data: truth.iter().map(|v| f32::from(*v) / 255.0).collect() };
        // A mask of 24 pixels across, moved aside by a third of one of them.
        let aside = w as f32 / 72.0;
        let few = sample_plane(&mask, Rect { x: aside, y: 0.0, ..whole }, 24, 24 * h / w, Edge::Zero);
        let all = Rect { x: 0.0, y: 0.0, width: few.width as f32, height: few.height as f32 };
        let rough = sample_plane(&few, all, w, h, Edge::Clamp);
        let found = crate::models::region::bounds(&rough, 0.5).unwrap();
        let graph = prior::DETAIL.loaded(&Rten).unwrap();
        check(&*graph).unwrap();
        let (drawn, _) = drawn(&canvas, &rough, found, &*graph).unwrap();
        let overlap = |m: &Plane| {
            let (mut both, mut either) = (0.0, 0.0);
            for (a, b) in m.data.iter().zip(&mask.data) {
                both += f64::from(u8::from(*a > 0.5 && *b > 0.5));
                either += f64::from(u8::from(*a > 0.5 || *b > 0.5));
            }
            both / either
        };
        assert!(overlap(&rough) < 0.96 && overlap(&drawn) > 0.98, "{} {}", overlap(&rough), overlap(&drawn));
    }
}
