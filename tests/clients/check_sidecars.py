"""Reads the sidecars and the record of a published folder with programs that are not ours.

    pip install 'pystac[validation]' owslib pyproj jsonschema
    python3 check_sidecars.py FOLDER

pystac checks the STAC item against the STAC and GeoJSON schemas that it brings along, OWSLib reads the ISO 19115 metadata
with its security constraints, pyproj measures the footprint, jsonschema checks the record by its published schema. Prints a line each; an exception, exit code 1, is a miss.
"""
import base64
import copy
import json
import pathlib
import sys

import jsonschema
import pystac
from owslib.etree import etree
from owslib.iso import MD_Metadata
from pyproj import Geod

folder = pathlib.Path(sys.argv[1])


def one(suffix):
    found = sorted(folder.glob("*" + suffix))
    assert len(found) == 1, f"{suffix}: {found}"
    return found[0]


marking = json.load(open(folder / "orb-marking.json"))["banner"]
item = pystac.Item.from_file(str(one(".stac.json")))
schemas = item.validate()
assert schemas, "no schema was applied"
for name, asset in item.assets.items():
    assert (folder / asset.href).exists(), f"asset {name} is not there"
print(f"ok      pystac  {item.id}: {len(item.assets)} assets, {len(schemas)} schemas")

metadata = MD_Metadata(etree.parse(str(one(".iso19115.xml"))).getroot())
identification = metadata.identification[0]
codes = {"UNCLASSIFIED": "unclassified", "CUI": "restricted", "SECRET": "secret", "TOP SECRET": "topSecret"}
classification = identification.securityconstraints
assert classification == [codes[marking]], f"{classification}, marked {marking}"
box = identification.bbox
assert [float(box.minx), float(box.miny), float(box.maxx), float(box.maxy)] == item.bbox, "another box than the STAC item's"
print(f"ok      OWSLib  {identification.title}: {classification[0]}, {metadata.stdname}")

feature = json.load(open(one(".footprint.geojson")))["features"][0]
shape = feature["geometry"]
polygons = [shape["coordinates"]] if shape["type"] == "Polygon" else shape["coordinates"]
area = sum(Geod(ellps="WGS84").polygon_area_perimeter(*zip(*ring[0]))[0] for ring in polygons)
assert abs(area - feature["properties"]["area_m2"]) < 2e-3 * max(area, 1), f"{area} {feature['properties']['area_m2']}"
print(f"ok      pyproj  footprint of {area:.2f} square metres")

root = pathlib.Path(__file__).resolve().parents[2]
validator = jsonschema.Draft202012Validator(json.load(open(root / "docs/record.schema.json")))
validator.check_schema(validator.schema)
record = json.loads(base64.b64decode(json.load(open(folder / "orb-record.dsse.json"))["payload"]))
validator.validate(record)


def changed(path, value):
    other = copy.deepcopy(record)
    at = other
    for step in path[:-1]:
        at = at[step]
    at[path[-1]] = value
    return other


wrong = [
    changed(["predicate", "trail_hash"], record["predicate"]["trail_hash"].upper() + "g"),
    changed(["predicate", "time", "utc"], "2026-11-21T04:05:06Z"),
    changed(["predicate", "chain", "seq"], -1),
    changed(["predicate", "params", "x"], 1.5),
    changed(["predicate", "unknown"], "x"),
    changed(["subject", 0, "annotations", "size"], "03"),
]
assert not any(validator.is_valid(w) for w in wrong), "the schema takes a record that is none"
print(f"ok      jsonschema  record {record['predicate']['chain']['seq']} of {len(record['subject'])} outputs")
