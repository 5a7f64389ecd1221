//! What one more model costs in a CDB store that grows: time, files and bytes of the last addition.
//!
//! cargo run --release -p orb-formats --example cdb_growth -- FEATURES

use std::cell::Cell;
use std::io;
use std::time::Instant;

use orb_formats::cdb::{self, Memory, Store};
use orb_formats::{Image, Mesh};

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
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let most: usize = std::env::args().nth(1).map_or(Ok(100_000), |n| n.parse())?;
    let mesh = Mesh {
        positions: vec![[-1.0, -1.0, 0.0], [1.0, -1.0, 0.0], [1.0, 1.0, 0.0], [-1.0, 1.0, 2.0]],
        normals: vec![[0.0, 0.0, 1.0]; 4],
        uvs: vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]],
        triangles: vec![[0, 1, 2], [0, 2, 3]],
    };
    let texture = Image { width: 4, height: 4, channels: 3, pixels: vec![90; 48] };
    let mut store = Memory::default();
    // A grid over one geocell, in an order that fills no part of it first.
    let side = (most as f64).sqrt().ceil() as usize;
    let mut next = 10;
    for i in 0..most {
        let spread = (i * 48_271) % (side * side);
        let (row, column) = (spread / side, spread % side);
        let step = |k: usize| (k as f64 + 0.5) / side as f64;
        let model = cdb::GsModel {
            name: format!("crate{i}"),
            facc: "UA005".into(),
            fsc: 0,
            latitude: 34.0 + step(row),
            longitude: -119.0 + step(column),
            height: 10.0,
            heading: 0.0,
            levels: vec![cdb::Level { mesh: mesh.clone(), significant_size: 3.0, texture: texture.clone() }],
            marking: "CLASSIFICATION: UNCLASSIFIED".into(),
            date: "Mon Jan  1 00:00:00 2024".into(),
            dbf_date: (2024, 1, 1),
            comment: String::new(),
        };
        let counted = Counted { store: &store, bytes: Cell::new(0), files: Cell::new(0) };
        let start = Instant::now();
        let added = cdb::add_model(&counted, &model)?;
        let seconds = start.elapsed().as_secs_f64();
        if i + 1 == next || i + 1 == most {
            let written: usize = added.files.iter().map(|f| f.bytes.len()).sum();
            println!(
                "{:7} features: {:.4} s, {} files with {} bytes read, {} with {written} written",
                i + 1,
                seconds,
                counted.files.get(),
                counted.bytes.get(),
                added.files.len()
            );
            next *= 10;
        }
        store.write(added.files);
    }
    Ok(())
}
