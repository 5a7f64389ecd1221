//! Every reader against damaged files: no panic, no hunger for memory.
//!
//! Deterministic: the same seeds and numbers give the same damage. `cargo test` tries some hundred files a reader;
//! `ORB_FUZZ_SECONDS=300` goes on so long for each (`.ci/fuzz`). What fails is written to the system's temporary folder,
//! to be kept in `tests/seeds`, from which every run begins.

use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;
use std::io::{Cursor, Read, Write};
use std::path::Path;
use std::time::{Duration, Instant};

use orb_formats::asset::{EncodedImage, Material, Part};
use orb_formats::cdb::{self, Memory};
use orb_formats::openflight::{self, Level, Model};
use orb_formats::spz::{self, Axes, Version};
use orb_formats::tiles3d::{self, Tile, Tileset, Volume};
use orb_formats::{Asset, Image, Label, Mesh, Place, Splats, geotiff, glb, jp2, ply, sgi, usdz};

/// Counts the bytes that this thread holds.
struct Counting;

thread_local! {
    static HELD: Cell<usize> = const { Cell::new(0) };
    static PEAK: Cell<usize> = const { Cell::new(0) };
}

fn count(grown: usize, freed: usize) {
    // Threads that end may allocate after their locals are gone; nobody asks for their count.
    let _ = HELD.try_with(|held| {
        let now = held.get().saturating_add(grown).saturating_sub(freed);
        held.set(now);
        let _ = PEAK.try_with(|peak| peak.set(peak.get().max(now)));
    });
}

// SAFETY: every call goes to the system's allocator unchanged; counting touches no memory of its own.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        count(layout.size(), 0);
        // SAFETY: the caller's promises are passed on.
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, place: *mut u8, layout: Layout) {
        count(0, layout.size());
        // SAFETY: as above.
        unsafe { System.dealloc(place, layout) }
    }

    unsafe fn realloc(&self, place: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        count(size, layout.size());
        // SAFETY: as above.
        unsafe { System.realloc(place, layout, size) }
    }
}

#[global_allocator]
static ALLOCATOR: Counting = Counting;

/// What a reader may hold: so many bytes for each of the file, and this much in any case.
const TIMES: usize = 400;
const ALWAYS: usize = 32 << 20;

/// SplitMix64 (Steele, Lea and Flood 2014).
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    fn below(&mut self, n: usize) -> usize {
        (self.next() % n.max(1) as u64) as usize
    }
}

/// A file with some damage: bits, bytes and words changed, parts cut out, doubled or taken from another file.
fn damaged(seeds: &[Vec<u8>], random: &mut Random) -> Vec<u8> {
    const WORDS: [u32; 8] = [0, 1, 0x7f, 0xff, 0xffff, 0x7fff_ffff, 0x8000_0000, 0xffff_ffff];
    let mut bytes = seeds[random.below(seeds.len())].clone();
    for _ in 0..=random.below(6) {
        let length = bytes.len();
        // The front holds headers: every other change goes there.
        let reach = if random.below(2) == 0 { length.min(256) } else { length };
        let at = random.below(reach);
        match random.below(9) {
            0 | 1 if length > 0 => bytes[at] ^= 1 << random.below(8),
            2 if length > 0 => bytes[at] = [0, 1, 0x7f, 0x80, 0xfe, 0xff][random.below(6)],
            3 | 4 if at + 4 <= length => {
                let word = WORDS[random.below(8)];
                let word = if random.below(2) == 0 { word.to_le_bytes() } else { word.to_be_bytes() };
                bytes[at..at + 4].copy_from_slice(&word);
            }
            5 => bytes.truncate(at),
            6 if length > 0 => {
                let end = (at + 1 + random.below(32)).min(length);
                bytes.drain(at..end);
            }
            7 if length > 0 => {
                let part = bytes[at..(at + 1 + random.below(64)).min(length)].to_vec();
                bytes.splice(at..at, part);
            }
            8 => {
                let other = &seeds[random.below(seeds.len())];
                bytes.extend_from_slice(&other[random.below(other.len())..]);
            }
            _ => {}
        }
    }
    bytes
}

/// Files that failed once, by the reader's name, beside those that the writers make.
fn kept(name: &str) -> Vec<Vec<u8>> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/seeds");
    let mut found: Vec<_> = std::fs::read_dir(folder).unwrap().map(|e| e.unwrap().path()).collect();
    found.sort();
    let of_name = |p: &&std::path::PathBuf| p.file_name().unwrap().to_str().unwrap().starts_with(&format!("{name}."));
    found.iter().filter(of_name).map(|p| std::fs::read(p).unwrap()).collect()
}

fn attack(name: &str, mut seeds: Vec<Vec<u8>>, read: impl Fn(&[u8]) + std::panic::RefUnwindSafe) {
    let seconds = std::env::var("ORB_FUZZ_SECONDS").ok().and_then(|s| s.parse().ok());
    let until = seconds.map(|s| Instant::now() + Duration::from_secs(s));
    seeds.extend(kept(name));
    let mut random = Random(0x0b5e_55ed);
    let mut tried = 0u64;
    let least = 400.max(2 * seeds.len() as u64);
    while until.map_or(tried < least, |end| Instant::now() < end) {
        // First the files as they are.
        let bytes = match seeds.get(tried as usize) {
            Some(seed) => seed.clone(),
            None => damaged(&seeds, &mut random),
        };
        tried += 1;
        let before = HELD.get();
        PEAK.set(before);
        let ended = std::panic::catch_unwind(|| read(&bytes));
        let held = PEAK.get() - before;
        let most = TIMES * bytes.len() + ALWAYS;
        if ended.is_err() || held > most {
            let path = std::env::temp_dir().join(format!("{name}.{tried}.bin"));
            std::fs::write(&path, &bytes).unwrap();
            panic!("file {tried}, kept as {}: held {held} bytes of at most {most}", path.display());
        }
    }
    println!("{name}: {tried} files from {} seeds", seeds.len());
}

fn mesh() -> Mesh {
    Mesh {
        positions: vec![[-1.0, -1.0, 0.0], [1.0, -1.0, 0.0], [1.0, 1.0, 0.0], [-1.0, 1.0, 2.0]],
        normals: vec![[0.0, 0.0, 1.0]; 4],
        uvs: vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]],
        triangles: vec![[0, 1, 2], [0, 2, 3]],
    }
}

/// A rolling field of so many quads a side.
fn field(side: u32) -> Mesh {
    let mut mesh = Mesh::default();
    for i in 0..(side + 1) * (side + 1) {
        let (x, y) = (f64::from(i % (side + 1)), f64::from(i / (side + 1)));
        mesh.positions.push([x, y, (x * 0.7).sin() * (y * 0.4).cos()]);
        mesh.normals.push([0.0, 0.6, 0.8]);
        mesh.uvs.push([x as f32 / side as f32, y as f32 / side as f32]);
    }
    let at = |x, y| y * (side + 1) + x;
    let quads = (0..side * side).map(|q| (q % side, q / side));
    mesh.triangles = quads
        .flat_map(|(x, y)| [[at(x, y), at(x + 1, y), at(x + 1, y + 1)], [at(x, y), at(x + 1, y + 1), at(x, y + 1)]])
        .collect();
    mesh
}

fn splats() -> Splats {
    Splats {
        positions: vec![[0.0, 1.0, 2.0], [-1.0, 0.5, 0.25]],
        log_scales: vec![[-3.0, -4.0, -5.0], [0.5, -0.5, -9.0]],
        rotations: vec![[1.0, 0.0, 0.0, 0.0], [0.5, -0.5, 0.5, -0.5]],
        logit_opacities: vec![0.0, 3.0],
        sh: vec![[[0.1, 0.2, 0.3]; 16]; 2],
    }
}

fn label() -> Label {
    let place = Place { latitude: 1.5, longitude: -2.5, height: 3.5, heading: 4.5 };
    Label { marking: "CLASSIFICATION: CUI".into(), place: Some(place) }
}

fn asset() -> Asset {
    Asset {
        name: "gate".into(),
        parts: vec![Part { mesh: mesh(), material: Some(0) }],
        materials: vec![Material { image: Some(0), ..Material::default() }],
        images: vec![EncodedImage { media_type: "image/png".into(), bytes: vec![7; 40] }],
        splats: None,
        label: label(),
    }
}

fn model() -> Model {
    Model {
        name: "Crate".into(),
        date: "Mon Jan  1 00:00:00 2024".into(),
        origin: Some((1.0, 2.0)),
        textures: vec!["a.rgb".into()],
        levels: vec![Level {
            switch_in: 100.0,
            significant_size: 2.0,
            texture: Some(0),
            mesh: mesh(),
            ..Level::default()
        }],
        ..Model::default()
    }
}

#[test]
fn ply_reader() {
    let ascii = "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\n\
                 property float f_dc_0\nproperty float f_dc_1\nproperty float f_dc_2\nproperty float opacity\n\
                 property float scale_0\nproperty float scale_1\nproperty float scale_2\nproperty float rot_0\n\
                 property float rot_1\nproperty float rot_2\nproperty float rot_3\nelement f 1\n\
                 property list uchar int i\nend_header\n1 2 3 4 5 6 7 8 9 1 2 3 4 5\n3 0 1 2\n";
    let seeds = vec![ply::write(&splats(), &["a".into()]).unwrap(), ascii.into()];
    attack("ply", seeds, |bytes| drop(ply::read(bytes)));
}

#[test]
fn spz_reader() {
    let of = |version| spz::Options { version, comment: "CLASSIFICATION: CUI".into(), ..spz::Options::default() };
    let all = [Version::V2, Version::V3, Version::V4];
    let seeds = all.map(|v| spz::write(&splats(), &of(v)).unwrap()).to_vec();
    attack("spz", seeds, |bytes| {
        let _ = spz::comment(bytes);
        drop(spz::read(bytes, Axes::RDF));
    });
}

/// Behind the check sum: the damage comes before the compression.
#[test]
fn spz_reader_inside_gzip() {
    let whole = spz::write(&splats(), &spz::Options::default()).unwrap();
    let mut inside = Vec::new();
    flate2::read::GzDecoder::new(whole.as_slice()).read_to_end(&mut inside).unwrap();
    attack("spz-inside", vec![inside], |bytes| {
        let mut gzip = flate2::write::GzEncoder::new(Vec::new(), flate2::Compression::fast());
        gzip.write_all(bytes).unwrap();
        drop(spz::read(&gzip.finish().unwrap(), Axes::RUB));
    });
}

#[test]
fn glb_reader() {
    let of_splats = Asset { splats: Some(splats()), ..Asset::default() };
    let mut seeds = [asset(), of_splats].map(|a| glb::write(&a).unwrap()).to_vec();
    seeds.push(glb::write_as(&asset(), glb::Compression::Meshopt).unwrap());
    attack("glb", seeds, |bytes| drop(glb::read(bytes)));
}

/// Behind the JSON, which seldom survives damage: the packed bytes of compressed views.
#[test]
fn glb_reader_inside_its_compression() {
    let mut of_side = asset();
    of_side.parts[0].mesh = field(24);
    let whole = glb::write_as(&of_side, glb::Compression::Meshopt).unwrap();
    let json_end = 20 + u32::from_le_bytes([whole[12], whole[13], whole[14], whole[15]]) as usize;
    let (front, packed) = whole.split_at(json_end + 8);
    attack("glb-inside", vec![packed.to_vec()], |bytes| {
        // As long as before, so that the views stay inside; their lengths are what they were.
        let mut bytes = bytes.to_vec();
        bytes.resize(packed.len(), 0xa5);
        drop(glb::read(&[front, &bytes].concat()));
    });
}

#[test]
fn usdz_reader() {
    let field = Asset { splats: Some(splats()), ..asset() };
    attack("usdz", [asset(), field].map(|a| usdz::write(&a).unwrap()).to_vec(), |bytes| drop(usdz::read(bytes)));
}

/// Behind the check sums of the package.
#[test]
fn usdz_reader_inside_its_layer() {
    let layer = |asset: &Asset| {
        let package = usdz::write(asset).unwrap();
        let mut layer = Vec::new();
        let mut archive = zip::ZipArchive::new(Cursor::new(&package)).unwrap();
        archive.by_index(0).unwrap().read_to_end(&mut layer).unwrap();
        layer
    };
    let field = Asset { splats: Some(splats()), ..asset() };
    attack("usdz-inside", vec![layer(&asset()), layer(&field)], |bytes| {
        let mut zip = zip::ZipWriter::new(Cursor::new(Vec::new()));
        let options = zip::write::SimpleFileOptions::default()
            .compression_method(zip::CompressionMethod::Stored)
            .with_alignment(64);
        for (name, content) in [("model.usdc", bytes), ("textures/image0.png", &[1, 2, 3][..])] {
            zip.start_file(name, options).unwrap();
            zip.write_all(content).unwrap();
        }
        drop(usdz::read(&zip.finish().unwrap().into_inner()));
    });
}

#[test]
fn tileset_reader() {
    let tile = Tile {
        volume: Volume::around([0.0; 3], [1.0; 3]),
        content: Some("a.glb".into()),
        children: vec![Tile::default()],
        geometric_error: 1.0,
        transform: Some([1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0]),
    };
    let tileset = Tileset { geometric_error: 2.0, root: tile, gltf_extensions: Vec::new(), label: label() };
    attack("tileset", vec![tiles3d::write(&tileset).unwrap()], |bytes| drop(tiles3d::read(bytes)));
}

#[test]
fn openflight_reader() {
    let master = openflight::Master {
        name: "Crate".into(),
        bounds: ([-1.0, -1.0, 0.0], [1.0, 1.0, 2.0]),
        levels: vec![openflight::Reference {
            switch_in: 100.0,
            significant_size: 2.0,
            path: "./L04/a.flt".into(),
            ..openflight::Reference::default()
        }],
        ..openflight::Master::default()
    };
    let point = openflight::Point { comment: "<CDB:Point name=\"DIS_Origin\"/>".into(), matrix: [[1.0; 4]; 4] };
    let pointed = Model { points: vec![point], ..model() };
    let seeds = vec![openflight::write(&pointed).unwrap(), openflight::write_master(&master).unwrap()];
    attack("flt", seeds, |bytes| {
        drop(openflight::read(bytes));
        drop(openflight::read_master(bytes));
        drop(openflight::check(bytes));
    });
}

#[test]
fn sgi_reader() {
    let image = Image { width: 8, height: 4, channels: 3, pixels: (0..96).collect() };
    let seeds = [false, true].map(|rle| sgi::write(&image, "x", rle).unwrap()).to_vec();
    attack("sgi", seeds, |bytes| drop(sgi::read(bytes)));
}

#[test]
fn attributes_reader() {
    let attributes = openflight::attributes::Attributes {
        width: 8,
        height: 4,
        alpha: false,
        clamp: true,
        comment: "CLASSIFICATION: CUI".into(),
    };
    let seeds = vec![openflight::attributes::write(&attributes).unwrap()];
    attack("attr", seeds, |bytes| drop(openflight::attributes::read(bytes)));
}

const GRID: geotiff::Grid = geotiff::Grid { west: -118.5, north: 34.5, step_x: 0.5, step_y: 0.25, posts: true };

#[test]
fn geotiff_reader() {
    let heights: Vec<f32> = (0..64).map(|i| i as f32).collect();
    let seeds = vec![geotiff::write(8, 8, &heights, &GRID, "CUI").unwrap(), geotiff::degenerate(&GRID)];
    attack("geotiff", seeds, |bytes| {
        drop(geotiff::read(bytes));
        drop(geotiff::grid(bytes));
    });
}

#[test]
fn jp2_header() {
    let image = Image { width: 8, height: 4, channels: 3, pixels: (0..96).collect() };
    let seeds = vec![jp2::write(&image, Some(&GRID), "CUI").unwrap(), jp2::write(&image, None, "").unwrap()];
    attack("jp2", seeds, |bytes| drop(jp2::header(bytes)));
}

/// Every file of a store in turn: shapes, tables, XML, archives and the models in them.
#[test]
fn cdb_check() {
    let gs = cdb::Model {
        kind: cdb::Kind::Geospecific,
        material: cdb::Material::assumed("UA005"),
        name: "crate".into(),
        facc: "UA005".into(),
        fsc: 0,
        latitude: 34.5523,
        longitude: -118.4712,
        height: 740.0,
        heading: 30.0,
        levels: vec![cdb::Level {
            mesh: mesh(),
            significant_size: 3.0,
            texture: Image { width: 4, height: 4, channels: 3, pixels: vec![90; 48] },
        }],
        marking: "CLASSIFICATION: CUI".into(),
        date: "Mon Jan  1 00:00:00 2024".into(),
        dbf_date: (2024, 1, 1),
        comment: "made by Orb".into(),
    };
    let kinds = [
        cdb::Kind::Geospecific,
        cdb::Kind::Geotypical,
        cdb::Kind::Moving(cdb::EntityType::parse("1.1.225.27.1.2.3").unwrap()),
    ];
    let mut store = Memory::default();
    for kind in kinds {
        let added = cdb::add_model(&store, &cdb::Model { kind, ..gs.clone() }).unwrap();
        store.write(added.files);
    }
    let ground = cdb::Ground {
        latitude: gs.latitude,
        longitude: gs.longitude,
        height: gs.height,
        radius: 5000.0,
        terrain: None,
        colors: None,
        marking: &gs.marking,
    };
    let small = cdb::add_ground(&store, ground).unwrap().files.into_iter().filter(|f| f.bytes.len() < 10_000);
    store.write(small.filter(|f| f.path.contains("/LC/")));
    assert_eq!(cdb::check(&store).unwrap(), []);
    let paths: Vec<String> = store.files.keys().cloned().collect();
    // The first bytes choose the file, the rest is its damaged content.
    let seed = |i: usize| [&(i as u16).to_le_bytes()[..], &store.files[&paths[i]]].concat();
    let seeds: Vec<Vec<u8>> = (0..paths.len()).map(seed).collect();
    attack("cdb", seeds, |bytes| {
        let Some((&[a, b], content)) = bytes.split_first_chunk() else { return };
        let mut store = store.clone();
        store.files.insert(paths[usize::from(u16::from_le_bytes([a, b])) % paths.len()].clone(), content.to_vec());
        let _ = cdb::check(&store);
        let other = cdb::Model { name: "other".into(), kind: kinds[content.len() % 3], ..gs.clone() };
        let _ = cdb::add_model(&store, &other);
    });
}
