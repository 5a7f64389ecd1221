//! What this program is built from, as CycloneDX 1.5: every package of the lock file that it was built with, so the same
//! build prints the same bytes, without a network. That is more than the binary holds: packages that only tests or other
//! platforms need stand in it too.

use serde_json::{Value, json};

use super::canonical::sha256_hex;

/// The lock file of this build.
const LOCK: &str = include_str!("../../Cargo.lock");

/// One `[[package]]` of a lock file, version 4.
#[derive(Debug, Default, PartialEq, Eq)]
struct Package<'a> {
    name: &'a str,
    version: &'a str,
    /// SHA-256 of the package as the registry serves it; none for this workspace's own.
    checksum: Option<&'a str>,
    /// `NAME`, or `NAME VERSION` where the lock file has several.
    dependencies: Vec<&'a str>,
}

/// The SBOM of this binary, one line of JSON with a line feed.
pub fn cyclonedx() -> String {
    format!("{}\n", of_lock(LOCK, env!("CARGO_PKG_NAME")))
}

/// `tool.sbom_sha256` of records: of what [`cyclonedx`] gives.
pub fn sha256() -> String {
    sha256_hex(cyclonedx().as_bytes())
}

/// Of a package that the lock file has once, or the first of several.
pub(super) fn locked_version(name: &str) -> Option<&'static str> {
    packages(LOCK).iter().find(|p| p.name == name).map(|p| p.version)
}

fn of_lock(lock: &str, root: &str) -> Value {
    let packages = packages(lock);
    let reference = |p: &Package<'_>| format!("pkg:cargo/{}@{}", p.name, p.version);
    let resolve = |wanted: &&str| {
        let (name, version) = wanted.split_once(' ').map_or((*wanted, None), |(n, v)| (n, Some(v)));
        packages.iter().find(|p| p.name == name && version.is_none_or(|v| v == p.version)).map(reference)
    };
    let component = |kind: &str, p: &Package<'_>| {
        let mut value = json!({
            "type": kind,
            "bom-ref": reference(p),
            "name": p.name,
            "version": p.version,
            "purl": reference(p),
        });
        if let Some(checksum) = p.checksum {
            value["hashes"] = json!([{"alg": "SHA-256", "content": checksum}]);
        }
        value
    };
    let dependencies: Vec<Value> = packages
        .iter()
        .map(|p| json!({"ref": reference(p), "dependsOn": p.dependencies.iter().filter_map(resolve).collect::<Vec<_>>()}))
        .collect();
    let main = packages.iter().find(|p| p.name == root).map(|p| component("application", p));
    json!({
        "bomFormat": "CycloneDX",
        "specVersion": "1.5",
        "version": 1,
        "metadata": {
            "component": main,
            "properties": [{
                "name": "orb:scope",
                "value": "every package of Cargo.lock, those for tests and other platforms among them",
            }],
        },
        "components": packages.iter().filter(|p| p.name != root).map(|p| component("library", p)).collect::<Vec<_>>(),
        "dependencies": dependencies,
    })
}

/// Cargo writes lock files in one form: a key, ` = `, and a string in quotes; lists have an item a line.
fn packages(lock: &str) -> Vec<Package<'_>> {
    let mut out: Vec<Package<'_>> = Vec::new();
    for line in lock.lines() {
        if line == "[[package]]" {
            out.push(Package::default());
        }
        let Some(package) = out.last_mut() else { continue };
        let value = |text: &'static str| line.strip_prefix(text).and_then(|v| v.strip_suffix('"'));
        if let Some(name) = value("name = \"") {
            package.name = name;
        } else if let Some(version) = value("version = \"") {
            package.version = version;
        } else if let Some(checksum) = value("checksum = \"") {
            package.checksum = Some(checksum);
        } else if let Some(dependency) = line.strip_prefix(" \"").and_then(|v| v.strip_suffix("\",")) {
            package.dependencies.push(dependency);
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_lock_file() {
        let lock = "version = 4\n\n[[package]]\nname = \"a\"\nversion = \"1.0.0\"\nsource = \"registry\"\n\
                    checksum = \"ab\"\n\n[[package]]\nname = \"a\"\nversion = \"2.0.0\"\n\n[[package]]\nname = \"orb\"\n\
                    version = \"0.1.0\"\ndependencies = [\n \"a 2.0.0\",\n]\n";
        let value = of_lock(lock, "orb");
        assert_eq!(value["metadata"]["component"]["purl"], "pkg:cargo/orb@0.1.0");
        assert_eq!(value["components"].as_array().unwrap().len(), 2);
        assert_eq!(value["components"][0]["hashes"][0]["content"], "ab");
        assert_eq!(value["dependencies"][2]["dependsOn"], json!(["pkg:cargo/a@2.0.0"]));
    }

    #[test]
    fn of_this_build() {
        let text = cyclonedx();
        assert_eq!(text, cyclonedx());
        let value: Value = serde_json::from_str(&text).unwrap();
        let names: Vec<&str> =
            value["components"].as_array().unwrap().iter().map(|c| c["name"].as_str().unwrap()).collect();
        assert!(names.contains(&"aws-lc-rs") && names.contains(&"orb-formats") && !names.contains(&"orb"));
        // Every dependency is found, and everything from a registry has its digest.
        let count = LOCK.lines().filter(|l| l.starts_with(" \"")).count();
        let found: usize =
            value["dependencies"].as_array().unwrap().iter().map(|d| d["dependsOn"].as_array().unwrap().len()).sum();
        assert_eq!(found, count);
        let hashed = value["components"].as_array().unwrap().iter().filter(|c| c["hashes"].is_array()).count();
        assert_eq!(hashed, LOCK.matches("\nchecksum = ").count());
    }
}
