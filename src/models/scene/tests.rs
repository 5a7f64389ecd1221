use std::sync::LazyLock;

use super::*;
use crate::Kind;
use crate::models::{Rten, Tensor};

fn built_in() -> Networks {
    Networks::built_in(&Rten).unwrap()
}

/// With a network for details that keeps the rough mask.
fn alone(scene: impl Graph + 'static) -> Networks {
    Networks { scene: Box::new(scene), detail: Box::new(detail::tests::Kept) }
}

/// Must not be asked.
struct Never;
impl Graph for Never {
    fn inputs(&self) -> Vec<Port> {
        vec![Port::new("image", &[1, 4, SIZE, SIZE])]
    }
    fn outputs(&self) -> Vec<Port> {
        vec![
            Port::new("mask", &[1, 1, SIZE, SIZE]),
            Port::new("inverse_depth", &[1, 1, SIZE, SIZE]),
            Port::new("elevation", &[1, 2]),
            Port::new("roll", &[1, 2]),
        ]
    }
    fn run(&self, _: &[(&str, &Tensor)]) -> Result<Vec<(String, Tensor)>> {
        panic!("asked")
    }
}

/// A disc of the network's own making, to test what is done with it.
#[derive(Clone, Copy)]
struct Disc {
    centre: (f32, f32),
    radius: f32,
}
impl Graph for Disc {
    fn inputs(&self) -> Vec<Port> {
        Never.inputs()
    }
    fn outputs(&self) -> Vec<Port> {
        Never.outputs()
    }
    fn run(&self, inputs: &[(&str, &Tensor)]) -> Result<Vec<(String, Tensor)>> {
        // Follows the green of the picture, so that it sees the disc wherever the look is taken.
        let green = &inputs[0].1.data[SIZE * SIZE..2 * SIZE * SIZE];
        let mask = green.iter().map(|v| if *v > 0.6 { 0.95 } else { 0.02 }).collect();
        let depth = (0..SIZE * SIZE).map(|i| (i / SIZE) as f32).collect();
        Ok(vec![
            ("mask".into(), Tensor::new(&[1, 1, SIZE, SIZE], mask)?),
            ("inverse_depth".into(), Tensor::new(&[1, 1, SIZE, SIZE], depth)?),
            ("elevation".into(), Tensor::new(&[1, 2], vec![0.2, 0.05])?),
            ("roll".into(), Tensor::new(&[1, 2], vec![0.03, 0.02])?),
        ])
    }
}
impl Disc {
    fn photo(&self, w: u32, h: u32) -> RgbImage {
        RgbImage::from_fn(w, h, |x, y| {
            let d = ((x as f32 - self.centre.0).powi(2) + (y as f32 - self.centre.1).powi(2)).sqrt();
            image::Rgb(if d < self.radius { [90, 200, 60] } else { [100 + (x % 80) as u8, 90, 120] })
        })
    }
}

#[test]
fn a_subject_that_the_photo_cuts_off_is_told_from_one_that_stands_in_it() {
    let mask = |inside: &dyn Fn(usize, usize) -> bool| Plane {
        width: 100,
        height: 80,
        data: (0..8000).map(|i| f32::from(u8::from(inside(i % 100, i / 100)))).collect(),
    };
    assert!(reaches_the_last_row(&mask(&|x, y| (30..70).contains(&x) && y > 20)));
    assert!(!reaches_the_last_row(&mask(&|x, y| (30..70).contains(&x) && (20..75).contains(&y))));
    // A corner of it alone touches the border; a strip that is next to nothing.
    assert!(!reaches_the_last_row(&mask(&|x, y| (30..70).contains(&x) && y > 20 && (x < 40 || y < 79))));
    assert!(!reaches_the_last_row(&mask(&|x, _| x < 4)));
}

#[test]
fn a_border_through_the_subject_is_told_from_one_it_touches() {
    let crossed = |inside: &dyn Fn(usize, usize) -> bool| {
        let data = (0..8000).map(|i| f32::from(u8::from(inside(i % 100, i / 100)))).collect();
        let mask = Plane { width: 100, height: 80, data };
        crossed_beside_or_above(&mask, bounds(&mask, 0.5).unwrap())
    };
    assert!(!crossed(&|x, y| (30..70).contains(&x) && (20..60).contains(&y)));
    assert!(crossed(&|x, y| x < 50 && (20..60).contains(&y)));
    assert!(crossed(&|x, y| x > 50 && (20..60).contains(&y)));
    assert!(crossed(&|x, y| (30..70).contains(&x) && y < 60));
    // Its foot is not in the photo; its tip touches the border, or its tail does.
    assert!(!crossed(&|x, y| (30..70).contains(&x) && y > 20));
    assert!(!crossed(&|x, y| (30..70).contains(&x) && y > 20 || (45..55).contains(&x)));
    assert!(!crossed(&|x, y| (30..70).contains(&x) && (20..60).contains(&y) || x < 70 && (30..40).contains(&y)));
}

#[test]
fn what_is_half_sure_is_expected_to_overlap_by_half() {
    let plane = |values: [f32; 4]| Plane { width: 4, height: 1, data: values.to_vec() };
    let sure = plane([1.0, 1.0, 0.0, 0.0]);
    assert_eq!(expected_iou(&sure, &sure), 1.0);
    assert_eq!(expected_iou(&plane([0.5, 0.5, 0.0, 0.0]), &sure), 0.5);
    // Half of the mask, and as much that the mask has not.
    assert!((expected_iou(&plane([1.0, 0.0, 1.0, 0.0]), &sure) - 1.0 / 3.0).abs() < 1e-6);
    assert_eq!(expected_iou(&plane([0.0; 4]), &plane([0.0; 4])), 0.0);
}

#[test]
fn a_disc_is_found_where_it_is_in_wide_and_tall_photos() {
    for (w, h) in [(640, 360), (360, 640), (300, 300), (2000, 700)] {
        let disc = Disc { centre: (w as f32 * 0.55, h as f32 * 0.45), radius: 70.0 };
        let subject = subject(&disc.photo(w, h), None, None, &alone(disc)).unwrap();
        let [x0, y0, x1, y1] = subject.bounds.map(|v| v as f32);
        let (sx, sy) = subject.scale;
        let near = |a: f32, b: f32| (a - b).abs() < 8.0;
        assert!(near(x0 * sx, disc.centre.0 - 70.0) && near(x1 * sx, disc.centre.0 + 70.0), "{w} × {h}");
        assert!(near(y0 * sy, disc.centre.1 - 70.0) && near(y1 * sy, disc.centre.1 + 70.0), "{w} × {h}");
        let (low, high) = subject.depth.data.iter().fold((9f32, -9f32), |(a, b), v| (a.min(*v), b.max(*v)));
        assert!(low == 0.0 && (high - 1.0).abs() < 1e-6);
        let depth = &subject.depth;
        assert!(depth.at(0, depth.height - 1) > depth.at(0, 0));
    }
}

#[test]
fn photos_without_a_subject_are_refused_with_advice() {
    fn refused(photo: &RgbImage, scene: impl Graph + 'static) -> String {
        let error = subject(photo, None, None, &alone(scene)).expect_err("no subject");
        assert_eq!(error.kind, Kind::Usage);
        assert!(error.to_string().contains("No subject found at the centre"), "{error}");
        error.found
    }
    for colour in [[255, 255, 255], [0, 0, 0], [90, 120, 60]] {
        assert!(refused(&RgbImage::from_pixel(400, 300, image::Rgb(colour)), Never).contains("one even colour"));
    }
    let corner = Disc { centre: (50.0, 40.0), radius: 38.0 };
    assert!(refused(&corner.photo(600, 400), corner).contains("border"));
    let speck = Disc { centre: (300.0, 200.0), radius: 4.0 };
    assert!(refused(&speck.photo(600, 400), speck).contains("large enough"));
    let all = Disc { centre: (300.0, 200.0), radius: 338.0 };
    assert!(refused(&all.photo(600, 400), all).contains("fills the whole frame"));
    let wide = Disc { centre: (300.0, 400.0), radius: 360.0 };
    assert!(refused(&wide.photo(600, 400), wide).contains("leaves the frame"));
}

#[test]
fn a_point_chooses_among_what_stands_around() {
    let disc = Disc { centre: (150.0, 100.0), radius: 60.0 };
    let mut photo = disc.photo(600, 300);
    let other = Disc { centre: (330.0, 150.0), radius: 60.0 }.photo(600, 300);
    for (x, y, pixel) in other.enumerate_pixels().filter(|(_, _, p)| p.0[1] == 200) {
        photo.put_pixel(x, y, *pixel);
    }
    let left = |point| subject(&photo, None, point, &alone(disc)).unwrap().bounds[0];
    assert!((265..275).contains(&left(None)), "{}", left(None));
    assert!((85..95).contains(&left(Some([150.0, 100.0]))), "{}", left(Some([150.0, 100.0])));
}

#[test]
fn the_point_is_shown_where_it_lies() {
    /// Where the point's peak was, its value, and the picture's colour there, of every run.
    type Seen = Vec<(usize, f32, [f32; 3])>;
    #[derive(Clone, Default)]
    struct Shown(std::sync::Arc<std::sync::Mutex<Seen>>);
    impl Graph for Shown {
        fn inputs(&self) -> Vec<Port> {
            Never.inputs()
        }
        fn outputs(&self) -> Vec<Port> {
            Never.outputs()
        }
        fn run(&self, inputs: &[(&str, &Tensor)]) -> Result<Vec<(String, Tensor)>> {
            let (colours, point) = inputs[0].1.data.split_at(3 * SIZE * SIZE);
            let (at, peak) = point.iter().enumerate().fold((0, -1.0), |a, (i, v)| if *v > a.1 { (i, *v) } else { a });
            let colour = std::array::from_fn(|c| colours[c * SIZE * SIZE + at]);
            self.0.lock().unwrap().push((at, peak, colour));
            Disc { centre: (0.0, 0.0), radius: 0.0 }.run(inputs)
        }
    }
    let disc = Disc { centre: (150.0, 100.0), radius: 60.0 };
    let mut photo = disc.photo(600, 300);
    for (x, y) in (118..126).flat_map(|x| (78..86).map(move |y| (x, y))) {
        photo.put_pixel(x, y, image::Rgb([250, 210, 250]));
    }
    let shown = Shown::default();
    subject(&photo, None, Some([122.0, 82.0]), &alone(shown.clone())).unwrap();
    // Squashed, mirrored, with a margin, and again closer: always on the marked patch.
    let seen = std::mem::take(&mut *shown.0.lock().unwrap());
    assert!(seen.len() >= 3);
    assert!(seen.iter().all(|(_, peak, c)| *peak > 0.9 && c[0] > 0.8 && c[2] > 0.8), "{seen:?}");
}

#[test]
fn an_alpha_channel_replaces_the_networks_mask() {
    let disc = Disc { centre: (200.0, 150.0), radius: 60.0 };
    let alpha = GrayImage::from_fn(400, 300, |x, y| {
        image::Luma([255 * u8::from((150..250).contains(&x) && (100..220).contains(&y))])
    });
    let found = subject(&disc.photo(400, 300), Some(&alpha), None, &alone(disc)).unwrap();
    assert!(found.from_cutout && found.expected_iou.is_none());
    assert_eq!(found.bounds, [150, 100, 250, 220]);
}

#[test]
fn a_cut_out_is_the_subject_wherever_it_stands_and_the_network_is_told() {
    /// Fails where it is told no place on the cut-out.
    struct Told(Disc);
    impl Graph for Told {
        fn inputs(&self) -> Vec<Port> {
            self.0.inputs()
        }
        fn outputs(&self) -> Vec<Port> {
            self.0.outputs()
        }
        fn run(&self, inputs: &[(&str, &Tensor)]) -> Result<Vec<(String, Tensor)>> {
            let pixels = &inputs[0].1.data;
            let (at, nearness) = (3 * SIZE * SIZE..4 * SIZE * SIZE)
                .map(|i| (i - 3 * SIZE * SIZE, pixels[i]))
                .fold((0, 0.0), |most, next| if next.1 > most.1 { next } else { most });
            assert!(nearness > 0.9 && pixels[SIZE * SIZE + at] > 0.6, "{nearness} at {at}");
            self.0.run(inputs)
        }
    }
    let corner = Disc { centre: (50.0, 40.0), radius: 38.0 };
    let alpha = GrayImage::from_fn(600, 400, |x, y| image::Luma([255 * u8::from((x < 80) && (10..70).contains(&y))]));
    let found = subject(&corner.photo(600, 400), Some(&alpha), None, &alone(Told(corner))).unwrap();
    assert_eq!(found.bounds, [0, 10, 80, 70]);
    assert_eq!(found.roll, 0.0);
    let nothing = GrayImage::new(600, 400);
    assert!(subject(&corner.photo(600, 400), Some(&nothing), None, &alone(corner)).is_err());
}

#[test]
fn a_mirrored_look_tells_the_other_roll() {
    /// Of 0.1 by the picture as it is, of −0.04 by its mirror image: whose left is where the disc is not.
    struct Leaning(Disc, f32);
    impl Graph for Leaning {
        fn inputs(&self) -> Vec<Port> {
            self.0.inputs()
        }
        fn outputs(&self) -> Vec<Port> {
            self.0.outputs()
        }
        fn run(&self, inputs: &[(&str, &Tensor)]) -> Result<Vec<(String, Tensor)>> {
            let mut made = self.0.run(inputs)?;
            let green = &inputs[0].1.data[SIZE * SIZE..2 * SIZE * SIZE];
            let left = (0..SIZE * SIZE).filter(|i| i % SIZE < SIZE / 2 && green[*i] > 0.6).count();
            let all = green.iter().filter(|v| **v > 0.6).count();
            made[3].1 = Tensor::new(&[1, 2], vec![if 2 * left > all { 0.1 } else { -0.04 }, self.1])?;
            Ok(made)
        }
    }
    // So large that the second look is at the whole photo.
    let disc = Disc { centre: (180.0, 150.0), radius: 140.0 };
    let found = subject(&disc.photo(400, 300), None, None, &alone(Leaning(disc, 0.01))).unwrap();
    assert!((found.roll - 0.07).abs() < 1e-6, "{}", found.roll);
    // What may as well be none is none.
    let unsure = subject(&disc.photo(400, 300), None, None, &alone(Leaning(disc, 0.05))).unwrap();
    assert_eq!(unsure.roll, 0.0);
    // Of a small one the whole photo is looked at once more.
    let disc = Disc { centre: (170.0, 150.0), radius: 40.0 };
    let found = subject(&disc.photo(400, 300), None, None, &alone(Leaning(disc, 0.01))).unwrap();
    assert!((found.roll - 0.1).abs() < 1e-6, "{}", found.roll);
}

/// A photo, and what the built-in networks find in it.
pub static CONTAINER: LazyLock<(RgbImage, Subject)> = LazyLock::new(|| {
    let bytes = include_bytes!("../../../tests/data/container.jpg");
    let photo = crate::photo::decode("container.jpg", bytes, &Default::default()).unwrap();
    let found = subject(&photo.pixels, None, None, &built_in()).unwrap();
    (photo.pixels, found)
});

#[test]
fn the_network_finds_the_container() {
    let found = &CONTAINER.1;
    let truth = image::load_from_memory(include_bytes!("../../../tests/data/container_mask.png")).unwrap().into_luma8();
    let (mut both, mut either) = (0.0, 0.0);
    for (a, b) in truth.iter().zip(&found.mask.data) {
        let (a, b) = (*a > 127, *b > 0.5);
        both += f64::from(u8::from(a && b));
        either += f64::from(u8::from(a || b));
    }
    assert!(both / either > 0.97, "IoU {}", both / either);
    // The near corner is nearer than the far end and than the horizon.
    let at = |x: usize, y: usize| found.depth.at(x, y);
    assert!(
        at(160, 330) > at(400, 230) && at(400, 230) > at(256, 60),
        "{} {} {}",
        at(160, 330),
        at(400, 230),
        at(256, 60)
    );
}

#[test]
fn noise_is_no_subject() {
    let mut state = 1u32;
    let photo = RgbImage::from_fn(320, 240, |_, _| {
        image::Rgb(std::array::from_fn(|_| {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (state >> 24) as u8
        }))
    });
    assert_eq!(subject(&photo, None, None, &built_in()).unwrap_err().kind, Kind::Usage);
}
