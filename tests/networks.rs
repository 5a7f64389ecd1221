//! Both engines on every graph in `tests/data/contracts`: stubs with the full-size tensors of the real networks, and
//! real architectures with small weights. `make_stubs.py`, `make_small.py` and `make_vectors.py` there made them.
//!
//! ONNX Runtime is found as in a real run (`ORT_DYLIB_PATH` first). Without one its half is skipped with a printed reason;
//! under `ORB_REQUIRE_CLIENTS=1` it is missed. `ORB_CONTRACTS` names a folder of more graphs with a `vectors.json`;
//! `ORB_TEST_PROVIDER`, `cuda` or `tensorrt`, what ONNX Runtime computes on in place of the CPU.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use orb::models::engine::{self, Choice, Provider, discovery::Search};
use orb::models::{Engine, Graph, Rten, Tensor};
use serde_json::Value;

fn contracts() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/contracts")
}

/// None: skip.
fn runtime() -> Option<Box<dyn Engine>> {
    let search = Search::from_environment(None, None, |name| std::env::var_os(name));
    let provider = match std::env::var("ORB_TEST_PROVIDER").as_deref() {
        Ok("cuda") => Provider::Cuda,
        Ok("tensorrt") => Provider::Tensorrt,
        _ => Provider::Cpu,
    };
    match engine::open(Choice::Ort, provider, &search, &mut |line| eprintln!("{line}")) {
        Ok(engine) => Some(engine),
        Err(e) => {
            assert!(std::env::var_os("ORB_REQUIRE_CLIENTS").is_none(), "{e}");
            eprintln!("skipped: {e}");
            None
        }
    }
}

/// The weights that `make_small.py` left out, by its rule.
fn numbers(recipe: &[f64]) -> Vec<u8> {
    let [tensor, count, mean, deviation] = *recipe else { panic!("{recipe:?}") };
    let value = |j: u32| {
        let mut h =
            j.wrapping_mul(2_654_435_761).wrapping_add((tensor as u32).wrapping_mul(40_503).wrapping_add(12_345));
        h ^= h >> 16;
        h = h.wrapping_mul(2_246_822_519);
        h ^= h >> 13;
        (mean + (f64::from(h) / 4_294_967_296.0 - 0.5) * 12f64.sqrt() * deviation) as f32
    };
    (0..count as u32).flat_map(|j| value(j).to_le_bytes()).collect()
}

/// Every graph by name, those without weights completed in `folder`.
fn graphs(folder: &Path) -> BTreeMap<String, PathBuf> {
    let mut all = BTreeMap::new();
    let mut add = |from: &Path| {
        for entry in std::fs::read_dir(from).unwrap().flatten() {
            let path = entry.path();
            if path.extension().is_some_and(|e| e == "onnx") {
                all.insert(path.file_stem().unwrap().to_string_lossy().into_owned(), path);
            }
        }
    };
    add(&contracts());
    let recipes: BTreeMap<String, Vec<Vec<f64>>> =
        serde_json::from_slice(&std::fs::read(contracts().join("tiny/weights.json")).unwrap()).unwrap();
    for (name, recipe) in recipes {
        let data: Vec<u8> = recipe.iter().flat_map(|r| numbers(r)).collect();
        std::fs::write(folder.join(format!("{name}.onnx_data")), data).unwrap();
        std::fs::copy(contracts().join(format!("tiny/{name}.onnx")), folder.join(format!("{name}.onnx"))).unwrap();
    }
    add(folder);
    all
}

/// Input i, element k: ((k · 7919 + 31 · i) mod 1000) / 1000; whole numbers are 1.
fn inputs(graph: &dyn Graph, shapes: &Value) -> Vec<(String, Tensor)> {
    let ports = graph.inputs();
    let shape_of = |name: &str| -> Vec<usize> { serde_json::from_value(shapes[name].clone()).unwrap() };
    ports
        .iter()
        .enumerate()
        .map(|(i, port)| {
            let shape = shape_of(&port.name);
            let n: usize = shape.iter().product();
            let whole = port.element.is_some_and(|e| e.is_integer());
            let data = (0..n).map(|k| if whole { 1.0 } else { ((k * 7919 + 31 * i) % 1000) as f32 / 1000.0 }).collect();
            (port.name.clone(), Tensor::new(&shape, data).unwrap())
        })
        .collect()
}

fn run(engine: &dyn Engine, path: &Path, vector: &Value) -> Vec<(String, Tensor)> {
    let graph = engine.load_file(path).unwrap_or_else(|e| panic!("{} {}: {e}", engine.name(), path.display()));
    let inputs = inputs(&*graph, &vector["inputs"]);
    let fed: Vec<(&str, &Tensor)> = inputs.iter().map(|(n, t)| (n.as_str(), t)).collect();
    graph.run(&fed).unwrap_or_else(|e| panic!("{} {}: {e}", engine.name(), path.display()))
}

/// Within a thousandth, of the value where it is more than 1.
fn near(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-3 * b.abs().max(1.0)
}

fn check(engine: &dyn Engine, name: &str, outputs: &[(String, Tensor)], vector: &Value) {
    let wanted = vector["outputs"].as_object().unwrap();
    assert_eq!(outputs.len(), wanted.len(), "{name}");
    for (output, tensor) in outputs {
        let want = &wanted[output];
        let shape: Vec<usize> = serde_json::from_value(want["shape"].clone()).unwrap();
        let first: Vec<f64> = serde_json::from_value(want["first"].clone()).unwrap();
        assert_eq!(tensor.shape, shape, "{} {name} {output}", engine.name());
        let n = tensor.data.len() as f64;
        let mean = tensor.data.iter().map(|v| f64::from(*v)).sum::<f64>() / n;
        let deviation = (tensor.data.iter().map(|v| (f64::from(*v) - mean).powi(2)).sum::<f64>() / n).sqrt();
        assert!(near(mean, want["mean"].as_f64().unwrap()), "{} {name} {output}: mean {mean}", engine.name());
        assert!(near(deviation, want["std"].as_f64().unwrap()), "{} {name} {output}: std {deviation}", engine.name());
        for (a, b) in tensor.data.iter().zip(first) {
            assert!(near(f64::from(*a), b), "{} {name} {output}: {a} {b}", engine.name());
        }
    }
}

fn vectors(folder: &Path) -> Value {
    serde_json::from_slice(&std::fs::read(folder.join("vectors.json")).unwrap()).unwrap()
}

/// Largest difference of all outputs of all graphs.
fn compare(graphs: &BTreeMap<String, PathBuf>, vectors: &Value, runtime: Option<&dyn Engine>) {
    for (name, path) in graphs {
        let vector = &vectors[name];
        assert!(vector.is_object(), "no vector for {name}");
        let mine = run(&Rten, path, vector);
        check(&Rten, name, &mine, vector);
        let Some(runtime) = runtime else { continue };
        let theirs = run(runtime, path, vector);
        check(runtime, name, &theirs, vector);
        let mut worst = 0.0f64;
        for ((a, x), (b, y)) in mine.iter().zip(&theirs) {
            assert_eq!((a, &x.shape), (b, &y.shape), "{name}");
            for (x, y) in x.data.iter().zip(&y.data) {
                assert!(near(f64::from(*x), f64::from(*y)), "{name} {a}: {x} {y}");
                worst = worst.max(f64::from((x - y).abs()));
            }
        }
        eprintln!("{name}: both engines within {worst:.1e}");
    }
}

#[test]
fn both_engines_give_the_same_on_every_contract() {
    let folder = tempfile::tempdir().unwrap();
    let graphs = graphs(folder.path());
    assert_eq!(graphs.len(), 18);
    compare(&graphs, &vectors(&contracts()), runtime().as_deref());
    if let Some(more) = std::env::var_os("ORB_CONTRACTS").map(PathBuf::from) {
        let mut graphs = BTreeMap::new();
        for folder in [more.clone(), more.join("tiny")] {
            for entry in std::fs::read_dir(folder).unwrap().flatten() {
                if entry.path().extension().is_some_and(|e| e == "onnx") {
                    let name = entry.path().file_stem().unwrap().to_string_lossy().into_owned();
                    graphs.insert(name, entry.path());
                }
            }
        }
        compare(&graphs, &vectors(&more), runtime().as_deref());
    }
}

#[test]
fn references_may_have_any_number_of_tokens() {
    let path = contracts().join("unet_read.onnx");
    let mut engines: Vec<Box<dyn Engine>> = vec![Box::new(Rten)];
    engines.extend(runtime());
    for engine in engines {
        let graph = engine.load_file(&path).unwrap();
        let fed: Vec<(String, Tensor)> = graph
            .inputs()
            .iter()
            .map(|p| {
                let shape: Vec<usize> = p.shape.as_ref().unwrap().iter().map(|d| d.unwrap_or(1)).collect();
                (p.name.clone(), Tensor::new(&shape, vec![0.5; shape.iter().product()]).unwrap())
            })
            .collect();
        let fed: Vec<(&str, &Tensor)> = fed.iter().map(|(n, t)| (n.as_str(), t)).collect();
        let out = graph.run(&fed).unwrap();
        // sample / 2 + 0.001 · (means of text, time and sixteen references).
        assert!((out[0].1.data[0] - (0.25 + 0.001 * 9.0)).abs() < 1e-5, "{}: {}", engine.name(), out[0].1.data[0]);
    }
}

#[test]
fn a_runtime_or_a_provider_that_is_missing_is_an_error() {
    let folder = tempfile::tempdir().unwrap();
    let nothing = Search::default();
    let open = |choice, provider, search: &Search| {
        let mut said = String::new();
        let engine = engine::open(choice, provider, search, &mut |line| said.push_str(line));
        (engine.map(|e| e.name().to_owned()), said)
    };
    // Left to itself Orb says what it falls back to; asked, it never does.
    let (engine, said) = open(Choice::Auto, Provider::Auto, &nothing);
    assert!(engine.unwrap().starts_with("rten") && said.contains("no ONNX Runtime is found"));
    for (choice, provider) in [(Choice::Ort, Provider::Auto), (Choice::Auto, Provider::Cuda)] {
        let error = open(choice, provider, &nothing).0.unwrap_err();
        assert!(error.kind == orb::Kind::Environment && error.to_string().contains("--onnxruntime"), "{error}");
    }
    let error = open(Choice::Rten, Provider::Tensorrt, &nothing).0.unwrap_err();
    assert_eq!(error.kind, orb::Kind::Usage);
    // Named and absent, named and no library, named and another library.
    let text = folder.path().join("libonnxruntime.so");
    std::fs::write(&text, "not a library").unwrap();
    let mut named = vec![(folder.path().join("absent.so"), "nothing there"), (text, "no ONNX Runtime 1")];
    if let Some(libc) =
        ["/lib/x86_64-linux-gnu/libm.so.6", "/usr/lib/libm.dylib"].map(PathBuf::from).iter().find(|p| p.is_file())
    {
        named.push((libc.clone(), "no ONNX Runtime 1"));
    }
    for (path, words) in named {
        let search = Search { given: Some(path), ..Search::default() };
        let error = open(Choice::Auto, Provider::Auto, &search).0.unwrap_err();
        assert!(error.found.contains(words), "{error}");
    }
    if runtime().is_some() {
        let search = Search::from_environment(None, None, |name| std::env::var_os(name));
        for provider in [Provider::Cuda, Provider::Tensorrt] {
            match open(Choice::Ort, provider, &search).0 {
                Ok(name) => assert!(name.contains(provider.name()), "{name} where {} was asked for", provider.name()),
                Err(e) => assert!(e.to_string().contains(provider.name()) && !e.found.is_empty(), "{e}"),
            }
        }
    }
}

/// A library that says it is ONNX Runtime 1.17.
#[test]
fn a_runtime_that_is_too_old_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let source = folder.path().join("old.c");
    std::fs::write(
        &source,
        "static const void *api(unsigned v) { return 0; }\n\
         static const char *version(void) { return \"1.17.3\"; }\n\
         static const struct { const void *(*a)(unsigned); const char *(*v)(void); } base = { api, version };\n\
         const void *OrtGetApiBase(void) { return &base; }\n",
    )
    .unwrap();
    let library = folder.path().join("libonnxruntime.so");
    let made = std::process::Command::new("cc").args(["-shared", "-fPIC", "-o"]).arg(&library).arg(&source).status();
    if !made.is_ok_and(|s| s.success()) {
        eprintln!("skipped: no C compiler that makes a library");
        return;
    }
    let search = Search { given: Some(library), ..Search::default() };
    let error = engine::open(Choice::Ort, Provider::Auto, &search, &mut |_| {}).err().unwrap();
    assert!(error.found.contains("1.17, too old"), "{error}");
}

/// z = 2 x + n: 16-bit floats and whole numbers, as half-precision exports have them.
#[test]
fn half_precision_goes_in_and_out_as_32_bits() {
    let path = contracts().join("half/double_and_add.onnx");
    let x = Tensor::new(&[1, 3], vec![0.5, -3.0, 100.25]).unwrap();
    let n = Tensor::new(&[1, 1], vec![4.0]).unwrap();
    let Some(engine) = runtime() else { return };
    let out = engine.load_file(&path).unwrap().run(&[("x", &x), ("n", &n)]).unwrap();
    assert_eq!(out[0].1.data, [5.0, -2.0, 204.5]);
    // The built-in engine computes in 32 bits: it runs such a graph so, or says that it cannot; never other numbers.
    match Rten.load_file(&path).and_then(|graph| graph.run(&[("x", &x), ("n", &n)])) {
        Ok(out) => assert_eq!(out[0].1.data, [5.0, -2.0, 204.5]),
        Err(e) => eprintln!("the built-in engine refuses 16-bit floats: {e}"),
    }
}
