use std::io::Cursor;

use tiff::encoder::colortype::{Gray32Float, GrayI16};
use tiff::encoder::{TiffEncoder, colortype::ColorType};

use super::*;
use crate::geo::Utm;

/// Height of the made-up ground: a plane in degrees, which bilinear sampling must reproduce.
fn plane(latitude: f64, longitude: f64) -> f64 {
    500.0 + 800.0 * (latitude - 34.5) - 300.0 * (longitude + 118.5)
}

/// A terrain of `w` × `h` with geographic keys; the first pixel's corner at (`north`, `west`).
fn geotiff<C: ColorType<Inner = T>, T: Clone>(
    keys: &[[u16; 4]],
    tie: [f64; 2],
    step: f64,
    (w, h): (u32, u32),
    no_data: &str,
    values: &[T],
) -> Vec<u8>
where
    [T]: tiff::encoder::TiffValue,
{
    let mut out = Cursor::new(Vec::new());
    let mut encoder = TiffEncoder::new(&mut out).unwrap();
    let mut image = encoder.new_image::<C>(w, h).unwrap();
    image.rows_per_strip(3).unwrap();
    let directory = image.encoder();
    let mut geo = vec![1u16, 1, 0, keys.len() as u16];
    keys.iter().for_each(|k| geo.extend(k));
    directory.write_tag(Tag::GeoKeyDirectoryTag, &geo[..]).unwrap();
    directory.write_tag(Tag::ModelPixelScaleTag, &[step, step, 0.0][..]).unwrap();
    directory.write_tag(Tag::ModelTiepointTag, &[0.0, 0.0, 0.0, tie[0], tie[1], 0.0][..]).unwrap();
    directory.write_tag(Tag::GdalNodata, no_data).unwrap();
    image.write_data(values).unwrap();
    out.into_inner()
}

const GEOGRAPHIC: [[u16; 4]; 3] = [[1024, 0, 1, 2], [1025, 0, 1, 1], [2048, 0, 1, 4326]];

fn degrees(above: u16) -> Vec<u8> {
    let (w, h, step) = (20u32, 16u32, 0.01);
    let values: Vec<f32> = (0..w * h)
        .map(|i| plane(34.6 - step * (f64::from(i / w) + 0.5), -118.6 + step * (f64::from(i % w) + 0.5)) as f32)
        .collect();
    let mut keys = GEOGRAPHIC.to_vec();
    keys.push([4096, 0, 1, above]);
    geotiff::<Gray32Float, f32>(&keys, [-118.6, 34.6], step, (w, h), "-9999", &values)
}

fn open(bytes: Vec<u8>) -> Result<Dem<Cursor<Vec<u8>>>> {
    Dem::open("ground.tif", Cursor::new(bytes), None)
}

#[test]
fn a_plane_is_sampled_exactly() {
    let mut dem = open(degrees(4979)).unwrap();
    assert_eq!(dem.datum, AltDatum::Ellipsoid);
    for (lat, lon) in [(34.5523, -118.4712), (34.5, -118.5), (34.4501, -118.4101), (34.5949, -118.5949)] {
        let h = dem.ground(lat, lon).unwrap();
        assert!((h.ellipsoidal - plane(lat, lon)).abs() < 1e-3, "{lat} {lon}: {h:?}");
    }
    let mut sea = open(degrees(5773)).unwrap();
    let n = crate::geo::geoid::undulation(34.5, -118.5);
    assert!((sea.ground(34.5, -118.5).unwrap().ellipsoidal - 500.0 - n).abs() < 1e-3);
    let corners = [(34.5, -118.5), (34.51, -118.5), (34.5, -118.49)];
    let heights = corners.map(|(a, o)| plane(a, o));
    let mean = heights.iter().sum::<f64>() / 3.0;
    assert!((dem.under(&corners, Fit::Mean).unwrap().ellipsoidal - mean).abs() < 1e-3);
    assert!((dem.under(&corners, Fit::Min).unwrap().ellipsoidal - 497.0).abs() < 1e-3);
}

#[test]
fn a_grid_in_utm_and_whole_feet() {
    let centre = Utm::of(34.5523, -118.4712);
    let tie = [centre.easting - 250.0, centre.northing + 250.0];
    let values: Vec<i16> = (0..2500).map(|i| (i % 50 * 10) as i16).collect();
    let keys = [[1024, 0, 1, 1], [1025, 0, 1, 2], [3072, 0, 1, 32611], [4096, 0, 1, 4979], [4099, 0, 1, 9002]];
    let mut dem = open(geotiff::<GrayI16, i16>(&keys, tie, 10.0, (50, 50), "", &values)).unwrap();
    // 250 m east of the first post: post 25, 250 feet.
    assert!((dem.ground(34.5523, -118.4712).unwrap().ellipsoidal - 250.0 * 0.3048).abs() < 1e-6);
}

#[test]
fn how_far_a_point_lies_inside_is_told_in_posts_and_posts_in_metres() {
    // 20 × 16 posts of 0.01°, the first at 34.595, −118.595.
    let dem = open(degrees(4979)).unwrap();
    let close = |found: Option<[f64; 2]>, want: [f64; 2], off: f64| {
        let found = found.unwrap();
        assert!((0..2).all(|k| (found[k] - want[k]).abs() < off), "{found:?} {want:?}");
    };
    close(dem.margin(34.59, -118.57), [3.0, 1.0], 1e-6);
    close(dem.margin(34.45, -118.41), [1.0, 1.0], 1e-6);
    close(dem.margin(34.62, -118.57), [3.0, -2.0], 1e-6);
    // West of it is far in the east of it: a longitude goes on from the western edge.
    assert!(dem.margin(34.52, -118.62).is_some_and(|m| m[0] < -1000.0));
    close(dem.spacing(34.5, -118.5), [918.0, 1109.0], 1.0);
    let centre = Utm::of(34.5523, -118.4712);
    let tie = [centre.easting - 250.0, centre.northing + 250.0];
    let keys = [[1024, 0, 1, 1], [1025, 0, 1, 1], [3072, 0, 1, 32611], [4096, 0, 1, 4979]];
    let grid = open(geotiff::<GrayI16, i16>(&keys, tie, 10.0, (50, 50), "", &[0; 2500])).unwrap();
    close(grid.margin(34.5523, -118.4712), [25.0, 25.0], 1e-6);
    close(grid.spacing(34.5523, -118.4712), [10.0, 10.0], 0.01);
}

#[test]
fn what_is_not_covered_is_refused() {
    let mut dem = open(degrees(4979)).unwrap();
    for (lat, lon) in [(34.61, -118.5), (34.5, -118.61), (34.43, -118.5), (34.5, -118.39), (-34.5, 118.5)] {
        let e = dem.ground(lat, lon).unwrap_err().to_string();
        assert!(e.contains("ground.tif") && e.contains("does not cover"), "{e}");
    }
    assert!(dem.under(&[(34.5, -118.5), (34.5, -118.39)], Fit::Min).is_err());
    let holes =
        geotiff::<Gray32Float, f32>(&GEOGRAPHIC, [-118.6, 34.6], 0.1, (2, 2), "-9999", &[1.0, 2.0, -9999.0, 3.0]);
    let e = open(holes).unwrap().ground(34.5, -118.5).unwrap_err().to_string();
    assert!(e.contains("hole"), "{e}");
}

#[test]
fn what_is_no_terrain_is_refused_by_name() {
    for (bytes, words) in [
        (b"words".to_vec(), "GeoTIFF"),
        (geotiff::<Gray32Float, f32>(&[], [0.0, 0.0], 1.0, (2, 2), "", &[0.0; 4]), "keys"),
        (
            geotiff::<Gray32Float, f32>(&[[1024, 0, 1, 1], [3072, 0, 1, 2056]], [0.0, 0.0], 1.0, (2, 2), "", &[0.0; 4]),
            "EPSG:2056",
        ),
        (geotiff::<Gray32Float, f32>(&GEOGRAPHIC, [0.0, 0.0], 0.0, (2, 2), "", &[0.0; 4]), "zero"),
    ] {
        let e = open(bytes).err().map(|e| e.to_string()).unwrap_or_default();
        assert!(e.contains(words) && e.contains("ground.tif"), "{words}: {e}");
    }
}
