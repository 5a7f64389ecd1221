"""Reads what `orb audit export` and `orb audit sbom` write with programs that are not ours.

    pip install compliance-trestle==5.2.0 'cyclonedx-python-lib[json-validation]' in-toto-attestation
    orb audit export FOLDER --for oscal -o DIR/oscal.json      (slsa and civium likewise)
    orb audit sbom > DIR/sbom.json
    python3 check_exports.py FOLDER DIR

compliance-trestle reads the OSCAL assessment results by NIST's schema, the in-toto project's own bindings read the SLSA
provenance and the record, Python's own json.dumps gives the hash that a Civium
service would, cyclonedx-python-lib checks the SBOM by its schema, and the record states the SBOM's digest. Prints a line
each; an exception, exit code 1, is a miss.
"""
import base64
import copy
import hashlib
import json
import pathlib
import sys

from cyclonedx.schema import SchemaVersion
from cyclonedx.validation.json import JsonStrictValidator
from google.protobuf import json_format
from in_toto_attestation.predicates.provenance.v1 import provenance_pb2
from in_toto_attestation.v1 import statement_pb2
from in_toto_attestation.v1.statement import Statement
from trestle.oscal.assessment_results import AssessmentResults

folder, exports = map(pathlib.Path, sys.argv[1:])
record = json.loads(base64.b64decode(json.load(open(folder / "orb-record.dsse.json"))["payload"]))
predicate = record["predicate"]

results = AssessmentResults.oscal_read(exports / "oscal.json")
assert predicate["marking"]["banner"] in results.metadata.title
observations = results.results[0].observations
assert len(observations) >= 5 and not results.results[0].findings
text = json.load(open(exports / "oscal.json"))
wrong = copy.deepcopy(text)
del wrong["assessment-results"]["results"][0]["reviewed-controls"]
broken = exports / "broken.json"
broken.write_text(json.dumps(wrong))
try:
    taken = AssessmentResults.oscal_read(broken) is not None
except Exception:
    taken = False
assert not taken, "trestle takes a file without reviewed-controls"
print(f"ok      trestle   OSCAL {results.metadata.oscal_version.root}: {len(observations)} observations")



def in_toto(value):
    """An in-toto Statement v1, by the project's messages: unknown fields and wrong types raise."""
    message = json_format.ParseDict(value, statement_pb2.Statement())
    Statement.copy_from_pb(message).validate()
    return message


assert in_toto(record).predicate_type == record["predicateType"]
statement = json.load(open(exports / "slsa.json"))
assert len(in_toto(statement).subject) == len(record["subject"])
provenance = json_format.ParseDict(statement["predicate"], provenance_pb2.Provenance())
assert provenance.build_definition.build_type and provenance.run_details.builder.id
assert provenance.run_details.metadata.started_on.ToJsonString().startswith(predicate["time"]["utc"][:10])
assert statement["_type"] == "https://in-toto.io/Statement/v1"
assert statement["predicateType"] == "https://slsa.dev/provenance/v1"
digests = {s["name"]: s["digest"]["sha256"] for s in statement["subject"]}
assert digests == {s["name"]: s["digest"]["sha256"] for s in record["subject"]}
definition = statement["predicate"]["buildDefinition"]
assert {"buildType", "externalParameters", "resolvedDependencies"} <= definition.keys()
assert statement["predicate"]["runDetails"]["builder"]["id"].startswith("https://")
needed = [d["digest"]["sha256"] for d in definition["resolvedDependencies"]]
assert set(i["sha256"] for i in predicate["inputs"]) <= set(needed)
print(f"ok      slsa      {len(digests)} subjects, {len(needed)} dependencies")

civium = json.load(open(exports / "civium.json"))
data = civium["entry"]["data"]
python = hashlib.sha256(json.dumps(data, sort_keys=True).encode()).hexdigest()
assert python == civium["expected_data_hash"], f"{python}, expected {civium['expected_data_hash']}"
assert civium["evidence"]["content_hash"] == data["trail_hash"] == predicate["trail_hash"]
print(f"ok      civium    {civium['entry']['action']}, hash {python[:16]}…")

sbom = (exports / "sbom.json").read_bytes()
error = JsonStrictValidator(SchemaVersion.V1_5).validate_str(sbom.decode())
assert error is None, error
assert hashlib.sha256(sbom).hexdigest() == predicate["tool"]["sbom_sha256"], "another SBOM than the record's"
print(f"ok      cyclonedx {len(json.loads(sbom)['components'])} components")
