use super::*;
use crate::cdb::{self, Memory};
use crate::jp2;

const PLACE: (f64, f64, f64) = (34.5523, -118.4712, 740.0);

fn ground<'a>() -> Ground<'a> {
    let (latitude, longitude, height) = PLACE;
    let marking = "CLASSIFICATION: UNCLASSIFIED";
    Ground { latitude, longitude, height, radius: 30.0, terrain: None, colors: None, marking }
}

fn heights(store: &Memory, tile: Tile) -> Vec<f32> {
    stored(store, tile).unwrap().unwrap()
}

/// Height between the posts of the tile that holds a point, as a client finds it.
fn height_at(store: &Memory, lod: i8, latitude: f64, longitude: f64) -> f64 {
    let tile = Tile::containing(latitude, longitude, lod).unwrap();
    let (n, grid) = (side(lod) as usize, elevation_grid(tile));
    let x = ((longitude - grid.west) / grid.step_x).round() as usize;
    let y = ((grid.north - latitude) / grid.step_y).round() as usize;
    heights(store, tile)[y.min(n - 1) * n + x.min(n - 1)].into()
}

#[test]
fn a_new_store_gets_a_whole_pyramid_that_passes_its_own_check() {
    let added = add_ground(&cdb::Empty, ground()).unwrap();
    assert_eq!(added.lod, 4, "posts of 6.8 m under a radius of 30 m");
    assert!(added.notes[0].contains("invented"));
    let mut store = Memory::default();
    store.write(added.files);
    for lod in -10..=4 {
        let tile = Tile::containing(PLACE.0, PLACE.1, lod).unwrap();
        assert!(heights(&store, tile).iter().all(|h| *h == 740.0));
        let path = names::path(tile, IMAGERY, SELECTOR, "jp2");
        let header = jp2::header(&store.files[&path]).unwrap();
        assert_eq!((header.width, header.bits), (side(lod), vec![8; 3]));
        assert!(header.texts[0].contains("CLASSIFICATION: UNCLASSIFIED"));
    }
    assert_eq!(store.files.len(), 30 + 22, "terrain and imagery to LOD 4, the lowest and highest to LOD 0");
    let broken: Vec<_> = cdb::check(&store).unwrap().into_iter().filter(|f| f.rule == 13).collect();
    assert_eq!(broken, []);
}

#[test]
fn terrain_is_level_under_the_model_and_itself_away_from_it() {
    let slope = |latitude: f64, longitude: f64| 700.0 + 1000.0 * (latitude - 34.55) + 500.0 * (longitude + 118.47);
    let mut known = |a: f64, b: f64| Some(slope(a, b));
    let added = add_ground(&cdb::Empty, Ground { terrain: Some(&mut known), ..ground() }).unwrap();
    assert_eq!(added.notes, Vec::<String>::new());
    let mut store = Memory::default();
    store.write(added.files);
    for lod in [0, 2, 4] {
        let spacing = DEGREE / 1024.0 / f64::from(1 << lod);
        // Level under it, as far as the level has posts there.
        if spacing < 30.0 {
            assert_eq!(height_at(&store, lod, PLACE.0, PLACE.1), 740.0);
            assert_eq!(height_at(&store, lod, PLACE.0 + 20.0 / DEGREE, PLACE.1), 740.0);
        }
        // The slope everywhere else, at the post's own place: corner registration.
        let tile = Tile::containing(PLACE.0, PLACE.1, lod).unwrap();
        let (n, grid) = (side(lod) as usize, elevation_grid(tile));
        let all = heights(&store, tile);
        for (column, row) in [(0, n - 1), (3, 3), (n - 1, 0)] {
            let (latitude, longitude) = grid::at(&grid, column, row);
            let expected = slope(latitude, longitude);
            assert!((f64::from(all[row * n + column]) - expected).abs() < 1e-3, "LOD {lod}: {column} {row}");
        }
        let [south, west, ..] = tile.bounds();
        assert_eq!(grid::at(&grid, 0, n - 1).1, west);
        assert!((grid::at(&grid, 0, n - 1).0 - south).abs() < 1e-12);
    }
    // Posts that coincide agree from level to level.
    let fine = height_at(&store, 4, 34.5, -118.5);
    assert_eq!(height_at(&store, 3, 34.5, -118.5), fine);
}

/// Every post that any level has, inside the bounds of every level; and bounds no wider than the posts about a cell make them.
#[test]
fn the_lowest_and_highest_bound_the_terrain_and_nothing_more() {
    let mut known = |a: f64, b: f64| Some(600.0 + 40.0 * (a * 700.0).sin() + 25.0 * (b * 900.0).cos());
    let added = add_ground(&cdb::Empty, Ground { terrain: Some(&mut known), ..ground() }).unwrap();
    let mut store = Memory::default();
    store.write(added.files);
    let bounds = |lod: i8, selector| {
        let tile = Tile::containing(PLACE.0, PLACE.1, lod).unwrap();
        super::heights(&store, tile, names::MIN_MAX_ELEVATION, selector).unwrap().unwrap()
    };
    for lod in [0, -3, -10] {
        let (low, high) = (bounds(lod, LOWEST), bounds(lod, HIGHEST));
        let n = side(lod) as usize;
        let cells = imagery_grid(Tile::containing(PLACE.0, PLACE.1, lod).unwrap());
        let (mut lowest, mut highest) = (vec![f32::INFINITY; n * n], vec![f32::NEG_INFINITY; n * n]);
        for fine in lod..=4 {
            let tile = Tile::containing(PLACE.0, PLACE.1, fine).unwrap();
            let (posts, grid, m) = (heights(&store, tile), elevation_grid(tile), side(fine) as usize);
            for (i, height) in posts.iter().enumerate() {
                let (latitude, longitude) = grid::at(&grid, i % m, i / m);
                // A post on an edge belongs to the cells on both sides: here to the one north-east of it.
                let column = ((longitude - cells.west) / cells.step_x + 1e-6).floor() as usize;
                let row = ((cells.north - latitude) / cells.step_y - 1e-6).floor() as usize;
                let cell = row * n + column;
                assert!(low[cell] <= *height && *height <= high[cell], "LOD {lod} of {fine}: {row} {column}");
                (lowest[cell], highest[cell]) = (lowest[cell].min(*height), highest[cell].max(*height));
            }
        }
        // Four cells that meet hold every post of the middle one's edges.
        for row in 1..n.saturating_sub(1) {
            for column in 1..n - 1 {
                let near = |v: &[f32], pick: fn(f32, f32) -> f32| {
                    let cells = (row - 1..=row).flat_map(|r| (column..=column + 1).map(move |c| r * n + c));
                    cells.map(|c| v[c]).reduce(pick).unwrap()
                };
                let cell = row * n + column;
                assert!(low[cell] >= near(&lowest, f32::min) && high[cell] <= near(&highest, f32::max));
            }
        }
    }
    let all: Vec<f32> =
        (-10..=4).flat_map(|lod| heights(&store, Tile::containing(PLACE.0, PLACE.1, lod).unwrap())).collect();
    assert_eq!(bounds(-10, LOWEST), [all.iter().copied().fold(f32::INFINITY, f32::min)]);
    assert_eq!(bounds(-10, HIGHEST), [all.iter().copied().fold(f32::NEG_INFINITY, f32::max)]);
}

/// The lowest and highest of a tile whose neighbours are known too.
fn extremes_of(tile: Tile, terrain: &BTreeMap<Tile, Vec<f32>>) -> [Vec<f32>; 2] {
    let mut store = Memory::default();
    store.write(extremes::tiles(&cdb::Empty, terrain, "").unwrap().0);
    [LOWEST, HIGHEST].map(|of| super::heights(&store, tile, names::MIN_MAX_ELEVATION, of).unwrap().unwrap())
}

#[test]
fn the_lowest_and_highest_know_where_geocells_change_their_width() {
    // Tiles of 16² posts: away from the equator geocells are twice as wide, and so are the steps between their posts.
    let sloping = |latitude: f64, longitude: f64| {
        let tile = Tile::containing(latitude, longitude, -6).unwrap();
        let grid = elevation_grid(tile);
        (tile, (0..256).map(|i| (64.0 * grid::at(&grid, i % 16, i / 16).1) as f32).collect::<Vec<_>>())
    };
    // From one degree to two, and from two to one and one.
    for (latitude, all, step, above) in
        [(49.5, vec![(50.5, 10.5)], 4, 8), (-50.5, vec![(-49.5, 10.5), (-49.5, 11.5), (-49.5, 12.5)], 8, 4)]
    {
        let own = sloping(latitude, 10.5);
        let tile = own.0;
        assert_eq!(tile.bounds()[1], 10.0);
        let terrain = all.into_iter().map(|(a, b)| sloping(a, b)).chain([own]).collect();
        let [low, high] = extremes_of(tile, &terrain);
        for column in 0..16 {
            let (from, to): (usize, usize) = (step * column, step * (column + 1));
            // The last post on the east is a neighbour's, which only the row above has.
            let expected = [from / above * above, to.div_ceil(above) * above].map(|h: usize| (640 + h) as f32);
            assert_eq!([low[column], high[column]], expected, "{latitude} {column}");
        }
    }
    // The neighbour in the east, over the date line.
    let level = |longitude: f64, height: f32| (Tile::containing(10.5, longitude, -6).unwrap(), vec![height; 256]);
    let (here, there) = (level(179.5, 100.0), level(-179.5, 500.0));
    let tile = here.0;
    let [low, high] = extremes_of(tile, &BTreeMap::from([here, there]));
    let of_row = |c: usize| [low[16 + c], high[16 + c]];
    assert_eq!([of_row(14), of_row(15)], [[100.0, 100.0], [100.0, 500.0]]);
}

#[test]
fn wrong_bounds_and_lost_halves_are_found() {
    let mut store = Memory::default();
    store.write(add_ground(&cdb::Empty, ground()).unwrap().files);
    let tile = Tile::containing(PLACE.0, PLACE.1, -6).unwrap();
    let path = |selector| names::path(tile, names::MIN_MAX_ELEVATION, selector, "tif");
    let found = |store: &Memory| {
        let findings = cdb::check(store).unwrap();
        findings.into_iter().filter(|f| f.rule == 13).map(|f| format!("{} {}", f.path, f.text)).collect::<Vec<_>>()
    };
    assert_eq!(found(&store), Vec::<String>::new());
    let mut values = vec![740.0; 256];
    values[37] = 745.0;
    let write = |values: &[f32]| geotiff::write(16, 16, values, &imagery_grid(tile), "").unwrap();
    let mut above = store.clone();
    above.files.insert(path(LOWEST), write(&values));
    assert!(
        found(&above).iter().any(|f| f.contains("745 m at column 5, row 2, expected below 740 m")),
        "{:?}",
        found(&above)
    );
    let mut half = store.clone();
    half.files.remove(&path(HIGHEST));
    assert!(found(&half).iter().any(|f| f.contains("its other half")), "{:?}", found(&half));
    let mut posts = store.clone();
    values[37] = 740.0;
    posts.files.insert(path(LOWEST), geotiff::write(16, 16, &values, &elevation_grid(tile), "").unwrap());
    assert!(found(&posts).iter().any(|f| f.contains("it says that it lies at")), "{:?}", found(&posts));
}

#[test]
fn terrain_without_bounds_gets_none_and_says_so() {
    let mut store = Memory::default();
    let files = add_ground(&cdb::Empty, ground()).unwrap().files.into_iter();
    store.write(files.filter(|f| !f.path.contains("002_")));
    let added = add_ground(&store, Ground { height: 750.0, ..ground() }).unwrap();
    assert!(added.files.iter().all(|f| !f.path.contains("002_")));
    assert!(added.notes.iter().any(|n| n.contains("no lowest and highest values")), "{:?}", added.notes);
}

#[test]
fn ground_of_a_store_is_kept_away_from_the_model() {
    let mut rolling = |a: f64, b: f64| Some(600.0 + 10.0 * (a * 900.0).sin() + 10.0 * (b * 900.0).cos());
    let far = Ground { terrain: Some(&mut rolling), latitude: 34.553, longitude: -118.46, ..ground() };
    let mut store = Memory::default();
    store.write(add_ground(&cdb::Empty, far).unwrap().files);
    let before = store.clone();
    let added = add_ground(&store, ground()).unwrap();
    assert!(added.notes.iter().any(|n| n.contains("imagery")), "{:?}", added.notes);
    assert!(added.files.iter().all(|f| f.path.ends_with(".tif")));
    store.write(added.files);
    assert_eq!(height_at(&store, 4, PLACE.0, PLACE.1), 740.0);
    let (there, away) = ((34.5523 + 95.0 / DEGREE, -118.4712), height_at);
    assert_eq!(away(&store, 4, there.0, there.1), away(&before, 4, there.0, there.1));
    assert_ne!(away(&before, 4, PLACE.0, PLACE.1), 740.0);
}

#[test]
fn finer_tiles_without_data_come_from_coarser_ones() {
    // A plane over LOD 0; LOD 4 is interpolated from it without a step, except at the rim that belongs to neighbours.
    let tile = |lod| Tile::containing(PLACE.0, PLACE.1, lod).unwrap();
    let mut parent: Vec<f32> = {
        let grid = elevation_grid(tile(0));
        (0..1024 * 1024).map(|i| (1000.0 * (grid::at(&grid, i % 1024, i / 1024).0 - 34.0)) as f32).collect()
    };
    for lod in 1..=4 {
        let grid = elevation_grid(tile(lod));
        parent = finer(&parent, tile(lod));
        for i in (0..1024 * 1024).step_by(4099).filter(|i| i / 1024 > 40) {
            let expected = 1000.0 * (grid::at(&grid, i % 1024, i / 1024).0 - 34.0);
            assert!((f64::from(parent[i]) - expected).abs() < 1e-2, "LOD {lod} at {i}: {} {expected}", parent[i]);
        }
    }
}

#[test]
fn imagery_holds_the_colours_and_their_means() {
    let mut colors =
        |a: f64, b: f64| (a > 34.5523).then_some(if b > -118.4712 { [250, 10, 20] } else { [10, 200, 30] });
    let tiles: BTreeSet<Tile> = [Tile::containing(PLACE.0, PLACE.1, 4).unwrap()].into();
    let files = imagery::tiles(Some(&mut colors), &tiles, ground().marking).unwrap();
    assert_eq!(files.len(), 15);
    assert!(files.iter().all(|f| names::parse(&f.path).is_some()));
}

#[test]
fn a_place_at_the_seam_of_tiles_gets_them_all() {
    for (latitude, longitude, tiles) in [(34.5, -118.5, 4), (34.5, -118.47, 2), (10.0, -180.0, 4), (34.52, -118.47, 1)]
    {
        let at = Ground { latitude, longitude, ..ground() };
        assert_eq!(touched(&at, 4).unwrap().len(), tiles, "{latitude} {longitude}");
    }
    assert!(!touched(&Ground { latitude: 89.9999, ..ground() }, 4).unwrap().is_empty());
    assert!(add_ground(&cdb::Empty, Ground { radius: f64::NAN, ..ground() }).is_err());
    assert!(add_ground(&cdb::Empty, Ground { height: f64::INFINITY, ..ground() }).is_err());
    assert!(add_ground(&cdb::Empty, Ground { latitude: 91.0, ..ground() }).is_err());
}
