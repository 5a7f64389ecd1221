//! Stores that others wrote.

use super::super::dbf::{Column, Table, Value};
use super::super::shapefile;
use super::*;

/// Rewrites the tables of a store as another tool would have: other order, unknown columns, a feature without model.
fn foreign(latitude: f64, longitude: f64, finest: i8) -> Memory {
    let mut store = Memory::default();
    for lod in -10..=finest {
        let tile = Tile::containing(latitude, longitude, lod).unwrap();
        let columns = vec![
            Column::new("CNAM", b'C', 16, 0),
            Column::new("RTAI", b'N', 3, 0),
            Column::new("VENDOR", b'C', 12, 0),
            Column::new("CMIX", b'N', 6, 0),
            Column::new("SCALX", b'N', 9, 5),
        ];
        let mut instances = Table::new(columns, (2001, 2, 3));
        let class_columns =
            vec![Column::new("CNAM", b'C', 16, 0), Column::new("FACC", b'C', 5, 0), Column::new("FSC", b'N', 3, 0)];
        let mut classes = Table::new(class_columns, (2001, 2, 3));
        let mut points = Vec::new();
        if lod >= 2 {
            points.push(Some(PointZ { x: longitude, y: latitude, z: 1.5, m: 0.0 }));
            let r = instances.push();
            for (c, v) in
                [(0, Value::Text("tower".into())), (2, Value::Text("keep me".into())), (3, Value::Number(3.0))]
            {
                instances.set(r, c, &v).unwrap();
            }
            let c = classes.push();
            classes.set(c, 0, &Value::Text("tower".into())).unwrap();
            classes.set(c, 1, &Value::Text("AL241".into())).unwrap();
        }
        let (shp, shx) = shapefile::write(&points);
        for (selector, extension, bytes) in [
            (GEOSPECIFIC.points(), "shp", shp),
            (GEOSPECIFIC.points(), "shx", shx),
            (GEOSPECIFIC.points(), "dbf", instances.write().unwrap()),
            (GEOSPECIFIC.classes(), "dbf", classes.write().unwrap()),
            (GEOSPECIFIC.extended(), "dbf", vec![9; 40]),
        ] {
            store.files.insert(path(tile, GEOSPECIFIC.dataset, selector, extension), bytes);
        }
    }
    store.files.insert("Metadata/Version.xml".into(), metadata::version_xml("CUI", "theirs", None).into_bytes());
    store
}

#[test]
fn foreign_features_and_columns_are_kept() {
    let (latitude, longitude) = (34.5523, -118.4712);
    let before = foreign(latitude, longitude, 5);
    let mut store = before.clone();
    let added = add_to(&mut store, &car("AVanWithALongName", latitude, longitude));
    assert_eq!(added.features_kept, 1);
    assert!(added.notes.iter().any(|n| n.contains("does not say UNCLASSIFIED")), "{:?}", added.notes);
    for lod in 4..=7 {
        let f = features(&store, latitude, longitude, lod);
        assert_eq!(f.points.len(), 2);
        let columns: Vec<String> = f.instances.columns().iter().map(Column::name).collect();
        assert_eq!(columns[..5], ["CNAM", "RTAI", "VENDOR", "CMIX", "SCALX"]);
        assert!(!columns.iter().any(|c| c == "SCALx" || c == "FACC"), "{columns:?}");
        assert_eq!(f.instances.text(0, "VENDOR").as_deref(), Some("keep me"));
        assert_eq!((f.text(0, "FACC").as_deref(), f.number(0, "CMIX")), (Some("AL241"), Some(3.0)));
        assert_eq!((f.instances.logical(0, "AHGT"), f.instances.logical(1, "AHGT")), (Some(false), Some(true)));
        assert_eq!((f.number(1, "SCALX"), f.text(1, "FACC").as_deref()), (Some(1.0), Some("UA005")));
        assert_eq!(f.text(1, "MODL").as_deref(), Some(added.model_name.as_str()));
        assert_eq!(f.instances.number(1, "MLOD"), Some(f64::from(lod)));
        let extended = path(
            Tile::containing(latitude, longitude, lod).unwrap(),
            GEOSPECIFIC.dataset,
            GEOSPECIFIC.extended(),
            "dbf",
        );
        assert_eq!(store.files[&extended], vec![9; 40], "extended attributes go with the features");
    }
    for lod in -10..=3 {
        let tile = Tile::containing(latitude, longitude, lod).unwrap();
        let shp = path(tile, GEOSPECIFIC.dataset, GEOSPECIFIC.points(), "shp");
        assert_eq!(store.files[&shp], before.files[&shp], "tiles above the model stay");
    }
}
