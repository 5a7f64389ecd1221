//! Import, damage, refuse: on the contract stubs.

use std::io::Write as _;
use std::path::PathBuf;

use super::*;
use crate::Kind;
use crate::models::Rten;
use crate::models::zero123::prompt_file;

pub(crate) fn stub(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/contracts").join(name)
}

struct Bench {
    dir: tempfile::TempDir,
    registry: Registry,
}

impl Bench {
    fn new() -> Bench {
        let dir = tempfile::tempdir().unwrap();
        let registry = Registry::at(dir.path().join("models"));
        Bench { dir, registry }
    }

    /// A file in a folder to import from.
    fn file(&self, name: &str, bytes: &[u8]) -> PathBuf {
        let path = self.dir.path().join("from").join(name);
        std::fs::create_dir_all(path.parent().unwrap()).unwrap();
        std::fs::write(&path, bytes).unwrap();
        path
    }

    fn import(&self, request: &Import) -> Result<Manifest> {
        let done = import(&self.registry, request, &Rten, &mut |_| {});
        let left = std::fs::read_dir(self.registry.root()).unwrap().flatten();
        assert!(left.into_iter().all(|e| !e.file_name().to_string_lossy().starts_with('.')), "staging is left");
        done
    }
}

fn trusting(sources: &[PathBuf]) -> Import {
    Import { sources: sources.to_vec(), allow_unpinned: true, accept_licence: true, ..Import::default() }
}

fn depth() -> PathBuf {
    stub("depth_anything_v2.onnx")
}

fn sam() -> [PathBuf; 2] {
    [stub("sam2_encoder.onnx"), stub("sam2_decoder.onnx")]
}

#[test]
fn a_network_is_imported_listed_verified_and_removed() {
    let bench = Bench::new();
    let made = bench.import(&trusting(&sam())).unwrap();
    assert_eq!((made.family, made.id.as_str(), made.pinned), (Family::Sam2Samexporter, "sam2-samexporter", false));
    assert_eq!((made.licence.as_str(), made.pin_source()), ("unknown", "unverified"));
    assert_eq!(bench.registry.list().unwrap(), std::slice::from_ref(&made));
    let network = bench.registry.verified(&made).unwrap();
    assert!(network.path(Role::Decoder).unwrap().ends_with("sam2_decoder.onnx"));
    assert!(network.path(Role::Depth).is_err());
    assert_eq!(made.weights_sha256().len(), 64);
    bench.registry.remove(&made.id).unwrap();
    assert!(bench.registry.list().unwrap().is_empty());
    assert_eq!(bench.registry.remove(&made.id).unwrap_err().kind, Kind::Usage);
}

#[test]
fn weights_that_changed_on_disk_stop_the_run() {
    let bench = Bench::new();
    let made = bench.import(&trusting(&[depth()])).unwrap();
    let file = bench.registry.root().join(&made.id).join("depth_anything_v2.onnx");
    let mut bytes = std::fs::read(&file).unwrap();
    bytes[700] ^= 1;
    std::fs::write(&file, bytes).unwrap();
    let error = bench.registry.verified(&made).unwrap_err();
    assert_eq!(error.kind, Kind::Integrity);
    assert!(error.to_string().contains("changed on disk") && error.to_string().contains("depth_anything_v2.onnx"));
    std::fs::remove_file(&file).unwrap();
    assert_eq!(bench.registry.verified(&made).unwrap_err().kind, Kind::Integrity);
}

#[test]
fn an_altered_manifest_is_no_way_out_of_the_folder() {
    let bench = Bench::new();
    let made = bench.import(&trusting(&[depth()])).unwrap();
    let path = bench.registry.root().join(&made.id).join(MANIFEST);
    let text = std::fs::read_to_string(&path).unwrap();
    for (from, to) in [
        ("\"depth_anything_v2.onnx\"", "\"../../x.onnx\""),
        ("\"schema\": 1", "\"schema\": 2"),
        ("\"depth-anything\"", "\"zero123pp\""),
        ("{", "{{"),
    ] {
        assert!(text.contains(from), "{from} in {text}");
        std::fs::write(&path, text.replace(from, to)).unwrap();
        assert_eq!(bench.registry.get(&made.id).unwrap_err().kind, Kind::Integrity, "{to}");
    }
    // Such a network can still be removed.
    bench.registry.remove(&made.id).unwrap();
    for id in ["../models", "", ".importing", "A", "a/b"] {
        assert_eq!(bench.registry.get(id).unwrap_err().kind, Kind::Usage, "{id}");
    }
}

#[test]
fn an_unknown_hash_needs_a_word_and_so_does_a_licence() {
    let bench = Bench::new();
    let mut request = trusting(&[depth()]);
    request.allow_unpinned = false;
    let error = bench.import(&request).unwrap_err();
    assert_eq!(error.kind, Kind::Policy);
    assert!(
        error.to_string().contains("--allow-unpinned") && error.found.contains("depth_anything_v2.onnx"),
        "{error}"
    );
    request.allow_unpinned = true;
    request.accept_licence = false;
    let error = bench.import(&request).unwrap_err();
    assert_eq!((error.kind, error.to_string().contains("--accept-licence")), (Kind::Policy, true));
    // Named as a network with a licence that allows every use, it needs no word on that.
    request.known_as = Some("depth-anything-v2-small".into());
    assert_eq!(bench.import(&request).unwrap().licence, "Apache-2.0");
    request.known_as = Some("depth-anything-v2-large".into());
    let error = bench.import(&request).unwrap_err();
    assert!(error.kind == Kind::Policy && error.found.contains("CC-BY-NC-4.0"), "{error}");
    request.known_as = Some("sam2-tiny".into());
    assert_eq!(bench.import(&request).unwrap_err().kind, Kind::Usage);
}

#[test]
fn a_pin_is_proof_and_other_bytes_under_its_name_are_refused() {
    let bench = Bench::new();
    let (_, sha256) = hash_file(&depth()).unwrap();
    std::fs::create_dir_all(bench.registry.root()).unwrap();
    let catalogue = format!(
        r#"[{{"id": "mine", "version": "1", "families": ["depth-anything"], "licence": "MIT", "commercial": true,
            "upstream": "here", "kind": "depth", "pins": ["{sha256}"]}}]"#
    );
    std::fs::write(bench.registry.root().join("catalogue.json"), catalogue).unwrap();
    let strict = Import { sources: vec![depth()], ..Import::default() };
    let made = bench.import(&strict).unwrap();
    assert_eq!((made.id.as_str(), made.pinned, made.pin_source()), ("mine", true, "catalogue"));
    assert_eq!(made.depth_kind, Some(DepthKind::Depth));
    // Twice under one name only on request.
    assert_eq!(bench.import(&strict).unwrap_err().kind, Kind::Usage);
    bench.import(&Import { replace: true, ..strict }).unwrap();
    let mut bytes = std::fs::read(depth()).unwrap();
    // Still a graph: one of its weights.
    let at = bytes.windows(4).position(|w| w == (1f32 / 147.0).to_le_bytes()).unwrap();
    bytes[at] ^= 1;
    let other = Import { known_as: Some("mine".into()), ..trusting(&[bench.file("other.onnx", &bytes)]) };
    let error = bench.import(&other).unwrap_err();
    assert_eq!(error.kind, Kind::Integrity);
}

#[test]
fn folders_and_archives_are_taken_too() {
    let bench = Bench::new();
    let bytes = |p: &PathBuf| std::fs::read(p).unwrap();
    bench.file("onnx/a.onnx", &bytes(&sam()[0]));
    bench.file("onnx/b.onnx", &bytes(&sam()[1]));
    bench.file("README.md", b"words");
    let folder = Import { id: Some("from-folder".into()), ..trusting(&[bench.dir.path().join("from")]) };
    let made = bench.import(&folder).unwrap();
    let parts: Vec<_> = made.parts.iter().map(|p| (p.role, p.path.as_str())).collect();
    assert_eq!(parts, [(Role::Encoder, "onnx/a.onnx"), (Role::Decoder, "onnx/b.onnx")]);
    assert!(!bench.registry.root().join("from-folder/README.md").exists());

    let archive = |entries: &[(&str, Vec<u8>)]| {
        let mut zip = zip::ZipWriter::new(std::io::Cursor::new(Vec::new()));
        for (name, bytes) in entries {
            let options = zip::write::SimpleFileOptions::default().compression_method(zip::CompressionMethod::Deflated);
            zip.start_file(*name, options).unwrap();
            zip.write_all(bytes).unwrap();
        }
        bench.file("net.zip", &zip.finish().unwrap().into_inner())
    };
    let good = archive(&[("x/a.onnx", bytes(&sam()[0])), ("x/b.onnx", bytes(&sam()[1]))]);
    let zipped = Import { id: Some("from-zip".into()), ..trusting(&[good]) };
    assert_eq!(bench.import(&zipped).unwrap().weights_sha256().len(), 64);
    let bad = archive(&[("../a.onnx", bytes(&depth()))]);
    let error = bench.import(&trusting(&[bad])).unwrap_err();
    assert!(error.kind == Kind::Usage && error.to_string().contains(".."), "{error}");
    let bomb = archive(&[("a.onnx", vec![0; 300 << 20])]);
    let error = bench.import(&trusting(&[bomb])).unwrap_err();
    assert!(error.kind == Kind::Usage && error.expected.contains("at most"), "{error}");
}

#[test]
fn what_is_too_large_or_too_much_is_refused() {
    let bench = Bench::new();
    let mut request = trusting(&[depth()]);
    request.limits.graph_bytes = 100;
    assert!(bench.import(&request).unwrap_err().expected.contains("at most 100 bytes"));
    request.limits = Limits { total_bytes: 500, ..Limits::default() };
    assert!(bench.import(&request).unwrap_err().expected.contains("at most 500 bytes"));
    let mut request = trusting(&sam());
    request.limits.files = 1;
    assert!(bench.import(&request).unwrap_err().expected.contains("at most 1 files"));
}

#[test]
fn graphs_that_are_none_or_others_are_refused_with_what_differs() {
    let bench = Bench::new();
    let whole = std::fs::read(depth()).unwrap();
    let said = |bytes: &[u8]| {
        let error = bench.import(&trusting(&[bench.file("x.onnx", bytes)])).unwrap_err();
        assert_eq!(error.kind, Kind::Usage, "{error}");
        error.to_string()
    };
    for cut in [0, 1, 10, 300, whole.len() - 1] {
        assert!(said(&whole[..cut]).contains("whole"), "cut at {cut}");
    }
    assert!(said(b"this is no protocol buffer").contains("no ONNX model"));
    // Another name, another type, another shape.
    let replaced = |from: &[u8], to: &[u8]| {
        let mut bytes = whole.clone();
        assert_eq!(from.len(), to.len());
        while let Some(at) = bytes.windows(from.len()).position(|w| w == from) {
            bytes[at..at + to.len()].copy_from_slice(to);
        }
        bytes
    };
    let text = said(&replaced(b"predicted_depth", b"predicted_thing"));
    assert!(
        text.contains("- output predicted_depth") && text.contains("+ output predicted_thing [1,518,518]"),
        "{text}"
    );
    // A strange type: the input's `elem_type` from float (1) to int64 (7).
    let mut bytes = whole.clone();
    let name = bytes.windows(14).rposition(|w| w == b"\x0a\x0cpixel_values").unwrap();
    let at = name + bytes[name..].windows(2).position(|w| w == [0x08, 1]).unwrap();
    bytes[at + 1] = 7;
    let text = said(&bytes);
    assert!(text.contains("+ input pixel_values [1,3,518,518] int64"), "{text}");
    let error = bench.import(&trusting(&[sam()[0].clone()])).unwrap_err();
    assert!(error.expected.contains("decoder"), "{error}");
    let error = bench.import(&trusting(&[sam()[0].clone(), depth()])).unwrap_err();
    assert!(error.expected.contains("one network"), "{error}");
    assert!(bench.import(&trusting(&[bench.file("x.txt", b"")])).unwrap_err().expected.contains(".onnx"));
    assert_eq!(bench.import(&trusting(&["/nowhere.onnx".into()])).unwrap_err().kind, Kind::Environment);
}

/// The depth stub with its kernel in another file, as exporters write large models.
fn with_external(location: &str, length: &str) -> Vec<u8> {
    let whole = std::fs::read(depth()).unwrap();
    let field = |key: u8, bytes: &[u8]| {
        let mut out = vec![key];
        let mut n = bytes.len();
        while n > 127 {
            out.push((n & 127) as u8 | 128);
            n >>= 7;
        }
        out.push(n as u8);
        out.extend_from_slice(bytes);
        out
    };
    let pair = |k: &str, v: &str| {
        field(13 << 3 | 2, &[field(1 << 3 | 2, k.as_bytes()), field(2 << 3 | 2, v.as_bytes())].concat())
    };
    let mut kernel = vec![0x08, 1, 0x08, 3, 0x08, 7, 0x08, 7, 0x10, 1];
    kernel.extend(field(8 << 3 | 2, b"k"));
    kernel.extend([pair("location", location), pair("offset", "0"), pair("length", length)].concat());
    kernel.extend([14 << 3, 1]);
    // Take the model apart and put it together with the other kernel.
    let mut out = Vec::new();
    for (key, bytes) in fields(&whole) {
        if key != 7 << 3 | 2 {
            out.extend(if key & 7 == 2 { field(key, &bytes) } else { [vec![key], bytes].concat() });
            continue;
        }
        let mut graph = Vec::new();
        for (key, bytes) in fields(&bytes) {
            let old_kernel = key == 5 << 3 | 2 && bytes.windows(3).any(|w| w == [8 << 3 | 2, 1, b'k']);
            graph.extend(if old_kernel { field(key, &kernel) } else { field(key, &bytes) });
        }
        out.extend(field(7 << 3 | 2, &graph));
    }
    out
}

/// Keys of one byte with their payloads.
fn fields(mut bytes: &[u8]) -> Vec<(u8, Vec<u8>)> {
    let mut out = Vec::new();
    while let [key, rest @ ..] = bytes {
        let (mut value, mut used) = (0usize, 0);
        while {
            value |= usize::from(rest[used] & 127) << (7 * used);
            used += 1;
            rest[used - 1] > 127
        } {}
        let end = if key & 7 == 2 { used + value } else { used };
        let start = if key & 7 == 2 { used } else { 0 };
        out.push((*key, rest[start..end].to_vec()));
        bytes = &rest[end..];
    }
    out
}

#[test]
fn external_data_comes_along_and_never_from_elsewhere() {
    let bench = Bench::new();
    let kernel: Vec<u8> = (0..147).flat_map(|_| (1f32 / 147.0).to_le_bytes()).collect();
    bench.file("net/k.onnx_data", &kernel);
    let model = bench.file("net/model.onnx", &with_external("k.onnx_data", "588"));
    let made = bench.import(&trusting(std::slice::from_ref(&model))).unwrap();
    assert_eq!(made.files.iter().map(|f| f.path.as_str()).collect::<Vec<_>>(), ["k.onnx_data", "model.onnx"]);
    let network = bench.registry.verified(&made).unwrap();
    use crate::models::{Engine as _, Tensor};
    let graph = Rten.load_file(&network.path(Role::Depth).unwrap()).unwrap();
    let grey = Tensor::new(&[1, 3, 518, 518], vec![0.5; 3 * 518 * 518]).unwrap();
    let out = graph.run(&[("pixel_values", &grey)]).unwrap();
    assert!((out[0].1.data[518 * 259 + 259] - 5.5).abs() < 1e-4);

    for location in ["../net/k.onnx_data", "/etc/hostname", "..\\k.onnx_data", "C:k.onnx_data", "a/../k.onnx_data", ""]
    {
        let path = bench.file("net/bad.onnx", &with_external(location, "588"));
        let error = bench.import(&Import { id: Some("bad".into()), ..trusting(&[path]) }).unwrap_err();
        assert!(error.kind == Kind::Usage && error.to_string().contains("somewhere else"), "{location}: {error}");
    }
    let path = bench.file("net/bad.onnx", &with_external("k.onnx_data", "999"));
    assert!(bench.import(&trusting(&[path])).unwrap_err().found.contains("588"));
    bench.file("net/k.onnx_data", &kernel[..500]);
    let error = bench.import(&Import { id: Some("short".into()), ..trusting(&[model]) }).unwrap_err();
    assert!(error.found.contains("500 bytes"), "{error}");
    #[cfg(unix)]
    {
        std::fs::remove_file(bench.dir.path().join("from/net/k.onnx_data")).unwrap();
        std::os::unix::fs::symlink("/etc/hostname", bench.dir.path().join("from/net/k.onnx_data")).unwrap();
        let path = bench.file("net/model.onnx", &with_external("k.onnx_data", "588"));
        let error = bench.import(&Import { id: Some("link".into()), ..trusting(&[path]) }).unwrap_err();
        assert!(error.found.contains("a link to"), "{error}");
    }
}

/// The parts of Zero123++ in a folder: stubs, a prompt of nothing, and a reading half that may be led.
pub(crate) fn zero123(folder: &Path, read: &str, control: bool) -> PathBuf {
    std::fs::create_dir_all(folder).unwrap();
    for name in ["clip_vision", "vae_encoder", "unet_write", "vae_decoder", read] {
        std::fs::copy(stub(&format!("{name}.onnx")), folder.join(format!("{name}.onnx"))).unwrap();
    }
    if control {
        std::fs::copy(stub("controlnet.onnx"), folder.join("controlnet.onnx")).unwrap();
    }
    std::fs::write(folder.join("prompt.safetensors"), prompt_file(0.0, |_| 0.0)).unwrap();
    folder.to_owned()
}

#[test]
fn a_controlnet_needs_a_unet_that_can_be_led() {
    let bench = Bench::new();
    let folder = |name: &str| bench.dir.path().join(name);
    let apart = zero123(&folder("apart"), "unet_read", true);
    let error = bench.import(&trusting(&[apart])).unwrap_err();
    assert!(error.kind == Kind::Usage && error.found.contains("control_00"), "{error}");
    for (name, read, control) in
        [("plain", "unet_read", false), ("ready", "unet_read_controlled", false), ("led", "unet_read_controlled", true)]
    {
        let request = Import { id: Some(name.into()), ..trusting(&[zero123(&folder(name), read, control)]) };
        let made = bench.import(&request).unwrap();
        let network = bench.registry.verified(&bench.registry.get(&made.id).unwrap()).unwrap();
        assert_eq!((network.has(Role::ControlNet), network.has(Role::UnetRead)), (control, true), "{name}");
    }
}
