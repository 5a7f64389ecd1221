//! Geotypical and moving models.

use super::super::attributes::{GEOTYPICAL, MOVING};
use super::super::dbf::{Table, Value};
use super::*;
use crate::openflight;

const ENTITY: &str = "1.1.225.6.1.0.0";

fn typical(name: &str, latitude: f64, longitude: f64) -> Model {
    let material = Material::assumed("AL015");
    Model { kind: Kind::Geotypical, facc: "AL015".into(), fsc: 16, material, ..car(name, latitude, longitude) }
}

fn moving(name: &str, latitude: f64, longitude: f64) -> Model {
    Model { kind: Kind::Moving(EntityType::parse(ENTITY).unwrap()), ..car(name, latitude, longitude) }
}

fn paths<'a>(store: &'a Memory, start: &str) -> Vec<&'a str> {
    store.files.keys().map(String::as_str).filter(|p| p.starts_with(start)).collect()
}

#[test]
fn a_geotypical_model_is_a_library_and_a_feature() {
    let store = store_with(&[typical("House", 34.5523, -118.4712)]);
    assert_sound(&store);
    let folder = "GTModel/500_GTModelGeometry/A_Culture/L_Misc_Feature/015_Building";
    let geometry = paths(&store, "GTModel/500");
    let mut expected = vec![format!("{folder}/D500_S001_T001_AL015_016_House.flt")];
    expected.push(format!("{folder}/D503_S001_T001_AL015_016_House.xml"));
    expected.extend((4..=7).map(|l| format!("{folder}/L{l:02}/D510_S001_T001_L{l:02}_AL015_016_House.flt")));
    assert_eq!(geometry, expected);
    // Four levels of eight mips, 4.5 cm a texel: LOD 8 to 1.
    assert_eq!(paths(&store, "GTModel/501").len(), 32);
    let finest = "GTModel/501_GTModelTexture/H/O/House_3/D511_S001_T001_L08_House_3.rgb";
    assert_eq!(crate::sgi::read(&store.files[finest]).unwrap().0, texture(128));

    let master = openflight::read_master(&store.files[&expected[0]]).unwrap();
    let references: Vec<&str> = master.levels.iter().map(|l| l.path.as_str()).collect();
    assert_eq!(references[0], "./L04/D510_S001_T001_L04_AL015_016_House.flt");
    assert_eq!(references.len(), 4);
    assert!(master.levels.windows(2).all(|w| w[0].switch_out == w[1].switch_in && w[1].switch_in > w[1].switch_out));
    let level = openflight::read(&store.files[&expected[5]]).unwrap();
    assert_eq!(level.textures, ["../../../../../501_GTModelTexture/H/O/House_3/D511_S001_T001_L08_House_3.rgb"]);
    assert_eq!(level.levels[0].mesh.triangles.len(), 12);

    // One feature, in the tile of the coarsest level, under a pyramid that ends there.
    assert!(paths(&store, "Tiles/N34/W119/100_GSFeature").is_empty());
    assert_eq!(paths(&store, "Tiles/N34/W119/101_GTFeature").len(), 15 * 4);
    let tile = |lod| Tile::containing(34.5523, -118.4712, lod).unwrap();
    let f = FeatureTile::read(&store, &GEOTYPICAL, tile(4), DATE).unwrap().unwrap();
    assert_eq!((f.points.len(), f.text(0, "MODT").as_deref(), f.number(0, "MLOD")), (1, Some("T"), Some(4.0)));
    assert_eq!(f.text(0, "MODL").as_deref(), Some("House"));
    assert!(FeatureTile::read(&store, &GEOTYPICAL, tile(3), DATE).unwrap().unwrap().points.is_empty());
}

#[test]
fn a_geotypical_model_is_kept_once_and_placed_often() {
    let mut store = store_with(&[typical("House", 34.5523, -118.4712)]);
    let library = paths(&store, "GTModel").len();
    // Another place, another heading at the first place, another day.
    for (latitude, heading, date) in [(34.6, 30.0, DATE), (34.5523, 90.0, (2027, 1, 2)), (-33.9, 30.0, DATE)] {
        let mut again = typical("House", latitude, -118.4712);
        again.heading = heading;
        again.dbf_date = date;
        again.date = "Sat Jan  2 09:00:00 2027".into();
        let added = add_to(&mut store, &again);
        assert!(!added.already_present && added.notes[0].contains("used again"), "{:?}", added.notes);
        assert_eq!(added.model_name, "House");
        assert!(added.files.iter().all(|f| f.path.starts_with("Tiles/")));
        assert_eq!(paths(&store, "GTModel").len(), library);
        assert_sound(&store);
    }
    let again = add_model(&store, &typical("House", 34.5523, -118.4712)).unwrap();
    assert!(again.already_present && again.files.is_empty());
    // The class stands once in a tile, however many features it has.
    let tile = Tile::containing(34.5523, -118.4712, 4).unwrap();
    let f = FeatureTile::read(&store, &GEOTYPICAL, tile, DATE).unwrap().unwrap();
    assert_eq!((f.points.len(), f.classes.len()), (2, 1));
    // A namesake of another shape, and one of another feature code, get names of their own.
    let mut other = typical("House", 34.5523, -118.4712);
    other.levels[3].mesh = block(1.8, 4.2, 1.4);
    assert_eq!(add_to(&mut store, &other).model_name, "House_2");
    other.facc = "AL241".into();
    assert_eq!(add_to(&mut store, &other).model_name, "House_3");
    assert_sound(&store);
}

#[test]
fn a_moving_model_is_one_file_under_its_entity_type() {
    let store = store_with(&[moving("Van", 34.5523, -118.4712)]);
    assert_sound(&store);
    let folder =
        "MModel/600_MModelGeometry/1_Platform/1_Land/225_United_States/6_Small_Wheeled_Utility_Vehicle/1_1_225_6_1_0_0";
    let geometry = format!("{folder}/D600_S001_T001_1_1_225_6_1_0_0.flt");
    let descriptor = format!("{folder}/D603_S001_T001_1_1_225_6_1_0_0.xml");
    assert_eq!(paths(&store, "MModel/600"), [&geometry, &descriptor]);
    assert_eq!(paths(&store, "MModel/601").len(), 4 * 8);
    assert!(store.files.contains_key("MModel/601_MModelTexture/V/A/Van_3/D601_S001_T001_W07_Van_3.rgb"));
    let model = openflight::read(&store.files[&geometry]).unwrap();
    assert_eq!(model.levels.len(), 4);
    assert_eq!(model.textures[3], "../../../../../../601_MModelTexture/V/A/Van_3/D601_S001_T001_W07_Van_3.rgb");
    assert_eq!(model.points[0].comment, "<CDB:Point name=\"DIS_Origin\"/>");
    assert_eq!(model.points[0].matrix[3], [0.0, 0.0, 0.75, 1.0], "the middle of the body");
    assert_eq!(model.origin.map(|(a, b)| (a.abs(), b.abs())).unwrap_or_default(), (0.0, 0.0));
    let text = String::from_utf8(store.files[&descriptor].clone()).unwrap();
    assert!(text.contains("<Country>225</Country><Category>6</Category>"), "{text}");
    // Its feature is a moving model location: MMDC, no MODL, no CMIX, no material table.
    let tile = Tile::containing(34.5523, -118.4712, 4).unwrap();
    let f = FeatureTile::read(&store, &MOVING, tile, DATE).unwrap().unwrap();
    assert_eq!(f.text(0, "MMDC").as_deref(), Some("1_1_225_6_1_0_0"));
    assert!(f.instances.column("MODL").is_none() && f.instances.column("CMIX").is_none());
    assert!(paths(&store, "Tiles/N34/W119/200").is_empty());
}

#[test]
fn an_entity_type_has_one_model() {
    let mut store = store_with(&[moving("Van", 34.5523, -118.4712)]);
    let second = add_to(&mut store, &moving("Van", 34.6, -118.4712));
    assert!(second.notes[0].contains("used again") && second.files.iter().all(|f| f.path.starts_with("Tiles/")));
    assert_sound(&store);
    let mut other = moving("Van", 34.7, -118.4712);
    other.levels[3].mesh = block(1.8, 4.2, 1.4);
    let refused = add_model(&store, &other).unwrap_err().to_string();
    assert!(refused.contains(ENTITY) && refused.contains("another specific or extra number"), "{refused}");
    // Under a code of its own it stands beside the first, its textures under another name.
    other.kind = Kind::Moving(EntityType::parse("1.1.225.6.1.0.1").unwrap());
    other.levels[3].texture.pixels[0] ^= 1;
    let added = add_to(&mut store, &other);
    assert_eq!(added.model_name, "1_1_225_6_1_0_1");
    assert!(added.files.iter().any(|f| f.path.contains("/Van_2_3/")));
    assert_sound(&store);
}

#[test]
fn a_deleted_model_makes_room_for_another() {
    let old = store_with(&[moving("Van", 34.5523, -118.4712)]);
    let mut other = moving("Van", 34.7, -118.4712);
    other.levels[3].mesh = block(1.8, 4.2, 1.4);
    assert!(add_version(&old, "../old.cdb", &other).unwrap_err().to_string().contains(ENTITY));
    // A file of no bytes in a newer version stands for a deleted one.
    let mut newer = Memory::default();
    newer.files.extend(paths(&old, "MModel/").into_iter().map(|p| (p.to_string(), vec![])));
    let chain = Versions::new(vec![&newer, &old]);
    let added = add_version(&chain, "../newer.cdb", &other).unwrap();
    assert_eq!(added.model_name, "1_1_225_6_1_0_0");
    assert!(
        added.files.iter().any(|f| f.path.contains("/Van_3/")) && added.files.iter().any(|f| f.path.contains("D600_"))
    );
    let gone = newer.files.keys().next().unwrap();
    assert!(chain.exists(gone).unwrap() && !store::exists(&chain, gone).unwrap() && store::exists(&old, gone).unwrap());
    let mut emptied = old.clone();
    emptied.files.extend(newer.files);
    assert!(add_model(&emptied, &other).is_ok());
}

#[test]
fn a_moving_model_may_have_many_levels() {
    let mut store = store_with(&[moving("Van", 34.5523, -118.4712)]);
    let geometry = store.files.iter_mut().find(|(path, _)| path.contains("D600_")).unwrap().1;
    let mut model = openflight::read(geometry).unwrap();
    let mut first = model.levels[0].clone();
    first.mesh.triangles.truncate(1);
    let level = |i: u8| openflight::Level {
        name: format!("Van_{i}"),
        significant_size: 5.0 - 0.03 * f64::from(i),
        ..first.clone()
    };
    model.levels = (0..130).map(level).collect();
    *geometry = openflight::write(&model).unwrap();
    assert_eq!(openflight::read(geometry).unwrap().levels.len(), 130);
    let found: Vec<Finding> = check(&store).unwrap().into_iter().filter(|f| f.rule == 5).collect();
    assert_eq!(found, [], "sizes that decrease");
}

#[test]
fn all_kinds_share_a_store() {
    let place = (34.5523, -118.4712);
    let store = store_with(&[
        moving("Van", place.0, place.1),
        typical("House", place.0, place.1),
        car("Crate", place.0, place.1),
        Model { material: Material::parse("paint/metal-steel").unwrap(), ..car("Tank", place.0 + 0.001, place.1) },
    ]);
    assert_sound(&store);
    let report = report(&store).unwrap();
    assert!(report.rules.iter().all(|r| r.number == 13 || r.verdict == Verdict::Pass), "{report:#?}");
}

#[test]
fn the_marking_is_in_every_file_of_the_libraries() {
    for mut model in [typical("House", 34.5523, -118.4712), moving("Van", 34.5523, -118.4712)] {
        model.marking = "SECRET//TEST".into();
        for file in add_model(&Empty, &model).unwrap().files {
            let has = file.bytes.windows(12).any(|w| w == b"SECRET//TEST");
            let room = ![".shp", ".shx", ".dbf"].iter().any(|e| file.path.ends_with(e));
            assert_eq!(has, room, "{}", file.path);
        }
    }
}

#[test]
fn planted_faults_in_libraries_are_found() {
    let good = store_with(&[typical("House", 34.5523, -118.4712), moving("Van", 34.5523, -118.4712)]);
    let rules = |change: &dyn Fn(&mut Memory)| -> BTreeSet<u8> {
        let mut store = good.clone();
        change(&mut store);
        assert_ne!(store, good, "nothing was planted");
        check(&store).unwrap().iter().map(|f| f.rule).collect()
    };
    let find = |part: &str| good.files.keys().find(|p| p.contains(part)).unwrap_or_else(|| panic!("{part}")).clone();
    let remove = |part: &str| rules(&|s: &mut Memory| drop(s.files.remove(&find(part))));
    let rename = |part: &str, from: &str, to: &str| {
        rules(&|s: &mut Memory| {
            let path = find(part);
            let bytes = s.files.remove(&path).unwrap();
            s.files.insert(path.replace(from, to), bytes);
        })
    };
    let patch =
        |part: &str, at: usize, byte: u8| rules(&|s: &mut Memory| s.files.get_mut(&find(part)).unwrap()[at] = byte);
    assert!(remove("D500_").contains(&1), "the entry file");
    assert!(remove("D503_").contains(&1));
    assert!(remove("D510_S001_T001_L05").contains(&1), "a level that the entry file refers to");
    assert!(remove("L08_House_3").contains(&2), "the texture that a palette names");
    assert!(remove("L01_House_3").contains(&2), "the last mip");
    assert!(remove("D600_").contains(&1));
    assert!(remove("D603_").contains(&1));
    assert!(remove("W07_Van_0").contains(&2));
    assert!(remove("W00_Van_0").contains(&2));
    assert!(remove("101_GTFeature/LC/U0/N34W119_D101_S001_T001_LC03").contains(&3));
    assert!(remove("101_GTFeature/LC/U0/N34W119_D101_S003_T001_LC03").contains(&3));
    assert!(remove("101_GTFeature/L04/U8/N34W119_D101_S003_T002").contains(&3));
    assert!(rename("D500_", "015_Building", "015_House").contains(&11));
    assert!(rename("D600_", "6_Small_Wheeled", "7_Small_Wheeled").contains(&11));
    assert!(rename("D510_S001_T001_L05", "_L05_", "_L03_").contains(&11));
    assert!(rename("W07_Van_0", "_W07_", "_W06_").contains(&2));
    assert!(patch("D510_S001_T001_L05", 95, 5).contains(&6), "projection");
    assert!(patch("D600_", 15, 0).contains(&6), "revision");
    assert!(patch("W07_Van_0", 0, 0).contains(&2), "SGI magic");
    let edit = |part: &str, from: &str, to: &str| {
        rules(&|s: &mut Memory| {
            let text = String::from_utf8(s.files[&find(part)].clone()).unwrap();
            s.files.insert(find(part), text.replace(from, to).into_bytes());
        })
    };
    assert!(edit("D603_", "<Country>225", "<Country>224").contains(&12));
    assert!(edit("D503_", "<Code>AL015", "<Code>AL016").contains(&12));
    assert!(edit("D603_", "BM_METAL-STEEL", "STEEL").contains(&9));
    let set = |part: &str, column: &str, value: Value| {
        rules(&|s: &mut Memory| {
            let mut table = Table::read(&s.files[&find(part)]).unwrap();
            let c = table.column(column).unwrap();
            table.set(0, c, &value).unwrap();
            s.files.insert(find(part), table.write().unwrap());
        })
    };
    let typical = "L04/U8/N34W119_D101_S001_T001_L04_U8_R8.dbf";
    let moving = "L04/U8/N34W119_D101_S003_T001_L04_U8_R8.dbf";
    assert!(set(typical, "MODL", Value::Text("Other".into())).contains(&1));
    assert!(set(typical, "MLOD", Value::Number(3.0)).contains(&4));
    assert!(set(typical, "HGT", Value::Number(9.0)).contains(&8));
    assert!(set(typical, "CMIX", Value::Number(7.0)).contains(&9));
    assert!(set(moving, "MMDC", Value::Text("1_1_225_6_1_0_9".into())).contains(&1));
    assert!(set(moving, "MMDC", Value::Text("van".into())).contains(&1));
    assert!(set(moving, "BSR", Value::Number(9.0)).contains(&8));
    assert!(set(moving, "AO1", Value::Number(-1.0)).contains(&8));
}

#[test]
fn codes_without_labels_are_refused_and_a_store_s_own_lists_help() {
    let mut shed = typical("Shed", 34.5523, -118.4712);
    shed.facc = "AL019".into();
    assert!(add_model(&Empty, &shed).unwrap_err().to_string().contains("AL019"));
    let mut store = Memory::default();
    let dictionary = "<Feature_Data_Dictionary><Category code=\"A\"><Label>Culture</Label><Subcategory code=\"L\">\
                      <Label>Misc_Feature</Label><Feature_Type code=\"019\"><Label>Shed</Label></Feature_Type>\
                      </Subcategory></Category></Feature_Data_Dictionary>";
    store.files.insert("Metadata/Feature_Data_Dictionary.xml".into(), dictionary.into());
    add_to(&mut store, &shed);
    assert_eq!(paths(&store, "GTModel/500_GTModelGeometry/A_Culture/L_Misc_Feature/019_Shed").len(), 6);
    assert_sound(&store);
}
