//! OpenImageIO's comparison of every texture and every imagery tile that a command writes with what it was made from;
//! GDAL on the terrain under the model.

use std::collections::BTreeMap;
use std::io::{Cursor, Read};
use std::path::{Path, PathBuf};
use std::process::Command;

use image::{Rgb, RgbImage};
use orb_formats::cdb::geocell::Tile;
use orb_formats::cdb::{ground, names};
use orb_formats::glb;
use tiff::encoder::{TiffEncoder, colortype::RGB8};
use tiff::tags::Tag;

const PLACE: (f64, f64, f64) = (-54.8019, -68.3030, 12.5);
/// Coarser images are means of means that were rounded on the way: three steps of 255.
const ROUNDED: &str = "0.012";

fn have(tools: &[&str]) -> bool {
    let missing = tools.iter().filter(|t| Command::new(t).arg("--help").output().is_err()).collect::<Vec<_>>();
    assert!(missing.is_empty() || std::env::var_os("ORB_REQUIRE_CLIENTS").is_none(), "required: {missing:?}");
    if !missing.is_empty() {
        eprintln!("skipped: {missing:?} are missing");
    }
    missing.is_empty()
}

fn run(program: &str, args: &[&str]) -> String {
    let out = Command::new(program).args(args).output().unwrap();
    let said = format!("{}{}", String::from_utf8_lossy(&out.stdout), String::from_utf8_lossy(&out.stderr));
    assert!(out.status.success(), "{program} {args:?}: {said}");
    said
}

/// Pictures beside those they are to be, which are compared in one go: OpenImageIO takes longer to start than to look.
struct Pairs<'a> {
    folder: &'a Path,
    /// How much of the range a pixel may differ by, and the two files.
    pairs: Vec<(&'static str, PathBuf, PathBuf)>,
}

impl Pairs<'_> {
    /// A file for the next of them.
    fn file(&self, what: &str) -> PathBuf {
        self.folder.join(format!("{}_{what}", self.pairs.len()))
    }

    fn push(&mut self, most: &'static str, found: PathBuf, expected: &RgbImage) {
        let beside = self.file("expected.png");
        expected.save(&beside).unwrap();
        self.pairs.push((most, found, beside));
    }

    /// Fails where one pixel of a pair differs by more than it may.
    fn compare(&self) {
        for most in ["0", ROUNDED] {
            let pairs: Vec<_> = self.pairs.iter().filter(|(m, ..)| *m == most).collect();
            let mut args = vec!["--fail", most, "--warn", most];
            for (_, found, expected) in &pairs {
                args.extend([found.to_str().unwrap(), expected.to_str().unwrap(), "--diff", "--pop", "--pop"]);
            }
            let said = run("oiiotool", &args);
            assert_eq!(said.matches("PASS").count(), pairs.len(), "{said}");
        }
    }
}

fn to_linear(v: u8) -> f64 {
    let v = f64::from(v) / 255.0;
    if v <= 0.04045 { v / 12.92 } else { ((v + 0.055) / 1.055).powf(2.4) }
}

fn to_byte(v: f64) -> u8 {
    let v = if v <= 0.003_130_8 { 12.92 * v } else { 1.055 * v.powf(1.0 / 2.4) - 0.055 };
    (v * 255.0).round() as u8
}

/// The mean light of every box, in one step.
fn reduced(image: &RgbImage, width: u32, height: u32) -> RgbImage {
    let linear: Vec<f64> = (0..=255).map(to_linear).collect();
    let (across, down) = (image.width() / width, image.height() / height);
    RgbImage::from_fn(width, height, |x, y| {
        let pixels = || (0..across * down).map(|i| image.get_pixel(x * across + i % across, y * down + i / across).0);
        Rgb(std::array::from_fn(|c| {
            to_byte(pixels().map(|p| linear[usize::from(p[c])]).sum::<f64>() / f64::from(across * down))
        }))
    })
}

fn files(root: &Path, ending: &str) -> Vec<PathBuf> {
    let mut found = Vec::new();
    let mut open = vec![root.to_owned()];
    while let Some(folder) = open.pop() {
        for entry in std::fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.is_dir() {
                open.push(path);
            } else if path.extension().is_some_and(|e| e == ending) {
                found.push(path);
            }
        }
    }
    found.sort();
    found
}

/// A picture of the ground that lies on a tile of imagery pixel for pixel.
fn orthophoto(tile: Tile) -> (RgbImage, Vec<u8>) {
    let image = RgbImage::from_fn(1024, 1024, |x, y| {
        let stripe = (x / 37 + y / 53) % 2 * 90;
        Rgb([(x / 8 + stripe) as u8, (y / 8 + stripe) as u8, ((x * 7 + y * 13) % 200) as u8])
    });
    let grid = ground::imagery_grid(tile);
    let mut out = Cursor::new(Vec::new());
    let mut encoder = TiffEncoder::new(&mut out).unwrap();
    let mut file = encoder.new_image::<RGB8>(1024, 1024).unwrap();
    let directory = file.encoder();
    let keys = [1u16, 1, 0, 3, 1024, 0, 1, 2, 1025, 0, 1, 1, 2048, 0, 1, 4326];
    directory.write_tag(Tag::GeoKeyDirectoryTag, &keys[..]).unwrap();
    directory.write_tag(Tag::ModelPixelScaleTag, &[grid.step_x, grid.step_y, 0.0][..]).unwrap();
    directory.write_tag(Tag::ModelTiepointTag, &[0.0, 0.0, 0.0, grid.west, grid.north, 0.0][..]).unwrap();
    file.write_data(image.as_raw()).unwrap();
    (image, out.into_inner())
}

#[test]
fn openimageio_finds_every_texture_and_tile_equal_to_its_source() {
    if !have(&["oiiotool", "gdalinfo", "gdallocationinfo"]) {
        return;
    }
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let dir = tempfile::tempdir().unwrap();
    let (out, photo) = (dir.path().join("out"), dir.path().join("ground.tif"));
    let tile = |lod| Tile::containing(PLACE.0, PLACE.1, lod).unwrap();
    let (finest, file) = orthophoto(tile(7));
    std::fs::write(&photo, file).unwrap();
    let made = Command::new(env!("CARGO_BIN_EXE_orb"))
        .args(["export", root.join("samples/truth/play_house/mesh.glb").to_str().unwrap(), "--origin"])
        .args([&format!("{},{},{}", PLACE.0, PLACE.1, PLACE.2), "--lods", "3", "--format", "flt,glb,cdb"])
        .args(["--ground", "--ground-image", photo.to_str().unwrap(), "-o", out.to_str().unwrap()])
        .env("ORB_DATA_DIR", dir.path().join("data"))
        .output()
        .unwrap();
    let said = String::from_utf8_lossy(&made.stderr);
    assert!(made.status.success() && said.contains("invented"), "{said}");

    // The sources: the pictures inside the GLBs, coarsest first.
    let names = ["mesh_lod3.glb", "mesh_lod2.glb", "mesh_lod1.glb", "mesh.glb"];
    let sources = names.map(|name| {
        let asset = glb::read(&std::fs::read(out.join(name)).unwrap()).unwrap();
        image::load_from_memory(&asset.images[0].bytes).unwrap().to_rgb8()
    });
    let mut pairs = Pairs { folder: dir.path(), pairs: Vec::new() };
    for (i, source) in sources.iter().enumerate() {
        pairs.push("0", out.join(format!("mesh_{i}.rgb")), source);
    }

    // Every mip in every archive.
    let store = out.join("mesh.cdb");
    let (mut mips, mut whole) = (0, 0);
    for archive in files(&store.join("Tiles"), "zip") {
        let mut zip = zip::ZipArchive::new(std::fs::File::open(archive).unwrap()).unwrap();
        for i in 0..zip.len() {
            let mut entry = zip.by_index(i).unwrap();
            let Some(stem) = entry.name().unwrap().strip_suffix(".rgb").map(str::to_owned) else { continue };
            let mut bytes = Vec::new();
            entry.read_to_end(&mut bytes).unwrap();
            let texture = pairs.file("texture.rgb");
            std::fs::write(&texture, &bytes).unwrap();
            let level =
                stem.trim_end_matches("_tile").rsplit('_').next().and_then(|n| n.parse::<usize>().ok()).unwrap();
            let size = orb_formats::sgi::read(&bytes).unwrap().0;
            let source = &sources[level];
            let equal = (size.width, size.height) == source.dimensions();
            pairs.push(if equal { "0" } else { ROUNDED }, texture, &reduced(source, size.width, size.height));
            (mips, whole) = (mips + 1, whole + usize::from(equal));
        }
    }
    assert!(whole >= 4 && mips >= 4 * 7, "{mips} textures, {whole} of full size");

    // Imagery: the tile that the picture covers is the picture, and coarser ones hold its means beside grey.
    let mut pyramid: BTreeMap<i8, RgbImage> = BTreeMap::from([(7, finest)]);
    for lod in (-10..7).rev() {
        let below = &pyramid[&(lod + 1)];
        let n = ground::side(lod);
        let mut image = RgbImage::from_pixel(n, n, Rgb([128; 3]));
        let half = reduced(below, below.width() / 2, below.height() / 2);
        let child = tile(lod + 1);
        let quarter = |k: u32| if lod >= 0 { i64::from(k & 1) * i64::from(n / 2) } else { 0 };
        let top = i64::from(n) - i64::from(half.height()) - quarter(child.up);
        image::imageops::replace(&mut image, &half, quarter(child.right), top);
        pyramid.insert(lod, image);
    }
    let found = files(&store.join("Tiles"), "jp2");
    assert_eq!(found.len(), 18);
    for (lod, image) in &pyramid {
        let path = store.join(names::path(tile(*lod), names::IMAGERY, (1, 1), "jp2"));
        let said = run("gdalinfo", &["-checksum", path.to_str().unwrap()]);
        let origin = ground::imagery_grid(tile(*lod));
        assert!(said.contains(&format!("Origin = ({:.15},", origin.west)), "{said}");
        assert!(!said.contains("ERROR") && said.contains("WGS 84"), "{said}");
        pairs.push(if *lod == 7 { "0" } else { ROUNDED }, path, image);
    }
    pairs.compare();

    // Terrain: GDAL finds the model's height under it, at every level.
    for lod in -10..=7 {
        let path = store.join(names::path(tile(lod), names::ELEVATION, (1, 1), "tif"));
        let said = run("gdalinfo", &["-checksum", path.to_str().unwrap()]);
        assert!(said.contains("Type=Float32") && !said.contains("ERROR") && !said.contains("Checksum=-1"), "{said}");
        let grid = ground::elevation_grid(tile(lod));
        let (x, y) = (grid.west, grid.north - f64::from(ground::side(lod) - 1) * grid.step_y);
        let args = ["-valonly", "-wgs84", path.to_str().unwrap(), &x.to_string(), &y.to_string()];
        assert_eq!(run("gdallocationinfo", &args).trim(), "12.5", "LOD {lod}");
    }
    let orb = |args: &[&str]| {
        let done =
            Command::new(env!("CARGO_BIN_EXE_orb")).args(args).env("ORB_DATA_DIR", dir.path().join("data")).output();
        let done = done.unwrap();
        let said = format!("{}{}", String::from_utf8_lossy(&done.stdout), String::from_utf8_lossy(&done.stderr));
        (done.status.success(), said)
    };
    let (good, said) = orb(&["cdb", "check", store.to_str().unwrap()]);
    assert!(good && said.contains("pass 13 "), "{said}");
    let (good, said) = orb(&["audit", "verify", out.to_str().unwrap()]);
    assert!(good, "{said}");
    // A tile that lies elsewhere than its name says is found.
    let wrong = store.join(names::path(tile(7), names::ELEVATION, (1, 1), "tif"));
    let mut grid = ground::elevation_grid(tile(7));
    grid.north += grid.step_y;
    std::fs::write(&wrong, orb_formats::geotiff::write(1024, 1024, &vec![0.0; 1 << 20], &grid, "").unwrap()).unwrap();
    let (good, said) = orb(&["cdb", "check", store.to_str().unwrap()]);
    assert!(!good && said.contains("FAIL 13 ") && said.contains("its name says"), "{said}");
}
