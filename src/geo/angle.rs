//! One angle in degrees, minutes and seconds, with a sign or a hemisphere.

use super::written::{Fault, fault, number};

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Axis {
    Latitude,
    Longitude,
}

#[derive(Clone, Copy, Debug)]
pub(super) struct Angle<'a> {
    pub degrees: f64,
    /// Size of the last place written, degrees.
    pub step: f64,
    pub axis: Option<Axis>,
    pub sexagesimal: bool,
    pub text: &'a str,
}

fn hemisphere(c: char) -> Option<(Axis, f64)> {
    match c.to_ascii_uppercase() {
        'N' => Some((Axis::Latitude, 1.0)),
        'S' => Some((Axis::Latitude, -1.0)),
        'E' => Some((Axis::Longitude, 1.0)),
        'W' => Some((Axis::Longitude, -1.0)),
        _ => None,
    }
}

/// Two angles and perhaps a height: at commas, else behind (or before) the letters of the hemispheres, else at spaces.
pub(super) fn split(text: &str) -> Option<Vec<&str>> {
    let pieces: Vec<&str> = if text.contains([',', ';']) {
        text.split([',', ';']).collect()
    } else {
        let letters: Vec<usize> =
            text.char_indices().filter(|(_, c)| hemisphere(*c).is_some()).map(|(i, _)| i).collect();
        match letters[..] {
            [0, second] => {
                let tail = &text[second..];
                // A height after the second angle stands behind the last mark, or behind the only number.
                let end = tail.rfind(['"', '″', '\'', '′', '°', 'd']).map_or_else(
                    || tail.find(char::is_whitespace).unwrap_or(tail.len()),
                    |i| i + tail[i..].chars().next().map_or(0, char::len_utf8),
                );
                vec![&text[..second], &tail[..end], &tail[end..]]
            }
            [first, second] => vec![&text[..=first], &text[first + 1..=second], &text[second + 1..]],
            _ => text.split_whitespace().collect(),
        }
    };
    let pieces: Vec<&str> = match pieces[..] {
        [a, b, c] if c.trim().is_empty() => vec![a, b],
        _ => pieces,
    };
    (2..=3).contains(&pieces.len()).then_some(pieces)
}

pub(super) fn read(text: &str) -> Result<Angle<'_>, Fault> {
    let text = text.trim();
    let mut body = text;
    let mut side = None;
    // `NaN` and other words are no angles with a hemisphere.
    let alone = |neighbour: Option<char>| !neighbour.is_some_and(char::is_alphabetic);
    if let Some(found) = body.chars().next().and_then(hemisphere).filter(|_| alone(body.chars().nth(1))) {
        (side, body) = (Some(found), &body[1..]);
    } else if let Some(found) = body.chars().last().and_then(hemisphere).filter(|_| alone(body.chars().rev().nth(1))) {
        (side, body) = (Some(found), &body[..body.len() - 1]);
    }
    let body = body.trim();
    let (sign, digits) = match body.strip_prefix(['-', '−']) {
        Some(rest) => (-1.0, rest),
        None => (1.0, body.strip_prefix('+').unwrap_or(body)),
    };
    let marks = ['°', 'º', 'd', 'D', ':', '\'', '′', '’', '"', '″', '”', ' ', '\t'];
    let parts: Vec<&str> = digits.split(marks).filter(|p| !p.is_empty()).collect();
    if parts.is_empty() || parts.len() > 3 {
        return Err(fault("an angle: degrees, or degrees, minutes and seconds", text));
    }
    if side.is_some() && body.starts_with(['-', '−', '+']) {
        return Err(fault("a sign or a hemisphere, not both", text));
    }
    let (mut degrees, mut unit, mut step) = (0.0, 1.0, 1.0);
    for (i, part) in parts.iter().enumerate() {
        if let Some(letter) =
            part.chars().find(|c| c.is_alphabetic() && parts.len() * part.len() > 1 && !"eE".contains(*c))
            && part.starts_with(|c: char| c.is_ascii_digit())
        {
            return Err(fault("N, S, E or W", letter.to_string()));
        }
        let (value, place) = number(part, ["an angle in degrees", "minutes", "seconds"][i])?;
        let last = i + 1 == parts.len();
        if !last && place < 1.0 {
            return Err(fault("a fraction in the last place only", *part));
        }
        if (i > 0 && !(0.0..60.0).contains(&value)) || value < 0.0 {
            return Err(fault("minutes and seconds below 60", *part));
        }
        degrees += value * unit;
        step = place * unit;
        unit /= 60.0;
    }
    let sign = side.map_or(sign, |(_, s)| s);
    Ok(Angle { degrees: sign * degrees, step, axis: side.map(|(a, _)| a), sexagesimal: parts.len() > 1, text })
}
