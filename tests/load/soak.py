#!/usr/bin/env python3
"""Fifty simulated pilots work on a server for a while; its memory must not go on growing, nor may anything fail.

usage: soak.py PROGRAM [--minutes N] [--pilots N]

Meant for a program built with a sanitizer (presets asan and tsan): each report is a fault. Prints a line a minute; ends
with 1 if a request was answered wrongly, a sanitizer reported, or memory, threads or open files grew: the median of the
last quarter of the time is compared with that of the third, by when the caches are full. Less than four minutes are too
few to judge by.
"""
import argparse
import os
import pathlib
import random
import statistics
import subprocess
import sys
import tempfile
import threading
import time
import urllib.error
import urllib.request

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "faults"))
from served import Gone, Served  # noqa: E402

DEPART = "2026-11-22T06:00:00Z"
WORKS_AT_ONCE = threading.BoundedSemaphore(2)  # as many as the server's workers: more would only wait
PATIENCE_S = 900  # a sanitizer makes it take minutes to say what would help a request without a plan


class Pilot(threading.Thread):
    """Looks round, reports bergs, plans, evaluates, exports, uploads, watches and cleans up, a little of each all the
    time."""

    def __init__(self, server, number, over):
        super().__init__(daemon=True)
        self.server, self.random, self.over = server, random.Random(number), over
        self.asked, self.faults, self.plans = 0, [], []

    def run(self):
        deeds = [self.look, self.look, self.look, self.plan, self.evaluate, self.cancel, self.report, self.forbid, self.send,
                 self.export, self.follow, self.watch, self.mistake]
        while not self.over.is_set():
            try:
                self.random.choice(deeds)()
            except Gone as broken:
                if not self.over.is_set():
                    self.faults.append(f"no answer: {broken}")
            except (KeyError, TypeError) as unlike:
                self.faults.append(f"an answer of another shape: {unlike!r}")
            self.over.wait(self.random.uniform(0.1, 2.0))

    def expect(self, statuses, method, path, body=None, headers=None):
        self.asked += 1
        try:
            status, answer = self.server.ask(method, path, body, headers, timeout_s=PATIENCE_S)
        except Gone as broken:
            raise Gone(f"{method} {path} {str(body or '')[:300]}: {broken}") from None
        if status not in statuses:
            self.faults.append(f"{method} {path}: {status}, not one of {statuses}: {str(answer)[:300]}")
        return answer if status in statuses else None

    def look(self):
        lon, lat = round(self.random.uniform(-54, -52), 3), round(self.random.uniform(68.5, 69.5), 3)
        self.expect((200,), "GET", self.random.choice((
            "/", "/api", "/collections", "/jobs?limit=10", "/datasets", "/collections/icebergs/items?limit=50", "/metrics",
            "/collections/plans/items?limit=5", "/collections/waypoints/items?limit=20", f"/probe?lon={lon}&lat={lat}&time={DEPART}",
            f"/map/currents?bbox=-54,68.5,{lon + 2},69.5&nx=32&ny=32&time=" + DEPART, "/map/bathymetry?bbox=-54,68.5,-52,69.5&nx=32&ny=32",
            "/map/coast?bbox=-54,68.5,-52,69.5",
            f"/map/drift?bbox=-54,68,-50,70&as_of={DEPART}&until=2026-11-22T12:00:00Z")))
        self.expect((200, 404), "GET", f"/edr/collections/currents/position?coords=POINT({lon}+{lat})&datetime={DEPART}")

    def plan(self):
        goal = [round(self.random.uniform(-53.2, -52.8), 2), round(self.random.uniform(68.95, 69.05), 2)]
        inputs = {"from": [-53, 69], "to": goal, "depart": DEPART, "spacing_m": 2000, "refine": False}
        answer = self.work("plan-route", inputs)
        if answer and answer.get("plan", {}).get("plan_id"):
            self.plans.append(answer["plan"]["plan_id"])

    def work(self, process, inputs):
        """Waits for what comes of it, unless enough others do."""
        if not WORKS_AT_ONCE.acquire(blocking=False):
            self.look()
            return None
        try:
            return self.expect((200, 400), "POST", f"/processes/{process}/execution", {"inputs": inputs}, {"Prefer": "respond-sync"})
        finally:
            WORKS_AT_ONCE.release()

    def evaluate(self):
        if self.plans:
            depart = f"2026-11-22T{self.random.randint(6, 12):02}:00:00Z"
            self.work("evaluate-route", {"plan_id": self.random.choice(self.plans), "depart": depart})

    def cancel(self):
        """A plan that is given up while it is made, or before it is begun."""
        goal = [round(self.random.uniform(-52.2, -51.8), 3), 69.2]
        inputs = {"from": [-54, 68.6], "to": goal, "depart": DEPART, "spacing_m": 1000}
        job = self.expect((201, 503), "POST", "/processes/plan-route/execution", {"inputs": inputs}, {"Prefer": "respond-async"})
        if job and "jobID" in job:
            self.over.wait(self.random.uniform(0.0, 0.5))
            self.expect((200,), "DELETE", f"/jobs/{job['jobID']}")

    def send(self):
        """A grid of depths far from where anybody plans, read and removed again."""
        number = self.random.getrandbits(40)
        bed = f"ncols 20\nnrows 20\nxllcorner {number % 100}\nyllcorner 10\ncellsize 0.01\n"
        bed += "\n".join(" ".join(str(-100 - (number + row * column) % 997) for column in range(20)) for row in range(20))
        upload = self.expect((201,), "POST", f"/uploads?name=bed{number}.asc", bed.encode())
        if upload is None:
            return
        if self.random.random() < 0.3:
            self.expect((204,), "DELETE", f"/uploads/{upload['id']}")
            return
        done = self.expect((200,), "POST", "/processes/ingest/execution",
                           {"inputs": {"uploads": [upload["id"]], "positive": "up"}}, {"Prefer": "respond-sync"})
        for dataset in done["report"]["datasets"] if done else []:
            if dataset["status"] != "stored":
                self.faults.append(f"a grid of depths was not stored: {dataset}")
            self.expect((204,), "DELETE", f"/datasets/{dataset['dataset_id']}")
        self.expect((204,), "DELETE", f"/uploads/{upload['id']}")  # it would count for a day

    def forbid(self):
        ring = [[-40, 60], [-39, 60], [-39, 61], [-40, 60]]
        zone = {"type": "Feature", "geometry": {"type": "Polygon", "coordinates": [ring]},
                "properties": {"kind": "no_go", "name": f"range {self.random.random()}"}}
        if self.expect((201,), "POST", "/collections/nogo-zones/items", zone) is None:
            return
        page = self.expect((200,), "GET", "/collections/nogo-zones/items?limit=1000")
        mine = [kept["id"] for kept in page["features"] if kept["properties"]["name"] == zone["properties"]["name"]]
        for number in mine:
            path = f"/collections/nogo-zones/items/{number}"
            self.expect((204,), "PATCH", path, {"properties": {"name": "moved"}})
            self.expect((204,), "PUT", path, zone)
            self.expect((204,), "DELETE", path)

    def watch(self):
        """Follows what happens for a while and goes away without a word."""
        self.asked += 1
        try:
            with urllib.request.urlopen(self.server.address + "/events", timeout=2) as stream:
                for _ in range(self.random.randint(1, 20)):
                    stream.readline()
        except TimeoutError:
            pass
        except OSError as broken:
            # All pilots are one client to the server, which may have only a limited number of streams.
            refused = isinstance(broken, urllib.error.HTTPError) and broken.code == 429
            if not refused and not self.over.is_set():
                self.faults.append(f"the stream of events broke: {broken}")

    def report(self):
        feature = {"type": "Feature", "geometry": {"type": "Point", "coordinates": [-40.0, 60.0]},
                   "properties": {"berg_id": f"seen-{self.random.random()}", "observed": DEPART}}
        if self.expect((201,), "POST", "/collections/icebergs/items", feature) is None:
            return
        page = self.expect((200,), "GET", "/collections/icebergs/items?bbox=-41,59,-39,61&limit=1000")
        for berg in (page or {"features": []})["features"][:1]:
            self.expect((204, 404), "DELETE", f"/collections/icebergs/items/{berg['id']}")

    def export(self):
        if self.plans:
            plan = self.plans[-1]
            path = self.random.choice(("mission.zip?full=true", "mission.gpx", "mission.kml", "mission.pdf", "mission.html", "check",
                                       f"comparison?with={self.plans[0]}"))
            self.expect((200, 400, 404), "GET", f"/collections/plans/items/{plan}/{path}")
        if len(self.plans) > 3:
            self.expect((204, 404), "DELETE", f"/collections/plans/items/{self.plans.pop(0)}")

    def follow(self):
        job = self.expect((201,), "POST", "/processes/echo/execution", {"inputs": {"pause": 1}}, {"Prefer": "respond-async"})
        if job:
            self.expect((200, 429), "GET", f"/jobs/{job['jobID']}/events")
            self.expect((200,), "DELETE", f"/jobs/{job['jobID']}")

    def mistake(self):
        self.expect((400,), "POST", "/processes/plan-route/execution", b"{" * self.random.randint(1, 2000))
        self.expect((404,), "GET", "/collections/plans/items/none")
        self.expect((400,), "GET", "/collections/icebergs/items?bbox=1,2")


def taken(process):
    """What the server has of the machine: megabytes, threads, open files."""
    with open(f"/proc/{process.pid}/status", encoding="ascii") as status:
        lines = dict(line.split(":", 1) for line in status)
    return {"MB": int(lines["VmRSS"].split()[0]) // 1024, "threads": int(lines["Threads"]),
            "files": len(os.listdir(f"/proc/{process.pid}/fd"))}


def growth(samples):
    """The medians of the four quarters of the time, and what grew from the third to the last: by more than a tenth, and a
    few threads or files that happen to be in use."""
    quarter = len(samples) // 4
    medians = {what: [statistics.median(sample[what] for sample in samples[quarter * n:quarter * (n + 1)]) for n in range(4)]
               for what in samples[0]}
    few = {"MB": 0, "threads": 4, "files": 40}
    return medians, [what for what, found in medians.items() if found[3] > 1.1 * found[2] + few[what]]


def main():
    arguments = argparse.ArgumentParser()
    arguments.add_argument("program")
    arguments.add_argument("--minutes", type=float, default=20)
    arguments.add_argument("--pilots", type=int, default=50)
    given = arguments.parse_args()
    # What was freed is kept for a while, to tell of its use: no more than little, or it would pass for growth.
    os.environ.setdefault("ASAN_OPTIONS", "detect_leaks=1:exitcode=66:quarantine_size_mb=16")
    support = pathlib.Path(__file__).resolve().parent.parent / "support"
    os.environ.setdefault("TSAN_OPTIONS", f"exitcode=66:suppressions={support / 'locks_of_libraries.txt'}")
    os.environ.setdefault("LSAN_OPTIONS", f"suppressions={support / 'leaks_of_libraries.txt'}")
    with tempfile.TemporaryDirectory(prefix="floeplan-soak-") as name:
        folder = pathlib.Path(name)
        subprocess.run([given.program, "demo", folder / "demo", "--start", DEPART[:10]], check=True, stdout=subprocess.DEVNULL)
        files = [path for path in (folder / "demo").iterdir() if path.suffix in (".nc", ".tif", ".geojson")]
        subprocess.run([given.program, "--data", folder / "store", "ingest", *files], check=True, stdout=subprocess.DEVNULL)
        server = Served(given.program, folder / "store", ["--workers", "2"])
        over = threading.Event()
        pilots = [Pilot(server, number, over) for number in range(given.pilots)]
        for pilot in pilots:
            pilot.start()
        samples, end = [], time.monotonic() + 60 * given.minutes
        while time.monotonic() < end and server.process.poll() is None:
            over.wait(5)
            if server.process.poll() is not None:
                break
            samples.append(taken(server.process))
            if len(samples) % 12 == 0:
                print(f"{sum(pilot.asked for pilot in pilots)} requests, {samples[-1]}, "
                      f"{sum(len(pilot.faults) for pilot in pilots)} faults", flush=True)
        over.set()
        for pilot in pilots:
            pilot.join(timeout=PATIENCE_S)
        code = server.process.poll() if server.process.poll() is not None else server.end()
        faults = [fault for pilot in pilots for fault in pilot.faults]
        reports = [line for line in server.said().splitlines() if "Sanitizer" in line or "runtime error" in line]
        print(f"{sum(pilot.asked for pilot in pilots)} requests in all")
        if len(samples) >= 48:
            medians, grown = growth(samples)
            print(f"medians of the quarters: {medians}")
            faults += [f"{what} grew" for what in grown]
        if code != 0 or reports:
            faults += [f"the server ended by {code}"] + reports[:20]
            print(server.said()[-20000:])
    print("\n".join(faults[:30]) if faults else "no fault")
    return 1 if faults else 0


if __name__ == "__main__":
    raise SystemExit(main())
