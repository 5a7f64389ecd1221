//! Ground control points: a CSV file whose first line names its columns. `point`, `latitude`, `longitude`, `height`, `photo`,
//! `x`, `y`: each line is one photo's pixel of one point; `sigma` is what its place is known to, metres.

use std::collections::BTreeMap;

use super::Posed;
use super::frame::nearest_to_lines;
use super::register::Fix;
use crate::geo::{AltDatum, Geodetic, to_ellipsoid};
use crate::{Error, Result};

/// What a surveyed point is good to where the file does not say.
const SIGMA: f64 = 0.05;
/// A point's rays may miss it by this part of its distance: more, and a pixel or a name is wrong.
const MISS: f64 = 0.02;

#[derive(Default)]
struct Point {
    place: [f64; 3],
    sigma: f64,
    line: usize,
    seen: Vec<(usize, [f64; 2])>,
}

/// The points of a file in the photos' world. `datum`: what heights are above.
///
/// # Errors
/// Usage, naming the line, for what is missing, no number, or no photo, for a point twice in one photo or in fewer than two, and
/// for one whose rays do not meet in front of the cameras.
pub fn read(name: &str, text: &str, photos: &[Posed], datum: AltDatum) -> Result<Vec<Fix>> {
    let wrong = |line: usize, expected: &str, found: String| {
        Error::usage(format!("{name}, line {line}")).expected(expected).found(found)
    };
    let mut lines = text.trim_start_matches('\u{feff}').lines().enumerate().map(|(i, l)| (i + 1, l.trim()));
    let mut rows = lines.by_ref().filter(|(_, l)| !l.is_empty() && !l.starts_with('#'));
    let (head_at, head) = rows.next().ok_or_else(|| wrong(1, "a line that names the columns", "nothing".into()))?;
    let columns: Vec<String> = head.split(',').map(|c| c.trim().to_ascii_lowercase()).collect();
    let find = |what: &str| columns.iter().position(|c| c == what);
    let needed = |what: &'static str| {
        find(what).ok_or_else(|| wrong(head_at, &format!("a column `{what}`"), columns.join(", ")))
    };
    let at = ["point", "latitude", "longitude", "height", "photo", "x", "y"].map(needed);
    let [point, latitude, longitude, height, photo, x, y] = {
        let mut out = [0; 7];
        for (o, a) in out.iter_mut().zip(at) {
            *o = a?;
        }
        out
    };
    let sigma = find("sigma");
    let mut points: BTreeMap<String, Point> = BTreeMap::new();
    for (line, row) in rows {
        let cells: Vec<&str> = row.split(',').map(str::trim).collect();
        let cell = |i: usize| {
            let found = cells.get(i).copied().filter(|c| !c.is_empty());
            found.ok_or_else(|| wrong(line, &format!("a `{}`", columns[i]), "an empty cell".into()))
        };
        let number = |i: usize| -> Result<f64> {
            let text = cell(i)?;
            let v = text.parse().ok().filter(|v: &f64| v.is_finite());
            v.ok_or_else(|| wrong(line, &format!("a number as `{}`", columns[i]), format!("`{text}`")))
        };
        let place = [number(latitude)?, number(longitude)?, number(height)?];
        if !((-90.0..=90.0).contains(&place[0]) && (-180.0..=180.0).contains(&place[1])) {
            return Err(wrong(line, "degrees of latitude and longitude", format!("{}, {}", place[0], place[1])));
        }
        let file = cell(photo)?;
        let Some(index) = photos.iter().position(|p| p.name == file) else {
            return Err(wrong(line, "the name of a photo with a pose", format!("`{file}`")));
        };
        let own = match sigma.filter(|i| cells.get(*i).is_some_and(|c| !c.is_empty())) {
            Some(i) => number(i)?,
            None => SIGMA,
        };
        if own <= 0.0 {
            return Err(wrong(line, "metres above 0 as `sigma`", own.to_string()));
        }
        let id = cell(point)?;
        let entry = points.entry(id.to_owned()).or_insert(Point { place, sigma: own, line, seen: vec![] });
        if entry.place != place {
            return Err(wrong(line, &format!("the place of line {}", entry.line), format!("{place:?}")));
        }
        // Two pixels of one photo would count as two sights of the point.
        if entry.seen.iter().any(|(i, _)| *i == index) {
            return Err(wrong(
                line,
                "one line for each photo that shows a point",
                format!("a second one of {id} in {file}"),
            ));
        }
        entry.seen.push((index, [number(x)?, number(y)?]));
    }
    points.into_iter().map(|(id, p)| fix(&id, &p, photos, datum, &|e, f| wrong(p.line, e, f))).collect()
}

fn fix(id: &str, p: &Point, photos: &[Posed], datum: AltDatum, wrong: &dyn Fn(&str, String) -> Error) -> Result<Fix> {
    if p.seen.len() < 2 {
        return Err(wrong("two photos at least of each point", format!("one of {id}")));
    }
    let rays = || {
        p.seen.iter().map(|(i, pixel)| {
            let ray = photos[*i].camera.ray(*pixel);
            (photos[*i].centre(), photos[*i].rotation.inverse() * glam::DVec3::from_array(ray).normalize())
        })
    };
    let at = nearest_to_lines(rays())
        .ok_or_else(|| wrong("photos from different sides", format!("parallel ones of {id}")))?;
    let miss = |(eye, along): (glam::DVec3, glam::DVec3)| {
        let d = at - eye;
        (d - along * along.dot(d)).length() / d.length().max(1e-12)
    };
    let worst = rays().map(miss).fold(0.0, f64::max);
    if worst > MISS {
        return Err(wrong(
            "pixels of one point",
            format!("rays of {id} that miss each other by {:.1} % of the way", 100.0 * worst),
        ));
    }
    // Lines go both ways: what lies behind a camera is not in its photo.
    let ahead = |(eye, along): (glam::DVec3, glam::DVec3)| along.dot(at - eye) > 0.0;
    if let Some(((i, _), _)) = p.seen.iter().zip(rays()).find(|(_, ray)| !ahead(*ray)) {
        let found = format!("rays of {id} that meet behind the camera of {}", photos[*i].name);
        return Err(wrong("pixels of one point in front of its cameras", found).advice("A pixel or a name is wrong."));
    }
    let height = to_ellipsoid((p.place[0], p.place[1]), p.place[2], p.sigma, datum, None)?;
    Ok(Fix {
        name: id.to_owned(),
        at,
        place: Geodetic { latitude: p.place[0], longitude: p.place[1], height: height.ellipsoidal },
        horizontal: p.sigma,
        vertical: height.sigma,
        control: true,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::photos::crops::tests::disc;
    use glam::{DQuat, DVec3};

    #[test]
    fn points_are_triangulated_and_mistakes_are_named() {
        let (first, ..) = disc((300, 200), [120.0, 90.0], 40.0);
        let rotation = DQuat::from_rotation_y(0.6);
        let second = Posed { name: "b".into(), rotation, translation: DVec3::new(0.3, 0.1, 6.0), ..first.clone() };
        let photos = [first, second];
        let p = DVec3::new(0.2, -0.1, 0.4);
        let line = |i: usize| {
            let [x, y] = photos[i].pixel(p).unwrap();
            format!("gate,48.1,11.5,560.2,{},{x},{y}\n", photos[i].name)
        };
        let head = "point,latitude,longitude,height,photo,x,y\n";
        let good = format!("{head}{}{}", line(0), line(1));
        let found = read("g.csv", &good, &photos, AltDatum::Ellipsoid).unwrap();
        assert!(found[0].at.distance(p) < 1e-6 && found[0].control && found[0].horizontal == SIGMA);
        // The same lines through the cameras, in the other direction.
        let behind = |i: usize| {
            let q = photos[i].rotation * DVec3::new(0.2, -0.1, -20.0) + photos[i].translation;
            assert!(q.z < 0.0);
            let [fx, fy, cx, cy] = photos[i].camera.pinhole();
            format!("gate,48.1,11.5,560.2,{},{},{}\n", photos[i].name, fx * q.x / q.z + cx, fy * q.y / q.z + cy)
        };
        let shifted = line(1).replace(",b,", ",b,9");
        for (text, said) in [
            (String::new(), "names the columns"),
            ("point,latitude\n".into(), "longitude"),
            (format!("{head}{}", line(0)), "two photos"),
            (format!("{head}{}", line(0).replace(",a,", ",c,")), "line 2"),
            (format!("{head}{}", line(0).replace("48.1", "x")), "`x`"),
            (format!("{head}{}{}", line(0), line(1).replace("48.1", "48.2")), "place of line 2"),
            (format!("{head}{}{shifted}", line(0)), "miss"),
            (format!("{head}{}{}{}", line(0), line(1), line(0)), "line 4"),
            (format!("{head}{}{}", line(0), line(0)), "a second one of gate in a"),
            (format!("{head}{}{}", behind(0), behind(1)), "rays of gate that meet behind the camera of a"),
        ] {
            let e = read("g.csv", &text, &photos, AltDatum::Ellipsoid).unwrap_err().to_string();
            assert!(e.contains(said), "{said}: {e}");
        }
    }
}
