#!/usr/bin/env python3
"""Drives every operation of a server's own OpenAPI document and checks each JSON answer against its schema.

usage: openapi_responses.py URL [DOCUMENT]     a server with the demonstration data

Every object of a schema must say what else it may hold (additionalProperties), so that a member that the document
does not describe is a fault. With DOCUMENT (a file) answers are compared with it and not with what the server serves.
"""
import hashlib
import json
import re
import sys
import urllib.error
import urllib.request

import jsonschema

URL = sys.argv[1]
DEPART = "2026-11-22T06:00:00Z"
FROM, TO, ON_LAND = [-53.0, 69.0], [-52.9, 69.02], [-51.0, 69.0]
PLAIN = {"from": FROM, "to": TO, "depart": DEPART, "spacing_m": 2000, "icebergs": "none", "steady": True,
         "refine_seconds": 0.2}
UNDER_AN_ICEBERG = {"route": [[-52.47, 69.227], [-52.37, 69.227]], "pass_under_icebergs": True,
                    "icebergs_drift": False}
MISSION = "behavior_name=goto_list\n<start:b_arg>\n\tb_arg: num_waypoints(nodim) 1\n<end:b_arg>\n" \
          "<start:waypoints>\n-5300.0000\t6900.0000\n<end:waypoints>\n"
VERBS = ("get", "post", "put", "patch", "delete")

# Query parameters that are plain text to the schema, and yet not any text.
STRUCTURED = {"as_of", "coords", "crs", "bbox-crs", "datetime", "depart", "firmware", "parameter-name", "parameter_names",
              "safe", "science", "sha256", "time", "until", "with", "within", "within-units", "z"}

faults = []
driven = set()
sent_wrong = set()


def ask(method, path, body=None, headers=None):
    """Status, media type and bytes of an answer."""
    data = None if body is None else body if isinstance(body, bytes) else json.dumps(body).encode()
    request = urllib.request.Request(URL + path, data=data, method=method, headers=dict(headers or {}))
    if data is not None and not request.has_header("Content-type"):
        request.add_header("Content-Type", "application/json")
    try:
        with urllib.request.urlopen(request, timeout=120) as answer:
            return answer.status, answer.headers.get("Content-Type", ""), answer.read()
    except urllib.error.HTTPError as refused:
        return refused.code, refused.headers.get("Content-Type", ""), refused.read()


def as_json_schema(schema):
    """OpenAPI 3.0 writes "nullable" where JSON Schema allows the type null."""
    if isinstance(schema, list):
        return [as_json_schema(member) for member in schema]
    if not isinstance(schema, dict):
        return schema
    result = {key: as_json_schema(value) for key, value in schema.items()
              if key != "nullable" or not isinstance(value, bool)}
    return {"anyOf": [{"type": "null"}, result]} if schema.get("nullable") is True else result


def the_document():
    """The OpenAPI document that answers are compared with."""
    if len(sys.argv) < 3:
        return json.loads(ask("GET", "/api")[2])
    with open(sys.argv[2], encoding="utf-8") as file:
        return json.load(file)


DOCUMENT = the_document()
COMPONENTS = as_json_schema(DOCUMENT["components"])


def note(where, error):
    """Of several alternatives none of which fits, what is wrong with the one that fits best."""
    while error.context:
        alternatives = {}
        for inner in error.context:
            alternatives.setdefault(inner.schema_path[0], []).append(inner)
        error = min(alternatives.values(), key=len)[0]
    at = "/".join(str(step) for step in error.absolute_path)
    faults.append(f"{where}: /{at}: {error.message[:300]}")


def drive(method, template, status, body=None, headers=None, query="", **names):
    """Asks one operation and checks its answer. Returns the JSON."""
    path = template
    for name, value in names.items():
        path = path.replace("{" + name + "}", str(value))
    where = f"{method} {path}{query}"
    operation = DOCUMENT["paths"][template][method.lower()]
    driven.add((method.lower(), template))
    found, media_type, content = ask(method, path + query, body, headers)
    if method == "GET" and found == status == 200:
        send_wrong(template, path, query)
    if found != status:
        faults.append(f"{where}: status {found}, not {status}: {content[:300]!r}")
        return None
    return described(where, operation, status, media_type, content)


def described(where, operation, status, media_type, content):
    """Checks that the operation describes the status, the media type and, of JSON, the schema. Returns the JSON."""
    response = operation["responses"].get(str(status), operation["responses"].get("default"))
    if response is None:
        faults.append(f"{where}: the status {status} is not described")
        return None
    if "$ref" in response:
        response = DOCUMENT["components"]["responses"][response["$ref"].rsplit("/", 1)[1]]
    if not content and "content" not in response:
        return None
    kind = media_type.split(";")[0]
    contents = {name.split(";")[0]: value for name, value in response.get("content", {}).items()}
    if kind not in contents:
        faults.append(f"{where}: the media type {media_type} is not described")
        return None
    if not kind.endswith("json"):
        return content
    answer = json.loads(content)
    schema = as_json_schema(contents[kind]["schema"])
    validator = jsonschema.Draft7Validator({**schema, "components": COMPONENTS})
    for error in validator.iter_errors(answer):
        note(where, error)
    return answer


def wrong_value(parameter):
    """One that the schema of the parameter does not allow; none for a text that may be anything."""
    schema = parameter["schema"]
    if "enum" in schema or schema.get("type") in ("array", "boolean", "integer", "number"):
        return "wrong"
    return "wrong" if parameter["name"] in STRUCTURED else None


def send_wrong(template, path, query):
    """Where a request was answered, each query parameter once with a wrong value."""
    if template in sent_wrong:
        return
    sent_wrong.add(template)
    parameters = [DOCUMENT["components"]["parameters"][entry["$ref"].rsplit("/", 1)[1]] if "$ref" in entry else entry
                  for entry in DOCUMENT["paths"][template]["get"]["parameters"]]
    wrong = {entry["name"]: wrong_value(entry) for entry in parameters if entry["in"] == "query"}
    for name, value in wrong.items():
        if value is None:
            continue
        others = [word for word in query[1:].split("&") if word and not word.startswith(name + "=")]
        address = path + "?" + "&".join(others + [f"{name}={value}"])
        refused("GET", template, address)


def refused(method, template, address, body=None):
    """Asks for what the operation has to refuse, with the faults and as it is described."""
    found, media_type, content = ask(method, address, body)
    if found != 400 or not json.loads(content).get("errors"):
        faults.append(f"{method} {address}: status {found}, not 400 with the faults: {content[:300]!r}")
        return
    described(f"{method} {address}", DOCUMENT["paths"][template][method.lower()], found, media_type, content)


def unknown_parameters():
    """Every operation once with an unknown query parameter."""
    for template, operations in DOCUMENT["paths"].items():
        path = re.sub("{[^}]*}", "none", template)
        for verb in set(VERBS) & set(operations):
            body = {} if "requestBody" in operations[verb] else None
            refused(verb.upper(), template, path + "?no_such_parameter=1", body)


def execute(process, inputs, status=200):
    return drive("POST", f"/processes/{process}/execution", status, {"inputs": inputs},
                 {"Prefer": "respond-sync"})


def resolved(schema):
    while "$ref" in schema:
        target = DOCUMENT
        for step in schema["$ref"][2:].split("/"):
            target = target[step]
        schema = target
    return schema


def wrong_inputs(right):
    """Every input of every process once with a value that it cannot have: each is refused by its name. `right` are inputs
    that would do; echo gives back whatever it is sent."""
    for process, inputs in right.items():
        path = f"/processes/{process}/execution"
        body = resolved(resolved(DOCUMENT["paths"][path]["post"]["requestBody"])["content"]["application/json"]["schema"])
        for name in [*resolved(body["properties"]["inputs"])["properties"], "no_such_input"]:
            for value in ({"no_such_member": 1}, [[["wrong"]]]):
                found, _, content = ask("POST", path, {"inputs": {**inputs, name: value}}, {"Prefer": "respond-sync"})
                errors = json.loads(content).get("errors", []) if found == 400 else []
                if not any(name in entry["pointer"] + entry["detail"] for entry in errors):
                    faults.append(f"POST {path}, {name} {value}: status {found}, not 400 for {name}: {content[:300]!r}")


def plans():
    """Results with everything that they can hold, and the id of a plan in open water."""
    plan = execute("plan-route", {**PLAIN, "from": [-53.2, 69.2], "to": [-53.1, 69.2]})
    execute("plan-route", PLAIN)
    execute("plan-route", {**PLAIN, "icebergs": "newest", "refine": False, "encounter_weight_s": 3600,
                           "max_loiter_s": 3600, "remarks": ["the goal was typed by hand"]})
    execute("plan-route", {**PLAIN, "objective": "energy", "refine": False,
                           "vehicle": {"thruster": {"speed_m_s": 0.6, "power_w": 8.0}}})
    execute("plan-route", {**PLAIN, "steady": False, "depart_until": "2026-11-22T12:00:00Z", "depart_step": "PT6H",
                           "refine": False})
    execute("plan-route", {**PLAIN, "via": [[-52.97, 69.01], [-52.95, 69.02]], "via_order": "best"})
    execute("plan-route", {**PLAIN, "uncertainty": {"members": 2, "objective": "quantile", "current_error_m_s": 0.03,
                                                    "length_scale_m": 20000, "time_scale_s": 43200,
                                                    "arrive_before": "2026-11-25T00:00:00Z"}})
    execute("plan-route", {**PLAIN, "steady": False, "depart_until": "2026-11-22T12:00:00Z", "depart_step": "PT6H",
                           "refine": False, "to": ON_LAND})
    execute("plan-route", {**PLAIN, "refine": False, "from": [-53.2, 69.2], "to": [-53.1, 69.2],
                           "under_ice": {"escape_plan": True, "surfacing_interval_s": 3600}})
    execute("plan-route", {**PLAIN, "to": "nowhere"}, 400)
    return plan["plan"]["plan_id"]


def judged_routes():
    route = {"route": [FROM, TO], "depart": DEPART, "icebergs": "none", "steady": True}
    execute("evaluate-route", route)
    execute("evaluate-route", {**UNDER_AN_ICEBERG, "depart": DEPART})
    execute("evaluate-route", {**route, "route": [FROM, ON_LAND]})
    execute("evaluate-route", {**route, "steady": False, "depart": "2026-11-19T00:00:00Z"}, 400)
    execute("evaluate-route", {**route, "speed_m_s": 0.05})


def reaches():
    reach = {"hours": [1, 3], "spacing_m": 2000, "icebergs": "none", "steady": True}
    execute("reach", {**reach, "from": FROM, "depart": DEPART})
    execute("reach", {**reach, "to": TO, "arrive_by": "2026-11-23T06:00:00Z"})
    execute("reach", {**reach, "from": ON_LAND, "depart": DEPART})


def simulations(plan):
    made = execute("simulate-plan", {"plan_id": plan, "runs": 2, "tracks": 1, "longest_s": 1800, "icebergs": "none",
                                     "ice": "none"})
    name = made["simulation"]["simulation_id"]
    execute("simulate-plan", {"plan_id": plan, "runs": 0}, 400)
    execute("fly-scenario", {"scenario": "random-icebergs", "runs": 1})
    execute("compare-flight", {"files": [{"name": "empty", "text": ""}]}, 400)
    drive("GET", "/simulations", 200, query=f"?plan_id={plan}")
    drive("GET", "/simulations/{simulation_id}", 200, simulation_id=name)
    drive("GET", "/simulations/{simulation_id}/flights/{run}", 200, simulation_id=name, run=0)
    drive("GET", "/simulations/{simulation_id}/flights/{run}", 404, simulation_id=name, run=1)
    drive("GET", "/simulations/{simulation_id}/tracks.nc", 200, simulation_id=name)
    drive("GET", "/simulations/{simulation_id}/tracks.geojson", 200, query="?run=0", simulation_id=name)
    drive("GET", "/simulations/{simulation_id}/tracks.nc", 404, query="?run=1", simulation_id=name)
    drive("DELETE", "/simulations/{simulation_id}", 204, simulation_id=name)
    drive("GET", "/simulations/{simulation_id}", 404, simulation_id=name)


def jobs():
    for process, inputs in (("plan-route", {**PLAIN, "refine": False}),
                            ("evaluate-route", {"route": [FROM, TO], "depart": DEPART, "icebergs": "none"}),
                            ("reach", {"from": FROM, "depart": DEPART, "hours": [1], "spacing_m": 2000,
                                       "icebergs": "none"})):
        job = drive("POST", f"/processes/{process}/execution", 201, {"inputs": inputs},
                    {"Prefer": "respond-async"})
        name = job["jobID"]
        state = drive("GET", "/jobs/{job_id}", 200, headers={"Prefer": "wait=30"}, job_id=name)
        while state["status"] in ("accepted", "running"):
            state = drive("GET", "/jobs/{job_id}", 200, headers={"Prefer": "wait=30"}, job_id=name)
        drive("GET", "/jobs/{job_id}/results", 200, job_id=name)
    drive("GET", "/jobs", 200)
    drive("GET", "/jobs", 200, query="?status=successful&processID=plan-route&type=process&limit=1")
    drive("GET", "/jobs", 400, query="?status=busy")
    events(name)
    drive("DELETE", "/jobs/{job_id}", 200, job_id=name)
    drive("GET", "/jobs/{job_id}", 404, job_id="none")


def events(job):
    """The stream of one job that has ended ends; of the other, which never does, the beginning is read."""
    drive("GET", "/jobs/{job_id}/events", 200, job_id=job)
    drive("GET", "/jobs/{job_id}/events", 400, headers={"Last-Event-ID": "yesterday"}, job_id=job)
    driven.add(("get", "/events"))
    with urllib.request.urlopen(URL + "/events", timeout=30) as stream:
        if stream.headers["Content-Type"] != "text/event-stream" or not stream.readline().startswith(b"retry:"):
            faults.append("GET /events: no stream of events")


def echoes():
    sent = {"echo": "a text", "numbers": [1, 2], "region": {"bbox": [-54, 68, -50, 70]}, "text": "plain", "value": 7}
    if execute("echo", sent) != sent:
        faults.append("echo does not give back what was sent")
    if execute("echo", {"value": {"value": "wrapped"}}) != {"value": "wrapped"}:
        faults.append("echo does not take a value that says more of itself")
    execute("echo", {"text": {"type": "wrong/type"}}, 400)
    body = {"inputs": {"echo": "teststring"}, "outputs": {"echo": {}}, "response": "raw"}
    if drive("POST", "/processes/echo/execution", 200, body) != b"teststring":
        faults.append("echo does not give one output raw")
    key = {"Prefer": "respond-async", "Idempotency-Key": "9f5b1a4e"}
    first = drive("POST", "/processes/echo/execution", 201, body, key)
    if drive("POST", "/processes/echo/execution", 201, body, key)["jobID"] != first["jobID"]:
        faults.append("the same key began another job")
    drive("POST", "/processes/echo/execution", 409, {"inputs": {}}, key)


def features():
    """Every collection, in every reference system, with each of its parameters wrong once."""
    for template in [path for path in DOCUMENT["paths"] if path.startswith("/collections/") and path.endswith("/items")]:
        page = drive("GET", template, 200, query="?limit=2")
        item = next(path for path in DOCUMENT["paths"] if path.startswith(template + "/{") and path.endswith("}"))
        name = item[len(template) + 2:-1]
        for feature in page["features"][:1]:
            drive("GET", item, 200, **{name: feature["id"]})
        drive("GET", item, 404, **{name: "none"})
        drive("GET", template[:-len("/items")] + "/schema", 200)
        for crs in DOCUMENT["components"]["parameters"]["crs"]["schema"]["enum"]:
            drive("GET", template, 200, query=f"?limit=1&crs={crs}")
        for wrong in ("limit=none", "bbox=1,2,3", "bbox=0,0,1,1&bbox-crs=none", "crs=none", "datetime=soon", "after=x",
                      "unknown=1"):
            drive("GET", template, 400, query="?" + wrong)
    ring = [[-53.1, 68.9], [-52.8, 68.9], [-52.8, 69.1], [-53.1, 68.9]]
    edits("/collections/nogo-zones/items", "zone_id", {"type": "Polygon", "coordinates": [ring]}, {"kind": "no_go"})
    edits("/collections/icebergs/items", "row", {"type": "Point", "coordinates": [-40, 60]},
          {"berg_id": "seen", "observed": "2026-11-20T06:00:00Z"})


def edits(items, name, geometry, properties):
    feature = {"type": "Feature", "geometry": geometry, "properties": properties}
    drive("POST", items, 400, {**feature, "geometry": None})
    drive("POST", items, 201, feature)
    made = {name: drive("GET", items, 200, query="?limit=10000")["features"][-1]["id"]}
    item = items + "/{" + name + "}"
    drive("PUT", item, 412, feature, {"If-Match": '"none"'}, **made)
    drive("PUT", item, 204, feature, **made)
    drive("PATCH", item, 204, {"properties": properties}, {"Content-Type": "application/merge-patch+json"}, **made)
    drive("DELETE", item, 204, **made)
    drive("DELETE", item, 404, **made)


def edr():
    """Every query of every kind of data, right and wrong."""
    for template in ("/edr", "/edr/conformance", "/edr/api"):
        drive("GET", template, 200)
    for collection in drive("GET", "/edr/collections", 200)["collections"]:
        drive("GET", "/edr/collections/{collection_id}", 200, collection_id=collection["id"])
    drive("GET", "/edr/collections/{collection_id}", 404, collection_id="none")
    box = "-53.1+68.9,-52.9+68.9,-52.9+69.1,-53.1+68.9"
    grid = "&resolution-x=3&resolution-y=3"
    right = {"position": "coords=POINT(-53+69)", "radius": "coords=POINT(-53+69)&within=9&within-units=km" + grid,
             "area": f"coords=POLYGON(({box}))" + grid, "cube": "bbox=-53.1,68.9,-52.9,69.1" + grid,
             "trajectory": "coords=LINESTRING(-53+69,-52.9+69.02)"}
    for kind in ("currents", "bathymetry", "sea-ice"):
        when = "" if kind == "bathymetry" else f"&datetime={DEPART}"
        for query, words in right.items():
            template = f"/edr/collections/{kind}/{query}"
            drive("GET", template, 200, query=f"?{words}{when}")
            for wrong in ("", "?coords=POINT()", f"?{words}&z=deep", f"?{words}&datetime=soon",
                          f"?{words}&parameter-name=salt", f"?{words}&crs=EPSG:3857", f"?{words}&f=netcdf"):
                drive("GET", template, 400, query=wrong)


def collections(plan):
    drive("GET", "/collections", 200)
    drive("GET", "/collections/{collection_id}", 200, collection_id="icebergs")
    drive("GET", "/collections/{collection_id}", 404, collection_id="none")
    features()
    drive("GET", "/collections/plans/items", 200)
    drive("GET", "/collections/plans/items/{plan_id}", 200, plan_id=plan)
    for template in DOCUMENT["paths"]:
        if template.startswith("/collections/plans/items/{plan_id}/"):
            drive("GET", template, 200, query=f"?with={plan}" if template.endswith("/comparison") else "", plan_id=plan)
    drive("DELETE", "/collections/plans/items/{plan_id}", 204, plan_id=plan)
    drive("GET", "/collections/plans/items/{plan_id}", 404, plan_id=plan)


def data():
    datasets = drive("GET", "/datasets", 200)["datasets"]
    drive("GET", "/datasets/{dataset_id}", 200, dataset_id=datasets[0]["id"])
    drive("GET", "/probe", 200, query=f"?lon={FROM[0]}&lat={FROM[1]}&time={DEPART}")
    drive("GET", "/probe", 200, query="?lon=100&lat=0")
    drive("GET", "/probe", 400, query="?lon=north")
    box = "?bbox=-53.5,68.9,-52.5,69.3"
    drive("GET", "/map/coast", 200, query=box)
    drive("GET", "/map/drift", 200, query=f"{box}&as_of={DEPART}&until={DEPART}")
    drive("GET", "/map/bathymetry", 200, query=box + "&nx=32&ny=32")
    drive("GET", "/map/currents", 200, query=box + f"&nx=32&ny=32&time={DEPART}")
    drive("GET", "/map/sea-ice", 200, query=box + f"&nx=32&ny=32&time={DEPART}")
    ice = next(entry["id"] for entry in datasets if entry["kind"] == "ice")
    drive("GET", "/map/ice-chart", 200, query=box + f"&nx=32&dataset={ice}")
    drive("POST", "/datasets/prune", 200, {"older_than": "P1D", "kind": "currents", "dry_run": True})
    for rules in ({}, {"older_than": "long"}, {"max_bytes": 0.5}, {"max_bytes": 1, "kind": "zones"}, {"younger": 1}, []):
        drive("POST", "/datasets/prune", 400, rules)
    coast = next(entry["id"] for entry in datasets if entry["kind"] == "coastline")
    drive("DELETE", "/datasets/{dataset_id}", 204, dataset_id=coast)


def uploads():
    file = b"ncols 2\nnrows 2\nxllcorner -60\nyllcorner 60\ncellsize 0.5\n-9 -8\n-7 -6\n"
    binary = {"Content-Type": "application/octet-stream"}
    digest = hashlib.sha256(file).hexdigest()
    sent = drive("POST", "/uploads", 201, file, binary, f"?name=bed.asc&sha256={digest}")
    letter = drive("POST", "/uploads", 201, b"a letter", binary, "?name=letter.txt")
    drive("POST", "/uploads", 400, file, binary, f"?name=bed.asc&sha256={64 * '0'}")
    drive("GET", "/uploads/{upload_id}", 200, upload_id=sent["id"])
    drive("GET", "/uploads", 200, query="?limit=1")
    reports = execute("ingest", {"uploads": [sent["id"], letter["id"]], "positive": "up"})["report"]["datasets"]
    statuses = [report["status"] for report in reports]
    if statuses != ["stored", "refused"]:
        faults.append(f"ingestion: {statuses}: {reports}")
    execute("ingest", {"uploads": [sent["id"]], "kind": "bathymetry", "positive": "sideways"}, 400)
    job = drive("POST", "/processes/ingest/execution", 201, {"inputs": {"uploads": [sent["id"]]}},
                {"Prefer": "respond-async"})
    state = job
    while state["status"] in ("accepted", "running"):
        state = drive("GET", "/jobs/{job_id}", 200, headers={"Prefer": "wait=30"}, job_id=job["jobID"])
    drive("GET", "/jobs/{job_id}/results", 200, job_id=job["jobID"])
    drive("DELETE", "/uploads/{upload_id}", 204, upload_id=sent["id"])
    drive("GET", "/uploads/{upload_id}", 404, upload_id=sent["id"])
    execute("ingest", {"uploads": [sent["id"]]}, 400)


def rest():
    for template in ("/", "/conformance", "/processes", "/vehicles", "/healthz", "/version", "/api"):
        drive("GET", template, 200)
    for process in ("plan-route", "evaluate-route", "reach", "simulate-plan", "fly-scenario", "compare-flight", "ingest", "echo"):
        drive("GET", "/processes/{process_id}", 200, process_id=process)
    drive("GET", "/app/{path}", 404, path="none.js")
    drive("GET", "/guide", 200)
    drive("GET", "/guide/{path}", 200, path="data")
    drive("GET", "/guide/{path}", 404, path="none")
    for template in ("/session", "/audit", "/metrics", "/readyz"):
        drive("GET", template, 200)
    drive("POST", "/session", 400, {"token": "none is needed here"})
    drive("DELETE", "/session", 204)
    drive("POST", "/missions/check", 200, MISSION.encode(), {"Content-Type": "text/plain"}, "?name=goto_l10.ma")
    drive("POST", "/missions/check", 200,
          {"files": [{"name": "goto_l10.ma", "text": MISSION}], "inputs": {"from": FROM, "depart": DEPART}})


def open_objects(schema, where, seen):
    """Objects of a schema that do not say what else they may hold would let an undescribed member pass."""
    if isinstance(schema, list):
        for step, member in enumerate(schema):
            open_objects(member, f"{where}/{step}", seen)
    if not isinstance(schema, dict):
        return
    if schema.get("type") == "object" and "additionalProperties" not in schema:
        faults.append(f"{where}: the object does not say additionalProperties")
    for name, member in schema.items():
        if name == "$ref" and member not in seen:
            seen.add(member)
            _, _, kind, component = member.split("/")
            open_objects(DOCUMENT["components"][kind][component], f"{kind}/{component}", seen)
        open_objects(member, f"{where}/{name}", seen)


def closed_answers():
    seen = set()
    for path, operations in DOCUMENT["paths"].items():
        for verb in set(VERBS) & set(operations):
            open_objects(operations[verb]["responses"], f"{verb.upper()} {path}", seen)


def missing():
    for path, operations in DOCUMENT["paths"].items():
        for verb in VERBS:
            if verb in operations and (verb, path) not in driven:
                faults.append(f"{verb.upper()} {path} was not asked: add it to this script")


try:
    closed_answers()
    rest()
    plan = plans()
    wrong_inputs({"plan-route": PLAIN, "evaluate-route": {"plan_id": plan, "depart": DEPART},
                  "reach": {"from": FROM, "depart": DEPART, "hours": [1]}, "simulate-plan": {"plan_id": plan},
                  "fly-scenario": {"scenario": "random-icebergs", "runs": 1}, "compare-flight": {"files": []},
                  "ingest": {"uploads": []}})
    simulations(plan)
    collections(plan)
    judged_routes()
    reaches()
    echoes()
    jobs()
    uploads()
    edr()
    data()
    unknown_parameters()
    missing()
except (KeyError, StopIteration, TypeError) as stopped:  # what was needed for the next question did not come
    faults.append(f"stopped: {stopped}")
print("\n".join(faults) if faults else f"{len(driven)} operations answer as they are described")
sys.exit(1 if faults else 0)
