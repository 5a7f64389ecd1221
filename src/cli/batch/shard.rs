//! Which rows may be written at once: shards whose models share no geocell, so no tile and no archive of a store.

use std::collections::BTreeMap;

use orb_formats::cdb::geocell::Geocell;
use serde::{Deserialize, Serialize};

/// Rows that are run one after the other, in the manifest's order.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Shard {
    /// Lines of the manifest.
    pub lines: Vec<usize>,
    /// `N34W119`; all that it may write into.
    pub cells: Vec<String>,
    /// Writes models that the whole store shares.
    pub shared: bool,
}

/// What is known of a row's place before it is run.
#[derive(Clone, Copy, Debug)]
pub struct Row {
    pub line: usize,
    pub latitude: f64,
    pub longitude: f64,
    /// Degrees of latitude that the model may stand away from there, or its terrain reach.
    pub reach: f64,
    /// Its model goes into a library of the whole store (geotypical, moving).
    pub shared: bool,
}

/// The geocells within reach of a row: at most the four around a corner, as far as reach is less than a cell.
fn cells(row: &Row) -> Vec<Geocell> {
    let mut all = Vec::new();
    for up in [-1.0, 0.0, 1.0] {
        for right in [-1.0, 0.0, 1.0] {
            let latitude = (row.latitude + up * row.reach).clamp(-90.0, 90.0);
            let narrow = latitude.to_radians().cos().max(1e-3);
            let longitude = row.longitude + right * (row.reach / narrow).min(179.0);
            let longitude = (longitude + 180.0).rem_euclid(360.0) - 180.0;
            all.extend(Geocell::containing(latitude, longitude));
        }
    }
    all.sort();
    all.dedup();
    all
}

/// Rows whose cells meet, directly or by way of others, are one shard; all that share a library are one. In the order of
/// their first lines.
pub fn shards(rows: &[Row]) -> Vec<Shard> {
    // Each row's group, by the smallest row in it.
    let mut group: Vec<usize> = (0..rows.len()).collect();
    fn root(group: &[usize], mut i: usize) -> usize {
        while group[i] != i {
            i = group[i];
        }
        i
    }
    let mut first_in: BTreeMap<Geocell, usize> = BTreeMap::new();
    let mut first_shared = None;
    let own: Vec<Vec<Geocell>> = rows.iter().map(cells).collect();
    for (i, row) in rows.iter().enumerate() {
        let cells = own[i].iter().map(|c| *first_in.entry(*c).or_insert(i));
        let shared = row.shared.then(|| *first_shared.get_or_insert(i));
        for other in cells.chain(shared).collect::<Vec<_>>() {
            let (a, b) = (root(&group, i), root(&group, other));
            let (low, high) = (a.min(b), a.max(b));
            group[high] = low;
        }
    }
    let mut out: BTreeMap<usize, (Shard, Vec<Geocell>)> = BTreeMap::new();
    for (i, row) in rows.iter().enumerate() {
        let empty = || (Shard { lines: Vec::new(), cells: Vec::new(), shared: false }, Vec::new());
        let (shard, cells) = out.entry(root(&group, i)).or_insert_with(empty);
        shard.lines.push(row.line);
        shard.shared |= row.shared;
        cells.extend(&own[i]);
    }
    let named = |(mut shard, mut cells): (Shard, Vec<Geocell>)| {
        cells.sort();
        cells.dedup();
        shard.cells = cells.iter().map(|c| c.latitude_name() + &c.longitude_name()).collect();
        shard
    };
    out.into_values().map(named).collect()
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use proptest::prelude::*;

    use super::*;

    fn row(line: usize, latitude: f64, longitude: f64) -> Row {
        Row { line, latitude, longitude, reach: 0.0, shared: false }
    }

    #[test]
    fn rows_meet_in_cells_by_reach_and_in_libraries() {
        let lines = |rows: &[Row]| shards(rows).into_iter().map(|s| s.lines).collect::<Vec<_>>();
        let rows = [row(2, 34.5, -118.5), row(3, 35.5, -118.5), row(4, 34.1, -118.9)];
        assert_eq!(lines(&rows), [vec![2, 4], vec![3]]);
        assert_eq!(shards(&rows)[0].cells, ["N34W119"]);
        let reaches = Row { reach: 0.1, ..row(5, 34.95, -118.5) };
        let met = shards(&[rows[0], rows[1], reaches]);
        assert_eq!((met.len(), &met[0].cells[..]), (1, &["N34W119".to_owned(), "N35W119".to_owned()][..]));
        let library = |line, latitude| Row { shared: true, ..row(line, latitude, 10.0) };
        assert_eq!(lines(&[library(2, 1.5), row(3, 7.5, 10.0), library(4, 50.5)]), [vec![2, 4], vec![3]]);
        // Over the date line.
        let date_line = Row { reach: 0.1, ..row(2, 0.5, 179.99) };
        assert_eq!(shards(&[date_line])[0].cells, ["N00W180", "N00E179"]);
    }

    proptest! {
        #[test]
        fn no_cell_is_in_two_shards(
            places in prop::collection::vec((-89.0..89.0f64, -180.0..180.0f64, 0.0..0.3f64, any::<bool>()), 1..60)
        ) {
            let rows: Vec<Row> = places
                .iter()
                .enumerate()
                .map(|(i, &(latitude, longitude, reach, shared))| Row {
                    line: i + 2,
                    latitude: latitude / 30.0,
                    longitude: longitude / 30.0,
                    reach,
                    shared: shared && i % 7 == 0,
                })
                .collect();
            let all = shards(&rows);
            let cells: Vec<&String> = all.iter().flat_map(|s| &s.cells).collect();
            prop_assert_eq!(cells.iter().collect::<BTreeSet<_>>().len(), cells.len());
            let mut lines: Vec<usize> = all.iter().flat_map(|s| s.lines.clone()).collect();
            lines.sort_unstable();
            prop_assert_eq!(lines, rows.iter().map(|r| r.line).collect::<Vec<_>>());
            prop_assert!(all.iter().filter(|s| s.shared).count() <= 1);
            prop_assert!(all.iter().all(|s| s.lines.is_sorted()));
        }
    }
}
