#!/usr/bin/env python3
"""Checks deploy/sbom.py on the built program: the fields that CycloneDX 1.5 asks for are there, the list holds what is known to
be in the program, nothing that only tests use, and the same bytes twice.

usage: tests/deploy/sbom_test.py PROGRAM
"""

import json
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
KNOWN = ["libc6", "libssl3", "libsqlite3-0", "libgdal32", "libboost-dev", "nlohmann-json3-dev", "libsqlitecpp-dev", "preact"]
UNWANTED = ["libgtest-dev", "libgmock-dev", "vite", "typescript", "eslint"]


def faults(text):
    """All that is wrong with a list."""
    bom = json.loads(text)
    found = []

    def expect(holds, fault):
        if not holds:
            found.append(fault)

    expect(bom.get("bomFormat") == "CycloneDX" and bom.get("specVersion") == "1.5", "no CycloneDX 1.5")
    expect(re.fullmatch(r"urn:uuid:[0-9a-f]{8}(-[0-9a-f]{4}){3}-[0-9a-f]{12}", bom.get("serialNumber", "")), "no serial number")
    expect(isinstance(bom.get("version"), int) and bom["version"] >= 1, "no version")
    components = bom.get("components", [])
    for component in components:
        for field in ("type", "name", "version", "purl", "bom-ref"):
            expect(component.get(field), f"{component.get('name')} has no {field}")
        for digest in component.get("hashes", []):
            lengths = {"SHA-1": 40, "SHA-256": 64, "SHA-384": 96, "SHA-512": 128}
            expect(len(digest["content"]) == lengths.get(digest["alg"]), f"{component.get('name')} has a bad digest")
    references = [component.get("bom-ref") for component in components]
    expect(len(references) == len(set(references)), "a component is there twice")
    own = bom.get("metadata", {}).get("component", {})
    expect(own.get("name") == "floeplan" and own.get("version"), "does not say what it is the list of")
    depends = {entry["ref"]: entry["dependsOn"] for entry in bom.get("dependencies", [])}
    expect(sorted(depends.get(own.get("bom-ref"), [])) == sorted(references), "depends on other things than it lists")
    names = {component.get("name") for component in components}
    found += [f"{name} is missing" for name in KNOWN if name not in names]
    found += [f"{name} is in no program" for name in UNWANTED if name in names]
    return found


def spoilt(text):
    """Lists with one fault each, to see that they are noticed."""
    for change in (
        lambda bom: bom.pop("serialNumber"),
        lambda bom: bom["components"][0].pop("version"),
        lambda bom: bom["components"].append(bom["components"][0]),
        lambda bom: bom["components"].pop(),
        lambda bom: bom.update(specVersion="9"),
    ):
        bom = json.loads(text)
        change(bom)
        yield json.dumps(bom)


def main():
    make = [str(ROOT / "deploy" / "sbom.py"), sys.argv[1]]
    first, second = (subprocess.run(make, check=True, capture_output=True, text=True).stdout for _ in range(2))
    found = faults(first)
    if first != second:
        found.append("two runs give different bytes")
    found += ["a spoilt list is taken for a good one" for bad in spoilt(first) if not faults(bad)]
    if found:
        sys.exit("FAILED: " + "; ".join(found))
    print(f"sbom: {len(json.loads(first)['components'])} components, as it should be")


if __name__ == "__main__":
    main()
