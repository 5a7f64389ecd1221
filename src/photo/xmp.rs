//! XMP packets (ISO 16684-1): where drones write how their gimbal stood, and some cameras their position.

use orb_formats::xml::{self, Element};

use super::gps::{AltitudeAbove, Position, altitude_reference};

/// How a camera hung, as its drone wrote it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Gimbal {
    /// Bearing of the optical axis, degrees clockwise from true north, [0, 360).
    pub yaw: Option<f64>,
    /// Of the optical axis above the horizon, degrees; negative looks down.
    pub pitch: Option<f64>,
    /// Metres above the point of take-off.
    pub above_takeoff: Option<f64>,
}

/// What a packet says; absent parts stay `None`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Xmp {
    pub position: Option<Position>,
    pub gimbal: Option<Gimbal>,
    pub focal_35mm: Option<f64>,
    pub image_direction: Option<f64>,
    pub direction_is_magnetic: bool,
    /// Of the position, where the drone's receiver wrote its own (RTK), metres.
    pub accuracy: Option<f64>,
    pub vertical_accuracy: Option<f64>,
}

/// Reads a packet. A damaged one says nothing: a photo is not refused for its metadata.
pub(super) fn read(packet: &[u8]) -> Xmp {
    let Ok(root) = xml::parse(String::from_utf8_lossy(packet).trim_matches(['\0', '\u{feff}'])) else {
        return Xmp::default();
    };
    let mut all = Vec::new();
    gather(&root, "", &mut all);
    let text = |names: &[&str]| {
        names.iter().find_map(|n| all.iter().find(|(name, _)| name.eq_ignore_ascii_case(n)).map(|(_, v)| v.as_str()))
    };
    let number = |names: &[&str]| text(names).and_then(number);

    // DJI and Autel by one set of names, Parrot and Skydio by their own; Pix4D's `Camera` (senseFly, MicaSense, Yuneec)
    // for the bearing alone, since its makers do not agree on where a pitch of 0 looks.
    let yaw = number(&[
        "drone-dji:GimbalYawDegree",
        "drone-autel:GimbalYawDegree",
        "drone:GimbalYawDegree",
        "drone-parrot:CameraYawDegree",
        "CameraOrientationNED/drone-skydio:Yaw",
        "Camera:Yaw",
    ]);
    let pitch = number(&[
        "drone-dji:GimbalPitchDegree",
        "drone-autel:GimbalPitchDegree",
        "drone:GimbalPitchDegree",
        "drone-parrot:CameraPitchDegree",
        "CameraOrientationNED/drone-skydio:Pitch",
    ]);
    let above_takeoff = number(&[
        "drone-dji:RelativeAltitude",
        "drone-autel:RelativeAltitude",
        "drone:RelativeAltitude",
        "Camera:AboveGroundAltitude",
    ]);
    let gimbal = Gimbal {
        yaw: yaw.filter(|y| (-360.0..=360.0).contains(y)).map(|y| y.rem_euclid(360.0)),
        pitch: pitch.filter(|p| (-90.0..=90.0).contains(p)),
        above_takeoff: above_takeoff.filter(|h| (-1000.0..=10_000.0).contains(h)),
    };
    let (sign, altitude_above) = altitude_reference(number(&["exif:GPSAltitudeRef"]).unwrap_or(0.0) as u8);
    let latitude =
        text(&["exif:GPSLatitude", "drone-dji:GpsLatitude", "drone-dji:Latitude"]).and_then(|t| angle(t, 'S'));
    let longitude =
        text(&["exif:GPSLongitude", "drone-dji:GpsLongitude", "drone-dji:GpsLongtitude", "drone-dji:Longitude"])
            .and_then(|t| angle(t, 'W'));
    let accuracy = number(&["drone-dji:RtkStdLat", "Camera:GPSXYAccuracy"])
        .map(|a| a.max(number(&["drone-dji:RtkStdLon"]).unwrap_or(a)));
    let vertical_accuracy = number(&["drone-dji:RtkStdHgt", "Camera:GPSZAccuracy"]);
    let position = latitude.zip(longitude).and_then(|(latitude, longitude)| {
        let (altitude, altitude_above) = match number(&["exif:GPSAltitude"]) {
            Some(a) => (Some(sign * a), altitude_above),
            None => (number(&["drone-dji:AbsoluteAltitude"]), AltitudeAbove::Sea),
        };
        Position { latitude, longitude, altitude, altitude_above, accuracy, vertical_accuracy }.sound()
    });
    let image_direction = number(&["exif:GPSImgDirection"]).filter(|d| (0.0..=360.0).contains(d)).map(|d| d % 360.0);
    Xmp {
        position,
        gimbal: (gimbal != Gimbal::default()).then_some(gimbal),
        focal_35mm: number(&["exif:FocalLengthIn35mmFilm", "exif:FocalLengthIn35mmFormat"])
            .filter(|f| (4.0..=3000.0).contains(f)),
        image_direction,
        direction_is_magnetic: image_direction.is_some()
            && text(&["exif:GPSImgDirectionRef"]).is_some_and(|r| r.starts_with('M')),
        accuracy,
        vertical_accuracy,
    }
}

/// Every property by its name as written, whether attribute or element; inside a structure also as `Structure/name`.
fn gather(e: &Element, parent: &str, into: &mut Vec<(String, String)>) {
    let mut put = |name: &str, value: &str| {
        into.push((name.to_owned(), value.trim().to_owned()));
        if !parent.is_empty() {
            into.push((format!("{parent}/{name}"), value.trim().to_owned()));
        }
    };
    let own = e.local_name().to_owned();
    for (name, value) in &e.attributes {
        put(name, value);
    }
    if e.children.is_empty() && !e.text.trim().is_empty() {
        put(&e.name, &e.text);
    }
    for (name, value) in &e.attributes {
        into.push((format!("{own}/{name}"), value.trim().to_owned()));
    }
    // A structure's fields may stand inside an rdf:Description or rdf:li of their own.
    let next =
        if matches!(own.as_str(), "Description" | "li" | "Seq" | "Bag" | "RDF" | "xmpmeta") { parent } else { &own };
    e.children.iter().for_each(|c| gather(c, next, into));
}

/// `+12.3`, `123/10`, `12.3 m`.
fn number(text: &str) -> Option<f64> {
    let text = text.trim().trim_end_matches(['m', ' ', '°']);
    let value = match text.split_once('/') {
        Some((n, d)) => n.trim().parse::<f64>().ok()? / d.trim().parse::<f64>().ok()?,
        None => text.strip_prefix('+').unwrap_or(text).parse().ok()?,
    };
    value.is_finite().then_some(value)
}

/// XMP's `34,33.138N` and `34,33,8.28N` (XMP part 2, section 1.2.2.2), and plain signed degrees.
fn angle(text: &str, negative: char) -> Option<f64> {
    let letters: Vec<char> = text.chars().filter(char::is_ascii_alphabetic).collect();
    let bare = text.trim_end_matches(|c: char| c.is_ascii_alphabetic());
    let mut sum = 0.0;
    for (i, part) in bare.split(',').enumerate() {
        sum += number(part)? / 60f64.powi(i as i32);
    }
    Some(if letters.first().is_some_and(|c| c.eq_ignore_ascii_case(&negative)) { -sum } else { sum })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn packet(description: &str) -> Vec<u8> {
        format!(
            "<?xpacket begin=\"\u{feff}\" id=\"W5M0MpCehiHzreSzNTczkc9d\"?><x:xmpmeta xmlns:x=\"adobe:ns:meta/\"><rdf:RDF \
             xmlns:rdf=\"http://www.w3.org/1999/02/22-rdf-syntax-ns#\">{description}</rdf:RDF></x:xmpmeta><?xpacket end=\"w\"?>"
        )
        .into_bytes()
    }

    #[test]
    fn gimbals_of_several_makers() {
        let dji = "<rdf:Description rdf:about=\"DJI\" xmlns:drone-dji=\"http://www.dji.com/drone-dji/1.0/\" \
                   drone-dji:AbsoluteAltitude=\"+812.33\" drone-dji:RelativeAltitude=\"+72.10\" \
                   drone-dji:GimbalRollDegree=\"+0.00\" drone-dji:GimbalYawDegree=\"-45.20\" \
                   drone-dji:GimbalPitchDegree=\"-31.50\" drone-dji:GpsLatitude=\"34.5523\" \
                   drone-dji:GpsLongtitude=\"-118.4712\" drone-dji:RtkStdLon=\"0.02\" drone-dji:RtkStdLat=\"0.01\" \
                   drone-dji:RtkStdHgt=\"0.03\"/>";
        let x = read(&packet(dji));
        let g = x.gimbal.unwrap();
        assert!((g.yaw.unwrap() - 314.8).abs() < 1e-9);
        assert_eq!((g.pitch, g.above_takeoff), (Some(-31.5), Some(72.1)));
        let p = x.position.unwrap();
        assert_eq!((p.latitude, p.longitude, p.altitude), (34.5523, -118.4712, Some(812.33)));
        assert_eq!((p.accuracy, p.vertical_accuracy), (Some(0.02), Some(0.03)));

        let parrot = "<rdf:Description xmlns:drone-parrot=\"http://www.parrot.com/drone-parrot/1.0/\">\
                      <drone-parrot:CameraYawDegree>12.5</drone-parrot:CameraYawDegree>\
                      <drone-parrot:CameraPitchDegree>-20</drone-parrot:CameraPitchDegree></rdf:Description>";
        let g = read(&packet(parrot)).gimbal.unwrap();
        assert_eq!((g.yaw, g.pitch), (Some(12.5), Some(-20.0)));

        let skydio = "<rdf:Description xmlns:drone-skydio=\"https://www.skydio.com/drone-skydio/1.0/\">\
                      <drone-skydio:CameraOrientationNED><rdf:Description drone-skydio:Roll=\"0\" drone-skydio:Pitch=\"-10\" \
                      drone-skydio:Yaw=\"200\"/></drone-skydio:CameraOrientationNED>\
                      <drone-skydio:VehicleOrientationNED><rdf:Description drone-skydio:Yaw=\"90\"/>\
                      </drone-skydio:VehicleOrientationNED></rdf:Description>";
        let g = read(&packet(skydio)).gimbal.unwrap();
        assert_eq!((g.yaw, g.pitch), (Some(200.0), Some(-10.0)));

        let pix4d = "<rdf:Description xmlns:Camera=\"http://pix4d.com/camera/1.0\" Camera:Yaw=\"33/2\" Camera:Pitch=\"0\" \
                     Camera:GPSXYAccuracy=\"1.5\"/>";
        let x = read(&packet(pix4d));
        assert_eq!((x.gimbal.unwrap().yaw, x.gimbal.unwrap().pitch, x.accuracy), (Some(16.5), None, Some(1.5)));
    }

    #[test]
    fn positions_as_xmp_writes_them() {
        let exif = "<rdf:Description xmlns:exif=\"http://ns.adobe.com/exif/1.0/\" exif:GPSLatitude=\"34,33.138S\" \
                    exif:GPSLongitude=\"118,28,16.32W\" exif:GPSAltitude=\"7400/10\" exif:GPSAltitudeRef=\"1\" \
                    exif:GPSImgDirection=\"9050/100\" exif:GPSImgDirectionRef=\"M\" exif:FocalLengthIn35mmFilm=\"24\"/>";
        let x = read(&packet(exif));
        let p = x.position.unwrap();
        assert!((p.latitude + 34.5523).abs() < 1e-9 && (p.longitude + 118.4712).abs() < 1e-9);
        assert_eq!((p.altitude, p.altitude_above), (Some(-740.0), AltitudeAbove::Sea));
        assert_eq!((x.image_direction, x.direction_is_magnetic, x.focal_35mm), (Some(90.5), true, Some(24.0)));
    }

    #[test]
    fn damage_says_nothing() {
        for bytes in [
            &b""[..],
            b"<x",
            b"\xff\xfe\0",
            b"<a drone-dji:GimbalYawDegree=\"900\"/>",
            b"<a drone-dji:GimbalYawDegree=\"x\"/>",
        ] {
            assert_eq!(read(bytes), Xmp::default());
        }
    }
}
