//! What one more model costs in a CDB store that grows: in the whole of it, in one geocell, and in one tile.
//!
//! cargo run --release -p orb-formats --example cdb_growth -- FEATURES

use std::cell::Cell;
use std::io;
use std::time::Instant;

use orb_formats::cdb::{self, Memory, Store};
use orb_formats::{Image, Mesh};

/// Features of each geocell while the store grows.
const IN_A_CELL: usize = 1000;
/// Models that are tried and not kept, for each line.
const TRIES: usize = 25;

/// Counts what is read of a store.
struct Counted<'a> {
    store: &'a Memory,
    bytes: Cell<usize>,
    files: Cell<usize>,
}

impl Store for Counted<'_> {
    fn read(&self, path: &str) -> io::Result<Option<Vec<u8>>> {
        let found = self.store.read(path)?;
        self.bytes.set(self.bytes.get() + found.as_ref().map_or(0, Vec::len));
        self.files.set(self.files.get() + usize::from(found.is_some()));
        Ok(found)
    }

    fn exists(&self, path: &str) -> io::Result<bool> {
        self.store.exists(path)
    }
}

type Done = Result<(), Box<dyn std::error::Error>>;

/// Where the models of a store stand.
struct Area {
    /// Models of a geocell; the next go into the next one.
    in_a_cell: usize,
    /// Degrees of each geocell that they spread over, from its south-west corner.
    side: f64,
}

fn main() -> Done {
    let most: usize = std::env::args().nth(1).map_or(Ok(100_000), |n| n.parse())?;
    println!("a store that grows by geocells of {IN_A_CELL} features; one more model in the first of them");
    grow(&Area { in_a_cell: IN_A_CELL, side: 1.0 }, IN_A_CELL, most)?;
    println!("one geocell that grows");
    grow(&Area { in_a_cell: most, side: 1.0 }, 10, most)?;
    // The models' feature tiles are of LOD 5: a thirty-second of a degree, 16,384 points and 32 MB an archive at the most.
    println!("one tile that grows");
    let most = most.min(16_384);
    grow(&Area { in_a_cell: most, side: 1.0 / 32.0 }, 10, most)
}

/// Fills a store and measures one more model at `first` features, ten times as many, and so on to `most`.
fn grow(area: &Area, first: usize, most: usize) -> Done {
    let mut store = Memory::default();
    let mut next = first;
    for i in 0..most {
        match cdb::add_model(&store, &model(i, i / area.in_a_cell, i % area.in_a_cell, area)) {
            Ok(added) => store.write(added.files),
            Err(full) => {
                println!("after {i}: {full}");
                break;
            }
        }
        if i + 1 == next || i + 1 == most {
            measure(&store, i + 1, area)?;
            next *= 10;
        }
    }
    Ok(())
}

/// The median of some additions that are not kept.
fn measure(store: &Memory, features: usize, area: &Area) -> Done {
    let mut tries = Vec::new();
    for i in 0..TRIES {
        let counted = Counted { store, bytes: Cell::new(0), files: Cell::new(0) };
        let mut model = model(i, 0, i * area.in_a_cell / TRIES, area);
        (model.name, model.heading) = (format!("new{i}"), 90.0);
        let start = Instant::now();
        let added = cdb::add_model(&counted, &model)?;
        let seconds = start.elapsed().as_secs_f64();
        let written: usize = added.files.iter().map(|f| f.bytes.len()).sum();
        tries.push((seconds, counted.files.get(), counted.bytes.get(), added.files.len(), written));
    }
    tries.sort_by(|a, b| a.0.total_cmp(&b.0));
    let (seconds, files, bytes, new, written) = tries[TRIES / 2];
    println!(
        "{features:7} features: {:8.3} ms, {files} files with {bytes} bytes read, {new} with {written} written",
        1e3 * seconds
    );
    Ok(())
}

/// A model of one level in a grid over an area, in an order that fills no part of it first.
fn model(number: usize, cell: usize, place: usize, area: &Area) -> cdb::Model {
    let side = (area.in_a_cell as f64).sqrt().ceil() as usize;
    let spread = (place * 48_271) % (side * side);
    let step = |k: usize| area.side * (k as f64 + 0.5) / side as f64;
    let mesh = Mesh {
        positions: vec![[-1.0, -1.0, 0.0], [1.0, -1.0, 0.0], [1.0, 1.0, 0.0], [-1.0, 1.0, 2.0]],
        normals: vec![[0.0, 0.0, 1.0]; 4],
        uvs: vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]],
        triangles: vec![[0, 1, 2], [0, 2, 3]],
    };
    let texture = Image { width: 4, height: 4, channels: 3, pixels: vec![90; 48] };
    cdb::Model {
        kind: cdb::Kind::Geospecific,
        name: format!("crate{number}"),
        facc: "UA005".into(),
        fsc: 0,
        latitude: 34.0 + (cell / 20) as f64 + step(spread / side),
        longitude: -119.0 + (cell % 20) as f64 + step(spread % side),
        height: 10.0,
        heading: 0.0,
        material: cdb::Material::assumed("UA005"),
        levels: vec![cdb::Level { mesh, significant_size: 3.0, texture }],
        marking: "CLASSIFICATION: UNCLASSIFIED".into(),
        date: "Mon Jan  1 00:00:00 2024".into(),
        dbf_date: (2024, 1, 1),
        comment: String::new(),
    }
}
