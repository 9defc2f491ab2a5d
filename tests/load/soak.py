#!/usr/bin/env python3
"""Fifty simulated pilots work on a server for a while; its memory must not go on growing, nor may anything fail.

usage: soak.py PROGRAM [--minutes N] [--pilots N]

Meant for a program built with a sanitizer (presets asan and tsan): each report is a fault. Prints a line a minute; ends
with 1 if a request was answered wrongly, a sanitizer reported, or memory grew by more than a quarter in the second half.
"""
import argparse
import os
import pathlib
import random
import subprocess
import sys
import tempfile
import threading
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "faults"))
from served import Gone, Served  # noqa: E402

DEPART = "2026-11-22T06:00:00Z"
PLANS_AT_ONCE = threading.BoundedSemaphore(4)  # a sanitizer makes a plan take half a minute: more would only wait


class Pilot(threading.Thread):
    """Looks round, reports bergs, plans, exports, watches and cleans up, a little of each all the time."""

    def __init__(self, server, number, over):
        super().__init__(daemon=True)
        self.server, self.random, self.over = server, random.Random(number), over
        self.asked, self.faults, self.plans = 0, [], []

    def run(self):
        deeds = [self.look, self.look, self.look, self.plan, self.report, self.export, self.follow, self.mistake]
        while not self.over.is_set():
            try:
                self.random.choice(deeds)()
            except Gone as broken:
                if not self.over.is_set():
                    self.faults.append(f"no answer: {broken}")
            self.over.wait(self.random.uniform(0.1, 2.0))

    def expect(self, statuses, method, path, body=None, headers=None):
        self.asked += 1
        status, answer = self.server.ask(method, path, body, headers, timeout_s=300)
        if status not in statuses:
            self.faults.append(f"{method} {path}: {status}, not one of {statuses}: {str(answer)[:300]}")
        return answer if status in statuses else None

    def look(self):
        lon, lat = round(self.random.uniform(-54, -52), 3), round(self.random.uniform(68.5, 69.5), 3)
        self.expect((200,), "GET", self.random.choice((
            "/", "/api", "/collections", "/jobs?limit=10", "/datasets", "/collections/icebergs/items?limit=50", "/metrics",
            "/collections/plans/items?limit=5", "/collections/waypoints/items?limit=20", f"/probe?lon={lon}&lat={lat}&time={DEPART}",
            "/map/currents?bbox=-54,68.5,-52,69.5&nx=32&ny=32&time=" + DEPART, "/map/coast?bbox=-54,68.5,-52,69.5",
            f"/map/drift?bbox=-54,68,-50,70&as_of={DEPART}&until=2026-11-22T12:00:00Z")))
        self.expect((200, 404), "GET", f"/edr/collections/currents/position?coords=POINT({lon}+{lat})&datetime={DEPART}")

    def plan(self):
        goal = [round(self.random.uniform(-53.2, -52.8), 2), round(self.random.uniform(68.95, 69.05), 2)]
        inputs = {"from": [-53, 69], "to": goal, "depart": DEPART, "spacing_m": 2000, "refine": False}
        if not PLANS_AT_ONCE.acquire(blocking=False):
            self.look()
            return
        try:
            answer = self.expect((200, 400), "POST", "/processes/plan-route/execution", {"inputs": inputs}, {"Prefer": "respond-sync"})
        finally:
            PLANS_AT_ONCE.release()
        if answer and answer.get("plan", {}).get("plan_id"):
            self.plans.append(answer["plan"]["plan_id"])

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
            path = self.random.choice(("mission.zip?full=true", "mission.gpx", "mission.kml", "check", f"comparison?with={plan}"))
            self.expect((200, 400, 404), "GET", f"/collections/plans/items/{plan}/{path}")
        if len(self.plans) > 3:
            self.expect((204, 404), "DELETE", f"/collections/plans/items/{self.plans.pop(0)}")

    def follow(self):
        job = self.expect((201,), "POST", "/processes/echo/execution", {"inputs": {"pause": 1}}, {"Prefer": "respond-async"})
        if job:
            self.expect((200,), "GET", f"/jobs/{job['jobID']}/events")
            self.expect((200,), "DELETE", f"/jobs/{job['jobID']}")

    def mistake(self):
        self.expect((400,), "POST", "/processes/plan-route/execution", b"{" * self.random.randint(1, 2000))
        self.expect((404,), "GET", "/collections/plans/items/none")
        self.expect((400,), "GET", "/collections/icebergs/items?bbox=1,2")


def resident(process):
    with open(f"/proc/{process.pid}/status", encoding="ascii") as status:
        return next(int(line.split()[1]) // 1024 for line in status if line.startswith("VmRSS"))


def main():
    arguments = argparse.ArgumentParser()
    arguments.add_argument("program")
    arguments.add_argument("--minutes", type=float, default=20)
    arguments.add_argument("--pilots", type=int, default=50)
    given = arguments.parse_args()
    os.environ.setdefault("ASAN_OPTIONS", "detect_leaks=1:exitcode=66")
    support = pathlib.Path(__file__).resolve().parent.parent / "support"
    os.environ.setdefault("TSAN_OPTIONS", f"exitcode=66:suppressions={support / 'locks_of_libraries.txt'}")
    os.environ.setdefault("LSAN_OPTIONS", f"suppressions={support / 'leaks_of_libraries.txt'}")
    with tempfile.TemporaryDirectory(prefix="floeplan-soak-") as name:
        folder = pathlib.Path(name)
        subprocess.run([given.program, "demo", folder / "demo"], check=True, stdout=subprocess.DEVNULL)
        files = [path for path in (folder / "demo").iterdir() if path.suffix in (".nc", ".geojson")]
        subprocess.run([given.program, "--data", folder / "store", "ingest", *files], check=True, stdout=subprocess.DEVNULL)
        server = Served(given.program, folder / "store", ["--workers", "2"])
        over = threading.Event()
        pilots = [Pilot(server, number, over) for number in range(given.pilots)]
        for pilot in pilots:
            pilot.start()
        memory, end = [], time.monotonic() + 60 * given.minutes
        while time.monotonic() < end and server.process.poll() is None:
            over.wait(min(60, max(0.1, end - time.monotonic())))
            memory.append(resident(server.process))
            print(f"{sum(pilot.asked for pilot in pilots)} requests, {memory[-1]} MB, "
                  f"{sum(len(pilot.faults) for pilot in pilots)} faults", flush=True)
        over.set()
        for pilot in pilots:
            pilot.join(timeout=300)
        code = server.end()
        faults = [fault for pilot in pilots for fault in pilot.faults]
        reports = [line for line in server.said().splitlines() if "Sanitizer" in line or "runtime error" in line]
        if len(memory) > 3 and memory[-1] > 1.25 * memory[len(memory) // 2]:
            faults.append(f"memory grew: {memory} MB")
        if code != 0 or reports:
            faults += [f"the server ended by {code}"] + reports[:20]
            print(server.said()[-20000:] if reports else "")
    print("\n".join(faults[:30]) if faults else "no fault")
    return 1 if faults else 0


if __name__ == "__main__":
    raise SystemExit(main())
