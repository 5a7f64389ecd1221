//! Which level of detail a model's level, or a texture, is filed under.
//!
//! Source: OGC CDB 1.x Volume 1, Table 3-1 (Requirement 41); Volume 6, Table 6-25 (vertex limits) and §6.8 (significant
//! size); Volume 7, "Handling of GS and T2D Models" (overhang; significant size from vertex counts).

use super::geocell::{DEGREE, LODS, Tile};
use crate::{Error, Result};

/// Most levels a model may have.
pub const MAX_LEVELS: usize = 8;

/// The significant size that a geometry level must exceed, metres.
pub fn size_bound(lod: i8) -> f64 {
    DEGREE / 2f64.powi(i32::from(lod) + 11)
}

/// The texel size that a texture must exceed, metres.
pub fn texel_bound(lod: i8) -> f64 {
    DEGREE / 2f64.powi(i32::from(lod) + 14)
}

/// The first level whose bound a significant size exceeds; 23 takes the rest.
pub fn of_size(significant_size: f64) -> i8 {
    LODS.into_iter().find(|&lod| significant_size > size_bound(lod)).unwrap_or(23)
}

/// The first level whose bound a texel size exceeds; 23 takes the rest.
pub fn of_texel(texel: f64) -> i8 {
    LODS.into_iter().find(|&lod| texel > texel_bound(lod)).unwrap_or(23)
}

/// Most vertices of a level that lies `steps` levels of detail above the coarsest.
pub fn max_vertices(steps: usize) -> usize {
    128 << (2 * steps.min(MAX_LEVELS - 1))
}

/// Points a vector tile may hold (Requirement 64).
pub fn max_points(lod: i8) -> usize {
    if lod >= 0 { 16384 } else { (16384usize >> (2 * lod.unsigned_abs()).min(14)).max(1) }
}

/// Where one level goes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Placed {
    pub lod: i8,
    /// What the LOD node says, metres.
    pub significant_size: f64,
}

/// Files levels under consecutive LODs, beginning with the LOD of the coarsest level's significant size.
///
/// Consecutive, because clients that look for the model at a feature tile's own LOD then always find it. A level whose
/// measured size belongs to a finer LOD gets size₀ / 2ⁱ, Volume 7's estimate from four times the vertices a level, so
/// that size and LOD agree.
///
/// # Errors
/// [`Error::Unsupported`] unless there are 1–8 levels of positive, strictly decreasing size that end at LOD 23 or
/// coarser.
pub fn place(significant_sizes: &[f64]) -> Result<Vec<Placed>> {
    let refuse = |what: String| Err(Error::Unsupported { format: "CDB levels of detail", what });
    if significant_sizes.is_empty() || significant_sizes.len() > MAX_LEVELS {
        return refuse(format!("a model has 1 to {MAX_LEVELS} levels, found {}", significant_sizes.len()));
    }
    if let Some(i) = significant_sizes.iter().position(|s| !(s.is_finite() && *s > 0.0)) {
        return refuse(format!("level {i} has significant size {}, expected a positive length", significant_sizes[i]));
    }
    if let Some(i) = significant_sizes.windows(2).position(|w| w[1] >= w[0]) {
        return refuse(format!(
            "significant sizes must decrease from the coarsest level, found {} then {} at level {}",
            significant_sizes[i],
            significant_sizes[i + 1],
            i + 1
        ));
    }
    let coarsest = of_size(significant_sizes[0]);
    if usize::from((23 - coarsest).unsigned_abs()) + 1 < significant_sizes.len() {
        return refuse(format!(
            "{} levels of a model of {} m do not fit below LOD 23",
            significant_sizes.len(),
            significant_sizes[0]
        ));
    }
    let placed = significant_sizes.iter().enumerate().map(|(i, &size)| {
        let lod = coarsest + i as i8;
        let estimate = significant_sizes[0] / 2f64.powi(i as i32);
        Placed { lod, significant_size: if of_size(size) > lod { estimate } else { size } }
    });
    Ok(placed.collect())
}

/// Whether geometry of this radius about its feature point sticks out of any tile of the LOD by at most half a tile.
pub fn fits(tile: Tile, latitude: f64, radius: f64) -> bool {
    2.0 * radius <= tile.shorter_side(latitude)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bounds_are_the_standard_s_table() {
        for (lod, size, texel) in [
            (-4, 869.68, 108.71),
            (0, 54.3550, 6.79437),
            (4, 3.39719, 0.424648),
            (7, 0.424648, 0.0530810),
            (11, 0.0265405, 0.00331756),
            (15, 0.00165878, 0.000207348),
        ] {
            assert!((size_bound(lod) / size - 1.0).abs() < 1e-5, "{lod}");
            assert!((texel_bound(lod) / texel - 1.0).abs() < 1e-5, "{lod}");
        }
    }

    #[test]
    fn sizes_fall_into_the_first_bound_they_exceed() {
        // A 75 m building, a 2 m bench and a 5 m car are the standard's and the usual examples.
        for (size, lod) in [(75.0, 0), (2.0, 5), (5.0, 4), (1e9, -10), (1e-9, 23)] {
            assert_eq!(of_size(size), lod);
        }
        assert_eq!(of_size(size_bound(4)), 5, "the bound itself is not exceeded");
        assert_eq!(of_texel(0.01), 10);
    }

    #[test]
    fn limits_are_the_standard_s_table() {
        assert_eq!(
            (0..8).map(max_vertices).collect::<Vec<_>>(),
            [128, 512, 2048, 8192, 32768, 131072, 524288, 2097152]
        );
        let points: Vec<usize> = (-10..=1).map(max_points).collect();
        assert_eq!(points, [1, 1, 1, 1, 4, 16, 64, 256, 1024, 4096, 16384, 16384]);
    }

    #[test]
    fn levels_are_consecutive_and_their_sizes_agree_with_their_lod() {
        for sizes in [vec![5.0, 0.3, 0.05, 0.01], vec![5.0, 4.9, 4.8, 4.7], vec![75.0, 30.0, 2.0], vec![0.4]] {
            let placed = place(&sizes).unwrap();
            assert_eq!(placed[0].significant_size, sizes[0]);
            for (i, p) in placed.iter().enumerate() {
                assert_eq!(p.lod, placed[0].lod + i as i8);
                assert!(of_size(p.significant_size) <= p.lod, "{sizes:?} level {i}");
            }
            assert!(placed.windows(2).all(|w| w[1].significant_size < w[0].significant_size), "{sizes:?}");
        }
        assert_eq!(place(&[5.0, 0.3, 0.05, 0.01]).unwrap()[3].significant_size, 0.625);
    }

    #[test]
    fn levels_that_cannot_be_placed_are_refused() {
        for sizes in [&[][..], &[1.0; 9], &[1.0, 1.0], &[0.0], &[f64::NAN], &[2.0, -1.0], &[1e-5, 1e-6]] {
            assert!(place(sizes).is_err(), "{sizes:?}");
        }
    }

    #[test]
    fn overhang_counts_the_shorter_side() {
        let fits_at =
            |latitude: f64, lod, radius| fits(Tile::containing(latitude, 0.0, lod).unwrap(), latitude, radius);
        assert!(fits_at(0.0, 14, 2.5) && !fits_at(0.0, 15, 2.5));
        assert!(fits_at(89.9, 7, 2.5) && !fits_at(89.999, 7, 2.5));
    }
}
