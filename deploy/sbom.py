#!/usr/bin/env python3
"""Lists what the program and the map client are made of, as CycloneDX 1.5 JSON: the Debian packages of the libraries that the
program loads, those whose headers and archives were compiled into it (deploy/install-deps names them), and the packages of
npm that web/package-lock.json pins and the client holds. The same tree on the same packages gives the same bytes.

usage: deploy/sbom.py PROGRAM [OUT.json]
"""

import base64
import json
import pathlib
import re
import subprocess
import sys
import uuid

ROOT = pathlib.Path(__file__).resolve().parent.parent
TESTS_ALONE = {"libgtest-dev", "libgmock-dev", "libbenchmark-dev"}


def printed_by(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def loaded_packages(program):
    """Of every library that the loader would take. Of merged folders dpkg may know a file by its other name."""
    names = {}  # of each file, by the library's place
    for line in printed_by("ldd", program).splitlines():
        if found := re.search(r"(/\S+)", line):
            real = str(pathlib.Path(found[1]).resolve())
            names[found[1]] = [real, found[1], real.removeprefix("/usr")]
    files = sorted({name for those in names.values() for name in those})
    known = subprocess.run(["dpkg-query", "-S", *files], capture_output=True, text=True, check=False).stdout
    owners = {}
    for line in known.splitlines():
        packages, _, file = line.partition(": ")
        owners[file] = packages.split(",")[0].strip()
    lost = [place for place, those in names.items() if not any(name in owners for name in those)]
    if lost:
        sys.exit(f"sbom.py: no package holds {lost[0]}; build on a machine whose libraries dpkg installed")
    return {next(owners[name] for name in those if name in owners) for those in names.values()}


def compiled_in_packages():
    lines = (ROOT / "deploy" / "install-deps").read_text(encoding="utf-8").splitlines()
    needed = {line.split()[1] for line in lines if re.match(r"/usr/include/\S+ \S+$", line)}
    return needed - TESTS_ALONE


def debian_components(packages, how):
    wanted = "${Package}\t${Version}\t${Architecture}\t${source:Package}\n"
    components = []
    for line in printed_by("dpkg-query", "-W", "-f", wanted, *sorted(packages)).splitlines():
        name, version, architecture, source = line.split("\t")
        purl = f"pkg:deb/debian/{name}@{version.replace('+', '%2B').replace(':', '%3A')}?arch={architecture}"
        properties = {"floeplan:how": how, "floeplan:source-package": source}
        components.append(
            {
                "type": "library",
                "bom-ref": purl,
                "name": name,
                "version": version,
                "purl": purl,
                "properties": [{"name": key, "value": value} for key, value in properties.items()],
            }
        )
    return components


def npm_components():
    lock = json.loads((ROOT / "web" / "package-lock.json").read_text(encoding="utf-8"))
    components = []
    for place, package in lock["packages"].items():
        if not place or package.get("dev") or package.get("devOptional") or package.get("link"):
            continue
        name = place.rpartition("node_modules/")[2]
        purl = f"pkg:npm/{name.replace('@', '%40')}@{package['version']}"
        component = {"type": "library", "bom-ref": purl, "name": name, "version": package["version"], "purl": purl}
        if "license" in package:
            component["licenses"] = [{"expression": package["license"]}]
        if "integrity" in package:
            algorithm, _, digest = package["integrity"].split()[0].partition("-")
            content = base64.b64decode(digest).hex()
            component["hashes"] = [{"alg": algorithm.upper().replace("SHA", "SHA-"), "content": content}]
        components.append(component)
    return components


def document(program):
    components = debian_components(loaded_packages(program), "loaded")
    components += debian_components(compiled_in_packages(), "compiled in")
    components += npm_components()
    components = sorted({component["bom-ref"]: component for component in components}.values(), key=lambda c: c["bom-ref"])
    version = re.search(r"project\(floeplan VERSION (\S+)", (ROOT / "CMakeLists.txt").read_text(encoding="utf-8"))[1]
    own = f"pkg:generic/floeplan@{version}"
    text = json.dumps(components, sort_keys=True)
    return {
        "bomFormat": "CycloneDX",
        "specVersion": "1.5",
        # From the contents, so that the same contents have the same number.
        "serialNumber": f"urn:uuid:{uuid.uuid5(uuid.NAMESPACE_URL, own + text)}",
        "version": 1,
        "metadata": {"component": {"type": "application", "bom-ref": own, "name": "floeplan", "version": version, "purl": own}},
        "components": components,
        "dependencies": [{"ref": own, "dependsOn": [component["bom-ref"] for component in components]}],
    }


def main():
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    text = json.dumps(document(sys.argv[1]), indent=1, sort_keys=True) + "\n"
    if len(sys.argv) == 3:
        pathlib.Path(sys.argv[2]).write_text(text, encoding="utf-8")
    else:
        sys.stdout.write(text)


if __name__ == "__main__":
    main()
