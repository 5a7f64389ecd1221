//! `orb batch`: rows over shards, here and on a Slurm cluster of this machine alone, to the same bytes; what is done stays done, what
//! was killed goes on. Without slurmctld it goes on here, and says so; under ORB_REQUIRE_CLIENTS=1 it fails.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::time::{Duration, Instant};

use serde_json::Value;

const AS_OF: &str = "--as-of=2026-01-31T12:00:00.000Z";
const OPTIONS: [&str; 10] = [
    "--format=cdb,glb",
    "--iterations=2",
    "--lods=1",
    "--device=cpu",
    "--triangles=1000",
    "--texture=256",
    "--symmetry=off",
    "--length=2.5",
    "--seed=7",
    concat!("--mask=", env!("CARGO_MANIFEST_DIR"), "/tests/data/container_mask.png"),
];

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// Two rows in one geocell, one in another, and one that is none.
fn manifest(folder: &Path) -> PathBuf {
    let photo = root().join("tests/data/container.jpg");
    let text = format!(
        "photo,name,origin,heading\n\
         {photo},first,\"34.55,-118.47,740\",10\n\
         {photo},elsewhere,\"36.55,-118.47,740\",20\n\
         # a remark\n\
         {photo},second,\"34.56,-118.40,740\",30\n\
         {photo},wrong,\"34.57,-118.40,740\",north\n",
        photo = photo.display()
    );
    let path = folder.join("site.csv");
    std::fs::write(&path, text).unwrap();
    path
}

fn batch(before: &[&str], data: &Path, manifest: &Path, output: &Path, options: &[&str]) -> Command {
    let program = env!("CARGO_BIN_EXE_orb");
    let all = [before, &[program]].concat();
    let mut command = Command::new(all[0]);
    command.args(&all[1..]).arg("batch").arg("--manifest").arg(manifest).arg("-o").arg(output);
    command.args(["--json", AS_OF]).args(options).arg("--").args(OPTIONS).env("ORB_DATA_DIR", data);
    command
}

fn said(out: &Output) -> Value {
    serde_json::from_slice(&out.stdout)
        .unwrap_or_else(|e| panic!("{e}: {:?}\n{}", out.status, String::from_utf8_lossy(&out.stderr)))
}

/// Every file below a folder, but what a batch keeps for itself.
fn files(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    fn walk(root: &Path, folder: &Path, out: &mut BTreeMap<String, Vec<u8>>) {
        for entry in std::fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            let name = path.strip_prefix(root).unwrap().display().to_string();
            match path.is_dir() {
                true if name != ".batch" => walk(root, &path, out),
                true => {}
                false => drop(out.insert(name, std::fs::read(&path).unwrap())),
            }
        }
    }
    let mut out = BTreeMap::new();
    walk(folder, folder, &mut out);
    out
}

/// Records name the run, its time and its key; everything else is to be the same.
fn products(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let is_record = |name: &String| {
        let last = name.rsplit('/').next().unwrap();
        last.starts_with("orb-record") || last == "orb-proof.tlog" || last == "report.html" || last == "VERIFY.txt"
    };
    // What is joined is listed by the records' hashes.
    files(folder).into_iter().filter(|(name, _)| !is_record(name) && !name.starts_with("joined/")).collect()
}

fn same(a: &Path, b: &Path) {
    let (a, b) = (products(a), products(b));
    assert_eq!(a.keys().collect::<Vec<_>>(), b.keys().collect::<Vec<_>>());
    let differ: Vec<_> = a.iter().filter(|(name, bytes)| b[*name] != **bytes).map(|(name, _)| name).collect();
    assert!(differ.is_empty(), "{differ:?}");
    assert!(
        a.keys().any(|n| n.starts_with("store.cdb/Tiles/N34/"))
            && a.keys().any(|n| n.starts_with("store.cdb/Tiles/N36/"))
    );
    assert!(a.contains_key("second/second.glb"));
}

fn has_slurm() -> bool {
    let path = std::env::var_os("PATH").unwrap_or_default();
    let folders: Vec<_> = std::env::split_paths(&path).chain(["/usr/sbin".into(), "/usr/bin".into()]).collect();
    let has = |name: &str| folders.iter().any(|f| f.join(name).is_file());
    let all = ["slurmctld", "slurmd", "sbatch", "munged"].into_iter().all(has);
    if !all {
        let required = std::env::var_os("ORB_REQUIRE_CLIENTS").is_some_and(|v| v == "1");
        assert!(!required, "slurmctld, slurmd, sbatch or munged is not there");
        eprintln!("skipped: slurmctld, slurmd, sbatch or munged is not there");
    }
    all
}

#[test]
fn here_on_slurm_and_killed_and_gone_on_with_to_the_same_bytes() {
    let work = tempfile::tempdir().unwrap();
    let (data, manifest) = (work.path().join("data"), manifest(work.path()));
    let whole = work.path().join("whole");
    runs_here(&data, &manifest, &whole);
    let killed = work.path().join("killed");
    goes_on_where_it_was_killed(&data, &manifest, &killed);
    same(&whole, &killed);
    does_again_what_is_missing_alone(&data, &manifest, &whole);
    // The store holds its model already: the list of what this run wrote into it is empty, and the store as it was.
    std::fs::copy(killed.join("second/orb-marking.json"), whole.join("second/orb-marking.json")).unwrap();
    same(&whole, &killed);
    // Another command in the same folder is another batch.
    let other = batch(&[], &data, &manifest, &whole, &["--threads=1"]).output().unwrap();
    assert!(other.status.code() == Some(2) && String::from_utf8_lossy(&other.stderr).contains("another"));
    let forbidden = batch(&[], &data, &manifest, &whole, &[]).arg("--cdb=x").output().unwrap();
    assert_eq!(forbidden.status.code(), Some(2));
}

fn runs_here(data: &Path, manifest: &Path, here: &Path) {
    let out = batch(&[], data, manifest, here, &["--jobs=2"]).output().unwrap();
    let done = said(&out);
    assert_eq!(out.status.code(), Some(3), "a row is wrong: {done}");
    assert_eq!((&done["shards"], &done["published"], &done["already"]), (&2.into(), &3.into(), &0.into()), "{done}");
    assert_eq!(done["failed"][0]["line"], 6, "{done}");
    assert!(done["failed"][0]["words"].as_str().unwrap().contains("heading: expected a number"), "{done}");
    // A store as any other, with a record of each joining.
    let check =
        Command::new(env!("CARGO_BIN_EXE_orb")).args(["cdb", "check"]).arg(here.join("store.cdb")).output().unwrap();
    assert!(check.status.success(), "{}", String::from_utf8_lossy(&check.stdout));
    for (shard, store) in [("joined/0000", true), ("joined/0001", true), ("second", false)] {
        let mut verify = Command::new(env!("CARGO_BIN_EXE_orb"));
        verify.args(["audit", "verify"]).arg(here.join(shard)).env("ORB_DATA_DIR", data);
        if store {
            verify.arg("--store").arg(here.join("store.cdb"));
        } else {
            verify.arg("--store").arg(here.join(".batch/0000/store.cdb"));
        }
        let verified = verify.output().unwrap();
        assert!(verified.status.success(), "{shard}: {}", String::from_utf8_lossy(&verified.stdout));
    }
}

/// Begins a batch, and kills it at a moment.
fn kill(data: &Path, manifest: &Path, folder: &Path, is_time: impl Fn(Duration) -> bool) {
    let mut child = batch(&[], data, manifest, folder, &[]).stdout(std::process::Stdio::null()).spawn().unwrap();
    let begun = Instant::now();
    while !is_time(begun.elapsed()) {
        assert!(begun.elapsed() < Duration::from_secs(300), "nothing was published");
        std::thread::sleep(Duration::from_millis(20));
    }
    child.kill().unwrap();
    child.wait().unwrap();
    // The run below it sees its input end, and ends at its next step.
    if !cfg!(target_os = "linux") {
        std::thread::sleep(Duration::from_secs(5));
    }
    let killed = Instant::now();
    while is_running(folder) {
        assert!(killed.elapsed() < Duration::from_secs(300), "the run below goes on");
        std::thread::sleep(Duration::from_millis(50));
    }
}

/// Whether there is a run of this batch; elsewhere than on Linux nobody knows.
fn is_running(folder: &Path) -> bool {
    let name = folder.to_str().unwrap().as_bytes();
    let names_it = |command: Vec<u8>| command.windows(name.len()).any(|w| w == name);
    let all = std::fs::read_dir("/proc").into_iter().flatten().flatten();
    all.filter_map(|process| std::fs::read(process.path().join("cmdline")).ok()).any(names_it)
}

/// Rows that are there, whoever made them, and how many of them were there already.
fn published(done: &Value) -> (u64, u64) {
    let already = done["already"].as_u64().unwrap();
    (done["published"].as_u64().unwrap() + already, already)
}

/// Begun here, killed once the first row is there, and gone on with by Slurm: what is done stays, whoever did it, and one shard is
/// Slurm's own from its first row.
fn goes_on_where_it_was_killed(data: &Path, manifest: &Path, killed: &Path) {
    kill(data, manifest, killed, |_| killed.join("first").is_dir());
    let script = root().join("tests/clients/slurm.sh");
    let there = has_slurm();
    let before = if there { vec![script.to_str().unwrap()] } else { Vec::new() };
    let engine: &[&str] = if there { &["--engine=slurm", "--jobs=2"] } else { &[] };
    let out = batch(&before, data, manifest, killed, &[engine, &["--retries=3"]].concat()).output().unwrap();
    let (went_on, words) = (said(&out), String::from_utf8_lossy(&out.stderr));
    let (done, already) = published(&went_on);
    assert!(done == 3 && (1..=2).contains(&already), "{went_on}");
    assert_eq!(went_on["failed"].as_array().unwrap().len(), 1, "{went_on}");
    assert_eq!(words.contains("job array"), there, "{words}");
}

fn does_again_what_is_missing_alone(data: &Path, manifest: &Path, whole: &Path) {
    let run = || said(&batch(&[], data, manifest, whole, &[]).output().unwrap());
    // Once more: nothing is done again, no record is another.
    let before = files(whole);
    let again = run();
    assert_eq!((&again["published"], &again["already"]), (&0.into(), &3.into()), "{again}");
    assert_eq!(files(whole), before);
    // A file that is not what the record says is said, and left as it is.
    let glb = whole.join("second/second.glb");
    let sound = std::fs::read(&glb).unwrap();
    let mut bytes = sound.clone();
    bytes[100] ^= 1;
    std::fs::write(&glb, &bytes).unwrap();
    let found = run();
    assert_eq!((&found["already"], found["failed"].as_array().unwrap().len()), (&2.into(), 2), "{found}");
    assert!(found["failed"][0]["words"].as_str().unwrap().contains("OUTPUT_DIGEST"), "{found}");
    assert_eq!(std::fs::read(&glb).unwrap(), bytes);
    // Without its folder the row is run again, to the same bytes, though the first to do so is killed on the way.
    std::fs::remove_dir_all(whole.join("second")).unwrap();
    kill(data, manifest, whole, |begun| begun > Duration::from_secs(1));
    assert!(!whole.join("second").exists(), "there before it was killed");
    let went_on = said(&batch(&[], data, manifest, whole, &["--retries=3"]).output().unwrap());
    assert_eq!(went_on["published"], 1, "{went_on}");
    assert_eq!(std::fs::read(&glb).unwrap(), sound);
}
