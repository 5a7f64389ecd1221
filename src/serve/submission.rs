//! What a job is asked to do: typed values, and the command line that is made of them.

use std::collections::BTreeMap;
use std::str::FromStr;

use serde::{Deserialize, Deserializer, Serialize};
use utoipa::ToSchema;

use crate::{Error, Result};

/// Longest text of a field, bytes.
const LONGEST: usize = 500;

#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Format {
    Cdb,
    Flt,
    Glb,
    Usdz,
    Tiles3d,
    Kmz,
    Ply,
    Spz,
    SplatGlb,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
#[serde(rename_all = "lowercase")]
pub enum Quality {
    Draft,
    Standard,
    High,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
#[serde(rename_all = "lowercase")]
pub enum Symmetry {
    Auto,
    Evident,
    On,
    Two,
    Off,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, ToSchema)]
#[serde(rename_all = "lowercase")]
pub enum HeightAbove {
    Ellipsoid,
    Msl,
}

/// The fields of a submission beside its photos; each means what the option of `orb geo` with its name means.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, ToSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Submission {
    /// Of the model. Default: of the photo's file, what may stand in a name.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(max_length = 100)]
    pub name: Option<String>,
    /// The ground point under the subject: `34.5523,-118.4712,740` and every other form that Orb reads. Default: from the photo.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(example = "34.5523,-118.4712,740", max_length = 500)]
    pub origin: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub alt_datum: Option<HeightAbove>,
    /// Metres.
    #[serde(deserialize_with = "number", skip_serializing_if = "Option::is_none")]
    pub origin_accuracy: Option<f64>,
    /// Degrees clockwise from true north.
    #[serde(deserialize_with = "number", skip_serializing_if = "Option::is_none")]
    #[schema(minimum = -360, maximum = 360)]
    pub heading: Option<f64>,
    /// Of one photo's camera, degrees above the horizon.
    #[serde(deserialize_with = "number", skip_serializing_if = "Option::is_none")]
    #[schema(minimum = -90, maximum = 90)]
    pub pitch: Option<f64>,
    /// Of one photo's camera, millimetres of a 36 × 24 mm frame.
    #[serde(deserialize_with = "number", skip_serializing_if = "Option::is_none")]
    #[schema(minimum = 4, maximum = 3000)]
    pub focal: Option<f64>,
    /// Metres, as the next four.
    #[serde(deserialize_with = "number", skip_serializing_if = "Option::is_none")]
    pub height: Option<f64>,
    #[serde(deserialize_with = "number", skip_serializing_if = "Option::is_none")]
    pub length: Option<f64>,
    #[serde(deserialize_with = "number", skip_serializing_if = "Option::is_none")]
    pub width: Option<f64>,
    #[serde(deserialize_with = "number", skip_serializing_if = "Option::is_none")]
    pub camera_height: Option<f64>,
    #[serde(deserialize_with = "number", skip_serializing_if = "Option::is_none")]
    pub distance: Option<f64>,
    /// Separated by commas. Default: cdb.
    #[serde(deserialize_with = "list", skip_serializing_if = "Vec::is_empty")]
    pub format: Vec<Format>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub quality: Option<Quality>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub symmetry: Option<Symmetry>,
    #[serde(deserialize_with = "number", skip_serializing_if = "Option::is_none")]
    pub seed: Option<u32>,
    /// On the subject, pixels of the photo: `X,Y`.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schema(pattern = "^[0-9]{1,6},[0-9]{1,6}$")]
    pub point: Option<String>,
    /// Banner. Default: what the photo carries, else UNCLASSIFIED.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub classification: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub raise_reason: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub classified_by: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub derived_from: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub declassify_on: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cui_controlled_by: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cui_office: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cui_category: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cui_dissemination: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub cui_poc: Option<String>,
    /// Made by the server, as the next three: the photos' file names.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    #[schema(read_only)]
    pub photos: Vec<String>,
    /// The files that say where several photos were taken from.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    #[schema(read_only)]
    pub poses: Vec<String>,
    /// There are ground control points.
    #[serde(skip_serializing_if = "is_false")]
    #[schema(read_only)]
    pub control: bool,
    /// There are country codes beyond those that Orb lists.
    #[serde(skip_serializing_if = "is_false")]
    #[schema(read_only)]
    pub register: bool,
}

/// Where a job's folder has what belongs to several photos.
pub const POSES: &str = "in/poses";
const CONTROL: &str = "in/gcp.csv";
/// Country codes that a marking may use.
pub const REGISTER: &str = "in/countries.txt";

#[allow(clippy::trivially_copy_pass_by_ref, reason = "serde gives it so")]
fn is_false(value: &bool) -> bool {
    !value
}

/// A number, or the text of one, as forms send it.
fn number<'de, D: Deserializer<'de>, T: Deserialize<'de> + FromStr>(
    from: D,
) -> std::result::Result<Option<T>, D::Error> {
    #[derive(Deserialize)]
    #[serde(untagged)]
    enum Either<T> {
        Number(T),
        Text(String),
    }
    match Either::deserialize(from)? {
        Either::Number(number) => Ok(Some(number)),
        Either::Text(text) => match text.trim().parse() {
            Ok(number) => Ok(Some(number)),
            Err(_) => Err(serde::de::Error::custom(format!("expected a number, found {text:?}"))),
        },
    }
}

/// A list, or its members in one text with commas between.
fn list<'de, D: Deserializer<'de>, T: for<'a> Deserialize<'a>>(from: D) -> std::result::Result<Vec<T>, D::Error> {
    #[derive(Deserialize)]
    #[serde(untagged)]
    enum Either<T> {
        List(Vec<T>),
        Text(String),
    }
    let one = |text: &str| serde_json::from_value(text.trim().into()).map_err(serde::de::Error::custom);
    match Either::deserialize(from)? {
        Either::List(list) => Ok(list),
        Either::Text(text) => text.split(',').map(one).collect(),
    }
}

impl Submission {
    /// Of a form's fields.
    ///
    /// # Errors
    /// Usage, naming the field or the value.
    pub fn of_fields(fields: BTreeMap<String, String>) -> Result<Submission> {
        for (field, files) in
            [("photos", "photo"), ("poses", "poses"), ("control", "gcp"), ("register", "country_register")]
        {
            if fields.contains_key(field) {
                return Err(Error::usage(field).expected(format!("files in fields named `{files}`")).found("a text"));
            }
        }
        for (name, text) in &fields {
            if text.len() > LONGEST || text.chars().any(char::is_control) {
                return Err(Error::usage(name)
                    .expected(format!("at most {LONGEST} bytes of text in one line"))
                    .found(format!("{} bytes", text.len())));
            }
        }
        // What a form leaves empty is not said.
        let given = fields.into_iter().filter(|(_, text)| !text.trim().is_empty());
        let object = serde_json::Value::Object(given.map(|(name, text)| (name, text.into())).collect());
        let submission: Submission = serde_json::from_value(object)
            .map_err(|e| Error::usage("a field of the submission").found(e.to_string()))?;
        if let Some(point) = &submission.point {
            let is_point =
                point.split_once(',').is_some_and(|(x, y)| x.parse::<u32>().is_ok() && y.parse::<u32>().is_ok());
            if !is_point {
                return Err(Error::usage("point").expected("X,Y in pixels of the photo").found(point.clone()));
            }
        }
        Ok(submission)
    }

    /// The options of `orb geo`, each with its value in the same argument: no value can be taken for an option.
    pub fn options(&self) -> Vec<String> {
        let mut out = Vec::new();
        let mut say = |option: &str, value: Option<String>| out.extend(value.map(|v| format!("--{option}={v}")));
        say("origin", self.origin.clone());
        say("alt-datum", self.alt_datum.map(|v| word(&v)));
        for (option, value) in [
            ("origin-accuracy", self.origin_accuracy),
            ("heading", self.heading),
            ("pitch", self.pitch),
            ("focal", self.focal),
            ("height", self.height),
            ("length", self.length),
            ("width", self.width),
            ("camera-height", self.camera_height),
            ("distance", self.distance),
        ] {
            say(option, value.map(|v| v.to_string()));
        }
        let formats: Vec<String> = self.format.iter().map(word).collect();
        say("format", (!formats.is_empty()).then(|| formats.join(",")));
        say("quality", self.quality.map(|v| word(&v)));
        say("symmetry", self.symmetry.map(|v| word(&v)));
        say("seed", self.seed.map(|v| v.to_string()));
        say("point", self.point.clone());
        for (option, value) in [
            ("classification", &self.classification),
            ("raise-reason", &self.raise_reason),
            ("classified-by", &self.classified_by),
            ("derived-from", &self.derived_from),
            ("declassify-on", &self.declassify_on),
            ("cui-controlled-by", &self.cui_controlled_by),
            ("cui-office", &self.cui_office),
            ("cui-category", &self.cui_category),
            ("cui-dissemination", &self.cui_dissemination),
            ("cui-poc", &self.cui_poc),
        ] {
            say(option, value.clone());
        }
        let list = self.poses.iter().find(|p| p.ends_with(".json")).map(|list| format!("{POSES}/{list}"));
        say("poses", list.or((!self.poses.is_empty()).then(|| POSES.to_owned())));
        say("gcp", self.control.then(|| CONTROL.to_owned()));
        say("country-register", self.register.then(|| REGISTER.to_owned()));
        out
    }

    /// What a run reads, below the job's folder: the photo, or the folder of several. The names in it are the server's.
    pub fn input(&self) -> String {
        match self.photos.as_slice() {
            [] | [_] => self.photo(0),
            _ => self.folder(),
        }
    }

    /// Of several photos: its name is the model's.
    fn folder(&self) -> String {
        match self.name.as_deref().unwrap_or("model") {
            // These `orb geo` would name after the folder above.
            plain @ ("images" | "photos") => format!("in/set/{plain}_model"),
            name => format!("in/set/{name}"),
        }
    }

    /// A photo, below the job's folder.
    pub fn photo(&self, number: usize) -> String {
        let name = self.photos.get(number).map_or("", String::as_str);
        if self.photos.len() > 1 { format!("{}/{name}", self.folder()) } else { format!("in/{name}") }
    }

    /// Every file that a run reads, below the job's folder.
    pub fn inputs(&self) -> Vec<String> {
        let photos = (0..self.photos.len()).map(|i| self.photo(i));
        let poses = self.poses.iter().map(|p| format!("{POSES}/{p}"));
        photos.chain(poses).chain(self.control.then(|| CONTROL.to_owned())).collect()
    }

    /// Says more of the marking than the photo does.
    pub fn marks(&self) -> bool {
        self.classification.as_deref().is_some_and(|c| c != "UNCLASSIFIED")
            || self.classified_by.is_some()
            || self.derived_from.is_some()
            || self.declassify_on.is_some()
            || self.register
    }
}

/// The word that the command line has for a value: the same as JSON's.
fn word(value: &impl Serialize) -> String {
    match serde_json::to_value(value) {
        Ok(serde_json::Value::String(text)) => text,
        _ => String::new(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(fields: &[(&str, &str)]) -> Result<Submission> {
        Submission::of_fields(fields.iter().map(|(k, v)| ((*k).to_owned(), (*v).to_owned())).collect())
    }

    #[test]
    fn a_form_becomes_a_command_line() {
        let s = of(&[
            ("origin", "-34.5,-118.4,740"),
            ("heading", "-12.5"),
            ("pitch", "-30"),
            ("focal", "26"),
            ("format", "cdb,splat-glb, tiles3d"),
            ("quality", "draft"),
            ("alt_datum", "msl"),
            ("seed", "7"),
            ("point", "12,34"),
            ("length", ""),
            ("classified_by", "--key=/etc/passwd"),
        ])
        .unwrap();
        assert_eq!(
            s.options(),
            [
                "--origin=-34.5,-118.4,740",
                "--alt-datum=msl",
                "--heading=-12.5",
                "--pitch=-30",
                "--focal=26",
                "--format=cdb,splat-glb,tiles3d",
                "--quality=draft",
                "--seed=7",
                "--point=12,34",
                "--classified-by=--key=/etc/passwd"
            ]
        );
        // Through the database and back.
        assert_eq!(serde_json::from_str::<Submission>(&serde_json::to_string(&s).unwrap()).unwrap(), s);
        assert!(s.marks() && !of(&[("classification", "UNCLASSIFIED")]).unwrap().marks());
        // Every word that this has, the command line has.
        for (field, words) in [
            ("format", "cdb,flt,glb,usdz,tiles3d,kmz,ply,spz,splat-glb"),
            ("quality", "draft"),
            ("quality", "standard"),
            ("quality", "high"),
            ("symmetry", "auto"),
            ("symmetry", "evident"),
            ("symmetry", "on"),
            ("symmetry", "two"),
            ("symmetry", "off"),
            ("alt_datum", "ellipsoid"),
        ] {
            let options = of(&[(field, words), ("origin", "1,2,3")]).unwrap().options();
            assert!(crate::cli::geo_args("in/x.jpg", &options).is_ok(), "{options:?}");
        }
    }

    #[test]
    fn several_photos_are_a_folder_of_the_models_name() {
        let mut s = of(&[("name", "barn")]).unwrap();
        s.photos = vec!["barn.jpg".into()];
        assert_eq!((s.input(), s.inputs()), ("in/barn.jpg".to_owned(), vec!["in/barn.jpg".to_owned()]));
        s.photos = vec!["a.jpg".into(), "b.jpg".into()];
        assert_eq!((s.input(), s.photo(1)), ("in/set/barn".to_owned(), "in/set/barn/b.jpg".to_owned()));
        s.poses = vec!["cameras.bin".into(), "images.bin".into(), "points3D.bin".into()];
        s.control = true;
        assert_eq!(s.options()[..], ["--poses=in/poses", "--gcp=in/gcp.csv"]);
        assert_eq!(
            s.inputs()[2..],
            ["in/poses/cameras.bin", "in/poses/images.bin", "in/poses/points3D.bin", "in/gcp.csv"]
        );
        s.poses = vec!["transforms.json".into()];
        assert_eq!(s.options()[0], "--poses=in/poses/transforms.json");
        assert!(crate::cli::geo_args(&s.input(), &s.options()).is_ok());
        s.name = Some("images".into());
        assert_eq!(s.input(), "in/set/images_model");
    }

    #[test]
    fn what_is_no_field_or_no_value() {
        for (field, value) in [
            ("colour", "red"),
            ("photos", "x"),
            ("poses", "/etc"),
            ("control", "true"),
            ("heading", "north"),
            ("seed", "-1"),
            ("seed", "1.5"),
            ("format", "cdb,exe"),
            ("format", "--output"),
            ("quality", "best"),
            ("point", "1"),
            ("point", "1,2,3"),
            ("point", "1,-2"),
            ("origin", "1\n2"),
            ("origin", &"1".repeat(LONGEST + 1)),
        ] {
            assert!(of(&[(field, value)]).is_err(), "{field}={value}");
        }
    }
}
