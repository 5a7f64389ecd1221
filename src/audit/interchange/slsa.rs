//! SLSA provenance v1: the outputs, what they were made from, and by what.

use serde_json::{Value, json};

use crate::audit::statement::{Input, Model, STATEMENT_TYPE, Statement, Tool};

const PREDICATE_TYPE: &str = "https://slsa.dev/provenance/v1";
/// A name, not an address.
const BUILD_TYPE: &str = "https://orb.invalid/orb/build/v1";
const BUILDER: &str = "https://orb.invalid/orb/cli";

/// An in-toto statement with the provenance predicate; unsigned, as the record's own signature covers other bytes.
pub fn provenance(statement: &Statement) -> Value {
    let p = &statement.predicate;
    let subjects: Vec<Value> = statement.subject.iter().map(|s| json!({"name": s.name, "digest": s.digest})).collect();
    let inputs = p.inputs.iter().map(|i: &Input| json!({"name": i.name, "digest": {"sha256": i.sha256}}));
    let weights = p.models.iter().filter_map(|m: &Model| {
        let sha256 = m.weights_sha256.as_ref()?;
        Some(json!({"name": format!("{} {}", m.id, m.version.as_deref().unwrap_or_default()), "digest": {"sha256": sha256}}))
    });
    json!({
        "_type": STATEMENT_TYPE,
        "subject": subjects,
        "predicateType": PREDICATE_TYPE,
        "predicate": {
            "buildDefinition": {
                "buildType": BUILD_TYPE,
                "externalParameters": {"command": p.source.command, "argv": p.source.argv_redacted, "params": p.params},
                "internalParameters": {"target": p.tool.target, "rustc": p.tool.rustc, "features": p.tool.features},
                "resolvedDependencies": inputs.chain(weights).collect::<Vec<_>>(),
            },
            "runDetails": {
                "builder": builder(&p.tool),
                "metadata": {"invocationId": p.event.id, "startedOn": p.time.utc},
                "byproducts": [{"name": "orb-record.dsse.json", "annotations": {"trail_hash": p.trail_hash}}],
            },
        },
    })
}

/// The program: its version, its source's commit, and the files that it can be recognised by.
fn builder(tool: &Tool) -> Value {
    let mut version = json!({"orb": tool.version});
    if let Some(commit) = &tool.git_commit {
        version["git_commit"] = json!(commit);
    }
    let files = [("orb", &tool.binary_sha256), ("orb audit sbom", &tool.sbom_sha256)];
    let dependencies: Vec<Value> = files
        .iter()
        .filter_map(|(name, sha256)| Some(json!({"name": name, "digest": {"sha256": sha256.as_ref()?}})))
        .collect();
    json!({"id": BUILDER, "version": version, "builderDependencies": dependencies})
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::audit::canonical::sha256_hex;
    use crate::audit::keys::tests::shared_key;
    use crate::audit::record::{self, tests::draft};
    use crate::audit::statement::Outcome;

    #[test]
    fn outputs_inputs_and_weights_with_their_digests() {
        let subject = record::subject("scene.ply".into(), "ab".repeat(32), 3, "application/octet-stream", "splats");
        let sealed = record::seal(&draft(), vec![subject], Outcome::Success, None, None, shared_key()).unwrap();
        let value = provenance(&sealed.statement);
        assert_eq!(value["subject"][0]["digest"]["sha256"], "ab".repeat(32));
        let needed = &value["predicate"]["buildDefinition"]["resolvedDependencies"];
        // The photo and one network; a stage that did not run is no dependency.
        assert_eq!(needed.as_array().unwrap().len(), 2);
        assert_eq!(needed[0]["name"], "van.jpg");
        let builder = &value["predicate"]["runDetails"]["builder"];
        assert_eq!(builder["builderDependencies"][0]["digest"]["sha256"], sha256_hex(b"orb"));
        assert_eq!(value["predicate"]["buildDefinition"]["externalParameters"]["argv"][2], "--seed");
        assert_eq!(value["predicate"]["runDetails"]["metadata"]["startedOn"], "2025-11-21T01:29:42.120Z");
    }
}
