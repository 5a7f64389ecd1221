//! Times Orb's coordinate conversions; `tests/clients/geodesy_speed.sh` runs it beside GeographicLib and PROJ.
//! One line a conversion: library, conversion, nanoseconds a point (best of 5 rounds), checksum.

use std::time::Instant;

use orb::geo::{Ecef, Enu, Geodetic, Utm, mgrs};

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
    let here = Geodetic { latitude: 34.5523, longitude: -118.4712, height: 740.0 }.frame();
    let enu: Vec<Enu> = ecef.iter().map(|e| here.to_enu(*e)).collect();
    // Where UPS is prescribed.
    let towards = |g: &Geodetic, from: f64, by: f64| (from + by * g.height.abs() / 1e6, g.longitude);
    let polar: Vec<(f64, f64)> =
        all.iter().map(|g| if g.latitude < 2.0 { towards(g, -90.0, 10.0) } else { towards(g, 84.0, 6.0) }).collect();
    let ups: Vec<Utm> = polar.iter().map(|p| Utm::in_zone(p.0, p.1, 0)).collect();
    let references: Vec<String> = all.iter().map(|g| mgrs::format(g.latitude, g.longitude, 5)).collect();
    let grid: Vec<Utm> = all.iter().map(|g| Utm::of(g.latitude, g.longitude)).collect();
    time("geodetic -> ecef", n, || all.iter().map(|g| g.to_ecef().x).sum());
    time("ecef -> geodetic", n, || ecef.iter().map(|e| e.to_geodetic()).map(|g| g.latitude + g.height).sum());
    time("geodetic -> enu", n, || all.iter().map(|g| here.to_enu(g.to_ecef()).east).sum());
    time("enu -> geodetic", n, || enu.iter().map(|e| here.to_ecef(*e).to_geodetic()).map(|g| g.latitude).sum());
    time("geodetic -> utm", n, || all.iter().map(|g| Utm::of(g.latitude, g.longitude).easting).sum());
    time("utm -> geodetic", n, || grid.iter().map(|u| u.to_degrees().0).sum());
    time("geodetic -> ups", n, || polar.iter().map(|p| Utm::in_zone(p.0, p.1, 0).easting).sum());
    time("ups -> geodetic", n, || ups.iter().map(|u| u.to_degrees().0).sum());
    time("geodetic -> mgrs", n, || {
        all.iter().map(|g| f64::from(mgrs::format(g.latitude, g.longitude, 5).as_bytes()[6])).sum()
    });
    time("mgrs -> geodetic", n, || {
        references.iter().filter_map(|t| mgrs::parse(t).ok()).map(|s| s.centre.to_degrees().0).sum()
    });
}
