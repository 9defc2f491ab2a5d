#!/usr/bin/env python3
"""Kills, starves and damages a server, and looks at what is left: nothing that was promised may be lost.

usage: faults.py PROGRAM [--kills N] [--seed S]

Prints a line for each fault; ends with 1 if something was lost, half done, done twice differently, or not said clearly.
"""
import argparse
import json
import os
import pathlib
import random
import resource
import signal
import sqlite3
import subprocess
import tempfile
import threading

import hostile_files
from served import Gone, Served

SIDE = 60
NOBODY = 65534
faults = []


def expect(held, what):
    if not held:
        faults.append(what)
        print("  BROKEN:", what, flush=True)


def grid(number):
    """A grid of depths of its own; each node's depth follows from its place."""
    rows = ["ncols %d\nnrows %d\nxllcorner %d\nyllcorner 50\ncellsize 0.01" % (SIDE, SIDE, number % 300 - 150)]
    rows += [" ".join(str(-100 - (row * 7 + column * 13 + number) % 97) for column in range(SIDE)) for row in range(SIDE)]
    return ("\n".join(rows) + "\n").encode()


# Files are ingested meanwhile, and a plan must be the same whichever of them it finds stored.
WITHOUT_DATA = {kind: "none" for kind in ("bathymetry", "coastline", "currents", "ice", "icebergs", "wind", "zones")}


def plan_inputs(generator):
    return {"from": [-53, 69], "to": [-53 + round(generator.uniform(0.3, 0.8), 4), 69.1],
            "depart": "2026-11-22T06:00:00Z", "spacing_m": generator.choice([300, 500]), "refine": False, **WITHOUT_DATA}


def lasting(result):
    """What of a result does not depend on how long the work took."""
    if isinstance(result, dict):
        return {name: lasting(value) for name, value in result.items() if name not in ("seconds", "ingested")}
    return [lasting(value) for value in result] if isinstance(result, list) else result


def integrity(store):
    # For reading alone: another program that moved the log to the database would write pages without their checksums.
    with sqlite3.connect(f"file:{store}/floeplan.sqlite?mode=ro", uri=True, timeout=30) as database:
        verdict = database.execute("PRAGMA integrity_check").fetchone()[0]
        broken = database.execute("PRAGMA foreign_key_check").fetchall()
    return verdict if not broken else f"broken references: {broken[:3]}"


class Client(threading.Thread):
    """Submits work and remembers what the server promised."""

    def __init__(self, server, generator, promised, first, hostile):
        super().__init__(daemon=True)
        self.hostile = hostile
        self.server, self.generator, self.promised, self.number = server, generator, promised, first

    def run(self):
        try:
            while True:
                self.number += 1
                self._submit("plan-route", plan_inputs(self.generator))
                if self.number % 3 == 0:
                    upload = self.server.upload(f"bed{self.number}.asc", grid(self.number))
                    self._submit("ingest", {"uploads": [upload], "positive": "up"})
                if self.number % 3 == 1:
                    name, content = self.generator.choice(self.hostile)
                    upload = self.server.upload(name, hostile_files.spoilt(content, self.generator))
                    self._submit("ingest", {"uploads": [upload]}, hostile=True)
                self._export()
        except Gone:
            pass

    def _submit(self, process, inputs, hostile=False):
        key = f"key-{self.generator.getrandbits(64):x}"
        status, answer = self.server.execute(process, inputs, key, wait=False)
        if status == 503 and answer["type"] == "/problems/queue-full":
            # Nothing was promised; where the machine is slow, work is handed in faster than it is done.
            if self.promised:
                self.server.ask("GET", "/jobs/" + self.promised[-1][0], headers={"Prefer": "wait=1"})
            return
        expect(status == 201, f"{process} was refused: {status} {answer}")
        if status == 201:
            self.promised.append((answer["jobID"], "hostile" if hostile else process, inputs, key))

    def _export(self):
        _, page = self.server.ask("GET", "/collections/plans/items?limit=1")
        for plan in page["features"]:
            status, files = self.server.ask("GET", f"/collections/plans/items/{plan['id']}/mission.zip?full=true")
            expect(status == 200 and files[:2] == b"PK", f"an export of {plan['id']} was answered by {status}")


def ended(server, job):
    while True:
        status, answer = server.ask("GET", "/jobs/" + job, headers={"Prefer": "wait=20"})
        if status != 200 or answer["status"] not in ("accepted", "running"):
            return answer.get("status", status), answer.get("message", "")


def kills(program, folder, count, generator):
    store, promised, given_up = folder / "killed", [], 0
    hostile = hostile_files.sample_of(store)
    for number in range(count):
        server = Served(program, store, ["--max-uploads", "100000"])  # one client sends thousands of files
        client = Client(server, generator, promised, 1000 * number, hostile)
        client.start()
        client.join(generator.uniform(0.0, 1.5))  # it works on: the moment of the kill is random
        server.end(signal.SIGKILL)
        client.join()
        verdict = integrity(store)
        expect(verdict == "ok", f"after kill {number + 1}: {verdict}")
        if number % 10 == 9 or number + 1 == count:
            given_up += settle(program, store, promised)
            promised.clear()
    print(f"{count} kills: every promised job was kept, {given_up} given up after three attempts", flush=True)


def all_have_ended(server):
    """Those, too, whose acceptance was stored but did not reach the client before the kill."""
    def of(state):
        return server.ask("GET", f"/jobs?status={state}")[1]["jobs"]

    while left := of("accepted") + of("running"):
        ended(server, left[0]["jobID"])


def settle(program, store, promised):
    """Everything promised ends; what was asked for twice is the same; what is stored is whole."""
    server = Served(program, store)
    given_up = 0
    for job, process, inputs, key in promised:
        status, message = ended(server, job)
        if status == "failed" and "begun 3 times" in message:
            given_up += 1
            continue
        if process == "hostile":
            expect(status in ("failed", "successful"), f"a hostile file {job} ended {status}: {message}")
            continue
        expect(status == "successful", f"{process} {job} ended {status}: {message}")
        again, answer = server.execute(process, inputs, key, wait=False)
        expect(again == 201 and answer["jobID"] == job, f"the key of {job} began another job: {answer}")
    plans = [entry for entry in promised if entry[1] == "plan-route"]
    for job, process, inputs, _ in plans[:2]:
        status, first = server.ask("GET", f"/jobs/{job}/results")
        _, second = server.ask("POST", f"/processes/{process}/execution", {"inputs": inputs, "force": True})
        expect(status != 200 or lasting(first) == lasting(second), f"{job} done again gave another result")
    _, listed = server.ask("GET", "/datasets")
    wanted = sum(1 for entry in promised if entry[1] == "ingest")
    whole = [entry for entry in listed["datasets"] if entry["rows_accepted"] == SIDE * SIDE]
    expect(len(whole) == len(listed["datasets"]), "a dataset is not whole")
    expect(len(whole) + given_up >= wanted, f"{wanted} files were ingested, {len(whole)} are there")
    for entry in whole[:3]:
        west, south = entry["bbox"][:2]
        status, place = server.ask("GET", f"/probe?lon={west + 0.3}&lat={south + 0.3}&dataset={entry['id']}")
        expect(status == 200 and place["depth_m"] is not None, f"{entry['id']} has no depth: {place}")
    all_have_ended(server)
    expect(not os.listdir(store / "incoming") if (store / "incoming").exists() else True, "files of a killed worker are left")
    expect(server.end() == 0, "the server did not end well")
    return given_up


def full_disk(program, folder):
    """The files may not grow beyond a size: what comes after is refused, and what was promised is kept."""
    store = folder / "full"
    Served(program, store).end()
    room = (store / "floeplan.sqlite").stat().st_size + 300_000
    server = Served(program, store, limits=[(resource.RLIMIT_FSIZE, room)])
    generator, promised, refusal = random.Random(1), [], None
    for number in range(3000):
        status, answer = server.execute("plan-route", plan_inputs(generator), wait=False)
        if status != 201:
            refusal = status, answer
            break
        promised.append(answer["jobID"])
    expect(refusal is not None and refusal[0] in (503, 507) and refusal[1]["type"] != "/problems/internal-error",
           f"a full disk is answered by {refusal}")
    status, answer = server.ask("POST", "/uploads?name=large.asc", b"x" * (room + 100_000))
    expect(status == 507, f"an upload to a full disk is answered by {status} {answer}")
    for path in ("/healthz", "/jobs?limit=5", "/datasets"):
        expect(server.ask("GET", path)[0] == 200, f"{path} is not answered while the disk is full")
    expect(server.end() == 0, "the server did not end well")
    server = Served(program, store)
    for job in promised:
        status, message = ended(server, job)
        expect(status == "successful", f"{job} ended {status}: {message}")
    server.end()
    expect(integrity(store) == "ok", "the store is damaged")
    shown = refusal and (refusal[0], refusal[1].get("detail", refusal[1]))
    print(f"full disk: {len(promised)} jobs were promised and kept, the next was answered {shown}", flush=True)

    (folder / "bed.asc").write_bytes(grid(7))
    limit = lambda: resource.setrlimit(resource.RLIMIT_FSIZE, (20_000, 20_000))
    said = subprocess.run([program, "--data", str(folder / "full2"), "ingest", "--positive", "up", str(folder / "bed.asc")],
                          capture_output=True, text=True, preexec_fn=limit, check=False)
    expect(said.returncode in (1, 3) and "floeplan: " in said.stderr, f"ingest on a full disk: {said}")
    print(f"full disk, command line: exit {said.returncode}: {said.stderr.strip()[:200]}", flush=True)


def read_only(program, folder):
    store = folder / "readonly"
    Served(program, store).end()
    folder.chmod(0o755)
    for path in [store, *store.rglob("*")]:
        path.chmod(0o555 if path.is_dir() else 0o444)
    user = NOBODY if os.getuid() == 0 else None
    server = Served(program, store, user=user)
    code = server.process.wait(30) if server.address is None else None
    expect(code == 1, f"a store that cannot be written is served: {code}")
    print(f"read-only store: exit {code}: {server.said().strip()[:200]}", flush=True)


def damaged(program, folder):
    """A page is overwritten while nobody serves, and one below a server."""
    store = folder / "damaged"
    server = Served(program, store)
    generator = random.Random(2)
    for _ in range(10):
        server.execute("plan-route", plan_inputs(generator))
    server.end()
    database = store / "floeplan.sqlite"
    sound = database.read_bytes()

    def overwrite(first):
        with open(database, "r+b") as file:
            for page in range(first, len(sound) // 4096):
                file.seek(page * 4096)
                file.write(b"\x7f" * 4096)

    overwrite(len(sound) // 4096 - 6)
    server = Served(program, store)
    expect(server.ask("GET", "/readyz")[1].get("damaged_pages") == 6, "a server does not say that its store is damaged")
    expect(server.ask("GET", "/healthz")[0] == 200, "what is whole of a damaged store is not served")
    server.end()
    verified = subprocess.run([program, "--data", str(store), "verify"], capture_output=True, text=True, check=False)
    expect(verified.returncode == 3 and "damaged" in verified.stdout, f"damage is not named: {verified}")
    print(f"damaged pages: {verified.stdout.splitlines()[0]}", flush=True)
    database.write_bytes(sound)
    for rest in ("floeplan.sqlite-wal", "floeplan.sqlite-shm"):
        (store / rest).unlink(missing_ok=True)

    server = Served(program, store)
    overwrite(3)
    answers = {}
    for path in ("/healthz", "/collections/plans/items", "/jobs", "/datasets", "/audit"):
        status, answer = server.ask("GET", path)
        answers[path] = status
        expect(status in (200, 503), f"{path} of a damaged store is answered by {status}: {answer}")
    status, answer = server.ask("POST", "/uploads?name=bed.asc", grid(1))
    answers["upload"] = status
    expect(status in (201, 503), f"an upload to a damaged store is answered by {status}: {answer}")
    expect(server.process.poll() is None, "the server has ended")
    server.end(signal.SIGKILL)
    print(f"page damaged below a server: {answers}", flush=True)


def out_of_memory(program, folder):
    """A plan that needs more memory than there is fails by itself and says so; the server goes on."""
    store = folder / "memory"
    resting = Served(program, store, ["--workers", "1"])
    limit = address_space(resting.process.pid) + 120_000_000
    resting.end()
    server = Served(program, store, ["--workers", "1"], limits=[(resource.RLIMIT_AS, limit)])
    expect(server.address is not None, f"the server does not start: {server.said()}")
    large = {"from": [-60, 50], "to": [-20, 50], "depart": "2026-11-22T06:00:00Z", "spacing_m": 900, "sectors": 5, "refine": False}
    status, answer = server.execute("plan-route", large, wait=False)
    expect(status == 201, f"the large plan was refused: {status} {answer}")
    told = ended(server, answer["jobID"])
    while told[0] == 503:
        told = ended(server, answer["jobID"])
    expect(told[0] == "failed" and "enough memory" in told[1], f"a plan without memory ended {told}")
    expect(server.ask("GET", "/healthz")[0] == 200, "the server does not answer any more")
    small = {"from": [-53, 69], "to": [-52.9, 69], "depart": "2026-11-22T06:00:00Z", "refine": False}
    status, answer = server.execute("plan-route", small)
    expect(status == 200, f"a small plan after it is answered by {status} {answer}")
    expect(server.end() == 0, "the server did not end well")
    print(f"worker out of memory: {told}", flush=True)


def address_space(pid):
    with open(f"/proc/{pid}/status", encoding="ascii") as status:
        return next(1024 * int(line.split()[1]) for line in status if line.startswith("VmSize"))


def main():
    arguments = argparse.ArgumentParser(description="Kills, starves and damages a server.")
    arguments.add_argument("program")
    arguments.add_argument("--kills", type=int, default=200)
    arguments.add_argument("--seed", type=int, default=1)
    given = arguments.parse_args()
    generator = random.Random(given.seed)
    with tempfile.TemporaryDirectory(prefix="floeplan-faults-") as name:
        folder = pathlib.Path(name)
        for fault in (read_only, full_disk, damaged, out_of_memory):
            fault(given.program, folder)
        kills(given.program, folder, given.kills, generator)
    print(json.dumps(faults, indent=1) if faults else "nothing was lost", flush=True)
    return 1 if faults else 0


if __name__ == "__main__":
    raise SystemExit(main())
