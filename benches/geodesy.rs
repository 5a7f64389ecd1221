//! Times Orb's coordinate conversions; `tests/clients/geodesy_speed.sh` runs it beside GeographicLib and PROJ.
//! One line a conversion: library, conversion, nanoseconds a point (best of 5 rounds), checksum.

use std::time::Instant;

use orb::geo::{Ecef, Geodetic, Utm, mgrs};

/// SplitMix64, seed 8, as in `geodesy_speed.cpp`.
fn points(n: usize) -> Vec<Geodetic> {
    let mut s = 8u64;
    let mut next = || {
        s = s.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = s;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((z ^ (z >> 31)) >> 11) as f64 / 9_007_199_254_740_992.0
    };
    (0..n)
        .map(|_| Geodetic {
            latitude: -79.0 + 162.0 * next(),
            longitude: -180.0 + 360.0 * next(),
            height: -10_000.0 + 1_010_000.0 * next(),
        })
        .collect()
}

fn time(what: &str, n: usize, mut round: impl FnMut() -> f64) {
    let (mut best, mut sum) = (f64::INFINITY, 0.0);
    for _ in 0..5 {
        let began = Instant::now();
        sum = round();
        best = best.min(began.elapsed().as_secs_f64() * 1e9 / n as f64);
    }
    println!("{:<14} {what:<20} {best:8.1} ns  {sum:.6e}", "Orb");
}

fn main() {
    let n = std::env::args().filter_map(|a| a.parse().ok()).next().unwrap_or(200_000);
    let all = points(n);
    let ecef: Vec<Ecef> = all.iter().map(|g| g.to_ecef()).collect();
    let grid: Vec<Utm> = all.iter().map(|g| Utm::of(g.latitude, g.longitude)).collect();
    time("geodetic -> ecef", n, || all.iter().map(|g| g.to_ecef().x).sum());
    time("ecef -> geodetic", n, || ecef.iter().map(|e| e.to_geodetic()).map(|g| g.latitude + g.height).sum());
    time("geodetic -> utm", n, || all.iter().map(|g| Utm::of(g.latitude, g.longitude).easting).sum());
    time("utm -> geodetic", n, || grid.iter().map(|u| u.to_degrees().0).sum());
    time("geodetic -> mgrs", n, || {
        all.iter().map(|g| f64::from(mgrs::format(g.latitude, g.longitude, 5).as_bytes()[6])).sum()
    });
}
