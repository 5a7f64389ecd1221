//! Whole stores: the smallest complete one, and growing ones.

use std::cell::RefCell;
use std::collections::BTreeSet;

use super::archive::Archive;
use super::attributes::GEOSPECIFIC;
use super::features::FeatureTile;
use super::geocell::Tile;
use super::names::{GS_MODEL_GEOMETRY, GS_MODEL_TEXTURE, VECTOR_MATERIAL, path};
use super::shapefile::PointZ;
use super::*;
use crate::{Image, Mesh};

mod faults;
mod foreign;
mod libraries;
mod refusals;
mod versions;

const DATE: (u16, u8, u8) = (2026, 5, 4);

/// A box of width, length and height on the ground; its faces fill the texture in six strips.
fn block(w: f64, l: f64, h: f64) -> Mesh {
    let mut mesh = Mesh::default();
    let axes: [([f64; 3], [f64; 3], [f64; 3]); 6] = [
        ([1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]),
        ([-1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, 1.0]),
        ([0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 0.0, 1.0]),
        ([0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]),
        ([0.0, 0.0, 1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]),
        ([0.0, 0.0, -1.0], [-1.0, 0.0, 0.0], [0.0, 1.0, 0.0]),
    ];
    for (face, (n, u, v)) in axes.into_iter().enumerate() {
        let first = mesh.positions.len() as u32;
        for (su, sv) in [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)] {
            let at = |a: usize| n[a] + su * u[a] + sv * v[a];
            mesh.positions.push([at(0) * w / 2.0, at(1) * l / 2.0, (at(2) + 1.0) * h / 2.0]);
            mesh.normals.push(n.map(|x| x as f32));
            mesh.uvs.push([(face as f32 + (su as f32 + 1.0) / 2.0) / 6.0, (sv as f32 + 1.0) / 2.0]);
        }
        mesh.triangles.extend([[first, first + 1, first + 2], [first, first + 2, first + 3]]);
    }
    mesh
}

fn texture(side: u32) -> Image {
    let pixels = (0..side * side).flat_map(|i| [(i % side) as u8, (i / side) as u8, 128]).collect();
    Image { width: side, height: side, channels: 3, pixels }
}

/// A car of four levels: 4.9 m across, so LOD 4 to 7; textures of 128 texels a side, 4.5 cm a texel, so LOD 8 and coarser.
fn car(name: &str, latitude: f64, longitude: f64) -> Model {
    let level = |size| Level { mesh: block(1.8, 4.2, 1.5), significant_size: size, texture: texture(128) };
    Model {
        kind: Kind::Geospecific,
        name: name.into(),
        facc: "UA005".into(),
        material: Material::assumed("UA005"),
        fsc: 0,
        latitude,
        longitude,
        height: 740.0,
        heading: 30.0,
        levels: [4.86, 0.4, 0.1, 0.02].map(level).into(),
        marking: "UNCLASSIFIED".into(),
        date: "Mon May  4 12:00:00 2026".into(),
        dbf_date: DATE,
        comment: "Made by a test".into(),
    }
}

fn add_to(store: &mut Memory, model: &Model) -> Added {
    let added = add_model(store, model).unwrap();
    store.write(added.files.clone());
    added
}

fn store_with(models: &[Model]) -> Memory {
    let mut store = Memory::default();
    models.iter().for_each(|m| drop(add_to(&mut store, m)));
    store
}

fn assert_sound(store: &Memory) {
    let findings: Vec<String> = check(store).unwrap().iter().map(Finding::to_string).collect();
    assert!(findings.is_empty(), "{findings:#?}");
}

fn features(store: &Memory, latitude: f64, longitude: f64, lod: i8) -> FeatureTile {
    let tile = Tile::containing(latitude, longitude, lod).unwrap();
    FeatureTile::read(store, &GEOSPECIFIC, tile, DATE).unwrap().unwrap()
}

#[test]
fn one_model_makes_the_smallest_complete_store() {
    let added = add_model(&Empty, &car("OrbVan", 34.5523, -118.4712)).unwrap();
    let mut expected = BTreeSet::from(["Metadata/Version.xml".to_string()]);
    for schema in metadata::SCHEMAS {
        expected.insert(format!("Metadata/Schema/{}.xsd", schema.0));
    }
    let cell = "Tiles/N34/W119";
    let mut tiles: Vec<(String, String, u32, u32)> =
        (1..=10).map(|n| (format!("LC{n:02}"), "LC".to_string(), 0, 0)).collect();
    for (lod, u, r) in [(0, 0, 0), (1, 1, 1), (2, 2, 2), (3, 4, 4), (4, 8, 8), (5, 17, 16), (6, 35, 33), (7, 70, 67)] {
        tiles.push((format!("L{lod:02}"), format!("L{lod:02}"), u, r));
    }
    for (lod, folder, u, r) in tiles {
        let file = format!("{cell}/100_GSFeature/{folder}/U{u}/N34W119_D100_S001_T001_{lod}_U{u}_R{r}");
        expected.extend(["shp", "shx", "dbf"].map(|e| format!("{file}.{e}")));
        expected.insert(format!("{}.dbf", file.replace("_T001_", "_T002_")));
    }
    expected.insert(format!("{cell}/200_VectorMaterial/L00/U0/N34W119_D200_S001_T001_L00_U0_R0.xml"));
    for (lod, u, r) in [(4, 8, 8), (5, 17, 16), (6, 35, 33), (7, 70, 67)] {
        for (dataset, code) in [("300_GSModelGeometry", 300), ("303_GSModelDescriptor", 303)] {
            expected
                .insert(format!("{cell}/{dataset}/L{lod:02}/U{u}/N34W119_D{code}_S001_T001_L{lod:02}_U{u}_R{r}.zip"));
        }
    }
    let mips = [(8, 141, 135), (7, 70, 67), (6, 35, 33), (5, 17, 16), (4, 8, 8), (3, 4, 4), (2, 2, 2), (1, 1, 1)];
    for (lod, u, r) in mips {
        expected
            .insert(format!("{cell}/301_GSModelTexture/L{lod:02}/U{u}/N34W119_D301_S001_T001_L{lod:02}_U{u}_R{r}.zip"));
    }
    let found: BTreeSet<String> = added.files.iter().map(|f| f.path.clone()).collect();
    assert_eq!(found, expected);
    assert_eq!(found.iter().filter(|p| p.starts_with("Tiles/")).count(), 89);
    assert_eq!(found.len(), added.files.len(), "no path twice");
    assert_eq!(added.folders, ["GTModel", "MModel", "Navigation", "Metadata/Stylesheet"]);
    assert_eq!((added.model_name.as_str(), added.class_name.as_str()), ("OrbVan", "UA005000OrbVan"));
    assert_eq!((added.geocell.as_str(), &added.lods[..]), ("N34W119", &[4, 5, 6, 7][..]));
    assert!(added.notes.is_empty() && !added.already_present, "{:?}", added.notes);
    let mut store = Memory::default();
    store.write(added.files);
    assert_sound(&store);
}

#[test]
fn archives_hold_both_texture_layouts_and_the_palette_finds_one() {
    let store = store_with(&[car("OrbVan", 34.5523, -118.4712)]);
    let tile = |lod| Tile::containing(34.5523, -118.4712, lod).unwrap();
    let open = |dataset, lod| {
        let path = path(tile(lod), dataset, (1, 1), "zip");
        Archive::read(store.files[&path].clone(), &path).unwrap()
    };
    let names: Vec<String> = open(GS_MODEL_TEXTURE, 7).names().map(String::from).collect();
    let base = "N34W119_D301_S001_T001_L07_U70_R67_OrbVan";
    assert_eq!(names, ["_0", "_1", "_2", "_3", "_3_tile"].map(|s| format!("{base}{s}.rgb")));
    let model = "N34W119_D300_S001_T001_L07_U70_R67_UA005_000_OrbVan.flt";
    let geometry = open(GS_MODEL_GEOMETRY, 7);
    assert_eq!(geometry.names().collect::<Vec<_>>(), [model]);
    let flt = crate::openflight::read(&geometry.get(model).unwrap()).unwrap();
    assert_eq!(flt.textures, [format!("../../../301_GSModelTexture/L07/U70/{base}_3_tile.rgb")]);
    assert_eq!(flt.zone_comment.as_deref(), Some("<CDB:Zone name=\"OrbVan\"><Material>1</Material></CDB:Zone>"));
    assert_eq!(flt.levels[0].significant_size, 4.86 / 8.0);
    let (image, name) = crate::sgi::read(&open(GS_MODEL_TEXTURE, 7).get(&names[4]).unwrap()).unwrap();
    assert_eq!((image, name.as_str()), (texture(128), "UNCLASSIFIED"));
    let (mip, _) = crate::sgi::read(&open(GS_MODEL_TEXTURE, 7).get(&names[0]).unwrap()).unwrap();
    assert_eq!((mip.width, mip.height), (64, 64));
}

#[test]
fn the_marking_is_in_every_file_that_has_room() {
    let mut model = car("OrbVan", 34.5523, -118.4712);
    model.marking = "SECRET//TEST".into();
    for file in add_model(&Empty, &model).unwrap().files {
        let has = file.bytes.windows(12).any(|w| w == b"SECRET//TEST");
        let room = ![".shp", ".shx", ".dbf"].iter().any(|e| file.path.ends_with(e));
        assert_eq!(has, room, "{}", file.path);
    }
}

#[test]
fn attributes_say_where_and_how_large() {
    let mut model = car("OrbVan", 34.5523, -118.4712);
    model.heading = -0.0001;
    let store = store_with(&[model]);
    for (lod, count) in [(-10, 0), (3, 0), (4, 1), (5, 1), (6, 1), (7, 1)] {
        assert_eq!(features(&store, 34.5523, -118.4712, lod).points.len(), count);
    }
    let f = features(&store, 34.5523, -118.4712, 6);
    assert_eq!(f.points[0], Some(PointZ { x: -118.4712, y: 34.5523, z: 740.0, m: 0.0 }));
    assert_eq!(f.instances.columns()[0].name(), "CNAM");
    for table in [&f.instances, &f.classes] {
        for (name, expected) in [
            ("CNAM", "UA005000OrbVan"),
            ("FACC", "UA005"),
            ("FSC", "0"),
            ("MODL", "OrbVan"),
            ("HGT", "1.50"),
            ("CMIX", "1"),
        ] {
            assert_eq!(table.text(0, name).as_deref(), Some(expected), "{name}");
        }
        assert_eq!(
            (table.number(0, "BBW"), table.number(0, "BBL"), table.number(0, "BBH")),
            (Some(1.8), Some(4.2), Some(1.5))
        );
        let radius = 0.9f64.hypot(2.1).hypot(1.5);
        assert!((table.number(0, "BSR").unwrap() - radius).abs() < 1e-3 && table.number(0, "BSR").unwrap() >= radius);
    }
    assert_eq!((f.instances.number(0, "MLOD"), f.instances.number(0, "AO1")), (Some(6.0), Some(0.0)));
    assert_eq!((f.instances.logical(0, "AHGT"), f.instances.number(0, "SCALx")), (Some(true), Some(1.0)));
}

#[test]
fn the_same_input_gives_the_same_bytes() {
    let model = car("OrbVan", 34.5523, -118.4712);
    assert_eq!(add_model(&Empty, &model).unwrap(), add_model(&Empty, &model).unwrap());
}

#[test]
fn a_second_model_leaves_the_first_as_it_was() {
    let first = store_with(&[car("OrbVan", 34.5523, -118.4712)]);
    // Same finest tile; same tile to LOD 4 only; another geocell.
    for (latitude, longitude) in [(34.5524, -118.4713), (34.5523, -118.46), (-33.8568, 151.2153)] {
        let mut other = car("Truck", latitude, longitude);
        other.facc = "AL015".into();
        other.material = Material::assumed("AL015");
        let mut store = first.clone();
        let added = add_to(&mut store, &other);
        assert_sound(&store);
        assert!(added.folders.is_empty());
        assert!(!added.files.iter().any(|f| f.path.starts_with("Metadata/")));
        for (path, bytes) in &first.files {
            let now = &store.files[path];
            if path.ends_with(".zip") {
                let (old, new) =
                    (Archive::read(bytes.clone(), path).unwrap(), Archive::read(now.clone(), path).unwrap());
                for name in old.names() {
                    assert_eq!(old.get(name), new.get(name), "{name}");
                }
            } else if path.contains("200_Vector") {
                assert!(String::from_utf8_lossy(now).contains("BM_METAL-STEEL"));
            } else if !path.contains("100_GSFeature") {
                assert_eq!(bytes, now, "{path}");
            }
        }
        for lod in 4..=7 {
            let (old, new) = (features(&first, 34.5523, -118.4712, lod), features(&store, 34.5523, -118.4712, lod));
            assert_eq!(old.points[0], new.points[0]);
            for column in old.instances.columns() {
                assert_eq!(old.instances.text(0, &column.name()), new.instances.text(0, &column.name()));
            }
        }
    }
}

#[test]
fn materials_of_two_models_keep_their_indices() {
    let mut house = car("House", 34.5524, -118.4713);
    house.facc = "AL015".into();
    house.material = Material::assumed("AL015");
    let mut store = store_with(&[car("OrbVan", 34.5523, -118.4712), house]);
    let f = features(&store, 34.5523, -118.4712, 7);
    assert_eq!((f.instances.number(0, "CMIX"), f.instances.number(1, "CMIX")), (Some(1.0), Some(2.0)));
    let path = path(Tile::containing(34.5, -118.5, 0).unwrap(), VECTOR_MATERIAL, (1, 1), "xml");
    let table = store.files[&path].clone();
    add_to(&mut store, &car("Van", 34.5525, -118.4711));
    assert_eq!(store.files[&path], table, "an equal material is used again");
    assert_sound(&store);
}

#[test]
fn namesakes_get_names_of_their_own() {
    let mut store = Memory::default();
    let mut names = Vec::new();
    // Three at one place, two elsewhere in the geocell, one in another geocell, one that differs by case.
    for (name, latitude, longitude) in [
        ("van", 34.5523, -118.4712),
        ("van", 34.5524, -118.4713),
        ("VAN", 34.5525, -118.4712),
        ("van", 34.1, -118.9),
        ("van", 34.1001, -118.9),
        ("van", 35.5, -118.5),
    ] {
        names.push(add_to(&mut store, &car(name, latitude, longitude)).model_name);
    }
    assert_eq!(names[0], "van");
    assert_eq!(names[1], "van_2");
    assert_eq!(names[2], "VAN_3");
    assert!(names[3].starts_with("van_") && names[4] == format!("{}_2", names[3]), "{names:?}");
    assert_eq!(names[5], "van");
    assert_sound(&store);
}

#[test]
fn the_very_same_model_is_not_added_twice() {
    let model = car("van", 34.5523, -118.4712);
    let elsewhere = car("van", 34.1, -118.9);
    let store = store_with(&[model.clone(), elsewhere.clone()]);
    for m in [model, elsewhere] {
        let again = add_model(&store, &m).unwrap();
        assert!(again.already_present && again.files.is_empty(), "{:?}", again.model_name);
    }
}

#[test]
fn other_latitudes_and_hemispheres_are_sound() {
    for (latitude, longitude) in
        [(62.3, -160.4), (-33.8568, 151.2153), (-5.2, 45.2), (0.0, 0.0), (-89.0, 179.99), (84.9, -180.0)]
    {
        let store = store_with(&[car("Van", latitude, longitude), car("Truck", latitude, longitude)]);
        assert_sound(&store);
        assert_eq!(features(&store, latitude, longitude, 7).points.len(), 2);
    }
}

#[test]
fn near_a_pole_fine_tiles_are_too_narrow() {
    let added = add_model(&Empty, &car("Van", 89.99, 0.5)).unwrap();
    assert_eq!(added.lods, [4, 5]);
    assert!(added.notes[0].contains("LOD 7 is left out"), "{:?}", added.notes);
    assert!(add_model(&Empty, &car("Van", 90.0, 0.5)).unwrap_err().to_string().contains("meridians"));
}

/// Adds levels of other LODs at one place: a big model coarse, a small one fine.
fn sized(name: &str, latitude: f64, longitude: f64, scale: f64) -> Model {
    let mut model = car(name, latitude, longitude);
    for level in &mut model.levels {
        level.mesh.positions.iter_mut().flatten().for_each(|x| *x *= scale);
        level.significant_size *= scale;
    }
    model
}

#[test]
fn features_are_repeated_in_every_finer_tile() {
    let (latitude, longitude) = (34.5523, -118.4712);
    // Big first: the small one's finer tiles must repeat it, as far as it lies in them.
    let mut store = store_with(&[sized("Big", latitude, longitude, 16.0)]);
    let old = features(&store, latitude, longitude, 3);
    let added = add_to(&mut store, &sized("Small", latitude, longitude, 0.25));
    assert_eq!(added.lods, [6, 7, 8, 9]);
    assert_sound(&store);
    for lod in 4..=9 {
        let f = features(&store, latitude, longitude, lod);
        assert_eq!((f.points[0], f.number(0, "MLOD")), (old.points[0], Some(3.0)), "LOD {lod}");
        assert_eq!(f.points.len(), if lod >= 6 { 2 } else { 1 }, "LOD {lod}");
    }
    // A third one, far enough that the finest tiles are not shared.
    let third = add_to(&mut store, &sized("Third", latitude + 0.003, longitude, 0.25));
    assert_sound(&store);
    assert_eq!(features(&store, latitude + 0.003, longitude, 9).points.len(), 1);
    assert_eq!(third.lods, [6, 7, 8, 9]);

    // Small first: the big one must reach into the finer tiles that are there.
    let mut store = store_with(&[sized("Small", latitude, longitude, 0.25)]);
    add_to(&mut store, &sized("Big", latitude, longitude, 16.0));
    assert_sound(&store);
    let f = features(&store, latitude, longitude, 9);
    assert_eq!((f.points.len(), f.number(1, "MLOD")), (2, Some(3.0)));
}

/// Counts reads.
struct Counting<'a>(&'a Memory, RefCell<BTreeSet<String>>);

impl Store for Counting<'_> {
    fn read(&self, path: &str) -> std::io::Result<Option<Vec<u8>>> {
        self.1.borrow_mut().insert(path.into());
        self.0.read(path)
    }

    fn exists(&self, path: &str) -> std::io::Result<bool> {
        self.0.exists(path)
    }

    fn size(&self, path: &str) -> std::io::Result<Option<u64>> {
        self.0.size(path)
    }
}

#[test]
fn only_the_model_s_own_tiles_are_read() {
    let far: Vec<Model> = (0..20).map(|i| car("Far", 34.01 + 0.04 * f64::from(i), -118.99)).collect();
    let mut store = store_with(&far);
    let here = car("Here", 34.5523, -118.4712);
    let counting = Counting(&store, RefCell::default());
    let added = add_model(&counting, &here).unwrap();
    let place = |p: &str| names::parse(p).is_none_or(|f| f.tile.contains(34.5523, -118.4712));
    assert!(counting.1.borrow().iter().all(|p| place(p)), "{:?}", counting.1.borrow());
    let reads = counting.1.borrow().len();
    assert!(reads < 60, "{reads} reads");
    assert!(added.files.iter().all(|f| place(&f.path)));
    store.write(added.files);
    assert_sound(&store);
}

#[test]
fn the_finest_level_has_its_whole_texture_beside_it() {
    let mut model = car("Van", 34.5523, -118.4712);
    model.levels.iter_mut().for_each(|l| l.texture = texture(1024));
    for count in 1..=4 {
        model.levels.truncate(count);
        let store = store_with(&[model.clone()]);
        assert_sound(&store);
        for (i, side) in [128, 256, 512, 1024].into_iter().take(count).enumerate() {
            let tile = Tile::containing(34.5523, -118.4712, 4 + i as i8).unwrap();
            let zip = path(tile, GS_MODEL_TEXTURE, (1, 1), "zip");
            let archive = Archive::read(store.files[&zip].clone(), &zip).unwrap();
            let name = archive.names().find(|n| n.ends_with("_tile.rgb")).unwrap();
            let (image, _) = crate::sgi::read(&archive.get(name).unwrap()).unwrap();
            assert_eq!(image.width, if i + 1 == count { 1024 } else { side }, "level {i} of {count}");
        }
        model.levels.resize(4, model.levels[0].clone());
        let sizes = [4.86, 0.4, 0.1, 0.02];
        model.levels.iter_mut().zip(sizes).for_each(|(l, s)| l.significant_size = s);
    }
}

#[test]
fn a_deleted_tile_is_written_anew() {
    // A file of no bytes stands for a deleted one.
    let (latitude, longitude) = (34.5523, -118.4712);
    for lod in [-4, 2, 4, 6, 7] {
        let mut store = store_with(&[car("Van", latitude, longitude)]);
        let tile = Tile::containing(latitude, longitude, lod).unwrap();
        store.files.insert(path(tile, names::GS_FEATURE, (1, 1), "shp"), vec![]);
        add_to(&mut store, &sized("Truck", latitude, longitude, 2.0));
        // Truck has LOD 3 to 6; what was deleted beyond stays deleted.
        if (3..=6).contains(&lod) {
            assert!(features(&store, latitude, longitude, lod).text(0, "MODL").is_some());
        }
    }
}
