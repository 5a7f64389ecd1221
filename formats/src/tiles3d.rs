//! OGC 3D Tiles 1.1: `tileset.json`, a tree of tiles whose contents are GLB files.
//!
//! Source: OGC 22-025r4. A tile's volume and its content lie in the tile's own frame; `transform` leads to its parent's,
//! the root's to the Earth's (ECEF). The content's glTF is Y up and is turned to Z up by every reader (§6.7.1.6), so
//! volumes are given in Orb's own axes: x right, y forward, z up.
//!
//! The geometric error of a tile is the error that remains when it is drawn and its children are not, metres; the
//! tileset's own is the error of drawing nothing.

use serde::{Deserialize, Serialize};

use crate::{Error, Label, Result};

const FORMAT: &str = "3D Tiles";

/// A tileset with one root.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Tileset {
    pub geometric_error: f64,
    pub root: Tile,
    /// glTF extensions of the contents, which readers like to know beforehand.
    pub gltf_extensions: Vec<String>,
    pub label: Label,
}

/// Children replace their parent.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Tile {
    /// Columns of the matrix to the parent's frame.
    pub transform: Option<[f64; 16]>,
    pub volume: Volume,
    pub geometric_error: f64,
    /// A relative path with `/` between folders.
    pub content: Option<String>,
    pub children: Vec<Tile>,
}

/// A box: its centre and the halves of its edges as vectors.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Volume {
    pub center: [f64; 3],
    pub half_axes: [[f64; 3]; 3],
}

impl Volume {
    /// Around the corners of an upright box, a thousandth wider: contents are stored in f32, and flat ones need a depth.
    pub fn around(low: [f64; 3], high: [f64; 3]) -> Self {
        let wider = (0..3).map(|i| high[i] - low[i]).fold(0.0, f64::max) * 1e-3 + 1e-6;
        let half = |i: usize| (high[i] - low[i]) / 2.0 + wider;
        Volume {
            center: std::array::from_fn(|i| (low[i] + high[i]) / 2.0),
            half_axes: std::array::from_fn(|axis| std::array::from_fn(|i| if i == axis { half(axis) } else { 0.0 })),
        }
    }
}

#[derive(Serialize, Deserialize)]
#[serde(rename_all = "camelCase")]
struct Json {
    asset: Asset,
    geometric_error: f64,
    root: JsonTile,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    extensions_used: Vec<String>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    extensions: Option<serde_json::Value>,
}

#[derive(Serialize, Deserialize)]
struct Asset {
    version: String,
    #[serde(default, skip_serializing_if = "serde_json::Value::is_null")]
    extras: serde_json::Value,
}

#[derive(Serialize, Deserialize)]
#[serde(rename_all = "camelCase")]
struct JsonTile {
    bounding_volume: Bounding,
    geometric_error: f64,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    refine: Option<String>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    transform: Option<[f64; 16]>,
    #[serde(default, skip_serializing_if = "Option::is_none")]
    content: Option<Content>,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    children: Vec<JsonTile>,
}

#[derive(Serialize, Deserialize)]
struct Bounding {
    #[serde(rename = "box", default, skip_serializing_if = "Option::is_none")]
    edges: Option<[f64; 12]>,
}

#[derive(Serialize, Deserialize)]
struct Content {
    uri: String,
}

const CONTENT_GLTF: &str = "3DTILES_content_gltf";

/// Writes a tileset.
///
/// # Errors
/// [`Error::Unsupported`] for numbers that are not finite, errors that are negative or grow towards the leaves, a
/// transformation whose last row is not 0, 0, 0, 1, contents outside the tileset's folder.
pub fn write(tileset: &Tileset) -> Result<Vec<u8>> {
    check(tileset)?;
    let mut extras = serde_json::Map::new();
    if !tileset.label.marking.is_empty() {
        extras.insert("marking".into(), tileset.label.marking.as_str().into());
    }
    if let Some(place) = &tileset.label.place {
        extras.insert("place".into(), serde_json::json!(place));
    }
    let extras = if extras.is_empty() { serde_json::Value::Null } else { serde_json::json!({ "orb": extras }) };
    let named = !tileset.gltf_extensions.is_empty();
    let json = Json {
        asset: Asset { version: "1.1".into(), extras },
        geometric_error: tileset.geometric_error,
        root: tile_to_json(&tileset.root, true),
        extensions_used: if named { vec![CONTENT_GLTF.into()] } else { Vec::new() },
        extensions: named.then(|| serde_json::json!({ CONTENT_GLTF: { "extensionsUsed": tileset.gltf_extensions } })),
    };
    let mut bytes = serde_json::to_vec_pretty(&json).map_err(|e| Error::unsupported(FORMAT, e.to_string()))?;
    bytes.push(b'\n');
    Ok(bytes)
}

fn tile_to_json(tile: &Tile, root: bool) -> JsonTile {
    let mut edges = [0.0; 12];
    edges[..3].copy_from_slice(&tile.volume.center);
    edges[3..].copy_from_slice(tile.volume.half_axes.as_flattened());
    JsonTile {
        bounding_volume: Bounding { edges: Some(edges) },
        geometric_error: tile.geometric_error,
        refine: root.then(|| "REPLACE".into()),
        transform: tile.transform,
        content: tile.content.as_ref().map(|uri| Content { uri: uri.clone() }),
        children: tile.children.iter().map(|c| tile_to_json(c, false)).collect(),
    }
}

/// Reads a tileset of version 1.0 or 1.1 with one content a tile and boxes for volumes.
///
/// # Errors
/// [`Error::Malformed`] for what is no tileset; [`Error::Unsupported`] for other versions, other volumes, children that
/// add to their parent, and what [`write()`] refuses.
pub fn read(bytes: &[u8]) -> Result<Tileset> {
    let json: Json = serde_json::from_slice(bytes)
        .map_err(|e| Error::malformed(FORMAT, e.column(), format!("a tileset, line {}", e.line()), e.to_string()))?;
    if !matches!(json.asset.version.as_str(), "1.0" | "1.1") {
        return Err(Error::unsupported(FORMAT, format!("version {:?}; 1.0 and 1.1 are read", json.asset.version)));
    }
    let own = &json.asset.extras["orb"];
    let label = Label {
        marking: own["marking"].as_str().unwrap_or_default().into(),
        place: serde_json::from_value(own["place"].clone()).ok(),
    };
    let names = json.extensions.as_ref().map(|e| e[CONTENT_GLTF]["extensionsUsed"].clone());
    let tileset = Tileset {
        geometric_error: json.geometric_error,
        root: tile_from_json(json.root)?,
        gltf_extensions: names.and_then(|n| serde_json::from_value(n).ok()).unwrap_or_default(),
        label,
    };
    check(&tileset)?;
    Ok(tileset)
}

fn tile_from_json(tile: JsonTile) -> Result<Tile> {
    let Some(b) = tile.bounding_volume.edges else {
        return Err(Error::unsupported(FORMAT, "a bounding volume that is no box"));
    };
    if tile.refine.is_some_and(|r| r != "REPLACE") {
        return Err(Error::unsupported(FORMAT, "children that add to their parent"));
    }
    let vector = |i: usize| [b[i], b[i + 1], b[i + 2]];
    Ok(Tile {
        transform: tile.transform,
        volume: Volume { center: vector(0), half_axes: [vector(3), vector(6), vector(9)] },
        geometric_error: tile.geometric_error,
        content: tile.content.map(|c| c.uri),
        children: tile.children.into_iter().map(tile_from_json).collect::<Result<_>>()?,
    })
}

fn check(tileset: &Tileset) -> Result<()> {
    let mut open = vec![(&tileset.root, tileset.geometric_error)];
    let refuse = |what: String| Err(Error::unsupported(FORMAT, what));
    if !(tileset.geometric_error.is_finite() && tileset.geometric_error >= 0.0) {
        return refuse(format!("geometric errors are 0 or more, found {}", tileset.geometric_error));
    }
    while let Some((tile, above)) = open.pop() {
        if !(0.0..=above).contains(&tile.geometric_error) {
            return refuse(format!(
                "a geometric error lies in 0..{above}, its parent's, found {}",
                tile.geometric_error
            ));
        }
        let numbers = tile.volume.center.iter().chain(tile.volume.half_axes.as_flattened());
        if !numbers.chain(tile.transform.iter().flatten()).all(|x| x.is_finite()) {
            return refuse("volumes and transformations must be finite".into());
        }
        if tile.transform.is_some_and(|t| [t[3], t[7], t[11], t[15]] != [0.0, 0.0, 0.0, 1.0]) {
            return refuse("the last row of a transformation must be 0, 0, 0, 1".into());
        }
        if let Some(uri) = &tile.content
            && (uri.is_empty()
                || uri.starts_with('/')
                || uri.contains(['\\', ':'])
                || uri.split('/').any(|p| p == ".."))
        {
            return refuse(format!("contents lie in the tileset's folder, found {uri:?}"));
        }
        open.extend(tile.children.iter().map(|c| (c, tile.geometric_error)));
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Place;

    fn tileset() -> Tileset {
        let volume = Volume::around([-1.0, -2.0, 0.0], [1.0, 2.0, 1.5]);
        let tile = |error: f64, name: &str| Tile {
            volume,
            geometric_error: error,
            content: Some(name.into()),
            ..Tile::default()
        };
        let mut transform = [0.0; 16];
        (0..4).for_each(|i| transform[5 * i] = 1.0);
        transform[12] = 6_378_137.0;
        let place = Place { latitude: 0.0, longitude: 0.0, height: 0.0, heading: 90.0 };
        Tileset {
            geometric_error: 5.0,
            root: Tile { transform: Some(transform), children: vec![tile(0.0, "lod0.glb")], ..tile(0.25, "lod1.glb") },
            gltf_extensions: vec!["KHR_xmp_json_ld".into()],
            label: Label { marking: "CLASSIFICATION: CUI".into(), place: Some(place) },
        }
    }

    #[test]
    fn what_is_written_reads_back_equal() {
        for t in [tileset(), Tileset { label: Label::default(), gltf_extensions: Vec::new(), ..tileset() }] {
            assert_eq!(read(&write(&t).unwrap()).unwrap(), t);
        }
    }

    #[test]
    fn volumes_enclose() {
        let v = Volume::around([-1.0, -2.0, 0.0], [1.0, 2.0, 0.0]);
        assert_eq!(v.center, [0.0; 3]);
        assert!(v.half_axes[0][0] > 1.0 && v.half_axes[1][1] > 2.0 && v.half_axes[2][2] > 0.0);
        assert!(v.half_axes[1][1] < 2.01);
    }

    #[test]
    fn broken_rules_are_refused() {
        type Change = fn(&mut Tileset);
        let table: [(Change, &str); 7] = [
            (|t| t.geometric_error = 0.1, "found 0.25"),
            (|t| t.geometric_error = f64::INFINITY, "0 or more"),
            (|t| t.root.children[0].geometric_error = 0.3, "found 0.3"),
            (|t| t.root.geometric_error = -1.0, "found -1"),
            (|t| t.root.volume.center[0] = f64::NAN, "finite"),
            (|t| t.root.transform = Some([1.0; 16]), "last row"),
            (|t| t.root.content = Some("../x.glb".into()), "../x.glb"),
        ];
        for (change, says) in table {
            let mut bad = tileset();
            change(&mut bad);
            let error = write(&bad).unwrap_err().to_string();
            assert!(error.contains(says), "{error:?} should say {says:?}");
        }
        let text = String::from_utf8(write(&tileset()).unwrap()).unwrap();
        for (from, to, says) in [
            ("\"1.1\"", "\"0.0\"", "version"),
            ("\"box\"", "\"sphere\"", "no box"),
            ("REPLACE", "ADD", "add to"),
            ("\"root\"", "\"rot\"", "root"),
            ("lod0.glb", "/etc/passwd", "/etc/passwd"),
        ] {
            let error = read(text.replace(from, to).as_bytes()).unwrap_err().to_string();
            assert!(error.contains(says), "{error:?} should say {says:?}");
        }
        let deep = "[".repeat(100_000);
        assert!(read(deep.as_bytes()).is_err());
    }
}
