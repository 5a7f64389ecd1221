//! What other programs make of our files: OpenSceneGraph for models, OpenImageIO and GDAL for textures.
//!
//! A missing program skips its test with a printed reason; under ORB_REQUIRE_CLIENTS=1 it fails.

use orb_formats::openflight::{self, Level, Model};
use orb_formats::{Image, Mesh, sgi};

mod common;
use common::{Folder, run};

/// Every corner another colour, so that a flip or a swapped channel shows.
fn texture(channels: u8) -> Image {
    let (width, height) = (16u32, 8u32);
    let pixel = |x: u32, y: u32| [(x * 16) as u8, (y * 32) as u8, 255 - (x * 8 + y) as u8, 255];
    let pixels = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
    let pixels = pixels.flat_map(|(x, y)| pixel(x, y).into_iter().take(channels.into())).collect();
    Image { width, height, channels, pixels }
}

/// A wall facing −Y, `columns` quads wide: two triangles a quad.
fn wall(columns: u32) -> Mesh {
    let mut mesh = Mesh::default();
    for i in 0..=columns {
        let u = i as f32 / columns as f32;
        for v in [0.0f32, 1.0] {
            mesh.positions.push([f64::from(u) * 4.0 - 2.0, 0.0, f64::from(v) * 2.0]);
            mesh.normals.push([0.0, -1.0, 0.0]);
            mesh.uvs.push([u, v]);
        }
    }
    mesh.triangles.extend((0..columns).flat_map(|i| [[2 * i, 2 * i + 2, 2 * i + 3], [2 * i, 2 * i + 3, 2 * i + 1]]));
    mesh
}

fn model() -> Model {
    let level = |name: &str, switch_in, switch_out, significant_size, columns| Level {
        name: name.into(),
        switch_in,
        switch_out,
        transition: 0.0,
        significant_size,
        center: [0.0, 0.0, 1.0],
        texture: Some(0),
        mesh: wall(columns),
    };
    Model {
        name: "TestWall".into(),
        date: "Mon Jan  1 00:00:00 2024".into(),
        origin: Some((34.5523, -118.4712)),
        header_comment: Some("UNCLASSIFIED".into()),
        zone_comment: Some("<CDB:Zone name=\"TestWall\"/>".into()),
        textures: vec!["textures/wall.rgb".into()],
        levels: vec![level("coarse wall", 20_000.0, 350.0, 4.5, 1), level("fine wall", 350.0, 0.0, 0.2, 5)],
        points: vec![],
    }
}

#[test]
fn openscenegraph_reads_models() {
    let folder = Folder::new("osg");
    std::fs::create_dir_all(folder.0.join("sub/textures")).unwrap();
    let bytes = openflight::write(&model()).unwrap();
    assert_eq!(openflight::check(&bytes), Vec::<String>::new());
    std::fs::write(folder.0.join("sub/wall.flt"), bytes).unwrap();
    std::fs::write(folder.0.join("sub/textures/wall.rgb"), sgi::write(&texture(3), "UNCLASSIFIED", true).unwrap())
        .unwrap();
    let Some(log) = run("osgconv", &["sub/wall.flt", "wall.osgt"], &folder.0) else { return };
    // osgconv answers 0 on broken files: judge by what it understood.
    for bad in ["an't find texture", "read error", "Unknown record"] {
        assert!(!log.contains(bad), "{log}");
    }
    let scene = std::fs::read_to_string(folder.0.join("wall.osgt")).unwrap();
    let flat: String = scene.split_whitespace().collect::<Vec<_>>().join(" ");
    for part in ["\"UNCLASSIFIED\"", "CDB:Zone name=", "TestWall", "350 20000", "0 350", "UserCenter 0 0 1", "wall.rgb"]
    {
        assert!(flat.contains(part), "{part:?} is missing from {flat}");
    }
}

#[test]
fn openimageio_and_gdal_read_textures() {
    let folder = Folder::new("oiio");
    for channels in 1..=4 {
        for rle in [false, true] {
            let image = texture(channels);
            std::fs::write(folder.0.join("t.rgb"), sgi::write(&image, "CUI//TEST", rle).unwrap()).unwrap();
            let info = run("iinfo", &["-v", "t.rgb"], &folder.0);
            if let Some(info) = info {
                assert!(info.contains(&format!("16 x    8, {channels} channel, uint8 sgi")), "{info}");
                assert!(info.contains("CUI//TEST"), "{info}");
            }
            // ENVI with pixel interleave is bare bytes, top row first.
            let arguments = ["-q", "-of", "ENVI", "-co", "INTERLEAVE=BIP", "t.rgb", "t.bip"];
            if run("gdal_translate", &arguments, &folder.0).is_some() {
                assert_eq!(std::fs::read(folder.0.join("t.bip")).unwrap(), image.pixels, "{channels} {rle}");
            }
        }
    }
}
