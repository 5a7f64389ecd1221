//! How fast each format is written and read, beside its size: from structs in memory to a closed file and back, the
//! median of seven rounds. The files stay in the folder that is named, for other programs to be timed on
//! (`tests/clients/format_speed.py`, which runs this). A folder in memory keeps the disk out of it.
//!
//! cargo run --release -p orb-formats --example speed -- FOLDER
//!
//! A line a format, between tabs: name, what is counted, how many, bytes of the file, seconds to write, seconds to read.
//! Behind them, after a `#`, what the file alone costs, which every line has in it: to write and to read one of so many
//! bytes; and what a published file costs besides, which no line has in it: SHA-256, and the disk's word that it is there
//! (fsync, in the folder that `ORB_DISK` names, else in the system's temporary one).

#[path = "speed/data.rs"]
mod data;

use std::io::Write;
use std::path::{Path, PathBuf};
use std::time::Instant;

use sha2::{Digest, Sha256};

use orb_formats::asset::{EncodedImage, Material, Part};
use orb_formats::cdb::dbf::Table;
use orb_formats::cdb::shapefile;
use orb_formats::geotiff::Grid;
use orb_formats::openflight::{self, Geometry, Level, Model};
use orb_formats::spz::{self, Axes, Version};
use orb_formats::{Asset, Result, geotiff, glb, jp2, ply, sgi, tiles3d, usdz};

const ROUNDS: usize = 7;

fn main() -> std::result::Result<(), Box<dyn std::error::Error>> {
    let folder = PathBuf::from(std::env::args().nth(1).ok_or("name a folder for the files")?);
    std::fs::create_dir_all(&folder)?;
    let bench = Bench { folder: &folder };
    splats(&bench)?;
    triangles(&bench)?;
    rasters(&bench)?;
    features(&bench)?;
    let tileset = data::tileset();
    bench.line("3D Tiles", "tiles", data::TILES, "tileset.json", &|| tiles3d::write(&tileset), &|b| {
        tiles3d::read(b).map(drop)
    })?;
    bench.file_alone("scene.ply")
}

type Outcome = std::result::Result<(), Box<dyn std::error::Error>>;

fn splats(bench: &Bench) -> Outcome {
    let splats = data::splats();
    let n = data::SPLATS;
    bench.line("PLY", "splats", n, "scene.ply", &|| ply::write(&splats, &[]), &|b| ply::read(b).map(drop))?;
    for version in [Version::V2, Version::V3, Version::V4] {
        let options = spz::Options { version, ..spz::Options::default() };
        let name = format!("SPZ {}", version as u32);
        let file = format!("scene.v{}.spz", version as u32);
        let read = |b: &[u8]| spz::read(b, Axes::RUB).map(drop);
        bench.line(&name, "splats", n, &file, &|| spz::write(&splats, &options), &read)?;
    }
    let asset = Asset { splats: Some(splats), ..Asset::default() };
    bench.line("splat GLB", "splats", n, "scene.glb", &|| glb::write(&asset), &|b| glb::read(b).map(drop))
}

fn triangles(bench: &Bench) -> Outcome {
    let mesh = data::field();
    let n = mesh.triangles.len();
    let asset = Asset {
        name: "field".into(),
        parts: vec![Part { mesh: mesh.clone(), material: Some(0) }],
        materials: vec![Material { image: Some(0), ..Material::default() }],
        images: vec![EncodedImage { media_type: "image/png".into(), bytes: data::PNG.to_vec() }],
        ..Asset::default()
    };
    bench.line("GLB", "triangles", n, "field.glb", &|| glb::write(&asset), &|b| glb::read(b).map(drop))?;
    let packed = || glb::write_as(&asset, glb::Compression::Meshopt);
    bench.line("GLB, meshopt", "triangles", n, "packed.glb", &packed, &|b| glb::read(b).map(drop))?;
    bench.line("USDZ", "triangles", n, "field.usdz", &|| usdz::write(&asset), &|b| usdz::read(b).map(drop))?;
    let level = Level { switch_in: 1000.0, significant_size: 1.0, mesh, ..Level::default() };
    let model = Model { name: "field".into(), levels: vec![level], ..Model::default() };
    for (name, file, geometry) in
        [("OpenFlight faces", "faces.flt", Geometry::Faces), ("OpenFlight meshes", "meshes.flt", Geometry::Meshes)]
    {
        let write = || openflight::write_as(&model, geometry);
        bench.line(name, "triangles", n, file, &write, &|b| openflight::read(b).map(drop))?;
    }
    Ok(())
}

fn rasters(bench: &Bench) -> Outcome {
    let texture = data::image(2048);
    let n = 2048 * 2048;
    bench.line("SGI .rgb", "pixels", n, "texture.rgb", &|| sgi::write(&texture, "", true), &|b| {
        sgi::read(b).map(drop)
    })?;
    let side = 1024;
    let grid = Grid { west: -119.0, north: 35.0, step_x: 1.0 / 1024.0, step_y: 1.0 / 1024.0, posts: true };
    let heights = data::heights(side as usize);
    let n = (side * side) as usize;
    bench.line("GeoTIFF", "posts", n, "tile.tif", &|| geotiff::write(side, side, &heights, &grid, ""), &|b| {
        geotiff::read(b).map(drop)
    })?;
    let image = data::image(side);
    // Orb reads the headers of imagery alone: nothing to time.
    let write = || jp2::write(&image, Some(&Grid { posts: false, ..grid }), "");
    let (seconds, bytes) = bench.written("tile.jp2", &write)?;
    println!("JPEG 2000\tpixels\t{n}\t{bytes}\t{seconds}\t-");
    Ok(())
}

/// The `.shp`, `.shx` and `.dbf` of a full tile; the `.dbf`'s every value is looked at.
fn features(bench: &Bench) -> Outcome {
    let (points, table) = (data::points(), data::table()?);
    let names = ["features.shp", "features.shx", "features.dbf"];
    let path = |name: &str| bench.folder.join(name);
    let write = || -> Outcome {
        let (shp, shx) = shapefile::write(&points);
        for (name, bytes) in names.iter().zip([shp, shx, table.write()?]) {
            std::fs::write(path(name), bytes)?;
        }
        Ok(())
    };
    let read = || -> Outcome {
        let points = shapefile::read(&std::fs::read(path(names[0]))?)?;
        let table = Table::read(&std::fs::read(path(names[2]))?)?;
        for i in 0..points.len() {
            std::hint::black_box(table.text(i, "MODL"));
            for name in ["HGT", "BSR", "AO1"] {
                std::hint::black_box(table.number(i, name));
            }
        }
        Ok(())
    };
    let (write, read) = (median(write)?, median(read)?);
    let bytes = names.iter().map(|n| std::fs::metadata(path(n)).map(|m| m.len())).sum::<std::io::Result<u64>>()?;
    println!("Shapefile\tpoints\t{}\t{bytes}\t{write}\t{read}", points.len());
    Ok(())
}

struct Bench<'a> {
    folder: &'a Path,
}

impl Bench<'_> {
    /// Times a writer and a reader and prints their line.
    fn line(
        &self,
        name: &str,
        unit: &str,
        count: usize,
        file: &str,
        write: &dyn Fn() -> Result<Vec<u8>>,
        read: &dyn Fn(&[u8]) -> Result<()>,
    ) -> Outcome {
        let (written, bytes) = self.written(file, write)?;
        let path = self.folder.join(file);
        let read = median(|| Ok(read(&std::fs::read(&path)?)?))?;
        println!("{name}\t{unit}\t{count}\t{bytes}\t{written}\t{read}");
        Ok(())
    }

    /// Costs of a file, whatever stands in it.
    fn file_alone(&self, file: &str) -> Outcome {
        let path = self.folder.join(file);
        let bytes = std::fs::read(&path)?;
        let copy = self.folder.join("alone.bin");
        let write = median(|| Ok(std::fs::write(&copy, &bytes)?))?;
        let read = median(|| {
            std::hint::black_box(std::fs::read(&copy)?);
            Ok(())
        })?;
        let hash = median(|| {
            std::hint::black_box(Sha256::digest(&bytes));
            Ok(())
        })?;
        std::fs::remove_file(&copy)?;
        let disk = std::env::var_os("ORB_DISK").map_or_else(std::env::temp_dir, PathBuf::from).join("orb-speed.bin");
        let unsynced = median(|| Ok(std::fs::write(&disk, &bytes)?))?;
        let synced = median(|| {
            let mut file = std::fs::File::create(&disk)?;
            file.write_all(&bytes)?;
            Ok(file.sync_all()?)
        })?;
        std::fs::remove_file(&disk)?;
        let rate = |seconds: f64| format!("{:.0} MB/s", bytes.len() as f64 / seconds / 1e6);
        println!(
            "# a file of {:.1} MB alone: written {}, read {}; SHA-256 {}; on the disk {}, with fsync {}",
            bytes.len() as f64 / 1e6,
            rate(write),
            rate(read),
            rate(hash),
            rate(unsynced),
            rate(synced)
        );
        Ok(())
    }

    /// Median seconds of writing a file, and its bytes.
    fn written(
        &self,
        file: &str,
        write: &dyn Fn() -> Result<Vec<u8>>,
    ) -> std::result::Result<(f64, u64), Box<dyn std::error::Error>> {
        let path = self.folder.join(file);
        let seconds = median(|| Ok(std::fs::write(&path, write()?)?))?;
        Ok((seconds, std::fs::metadata(&path)?.len()))
    }
}

fn median(work: impl Fn() -> Outcome) -> std::result::Result<f64, Box<dyn std::error::Error>> {
    let mut times = Vec::new();
    for _ in 0..ROUNDS {
        let start = Instant::now();
        work()?;
        times.push(start.elapsed().as_secs_f64());
    }
    times.sort_by(f64::total_cmp);
    Ok(times[ROUNDS / 2])
}
