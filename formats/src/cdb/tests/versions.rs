//! Incremental versions.

use super::*;

/// Newer files over older ones, as a reader of the chain sees them.
fn flattened(old: &Memory, new: &Memory) -> Memory {
    let mut all = old.clone();
    all.files.extend(new.files.clone());
    all
}

fn version(old: &dyn Store, model: &Model) -> Memory {
    let mut new = Memory::default();
    new.write(add_version(old, "../old.cdb", model).unwrap().files);
    new
}

#[test]
fn a_new_version_holds_the_union_and_leaves_the_old_one_alone() {
    let (latitude, longitude) = (34.5523, -118.4712);
    let old = store_with(&[car("Van", latitude, longitude), car("Far", 34.1, -118.9)]);
    let new = version(&old, &car("Truck", latitude + 0.0001, longitude));
    assert_eq!(previous_version(&new).unwrap().as_deref(), Some("../old.cdb"));
    assert_eq!(previous_version(&old).unwrap(), None);
    // Both cars stand in the finest tile; what lies elsewhere is not copied.
    assert_eq!(features(&new, latitude, longitude, 7).points.len(), 2);
    assert!(!new.files.keys().any(|p| names::parse(p).is_some_and(|f| !f.tile.contains(latitude, longitude))));
    let both = flattened(&old, &new);
    assert_sound(&both);
    // The same model again is known, also through the chain.
    let chain = Versions::new(vec![&new, &old]);
    assert!(add_version(&chain, "../new.cdb", &car("Truck", latitude + 0.0001, longitude)).unwrap().already_present);
    // A third version, at a place that only the first has tiles of.
    let third = version(&chain, &car("Bus", 34.1, -118.9));
    assert_sound(&flattened(&both, &third));
    assert_eq!(features(&third, 34.1, -118.9, 7).points.len(), 2);
}

#[test]
fn a_deleted_file_stays_deleted() {
    let (latitude, longitude) = (34.5523, -118.4712);
    let old = store_with(&[car("Van", latitude, longitude)]);
    let mut new = Memory::default();
    let gone = path(Tile::containing(latitude, longitude, 7).unwrap(), GS_MODEL_GEOMETRY, (1, 1), "zip");
    new.files.insert(gone.clone(), vec![]);
    let chain = Versions::new(vec![&new, &old]);
    assert_eq!(store::read(&chain, &gone).unwrap(), None);
    assert!(store::read(&old, &gone).unwrap().is_some());
}

#[test]
fn a_store_of_versions_takes_models_only_as_a_further_version() {
    let old = store_with(&[car("Van", 34.5523, -118.4712)]);
    let new = version(&old, &car("Truck", 34.5524, -118.4712));
    let refused = add_model(&new, &car("Bus", 34.5525, -118.4712)).unwrap_err().to_string();
    assert!(refused.contains("../old.cdb") && refused.contains("further version"), "{refused}");
    let mut joined = old.clone();
    joined.files.insert("Metadata/Configuration.xml".into(), b"<Configuration/>".to_vec());
    assert!(add_model(&joined, &car("Bus", 34.5525, -118.4712)).is_err());
}
