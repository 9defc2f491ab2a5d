#!/usr/bin/env python3
"""Kills nodes that share a store, and the database server below them: each job that was promised is done, once.

usage: lost_nodes.py PROGRAM [--jobs N] [--kills K] [--seed S] [--long]

Two servers that only answer, three workers, two clients. `--long` also cuts a node off from the database, slows the database
down, fills its disk, and restores it to a moment of the past. Prints a line for each fault; ends with 1 if a job was lost or doubled, or has a wrong
result; with 77 where PostgreSQL is not installed.
"""
import argparse
import json
import os
import pathlib
import random
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import threading
import time

from postgresql import Database, programs
from served import Gone, Served

faults = []


def expect(held, what):
    if not held:
        faults.append(what)
        print("  BROKEN:", what, flush=True)


class Nodes:
    """Two servers and three workers at one store. Each has a folder of its own."""

    def __init__(self, program, folder, store, environments=None):
        """`environments` of the nodes that have one of their own, by their names."""
        self.program, self.folder, self.store = program, folder, store
        self.environments = environments or {}
        self.changed = threading.Condition()  # somebody who was gone may be back
        self.places = [("serve", "server1"), ("serve", "server2"), ("worker", "worker1"), ("worker", "worker2"), ("worker", "worker3")]
        self.nodes = {name: self._begin(command, name) for command, name in self.places}

    def _begin(self, command, name):
        flags = ["--workers", "0"] if command == "serve" else ["--workers", "2"]
        return Served(self.program, self.folder / name, flags, before=["--store", self.store, "--log-level", "error"],
                      command=command, environment=self.environments.get(name))

    def servers(self):
        return [self.nodes[name] for command, name in self.places if command == "serve"]

    def kill(self, command, name):
        """Kills a node and starts it again."""
        self.nodes[name].end(signal.SIGKILL)
        self.nodes[name] = self._begin(command, name)
        self.tell_of_change()

    def tell_of_change(self):
        with self.changed:
            self.changed.notify_all()

    def wait_for_change(self, most_s):
        with self.changed:
            self.changed.wait(most_s)

    def end(self):
        for name, node in self.nodes.items():
            expect(node.end() == 0, f"{name} did not end well: {node.said()[-300:]}")


class Client(threading.Thread):
    """Submits jobs to any server until it has as many promises as it wants. One that is not answered asks again with its
    key, maybe at the other server: so a promise that did not arrive makes no second job."""

    def __init__(self, nodes, generator, wanted, number, text_of=0):
        """`text_of`: the length of the jobs' texts, at least."""
        super().__init__(daemon=True)
        self.nodes, self.generator, self.wanted, self.number, self.text_of = nodes, generator, wanted, number, text_of
        self.refused = None  # an event: a server could not keep a job
        self.promised = {}  # job: what it must answer
        self.has_a_third = threading.Event()  # of what it wants
        self.longest_silence_s, self.answered_at = 0.0, time.monotonic()

    def run(self):
        for count in range(self.wanted):
            text = f"client {self.number}, job {count}".ljust(self.text_of, ".")
            self.promised[self._submit(text, f"key-{self.number}-{count}")] = text
            if count >= self.wanted // 3:
                self.has_a_third.set()

    def _submit(self, text, key):
        while True:
            try:
                server = self.generator.choice(self.nodes.servers())
                status, answer = server.ask("POST", "/processes/echo/execution", {"inputs": {"text": text}},
                                            {"Prefer": "respond-async", "Idempotency-Key": key}, timeout_s=40)
                if status == 201:
                    now = time.monotonic()
                    self.longest_silence_s = max(self.longest_silence_s, now - self.answered_at)
                    self.answered_at = now
                    return answer["jobID"]
                expect(status in (503, 507), f"a job was answered by {status}: {answer}")
                if answer["type"] == "/problems/queue-full":
                    server.ask("GET", f"/jobs/{next(reversed(self.promised))}", headers={"Prefer": "wait=1"})
                    self.answered_at = time.monotonic()
                    continue
                if self.refused:
                    self.refused.set()
            except (Gone, KeyError):
                pass
            self.nodes.wait_for_change(0.5)


def have_ended(nodes, most_s):
    """Waits until no job is left to do. Time: leases of killed workers must expire first."""
    deadline = time.monotonic() + most_s
    while time.monotonic() < deadline:
        answers = [nodes.servers()[0].ask("GET", f"/jobs?status={state}") for state in ("accepted", "running")]
        if any(status != 200 for status, _ in answers):
            nodes.wait_for_change(0.5)
            continue
        left = [job for _, answer in answers for job in answer["jobs"]]
        if not left:
            return True
        nodes.servers()[0].ask("GET", "/jobs/" + left[0]["jobID"], headers={"Prefer": "wait=20"})
    return False


def look_at(database, promised):
    """What the store says of all jobs. Returns how many were given up after three attempts."""
    rows = {row[0]: row for row in database.query(
        "SELECT id, status, replace(coalesce(result_json, ''), chr(10), ' '), attempts, message FROM job")}
    expect(len(rows) == len(promised), f"{len(promised)} jobs were promised, {len(rows)} are in the store")
    given_up = 0
    for job, text in promised.items():
        if job not in rows:
            expect(False, f"job {job} is lost")
            continue
        _, status, result, attempts, message = rows[job]
        if status == "failed" and message.startswith("begun 3 times"):
            given_up += 1
            continue
        expect(status == "successful", f"job {job} ended {status} after {attempts} attempts: {message}")
        expect(status != "successful" or json.loads(result)["text"] == text, f"job {job} has the result {result}, not {text}")
    return given_up


def killed_nodes(program, folder, jobs, kills, generator):
    folder.mkdir()
    database = Database(folder / "database")
    nodes = Nodes(program, folder, database.address)
    clients = [Client(nodes, random.Random(generator.random()), jobs // 2, number) for number in range(2)]
    for client in clients:
        client.start()
    for _ in range(kills):
        clients[0].join(generator.uniform(0.0, 0.4))  # it works on: the moment of the kill is random
        nodes.kill(*generator.choice(nodes.places))
    for client in clients:
        client.join()
    expect(have_ended(nodes, 300), "jobs did not end")
    promised = {job: text for client in clients for job, text in client.promised.items()}
    given_up = look_at(database, promised)
    nodes.end()
    database.end()
    print(f"{kills} kills of nodes: {len(promised)} jobs promised, none lost, none doubled, {given_up} given up after three "
          "attempts" if not faults else f"{kills} kills of nodes: see above", flush=True)


def lost_primary(program, folder, jobs, generator):
    """The database server is killed under load, and its synchronous standby takes its place."""
    folder.mkdir()
    primary = Database(folder / "primary", settings=["synchronous_standby_names=standby"])
    # Until there is a standby, a commit would wait for it.
    standby = Database(folder / "standby", copy_of=primary)
    store = f"postgresql://floeplan@/postgres?host={primary.folder},{standby.folder}&target_session_attrs=read-write"
    nodes = Nodes(program, folder, store)
    clients = [Client(nodes, random.Random(generator.random()), jobs // 2, number) for number in range(2)]
    for client in clients:
        client.start()
    for client in clients:
        client.has_a_third.wait()
    for client in clients:
        client.longest_silence_s = 0.0
    primary.kill()
    standby.promote()
    # The one that is left now has nobody to wait for.
    standby.query("ALTER SYSTEM SET synchronous_standby_names = ''")
    standby.query("SELECT pg_reload_conf()")
    nodes.tell_of_change()
    for client in clients:
        client.join()
    expect(have_ended(nodes, 300), "jobs did not end after the promotion")
    promised = {job: text for client in clients for job, text in client.promised.items()}
    look_at(standby, promised)
    silence_s = max(client.longest_silence_s for client in clients)
    expect(silence_s <= 30.0, f"no server took a job for {silence_s:.1f} s after the promotion")
    status, answer = nodes.servers()[0].ask("GET", "/readyz")
    expect(status == 200, f"a server is not ready after the promotion: {answer}")
    nodes.end()
    standby.end()
    print(f"primary killed, standby promoted: {len(promised)} jobs promised, no job taken for {silence_s:.1f} s", flush=True)


CLOCK_OFF = """
#define _GNU_SOURCE
#include <dlfcn.h>
#include <stdlib.h>
#include <time.h>
int clock_gettime(clockid_t clock, struct timespec *time) {
  static int (*real)(clockid_t, struct timespec *);
  if (!real) real = (int (*)(clockid_t, struct timespec *))dlsym(RTLD_NEXT, "clock_gettime");
  const int result = real(clock, time);
  if (result == 0 && clock == CLOCK_REALTIME) time->tv_sec += atoi(getenv("CLOCK_OFF_S"));
  return result;
}
"""


def clocks_off(program, folder, jobs, generator):
    """The clocks of two workers and a server are wrong by an hour. Leases go by the database's clock: no job is taken from a
    worker that lives."""
    if not shutil.which("cc"):
        print("clocks off by an hour: left out, there is no C compiler", flush=True)
        return
    folder.mkdir()
    (folder / "clock_off.c").write_text(CLOCK_OFF)
    subprocess.run(["cc", "-shared", "-fPIC", "-o", folder / "clock_off.so", folder / "clock_off.c", "-ldl"], check=True)
    off = {name: {**os.environ, "LD_PRELOAD": str(folder / "clock_off.so"), "CLOCK_OFF_S": seconds}
           for name, seconds in (("worker1", "3600"), ("worker2", "-3600"), ("server2", "3600"))}
    database = Database(folder / "database")
    nodes = Nodes(program, folder, database.address, off)
    clients = [Client(nodes, random.Random(generator.random()), jobs // 2, number) for number in range(2)]
    for number in range(6):  # two for each worker, long enough to be taken away
        nodes.servers()[number % 2].ask("POST", "/processes/echo/execution", {"inputs": {"text": "long", "pause": 3}},
                                        {"Prefer": "respond-async"})
    for client in clients:
        client.start()
    for client in clients:
        client.join()
    expect(have_ended(nodes, 120), "jobs did not end while clocks were off")
    again = database.query("SELECT count(*) FROM job WHERE attempts <> 1 OR status <> 'successful'")
    expect(again == [["0"]], f"{again[0][0]} jobs were taken from a worker that lived, or did not end")
    nodes.end()
    database.end()
    print(f"clocks off by an hour: {jobs + 6} jobs, each begun once", flush=True)


class Line:
    """A line to a database that can be slow, and cut: whoever is connected loses the connection, and nobody gets a new one."""

    def __init__(self, database, delay_s=0.0):
        """`delay_s`: what passes takes this long, each way."""
        self.database, self.delay_s, self.is_cut, self.ends = database, delay_s, threading.Event(), []
        self.door = socket.create_server(("127.0.0.1", 0))
        self.address = f"postgresql://floeplan@127.0.0.1:{self.door.getsockname()[1]}/postgres?sslmode=disable"
        threading.Thread(target=self._accept, daemon=True).start()

    def _accept(self):
        while True:
            near, _ = self.door.accept()
            if self.is_cut.is_set():
                near.close()
                continue
            far = socket.socket(socket.AF_UNIX)
            far.connect(str(self.database.folder / ".s.PGSQL.5432"))
            self.ends += [near, far]
            for ends in ((near, far), (far, near)):
                threading.Thread(target=self._carry, args=ends, daemon=True).start()

    def _carry(self, source, target):
        try:
            while data := source.recv(1 << 16):
                if self.is_cut.wait(self.delay_s):
                    return
                target.sendall(data)
            target.shutdown(socket.SHUT_WR)
        except OSError:
            pass

    def cut(self):
        self.is_cut.set()
        for end in self.ends:
            try:
                end.shutdown(socket.SHUT_RDWR)
            except OSError:
                pass
            end.close()
        self.ends = []

    def mend(self):
        self.is_cut.clear()


def cut_off(program, folder):
    """A worker is cut off from the database for longer than its lease. Its job is done by another, once; it works on when the
    line is mended."""
    folder.mkdir()
    database = Database(folder / "database")
    line = Line(database)
    flags, quiet = ["--workers", "2"], ["--log-level", "error"]
    server = Served(program, folder / "server", ["--workers", "0"], before=["--store", database.address, *quiet])
    lonely = Served(program, folder / "lonely", flags, before=["--store", line.address], command="worker")

    def submit(pause_s):
        return server.ask("POST", "/processes/echo/execution", {"inputs": {"text": "ice", "pause": pause_s}},
                          {"Prefer": "respond-async"})[1]["jobID"]

    def succeeds(job, most_s):
        deadline = time.monotonic() + most_s
        status = "accepted"
        while status in ("accepted", "running") and time.monotonic() < deadline:
            status = server.ask("GET", "/jobs/" + job, headers={"Prefer": "wait=20"})[1]["status"]
        return status == "successful"

    first = submit(10)
    expect(lonely.says(f"job={first} process=echo attempt=1 begins", 20), "the worker took no job")
    line.cut()
    other = Served(program, folder / "other", flags, before=["--store", database.address, *quiet], command="worker")
    expect(succeeds(first, 90), "nobody did the job of a worker that was cut off")
    expect(lonely.ask("GET", "/readyz")[0] == 503, "a worker that cannot reach the database says that it is ready")
    expect(other.end() == 0, "a worker did not end well")
    line.mend()
    expect(succeeds(submit(0), 60), "the worker that was cut off does not work again")
    expect(lonely.ask("GET", "/readyz")[0] == 200, "a worker that reaches the database again is not ready")
    rows = database.query(f"SELECT status, attempts FROM job WHERE id = '{first}'")
    expect(rows == [["successful", "2"]], f"the job of a worker that was cut off is {rows}")
    for node in (server, lonely):
        expect(node.end() == 0, "a node did not end well")
    database.end()
    print("worker cut off from the database: its job was done by another, and it works again", flush=True)


WINDOW = {"from": [-53, 69], "to": [-50, 67], "depart": "2026-11-20T06:00:00Z", "depart_until": "2026-11-24T06:00:00Z",
          "depart_step": "PT1H", "spacing_m": 1500, "refine": False}


def of_plan(answer):
    """What a plan says, without the time that it took."""
    return {name: answer["plan"][name] for name in ("plan_id", "waypoints", "departures")} if "plan" in answer else answer


def shared_windows(program, folder, windows, kills, generator):
    """Workers do windows of departures together, and are killed: each window ends as one worker alone ends it."""
    folder.mkdir()
    wanted = [{**WINDOW, "speed_m_s": 0.3 + 0.02 * number} for number in range(windows)]
    alone = Served(program, folder / "alone", before=["--log-level", "error"])
    right = [of_plan(alone.execute("plan-route", inputs)[1]) for inputs in wanted]
    alone.end()

    database = Database(folder / "database")
    nodes = Nodes(program, folder, database.address)
    server = nodes.servers()[0]
    jobs = [server.execute("plan-route", inputs, wait=False)[1]["jobID"] for inputs in wanted]
    for _ in range(kills):
        server.ask("GET", "/jobs/" + jobs[-1], headers={"Prefer": f"wait={generator.randint(1, 3)}"})
        nodes.kill(*generator.choice(nodes.places[2:]))
    expect(have_ended(nodes, 300), "windows did not end")
    for job, plan in zip(jobs, right):
        status, answer = server.ask("GET", f"/jobs/{job}/results")
        if status != 200 and "begun 3 times" in json.dumps(answer):
            continue
        expect(status == 200 and of_plan(answer) == plan, f"window {job} is another plan: {json.dumps(answer)[:200]}")
    left = database.query("SELECT count(*) FROM job_part")
    expect(left == [["0"]], f"{left[0][0]} parts of ended jobs are left")
    nodes.end()
    database.end()
    print(f"{kills} kills of workers that share {windows} windows: each plan is the one of a single worker", flush=True)


def slow_database(program, folder, jobs, generator):
    """Each word to the database and back takes a tenth of a second: slower, but each job once."""
    folder.mkdir()
    database = Database(folder / "database")
    line = Line(database, delay_s=0.05)
    nodes = Nodes(program, folder, line.address)
    clients = [Client(nodes, random.Random(generator.random()), jobs // 2, number) for number in range(2)]
    for client in clients:
        client.start()
    for client in clients:
        client.join()
    expect(have_ended(nodes, 300), "jobs did not end at a slow database")
    look_at(database, {job: text for client in clients for job, text in client.promised.items()})
    again = database.query("SELECT count(*) FROM job WHERE attempts <> 1")
    expect(again == [["0"]], f"{again[0][0]} jobs were begun again because the database is slow")
    for server in nodes.servers():
        expect(server.ask("GET", "/readyz")[0] == 200, "a server is not ready because the database is slow")
    nodes.end()
    database.end()
    print(f"slow database: {jobs} jobs promised, each begun once", flush=True)


def full_disk(program, folder, jobs, generator):
    """The disk of the database is full for a while. What is not written is not promised, and what was promised is done."""
    folder.mkdir()
    disk = folder / "disk"
    disk.mkdir()
    if subprocess.run(["mount", "-t", "tmpfs", "-o", "size=64m,mode=0777", "tmpfs", disk], capture_output=True).returncode != 0:
        print("full disk: left out, this user may not mount a small disk", flush=True)
        return
    try:
        database = Database(folder / "database")
        space = disk / "tables"
        space.mkdir()
        shutil.chown(space, database.user)
        database.query(f"CREATE TABLESPACE small LOCATION '{space}'")
        database.query("ALTER DATABASE postgres SET default_tablespace = small")
        nodes = Nodes(program, folder, database.address)
        clients = [Client(nodes, random.Random(generator.random()), jobs // 2, number, text_of=4000) for number in range(2)]
        for client in clients:
            client.start()
        for client in clients:
            client.has_a_third.wait()
        filler = disk / "filler"
        with filler.open("wb", buffering=0) as out:
            try:
                while out.write(b"\0" * 4096):
                    pass
            except OSError:
                pass  # it is full
        refused = threading.Event()
        for client in clients:
            client.refused = refused
        expect(refused.wait(60), "a full disk was not noticed")
        filler.unlink()
        nodes.tell_of_change()
        for client in clients:
            client.join()
        expect(have_ended(nodes, 300), "jobs did not end after the disk was full")
        look_at(database, {job: text for client in clients for job, text in client.promised.items()})
        for server in nodes.servers():
            expect(server.ask("GET", "/readyz")[0] == 200, "a server is not ready after the disk was full")
        nodes.end()
        database.end()
        print(f"disk of the database full for a while: {jobs} jobs promised, each done once", flush=True)
    finally:
        subprocess.run(["umount", disk], check=False)


def restored(program, folder, generator):
    """A database is restored to a moment of the past from a base backup and its log: what was promised before is there."""
    folder.mkdir()
    archive = folder / "archive"
    archive.mkdir()
    archive.chmod(0o777)
    database = Database(folder / "database", settings=["archive_mode=on", f"archive_command=cp %p {archive}/%f"])
    server = Served(program, folder / "node", before=["--store", database.address, "--log-level", "error"])

    def submit(count):
        return [server.ask("POST", "/processes/echo/execution", {"inputs": {"text": str(generator.random())}},
                           {"Prefer": "respond-async"})[1]["jobID"] for _ in range(count)]

    before = submit(50)
    copy = Database(folder / "copy", copy_of=database, starts=False)
    before += submit(50)
    moment = database.query("SELECT clock_timestamp()")[0][0]
    after = submit(50)
    database.query("SELECT pg_switch_wal()")
    server.end()
    database.end()  # which archives the rest of its log
    (copy.data / "standby.signal").unlink()
    (copy.data / "recovery.signal").touch()
    copy.start(["archive_mode=off", f"restore_command=cp {archive}/%f %p", f"recovery_target_time={moment}",
                "recovery_target_action=promote"], ready="ready to accept connections")
    server = Served(program, folder / "node", before=["--store", copy.address, "--log-level", "error"])
    there = {row[0] for row in copy.query("SELECT id FROM job")}
    expect(there == set(before), f"{len(set(before) - there)} jobs of before and {len(there & set(after))} of after are there")
    status, answer = server.ask("GET", "/readyz")
    expect(status == 200, f"a server at the restored database is not ready: {answer}")
    server.end()
    copy.end()
    print(f"restored to a moment: {len(before)} jobs of before are there, {len(after)} of after are not", flush=True)


def main():
    arguments = argparse.ArgumentParser(description="Kills nodes that share a store, and the database server below them.")
    arguments.add_argument("program")
    arguments.add_argument("--jobs", type=int, default=10_000)
    arguments.add_argument("--kills", type=int, default=200)
    arguments.add_argument("--seed", type=int, default=1)
    arguments.add_argument("--long", action="store_true")
    given = arguments.parse_args()
    if programs() is None:
        print("skipped: no PostgreSQL server is installed (deploy/install-deps --with-tests does)")
        return 77
    generator = random.Random(given.seed)
    with tempfile.TemporaryDirectory(prefix="floeplan-nodes-") as name:
        folder = pathlib.Path(name)
        folder.chmod(0o755)
        killed_nodes(given.program, folder / "killed", given.jobs, given.kills, generator)
        lost_primary(given.program, folder / "promoted", max(given.jobs // 5, 90), generator)
        clocks_off(given.program, folder / "clocks", 40, generator)
        shared_windows(given.program, folder / "windows", 6, 8 if given.long else 2, generator)
        if given.long:
            cut_off(given.program, folder / "cut")
            slow_database(given.program, folder / "slow", 60, generator)
            full_disk(given.program, folder / "full", 2000, generator)
            restored(given.program, folder / "restored", generator)
    print(json.dumps(faults[:20], indent=1) if faults else "nothing was lost", flush=True)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
