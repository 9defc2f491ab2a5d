#!/usr/bin/env python3
"""Asks a server what the executable test suites of OGC API - Features (Core, CRS), Processes and EDR ask, for machines on
which those suites cannot be had: the same requests, the same conditions on what comes back.

usage: abstract_tests.py URL      a server with the demonstration data
"""
import http.client
import json
import sys
import urllib.parse

BASE = sys.argv[1]
PARTS = urllib.parse.urlsplit(BASE)
OPENAPI = "application/vnd.oai.openapi+json;version=3.0"
CRS84 = "http://www.opengis.net/def/crs/OGC/1.3/CRS84"
faults = []


class Answer:
    def __init__(self, answer):
        self.status, self.version, self.headers, self.bytes = answer.status, answer.version, answer.headers, answer.read()

    def json(self):
        return json.loads(self.bytes)


def ask(address, method="GET", body=None, **headers):
    """`address` is a path or one of the server's own links."""
    if address.startswith("http"):
        split = urllib.parse.urlsplit(address)
        expect(f"{split.scheme}://{split.netloc}" == BASE, f"{address} leads to another server")
        address = split.path + ("?" + split.query if split.query else "")
    connection = http.client.HTTPConnection(PARTS.hostname, PARTS.port, timeout=120)
    named = {name.replace("_", "-"): value for name, value in headers.items()}
    if body is not None:
        body = json.dumps(body)
        named.setdefault("Content-Type", "application/json")
    connection.request(method, address, body, named)
    with connection.getresponse() as answer:
        return Answer(answer)


def expect(held, what):
    if not held:
        faults.append(what)
    return held


def status(address, wanted, **how):
    answer = ask(address, **how)
    expect(answer.status == wanted, f"{address}: {answer.status}, not {wanted}: {answer.bytes[:200]!r}")
    return answer


def link(document, *rels, kind=None):
    """The first link with one of the relations, which says its type."""
    for entry in document.get("links", []):
        if entry["rel"] in rels and (kind is None or entry.get("type", "").replace(" ", "") == kind):
            expect("type" in entry, f"the link {entry} does not say its type")
            return entry["href"]
    expect(False, f"no link {rels} of type {kind} among {[entry['rel'] for entry in document.get('links', [])]}")
    return "/"


def parameter(document, operation, name):
    for entry in operation["parameters"]:
        entry = document["components"]["parameters"][entry["$ref"].rsplit("/", 1)[1]] if "$ref" in entry else entry
        if entry["name"] == name:
            return entry
    expect(False, f"{operation['operationId']} does not describe {name}")
    return {"schema": {}}


def check_parameter(entry, required, kind):
    name = entry.get("name")
    expect(entry.get("in") == "query" and entry.get("required", False) is required and entry.get("explode") is not True,
           f"{name} is described as {entry}")
    expect(kind in (entry["schema"].get("type"), *(["array"] if "oneOf" in entry["schema"] else [])), f"{name} is no {kind}")
    if not required:
        expect(entry.get("style") == "form", f"{name} does not say its style")


def places(geometry):
    """Every position of a geometry."""
    def inner(value):
        if value and isinstance(value[0], (int, float)):
            yield value
        else:
            for member in value:
                yield from inner(member)
    return list(inner(geometry["coordinates"])) if geometry else []


def all_ids(address):
    """Of every page, with the greatest limit from the second one on, as the suite pages."""
    ids, first = [], None
    while address:
        page = status(address, 200).json()
        first = first or page
        ids += [feature["id"] for feature in page["features"]]
        following = [entry["href"] for entry in page["links"] if entry["rel"] == "next"]
        address = following[0] + "&limit=10000" if following else None
    return first, ids


def items(address):
    answer = status(address, 200, Accept="application/geo+json")
    expect(answer.headers["Content-Type"] == "application/geo+json", f"{address} is {answer.headers['Content-Type']}")
    page = answer.json()
    expect(page["type"] == "FeatureCollection" and page["numberReturned"] == len(page["features"]), f"{address}: wrong count")
    link(page, "self", kind="application/geo+json")
    for feature in page["features"]:
        for lon, lat, *_ in places(feature["geometry"]):
            expect(-180 <= lon <= 180 and -90 <= lat <= 90, f"{address}: {lon}, {lat} is not in CRS84")
    first, ids = all_ids(address)
    expect(first["numberMatched"] == len(ids) == len(set(ids)), f"{address}: {first['numberMatched']} matched, {len(ids)} came")
    return page


def core_of_features():
    landing = status("/", 200, Accept="application/json")
    expect(landing.version == 11, "the version is not HTTP/1.1")
    landing = landing.json()
    link(landing, "conformance"), link(landing, "data")
    document = status(link(landing, "service-desc", kind=OPENAPI), 200, Accept=OPENAPI).json()
    expect([server["url"] for server in document["servers"]] == [BASE], f"the servers are {document['servers']}")
    classes = status("/conformance", 200).json()["conformsTo"]
    for name in ("ogcapi-features-1/1.0/conf/core", "ogcapi-features-1/1.0/conf/geojson", "ogcapi-features-1/1.0/conf/oas30",
                 "ogcapi-features-2/1.0/conf/crs", "ogcapi-processes-1/1.0/conf/core"):
        expect("http://www.opengis.net/spec/" + name in classes, f"{name} is not declared")
    collections = status("/collections", 200, Accept="application/json").json()
    link(collections, "self")
    for collection in collections["collections"]:
        features_of(collection, document)
    return landing


def features_of(collection, document):
    name = collection["id"]
    alone = status(f"/collections/{name}", 200).json()
    for member in ("id", "title", "description", "extent", "crs"):
        expect(collection[member] == alone[member], f"{name}: {member} differs between the list and the collection")
    box = collection["extent"]["spatial"]["bbox"][0]
    expect(len(box) == 4, f"the extent of {name} has heights")
    address = link(collection, "items", kind="application/geo+json")
    operation = document["paths"][f"/collections/{name}/items"]["get"]
    limit = parameter(document, operation, "limit")
    check_parameter(limit, False, "integer")
    expect({"minimum", "maximum", "default"} <= set(limit["schema"]), "limit does not say its bounds")
    check_parameter(parameter(document, operation, "bbox"), False, "array")
    check_parameter(parameter(document, operation, "datetime"), False, "string")

    page = items(address)
    for count in (1, 50, 10_000):
        expect(len(status(f"{address}?limit={count}", 200).json()["features"]) <= count, f"{name}: more than {count} came")
    status(f"{address}?limit=unlimited", 400)
    status(f"{address}?unknownQueryParameter1=1", 400)
    for west, south, east, north in (box, (-1.5, 50, 1.5, 53), (-80, -5, -70, 5), (177, 65, -177, 70), (-180, 85, 180, 90),
                                     (-180, -90, 180, -85)):
        status(f"{address}?bbox={west:.7f},{south:.7f},{east:.7f},{north:.7f}", 200)
    inside = items(f"{address}?bbox=" + ",".join(f"{number:.7f}" for number in box))
    expect(inside["numberMatched"] == page["numberMatched"], f"{name}: features lie outside of its extent")
    for feature in page["features"][:1]:
        found = status(f"{address}/{urllib.parse.quote(str(feature['id']))}", 200).json()
        link(found, "self"), link(found, "collection")
        reference_systems(collection, address, f"{address}/{feature['id']}", box)


def reference_systems(collection, address, item, box):
    for crs in collection["crs"]:
        for path in (address, item):
            found = status(f"{path}?crs={urllib.parse.quote(crs)}", 200).headers["Content-Crs"]
            expect(found == f"<{crs}>", f"{path} in {crs} says {found}")
    for path in (address, item):
        expect(status(path, 200).headers["Content-Crs"] == f"<{CRS84}>", f"{path} does not say CRS84")
        status(f"{path}?crs=http://www.opengis.net/def/crs/0/unsupported", 400)
    status(f"{address}?bbox=0,0,1,1&bbox-crs=http://www.opengis.net/def/crs/0/unsupported", 400)
    west, south, east, north = box
    plain = status(f"{address}?limit=10&bbox={west},{south},{east},{north}", 200).json()
    for crs, turned in ((CRS84, box), ("http://www.opengis.net/def/crs/EPSG/0/4326", (south, west, north, east))):
        named = status(f"{address}?limit=10&bbox={','.join(map(str, turned))}&bbox-crs={urllib.parse.quote(crs)}", 200).json()
        expect([feature["id"] for feature in named["features"]] == [feature["id"] for feature in plain["features"]],
               f"{address}: the box in {crs} finds others")


def execute(inputs, prefer=None, **rest):
    headers = {"Prefer": prefer} if prefer else {}
    return ask("/processes/echo/execution", "POST", {"inputs": inputs, **rest}, Accept="application/json", **headers)


def processes(landing):
    for rel in ("http://www.opengis.net/def/rel/ogc/1.0/conformance", "http://www.opengis.net/def/rel/ogc/1.0/processes",
                "processes"):
        link(landing, rel)
    expect(len(status("/processes?limit=1", 200).json()["processes"]) == 1, "limit=1 gives more than one process")
    for process in status("/processes", 200).json()["processes"]:
        expect({"id", "version", "jobControlOptions"} <= set(process), f"{process['id']} does not say all of itself")
    described = status("/processes/echo", 200)
    expect(described.headers["Content-Type"] == "application/json", "a process is not application/json")
    described = described.json()
    for group in ("inputs", "outputs"):
        expect(all("schema" in entry for entry in described[group].values()), f"{group} without a schema")
    expect({"sync-execute", "async-execute", "dismiss"} <= set(described["jobControlOptions"]), "echo cannot do all")
    none = status("/processes/invalid-process", 404)
    expect(none.headers["Content-Type"] == "application/problem+json" and "type" in none.json(), "no problem document")

    started = execute({"echo": "teststring", "pause": 1}, "respond-async ")
    expect(started.status == 201 and started.json()["status"] in ("accepted", "running", "successful"), "no job was made")
    job = started.headers["Location"]
    early = status(job + "/results", 404).json()
    expect(early["type"].endswith("ogcapi-processes-1/1.0/result-not-ready"), f"an early result is {early}")
    for _ in range(20):  # each answer comes at the job's next change
        state = status(job, 200, Prefer="wait=20").json()
        if state["status"] not in ("accepted", "running"):
            break
    expect(state["status"] == "successful", f"the job is {state['status']}")
    results = status(link(state, "http://www.opengis.net/def/rel/ogc/1.0/results"), 200).json()
    expect(results.get("echo") == "teststring", f"the results are {results}")

    done = execute({"echo": "teststring"})
    expect(done.status == 200 and done.headers["Link"] is None, "no synchronous result, or a Link header with it")
    expect(b"teststring" in execute({"echo": "teststring"}, response="raw", outputs={"echo": {}}).bytes, "no raw value")
    expect(execute({"echo": "teststring"}, outputs={}).status in (200, 201), "no outputs are not all outputs")
    wrong = execute({"text": {"type": "wrong/type"}})
    expect(wrong.status == 400 and wrong.headers["Content-Type"] == "application/json", "a wrong media type is taken")
    expect(ask("/processes/echo/execution", "POST", {}).status >= 400, "a request without inputs is taken")
    for path in ("/jobs/invalid-job", "/jobs/invalid-job/results"):
        expect("type" in status(path, 404).json(), f"{path} has no problem document")
    jobs = status("/jobs", 200).json()
    expect(jobs["jobs"] and jobs["links"], "the list of jobs is empty")
    gone = ask(job, "DELETE")
    expect(gone.status == 200 and gone.json()["status"] == "dismissed", "a job is not dismissed")


def edr():
    for suffix in ("", "/", "?f=application/json", "?f=json"):
        status("/edr" + suffix, 200, Accept="text/html, */*; q=.2")
    landing = status("/edr?f=json", 200).json()
    first = [entry for entry in landing["links"] if entry["rel"] in ("service-desc", "service-doc")][0]
    expect(first["rel"] == "service-desc" and first["type"].replace(" ", "") == OPENAPI, "service-desc does not come first")
    document = status(first["href"], 200).json()
    classes = status("/edr/conformance?f=json", 200).json()["conformsTo"]
    expect("http://www.opengis.net/spec/ogcapi-edr-1/1.0/conf/core" in classes, "the core of EDR is not declared")
    collections = status("/edr/collections", 200).json()
    link(collections, "self")
    for path, operations in document["paths"].items():
        query = path.rsplit("/", 1)[1]
        if query in ("position", "area", "trajectory", "radius"):
            check_parameter(parameter(document, operations["get"], "coords"), True, "string")
        if query == "cube":
            check_parameter(parameter(document, operations["get"], "bbox"), True, "array")
        if query in ("position", "area", "trajectory", "radius", "cube"):
            check_parameter(parameter(document, operations["get"], "datetime"), False, "string")
    for collection in collections["collections"]:
        field(collection)


def field(collection):
    name = collection["id"]
    link(collection, "data", "collection"), link(collection, "self", "alternate")
    expect(status(f"/edr/collections/{name}", 200).json()["id"] == name, f"{name} is not found by its name")
    expect("CRS84" in collection["crs"][-1], f"{name}: the last reference system is not CRS84")
    expect(all({"type", "observedProperty"} <= set(entry) for entry in collection["parameter_names"].values()),
           f"{name}: parameters do not say what they are")
    west, south, east, north = collection["extent"]["spatial"]["bbox"][0]
    lon, lat = (west + east) / 2, (south + north) / 2
    begin, end = collection["extent"]["temporal"]["interval"][0]
    expect(end is not None, f"{name} has no end")
    coords = {"position": f"POINT({lon}+{lat})", "trajectory": f"LINESTRING({lon - 1}+{lat},{lon + 1}+{lat})",
              "area": f"POLYGON(({lon - 1}+{lat - 1},{lon + 1}+{lat - 1},{lon + 1}+{lat + 1},{lon - 1}+{lat + 1},{lon - 1}+{lat - 1}))"}
    for query, text in coords.items():
        address = link({"links": [collection["data_queries"][query]["link"]]}, "data")
        form = collection["data_queries"][query]["link"]["variables"]["output_formats"][0]
        expect(form == "CoverageJSON", f"{name}: {form} comes before CoverageJSON")
        status(address, 400)
        for empty in ("", "POINT()", "POLYGON()", "LINESTRING()", "LINESTRINGM()", "LINESTRINGZM()", "LINESTRINGZ()"):
            status(f"{address}?coords={empty}", 400)
        for spelling in ("parameter-name", "parameter_names"):
            answer = status(f"{address}?coords={text}&{spelling}={next(iter(collection['parameter_names']))}&crs=CRS84"
                            f"&f={form}&datetime={begin}/{end}", 200)
            expect(b"Coverage" in b"".join(answer.bytes.split(b"\n")[:10]), f"{name}: {query} gives no coverage")


processes(core_of_features())
edr()
print("\n".join(faults) if faults else "every condition holds")
sys.exit(1 if faults else 0)
