//! The Military Grid Reference System over UTM and UPS (NGA.STND.0037).

use super::utm::{BANDS, Utm, band};

const SQUARE: f64 = 100_000.0;
/// Columns of zones 1, 2, 3 and again; eight squares from 100 km east on.
const COLUMNS: [&[u8; 8]; 3] = [b"ABCDEFGH", b"JKLMNPQR", b"STUVWXYZ"];
/// Rows repeat every 2,000 km; even zones begin five letters later.
const ROWS: &[u8; 20] = b"ABCDEFGHJKLMNPQRSTUV";

/// UPS: west and east half of the south, then of the north.
const POLAR_BANDS: &[u8; 4] = b"ABYZ";
const POLAR_COLUMNS: [&[u8]; 4] = [b"JKLPQRSTUXYZ", b"ABCFGHJKLPQR", b"RSTUXYZ", b"ABCFGHJ"];
const POLAR_ROWS: [&[u8]; 2] = [b"ABCDEFGHJKLMNPQRSTUVWXYZ", b"ABCDEFGHJKLMNP"];
/// First square of the south and of the north, in hundreds of kilometres; east of the pole begins at 20.
const POLAR_FIRST: [i64; 2] = [8, 13];
const POLAR_EAST: i64 = 20;

/// What a reference names: the middle of its square, and the square's side in metres.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Square {
    pub centre: Utm,
    pub side: f64,
}

/// Letters and digits of a point, `digits` (0 to 11) for each axis; 5 is a metre. The rest is cut off, not rounded.
pub fn format(latitude: f64, longitude: f64, digits: usize) -> String {
    let at = Utm::of(latitude, longitude);
    let digits = digits.min(11);
    // Eleven digits are a micrometre; the point that a metre's corner lies on must not fall into the square before.
    let hundred_km = |v: f64| ((v + 1e-9) / SQUARE).floor() as i64;
    let (column, row) = (hundred_km(at.easting), hundred_km(at.northing));
    let pick = |letters: &[u8], i: i64| *letters.get(i.max(0) as usize).unwrap_or(&b'?') as char;
    let mut out = String::with_capacity(5 + 2 * digits);
    if at.zone == 0 {
        let (n, east) = (usize::from(at.north), column >= POLAR_EAST);
        let half = 2 * n + usize::from(east);
        out.push(POLAR_BANDS[half] as char);
        out.push(pick(POLAR_COLUMNS[half], column - if east { POLAR_EAST } else { POLAR_FIRST[n] }));
        out.push(pick(POLAR_ROWS[n], row - POLAR_FIRST[n]));
    } else {
        let zone = i64::from(at.zone) - 1;
        put_digits(&mut out, at.zone.into(), 2);
        out.push(BANDS[band(latitude)] as char);
        out.push(pick(COLUMNS[(zone % 3) as usize], column - 1));
        out.push(ROWS[(row + 5 * (zone & 1)).rem_euclid(20) as usize] as char);
    }
    let unit = 10f64.powi(5 - digits as i32);
    for (value, square) in [(at.easting, column), (at.northing, row)] {
        let inside = ((value - square as f64 * SQUARE + 1e-9) / unit).floor().max(0.0) as u64;
        put_digits(&mut out, inside, digits);
    }
    out
}

/// Faster than the formatting machinery, which takes as long as the projection.
fn put_digits(out: &mut String, value: u64, digits: usize) {
    let mut unit = 10u64.pow(digits as u32);
    while unit > 1 {
        let rest = value % unit;
        unit /= 10;
        out.push((b'0' + (rest / unit) as u8) as char);
    }
}

/// Reads a reference; spaces are skipped, letters of either case.
///
/// # Errors
/// A sentence that names the wrong part.
pub fn parse(text: &str) -> Result<Square, String> {
    let compact: Vec<u8> = text.bytes().filter(|b| !b.is_ascii_whitespace()).map(|b| b.to_ascii_uppercase()).collect();
    let zone_digits = compact.iter().take_while(|b| b.is_ascii_digit()).count();
    let (zone_text, rest) = compact.split_at(zone_digits);
    let show = |part: &[u8]| String::from_utf8_lossy(part).into_owned();
    let zone: u8 = match zone_digits {
        0 => 0,
        1 | 2 => zone_text.iter().fold(0, |n, digit| 10 * n + (digit - b'0')),
        _ => return Err(format!("zone `{}`: one or two digits", show(zone_text))),
    };
    if zone_digits > 0 && !(1..=60).contains(&zone) {
        return Err(format!("zone `{}`: zones are 1 to 60", show(zone_text)));
    }
    let letters = rest.iter().take_while(|b| b.is_ascii_alphabetic()).count();
    if letters != 3 {
        return Err(format!("letters `{}`: a band and two letters of a 100 km square", show(&rest[..letters])));
    }
    let (letters, digits) = rest.split_at(3);
    if let Some(wrong) = digits.iter().find(|b| !b.is_ascii_digit()) {
        return Err(format!("`{}` among the digits", *wrong as char));
    }
    if digits.len() % 2 != 0 || digits.len() > 22 {
        return Err(format!("digits `{}`: as many for the easting as for the northing, 11 each at most", show(digits)));
    }
    let half = digits.len() / 2;
    let side = 10f64.powi(5 - half as i32);
    let number = |d: &[u8]| d.iter().fold(0u64, |n, digit| 10 * n + u64::from(digit - b'0'));
    let inside = |d: &[u8]| number(d) as f64 * side + side / 2.0;
    let (dx, dy) = (inside(&digits[..half]), inside(&digits[half..]));
    let corner = if zone == 0 { polar_corner(letters)? } else { utm_corner(zone, letters)? };
    let centre = Utm { easting: corner.easting + dx, northing: corner.northing + dy, ..corner };
    Ok(Square { centre, side })
}

fn find(letters: &[u8], wanted: u8, what: &str) -> Result<i64, String> {
    match letters.iter().position(|&l| l == wanted) {
        Some(i) => Ok(i as i64),
        None => Err(format!("{what} `{}`: one of {}", wanted as char, String::from_utf8_lossy(letters))),
    }
}

fn polar_corner(letters: &[u8]) -> Result<Utm, String> {
    let half = find(POLAR_BANDS, letters[0], "band without a zone")? as usize;
    let (n, east) = (half / 2, half % 2 == 1);
    let first = if east { POLAR_EAST } else { POLAR_FIRST[n] };
    let column = find(POLAR_COLUMNS[half], letters[1], "column letter")? + first;
    let row = find(POLAR_ROWS[n], letters[2], "row letter")? + POLAR_FIRST[n];
    Ok(Utm { zone: 0, north: n == 1, easting: column as f64 * SQUARE, northing: row as f64 * SQUARE })
}

/// Northing of the central meridian at the bands' borders from the equator on, every 8° up to 80°, and at 84°.
const BORDERS: [f64; 12] = [
    0.0,
    884_297.851,
    1_768_935.376,
    2_654_226.538,
    3_540_435.693,
    4_427_757.219,
    5_316_300.224,
    6_206_079.587,
    7_097_014.163,
    7_988_932.503,
    8_881_585.816,
    9_328_093.831,
];

fn utm_corner(zone: u8, letters: &[u8]) -> Result<Utm, String> {
    let band = find(BANDS, letters[0], "band")?;
    let index = i64::from(zone) - 1;
    let column = find(COLUMNS[(index % 3) as usize], letters[1], "column letter")? + 1;
    let row = (find(ROWS, letters[2], "row letter")? - 5 * (index & 1)).rem_euclid(20);
    let north = band >= 10;
    let steps = if north { band - 10 } else { 9 - band } as usize;
    // Of both hemispheres as distances from the equator.
    let (near, far) = (BORDERS[steps], BORDERS[if band == 19 { 11 } else { steps + 1 }]);
    let false_north = if north { 0.0 } else { 10_000_000.0 };
    let no_square =
        || format!("row letter `{}`: no such square in band {} of zone {zone}", letters[2] as char, letters[0] as char);
    // Rows repeat every 2,000 km, a band is 900 km high, the last one 1,340 km: one repetition lies in the band, or at a
    // border that bends away from the meridian by less than a square.
    let middle = (if north { near + far } else { -near - far }) / (2.0 * SQUARE);
    let from_equator = (row as f64 + 20.0 * ((middle - 0.5 - row as f64) / 20.0).round()) * SQUARE;
    let corner = Utm { zone, north, easting: column as f64 * SQUARE, northing: from_equator + false_north };
    let (low, high) = match north {
        true => (from_equator, from_equator + SQUARE),
        false => (-from_equator - SQUARE, -from_equator),
    };
    if low >= near + SQUARE && high <= far {
        return Ok(corner);
    }
    // The edge towards the central meridian is where a square reaches furthest from the equator.
    let (inner, outer) = if column >= 5 { (0.0, SQUARE) } else { (SQUARE, 0.0) };
    let latitude = |dx: f64, distance: f64| {
        let at = if north { distance } else { -distance } + false_north;
        Utm { zone, north, easting: corner.easting + dx, northing: at }.to_degrees().0.abs()
    };
    let (nearest, farthest) = (8.0 * steps as f64, if band == 19 { 84.0 } else { 8.0 * steps as f64 + 8.0 });
    let reaches = (0.0..9_600_000.0).contains(&low)
        && latitude(inner, high) > nearest + 1e-9
        && latitude(outer, low) < farthest - 1e-9;
    if reaches { Ok(corner) } else { Err(no_square()) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn refuses_and_names_the_part() {
        for (text, part) in [
            ("61SLU1234", "61"),
            ("11ILU1234", "`I`"),
            ("11SAU1234", "`A`"),
            ("11SLW12", "`W`"),
            ("11SLU123", "`123`"),
            ("11SLU12x4", "`X`"),
            ("11SL1234", "`SL`"),
            ("CLU1234", "`C`"),
            ("", "``"),
            ("11CLD", "`D`"),
        ] {
            let said = parse(text).unwrap_err();
            assert!(said.contains(part), "{text}: {said}");
        }
    }

    proptest! {
        /// The middle of the square that a reference names is within half its diagonal of the point.
        #[test]
        fn round_trip(lat in -90.0..=90.0f64, lon in -180.0..180.0f64, digits in 0usize..=9) {
            let text = format(lat, lon, digits);
            let square = parse(&text).map_err(|e| TestCaseError::fail(format!("{text}: {e}")))?;
            let at = Utm::of(lat, lon);
            prop_assert_eq!((square.centre.zone, square.centre.north), (at.zone, at.north), "{}", text);
            let off = (square.centre.easting - at.easting).abs().max((square.centre.northing - at.northing).abs());
            prop_assert!(off <= square.side / 2.0 + 4e-9, "{} {}", text, off);
        }
    }
}
