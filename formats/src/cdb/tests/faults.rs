//! Faults planted in a sound store are found.

use super::super::dbf::{Table, Value};
use super::*;

#[test]
fn planted_faults_are_found() {
    let (latitude, longitude) = (34.5523, -118.4712);
    let good = store_with(&[car("Van", latitude, longitude)]);
    let at = |lod| Tile::containing(latitude, longitude, lod).unwrap();
    let rules = |change: &dyn Fn(&mut Memory)| -> BTreeSet<u8> {
        let mut store = good.clone();
        change(&mut store);
        assert_ne!(store, good, "nothing was planted");
        check(&store).unwrap().iter().map(|f| f.rule).collect()
    };
    let remove = |file: String| rules(&|s: &mut Memory| drop(s.files.remove(&file)));
    let shp = |lod| path(at(lod), GEOSPECIFIC.dataset, GEOSPECIFIC.points(), "shp");
    let zip = |dataset, lod| path(at(lod), dataset, (1, 1), "zip");
    assert!(remove(zip(GS_MODEL_GEOMETRY, 5)).contains(&1));
    assert!(remove(zip(names::GS_MODEL_DESCRIPTOR, 5)).contains(&1));
    assert!(remove(zip(GS_MODEL_TEXTURE, 5)).contains(&2));
    assert!(remove(zip(GS_MODEL_TEXTURE, 1)).contains(&2), "the last mip");
    assert!(remove(shp(-3)).contains(&3));
    assert!(remove(path(at(2), GEOSPECIFIC.dataset, GEOSPECIFIC.classes(), "dbf")).contains(&3));
    assert!(remove(shp(7)).contains(&4), "a level whose feature tile is missing");
    assert!(remove("Metadata/Version.xml".into()).contains(&12));
    assert!(remove("Metadata/Schema/Lights.xsd".into()).contains(&12));
    assert!(remove(path(at(0), VECTOR_MATERIAL, (1, 1), "xml")).contains(&9));

    let set = |lod, column: &str, value: Value| {
        rules(&|s: &mut Memory| {
            let file = path(at(lod), GEOSPECIFIC.dataset, GEOSPECIFIC.points(), "dbf");
            let mut table = Table::read(&s.files[&file]).unwrap();
            let c = table.column(column).unwrap();
            table.set(0, c, &value).unwrap();
            s.files.insert(file, table.write().unwrap());
        })
    };
    assert!(set(6, "MLOD", Value::Number(7.0)).contains(&4));
    assert!(set(6, "MLOD", Value::Number(5.0)).contains(&4));
    assert!(set(6, "AO1", Value::Number(360.0)).contains(&8));
    assert!(set(6, "BSR", Value::Number(9.0)).contains(&8));
    assert!(set(6, "HGT", Value::Number(1.0)).contains(&8));
    assert!(set(6, "CMIX", Value::Number(2.0)).contains(&9));
    assert!(set(6, "MODL", Value::Text("Other".into())).contains(&1));
    assert!(set(6, "CNAM", Value::Text("Other".into())).contains(&1));

    let rewrite = |dataset, lod, change: &dyn Fn(String, Vec<u8>) -> (String, Vec<u8>)| {
        rules(&|s: &mut Memory| {
            let file = zip(dataset, lod);
            let old = Archive::read(s.files[&file].clone(), &file).unwrap();
            let new: Vec<_> = old.names().map(|n| change(n.into(), old.get(n).unwrap())).collect();
            s.files.insert(file.clone(), Archive::default().with(&new, "", &file).unwrap());
        })
    };
    let patch = |offset: usize, bytes: &'static [u8]| {
        move |n: String, mut b: Vec<u8>| {
            b[offset..offset + bytes.len()].copy_from_slice(bytes);
            (n, b)
        }
    };
    assert!(rewrite(GS_MODEL_TEXTURE, 6, &patch(0, &[0, 0])).contains(&2), "SGI magic");
    assert!(rewrite(GS_MODEL_GEOMETRY, 6, &patch(95, &[5])).contains(&6), "projection");
    assert!(rewrite(GS_MODEL_GEOMETRY, 6, &|n, b| (n.replace("L06_U35", "L06_U36"), b)).contains(&10));
    let replace = |from: &'static str, to: &'static str| {
        move |n: String, b: Vec<u8>| {
            let at = b.windows(from.len()).position(|w| w == from.as_bytes());
            assert!(at.is_some() && from.len() == to.len(), "{from}");
            let mut b = b;
            b[at.unwrap()..at.unwrap() + to.len()].copy_from_slice(to.as_bytes());
            (n, b)
        }
    };
    assert!(rewrite(GS_MODEL_GEOMETRY, 6, &replace("<CDB:Zone name=\"Van\"", "<CDB:Zone name=\"Bus\"")).contains(&6));
    assert!(rewrite(GS_MODEL_GEOMETRY, 6, &replace("../../../301_", "../../.x/301_")).contains(&2));
    assert!(rewrite(names::GS_MODEL_DESCRIPTOR, 6, &replace("BM_METAL", "XX_METAL")).contains(&9));
    assert!(rewrite(names::GS_MODEL_DESCRIPTOR, 6, &replace("<Code>UA005", "<Code>AL015")).contains(&12));

    let move_file = |from: String, to: String| {
        rules(&|s: &mut Memory| {
            let bytes = s.files.remove(&from).unwrap();
            s.files.insert(to.clone(), bytes);
        })
    };
    assert!(move_file(shp(7), shp(7).replace("R67", "R68")).contains(&3), "points that lie in another tile");
    assert!(move_file(shp(7), shp(7).replace("U70_R67", "U71_R67")).contains(&11));
    let stray = |name: &str| rules(&|s: &mut Memory| drop(s.files.insert(name.into(), vec![1])));
    assert!(stray("readme.txt").contains(&11));
    assert!(stray("metadata/x.txt").contains(&11));
    assert!(stray(&format!("Tiles/{}", "x".repeat(256))).contains(&11));
}

#[test]
fn rules_of_sizes_and_vertices_are_checked() {
    // Levels filed where their size or vertices do not belong: their archives renamed one LOD finer or coarser.
    let (latitude, longitude) = (34.5523, -118.4712);
    let mut off_centre = car("Van", latitude, longitude);
    off_centre.levels[3].mesh.positions.iter_mut().for_each(|p| p[0] += 0.0009);
    assert_sound(&store_with(&[off_centre]));

    let good = store_with(&[car("Van", latitude, longitude)]);
    let at = |lod| Tile::containing(latitude, longitude, lod).unwrap();
    let swap = |change: &dyn Fn(&mut crate::openflight::Model)| -> BTreeSet<u8> {
        let mut store = good.clone();
        let file = path(at(7), GS_MODEL_GEOMETRY, (1, 1), "zip");
        let old = Archive::read(store.files[&file].clone(), &file).unwrap();
        let name = old.names().next().unwrap().to_string();
        let mut model = crate::openflight::read(&old.get(&name).unwrap()).unwrap();
        change(&mut model);
        let bytes = crate::openflight::write(&model).unwrap();
        store.files.insert(file.clone(), Archive::default().with(&[(name, bytes)], "", &file).unwrap());
        check(&store).unwrap().iter().map(|f| f.rule).collect()
    };
    assert_eq!(swap(&|_| {}), BTreeSet::new(), "read and written again, the model is sound");
    assert!(swap(&|m| m.levels[0].significant_size = 0.1).contains(&5), "too small for LOD 7");
    assert!(swap(&|m| m.levels[0].significant_size = 50.0).contains(&5), "larger than the coarser level's");
    assert!(swap(&|m| m.levels[0].mesh.positions.iter_mut().for_each(|p| p[1] += 0.01)).contains(&7));
    assert!(swap(&|m| m.levels[0].mesh.positions.iter_mut().for_each(|p| p[2] -= 0.01)).contains(&7));
    assert!(swap(&|m| m.levels[0].mesh.positions.iter_mut().flatten().for_each(|x| *x *= 1.1)).contains(&8));
    assert!(swap(&|m| m.textures[0] = "missing.rgb".into()).contains(&2));
}
