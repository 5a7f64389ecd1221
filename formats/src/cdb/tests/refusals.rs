//! What is refused: models, stores, full tiles.

use super::super::metadata::VERSION_XML;
use super::*;

#[test]
fn what_cannot_be_kept_is_refused() {
    let (latitude, longitude) = (34.5523, -118.4712);
    let good = store_with(&[car("Van", latitude, longitude)]);
    let tile = Tile::containing(latitude, longitude, 6).unwrap();
    let shp = path(tile, GEOSPECIFIC.dataset, GEOSPECIFIC.points(), "shp");
    let dbf = path(tile, GEOSPECIFIC.dataset, GEOSPECIFIC.points(), "dbf");
    let zip = path(tile, GS_MODEL_GEOMETRY, (1, 1), "zip");
    let vcmt = path(Tile::containing(latitude, longitude, 0).unwrap(), VECTOR_MATERIAL, (1, 1), "xml");
    let polygon = {
        let mut b = good.files[&shp].clone();
        b[32] = 15;
        b
    };
    let version =
        |inner: &str| format!("<Version xmlns=\"{}\">{inner}</Version>", metadata::VERSION_NAMESPACE).into_bytes();
    let gpkg = "Tiles/N34/W119/100_GSFeature/LC/U0/N34W119_D100_S001_T001_LC10_U0_R0.gpkg";
    for (file, bytes, reason) in [
        (shp.as_str(), polygon, "shape type 15"),
        (&shp, b"short".to_vec(), "shapefile"),
        (&dbf, b"short".to_vec(), "dBASE"),
        (&dbf, vec![], "missing"),
        (&zip, b"no zip".to_vec(), "cannot be kept"),
        (&vcmt, b"<a>".to_vec(), "XML"),
        (VERSION_XML, b"<Version".to_vec(), "XML"),
        (VERSION_XML, version("<PreviousIncrementalRootDirectory name=\"../old\"/>"), "../old"),
        ("Metadata/Configuration.xml", b"<Configuration/>".to_vec(), "several versions"),
        (gpkg, b"SQLite".to_vec(), "GeoPackage"),
    ] {
        let mut store = good.clone();
        store.files.insert(file.into(), bytes);
        let error = add_model(&store, &car("Truck", latitude, longitude)).unwrap_err().to_string();
        assert!(error.contains(reason), "{file}: {error}");
    }
}

#[test]
fn models_that_break_a_rule_are_refused() {
    let good = car("Van", 34.5523, -118.4712);
    type Fault = (fn(&mut Model), &'static str);
    let faults: [Fault; 15] = [
        (|m| m.facc = "car".into(), "feature code"),
        (|m| m.fsc = 1000, "feature code"),
        (|m| m.latitude = 91.0, "latitude"),
        (|m| m.longitude = f64::NAN, "longitude"),
        (|m| m.height = f64::INFINITY, "height"),
        (|m| m.heading = f64::NAN, "heading"),
        (|m| m.dbf_date = (1815, 6, 18), "date"),
        (|m| m.levels.clear(), "1 to 8 levels"),
        (|m| m.levels.swap(0, 1), "decrease"),
        (|m| m.levels[2].mesh.triangles.clear(), "level 2"),
        (|m| m.levels[1].mesh.positions[0][0] = f64::NAN, "not finite"),
        (|m| m.levels[1].texture.width = 100, "powers of two"),
        (|m| m.levels[1].mesh.uvs.iter_mut().for_each(|t| *t = [0.5; 2]), "map the mesh"),
        (|m| m.levels[3].mesh.positions.iter_mut().for_each(|p| p[0] += 0.01), "origin"),
        (
            |m| {
                let n = m.levels[0].mesh.clone();
                for i in 0..6 {
                    let first = m.levels[0].mesh.positions.len() as u32;
                    let shrink = 0.9 - 0.1 * f64::from(i);
                    m.levels[0].mesh.positions.extend(n.positions.iter().map(|p| p.map(|x| x * shrink)));
                    m.levels[0].mesh.normals.extend(&n.normals);
                    m.levels[0].mesh.uvs.extend(&n.uvs);
                    m.levels[0].mesh.triangles.extend(n.triangles.iter().map(|t| t.map(|v| v + first)));
                }
            },
            "168 vertices, LOD 4 takes 128",
        ),
    ];
    for (fault, reason) in faults {
        let mut model = good.clone();
        fault(&mut model);
        let error = add_model(&Empty, &model).unwrap_err().to_string();
        assert!(error.contains(reason), "expected {reason}: {error}");
    }
}

#[test]
fn a_full_tile_is_refused() {
    // At LOD −6 a tile takes four points.
    let huge = |i: i32| sized(&format!("Huge{i}"), 34.5 + 0.01 * f64::from(i), -118.5, 1000.0);
    let mut store = Memory::default();
    for i in 0..4 {
        assert_eq!(add_to(&mut store, &huge(i)).lods[0], -6);
    }
    assert_sound(&store);
    let error = add_model(&store, &huge(4)).unwrap_err().to_string();
    assert!(error.contains("is full") && error.contains("takes 4"), "{error}");
}

#[test]
fn a_nearly_full_archive_takes_a_smaller_texture_beside_the_geometry() {
    let (latitude, longitude) = (34.5523, -118.4712);
    let mut store = store_with(&[car("Van", latitude, longitude)]);
    let zip = path(Tile::containing(latitude, longitude, 7).unwrap(), GS_MODEL_TEXTURE, (1, 1), "zip");
    let filler = |store: &Memory, room: usize| {
        let old = Archive::read(store.files[&zip].clone(), &zip).unwrap();
        let name = "N34W119_D301_S001_T001_L07_U70_R67_Fill.rgb".to_string();
        let bytes = vec![0; super::archive::MAX_BYTES - old.length() - Archive::cost(&name, &[]) - room];
        old.with(&[(name, bytes)], "", &zip).unwrap()
    };
    let mut tight = store.clone();
    // Four mips of 64 texels a side, about 13 kB each, and one of 128 or less.
    tight.files.insert(zip.clone(), filler(&store, 70_000));
    let added = add_model(&tight, &car("Truck", latitude, longitude)).unwrap();
    assert!(added.notes.iter().any(|n| n.contains("LOD 7 is cut to 64 × 64")), "{:?}", added.notes);
    store.files.insert(zip.clone(), filler(&store, 10_000));
    let error = add_model(&store, &car("Truck", latitude, longitude)).unwrap_err().to_string();
    assert!(error.contains("the tile is full"), "{error}");
}
