#!/usr/bin/env python3
"""Attacks a server on loopback and watches what others notice: how soon they are answered, and its memory.

usage: attack.py PROGRAM             starts a server of its own, on an empty store, with a token for an admin
       attack.py PORT PID TOKEN      nothing but a server of your own; the token of an admin
Ends with 1 if a bound was broken.

Bounds: of others' requests 99 of 100 are answered within 100 ms, the server takes less than 1 GB, and nothing is answered by
5xx but 503. Each attack goes on until others have made 200 requests. What they notice while nobody attacks is printed first:
on a busy machine it is no less.
"""
import concurrent.futures
import gzip
import http.client
import json
import multiprocessing
import os
import pathlib
import random
import resource
import socket
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "faults"))
from served import Served  # noqa: E402

if len(sys.argv) == 2:
    STORE = tempfile.TemporaryDirectory(prefix="floeplan-attack-")
    TOKEN = subprocess.run([sys.argv[1], "--data", STORE.name, "token", "add", "attacked", "--role", "admin"],
                           capture_output=True, text=True, check=True).stdout.split()[-1]
    SERVER = Served(sys.argv[1], STORE.name)
    PORT, PID = int(SERVER.address.rsplit(":", 1)[1]), SERVER.process.pid
else:
    SERVER, PORT, PID, TOKEN = None, int(sys.argv[1]), int(sys.argv[2]), sys.argv[3]
AUTHORIZED = {"Authorization": "Bearer " + TOKEN}
LONGEST_S, MOST_BYTES = 0.1, 1_000_000_000
FEWEST_OTHERS = 200  # or the slowest hundredth would be a single request

faults = []


IDLE = 10_000


def memory():
    with open(f"/proc/{PID}/status", encoding="ascii") as status:
        return next(int(line.split()[1]) * 1024 for line in status if line.startswith("VmRSS"))


class Bystander:
    """Asks for the health every few milliseconds, each time on a connection of its own. It does so in a process of its
    own: the threads of this one would wait for each other, and that would be taken for the server's slowness."""

    def __init__(self):
        self.times, self.failed, self.most_memory = [], 0, 0
        self.over, self.found = multiprocessing.Event(), multiprocessing.Queue()
        self.asked, self.count = multiprocessing.Semaphore(0), multiprocessing.Value("i", 0)
        self.process = multiprocessing.Process(target=self._ask, daemon=True)
        self.process.start()

    def watches(self, requests):
        """Waits until it has made this number of further requests, or has completed none for 20 s."""
        while self.asked.acquire(block=False):
            pass
        for _ in range(requests):
            if not self.asked.acquire(timeout=20):
                return

    def stop(self):
        self.over.set()
        self.times, self.failed, self.most_memory = self.found.get(timeout=60)
        self.process.join()

    def _ask(self):
        while not self.times or not self.over.is_set():
            begin = time.monotonic()
            try:
                connection = http.client.HTTPConnection("127.0.0.1", PORT, timeout=10)
                connection.request("GET", "/healthz", headers=AUTHORIZED)
                if connection.getresponse().status != 200:
                    self.failed += 1
                connection.close()
            except OSError:
                self.failed += 1
            self.times.append(time.monotonic() - begin)
            self.most_memory = max(self.most_memory, memory())
            with self.count.get_lock():
                self.count.value += 1
            self.asked.release()
            self.over.wait(0.02)
        self.found.put((self.times, self.failed, self.most_memory))


def attacked(name, attack):
    bystander = Bystander()
    attack(bystander)
    while bystander.count.value < FEWEST_OTHERS:
        attack(bystander)
    bystander.stop()
    times = sorted(bystander.times)
    p99 = times[int(len(times) * 0.99)]
    print(f"{name:34} {len(times):5} others, p50 {times[len(times) // 2] * 1000:6.1f} ms, p99 {p99 * 1000:6.1f} ms, "
          f"longest {times[-1] * 1000:6.1f} ms, failed {bystander.failed}, memory {bystander.most_memory / 1e6:.0f} MB",
          flush=True)
    if p99 > LONGEST_S or bystander.failed or bystander.most_memory > MOST_BYTES:
        faults.append(name)


def connected(address="127.0.4.1"):
    """From an address that others do not have: the server is fair between addresses, not between a client's requests."""
    return socket.create_connection(("127.0.0.1", PORT), timeout=5, source_address=(address, 0))


def send_all(data):
    """The first bytes of the answer, or none."""
    try:
        with connected() as wire:
            try:
                wire.sendall(data)
            except OSError:
                pass  # it may refuse before it has read everything
            answer = b""
            while len(answer) < 15:
                piece = wire.recv(4096)
                if not piece:
                    break
                answer += piece
            return answer
    except OSError:
        return b""


def hold(bystander, count, first, drip, seconds):
    """Many connections that send a little, then a drop after every twenty requests of the bystander, half a second."""
    wires = []
    for _ in range(count):
        try:
            wire = connected()
            wire.sendall(first)
            wires.append(wire)
        except OSError:
            pass
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        for wire in wires:
            try:
                if drip:
                    wire.send(drip)
            except OSError:
                pass
        bystander.watches(20)
    for wire in wires:
        wire.close()


def head(method, path, headers=None):
    lines = [f"{method} {path} HTTP/1.1", f"Host: 127.0.0.1:{PORT}", "Connection: close"]
    lines += [f"{name}: {value}" for name, value in {**AUTHORIZED, **(headers or {})}.items()]
    return ("\r\n".join(lines) + "\r\n\r\n").encode()


def expect(name, data, *statuses):
    answer = send_all(data)
    status = answer[9:12].decode("latin-1") if answer.startswith(b"HTTP/1.1 ") else "none"
    if status not in statuses:
        faults.append(f"{name}: {status}, not one of {statuses}")
        print(f"  {name}: answered {status}, not one of {statuses}")


def oversized(_):
    expect("header of 1 MB", head("GET", "/", {"X": "a" * 1_000_000}), "431", "none")
    expect("address of 1 MB", head("GET", "/" + "a" * 1_000_000), "414", "431", "none")
    expect("5,000 headers", head("GET", "/", {f"X{i}": "a" for i in range(5000)}), "431", "none")
    expect("body of 1 TB", head("POST", "/processes/plan-route/execution", {"Content-Length": 10**12}), "413")
    expect("upload of 1 TB", head("POST", "/uploads", {"Content-Length": 10**12}), "413")
    expect("body of 5 MB in chunks", head("POST", "/missions/check", {"Transfer-Encoding": "chunked"})
           + (b"10000\r\n" + b"a" * 65536 + b"\r\n") * 80 + b"0\r\n\r\n", "413", "none")
    expect("chunk of 2^64", head("POST", "/missions/check", {"Transfer-Encoding": "chunked"})
           + b"ffffffffffffffff\r\nabc", "400", "413")
    expect("chunk extension of 1 MB", head("POST", "/missions/check", {"Transfer-Encoding": "chunked"})
           + b"5;" + b"a" * 1_000_000 + b"\r\nhello\r\n0\r\n\r\n", "400", "413", "431", "none")
    expect("query of 3,000 parameters", head("GET", "/datasets?" + "&".join(f"a{i}=1" for i in range(2000))), "400")


def smuggled(_):
    post = "/missions/check"
    for name, headers in {"CL and TE": "Content-Length: 4\r\nTransfer-Encoding: chunked",
                          "two CL": "Content-Length: 4\r\nContent-Length: 5", "TE twice": "Transfer-Encoding: chunked\r\n"
                          "Transfer-Encoding: identity", "odd TE": "Transfer-Encoding: \x0bchunked",
                          "CL with sign": "Content-Length: +4", "blank before colon": "Content-Length : 4",
                          "bare LF": "X: a\nTransfer-Encoding: chunked\r\nContent-Length: 4"}.items():
        data = (f"POST {post} HTTP/1.1\r\nHost: 127.0.0.1\r\n{headers}\r\n\r\n"
                "0\r\n\r\nGET /smuggled HTTP/1.1\r\nHost: 127.0.0.1\r\n\r\n").encode("latin-1")
        expect(name, data, "400")


def written_wrong(_):
    execution = "/processes/plan-route/execution"
    deep = b"[" * 10_000 + b"]" * 10_000
    for name, body in {"JSON 10,000 levels deep": deep, "objects 10,000 levels deep": b'{"a":' * 10_000 + b"1" + b"}" * 10_000,
                       "wrong UTF-8": b'{"inputs":{"from":"\xff\xfe\xc0\xaf"}}', "a surrogate alone": b'{"inputs":{"a":"\\ud800"}}',
                       "NaN": b'{"inputs":{"from":[NaN,1]}}', "1e999": b'{"inputs":{"from":[1e999,1]}}', "NUL": b"\x00" * 100,
                       "a number of 900,000 digits": b"1" * 900_000}.items():
        expect(name, head("POST", execution, {"Content-Length": len(body), "Content-Type": "application/json"}) + body, "400")
    for path in ("/app/../../etc/passwd", "/app/%2e%2e/%2e%2e/etc/passwd", "/app/..%2f..%2fetc/passwd", "/app//etc/passwd",
                 "/uploads/..%2f..%2fserve.lock", "/uploads/%2e%2e", "/app/%5c..%5c", "/collections/plans/items/..%2f..%2fx",
                 "/%ff%fe", "/app/a%0d%0aSet-Cookie:%20x", "/jobs/%0d%0aX:%20y", "/simulations/../../x"):
        expect(path, head("GET", path), "404", "400")
    expect("NUL in a path", head("GET", "/app/a%00.js"), "400")
    expect("upload with a path for a name", head("POST", "/uploads?name=..%2f..%2f..%2fetc%2fpasswd", {"Content-Length": 3})
           + b"abc", "201")
    expect("header with a line break", head("GET", "/healthz", {"X": "a\r\n b"}), "400", "200")


def bombs(_):
    """A megabyte that becomes a gigabyte."""
    bomb = gzip.compress(b"\0" * 1_000_000_000, 9)[:1_000_000]
    expect("gzip in a body", head("POST", "/processes/plan-route/execution", {
        "Content-Length": len(bomb), "Content-Encoding": "gzip", "Content-Type": "application/json"}) + bomb, "400", "413", "415")
    answer = send_all(head("POST", "/uploads?name=bomb.nc.gz", {"Content-Length": len(bomb)}) + bomb)
    if not answer.startswith(b"HTTP/1.1 201"):
        return
    with connected() as wire:
        wire.sendall(head("POST", "/uploads?name=bomb.csv.gz", {"Content-Length": len(bomb)}) + bomb)
        upload = json.loads(wire.makefile("rb").read().split(b"\r\n\r\n", 1)[1])["id"]
    body = json.dumps({"inputs": {"uploads": [upload]}}).encode()
    expect("gzip as a file", head("POST", "/processes/ingest/execution", {
        "Content-Length": len(body), "Content-Type": "application/json", "Prefer": "respond-sync"}) + body, "200")


def shown(token, address):
    """The status with which a token that is shown from this address is answered."""
    try:
        with connected(address) as wire:
            wire.sendall(f"GET /datasets HTTP/1.1\r\nHost: 127.0.0.1\r\nConnection: close\r\nAuthorization: Bearer {token}\r\n\r\n"
                         .encode())
            return wire.makefile("rb").readline()[9:12].decode("latin-1")
    except OSError:
        return "none"


def tried(tokens_and_addresses):
    with concurrent.futures.ThreadPoolExecutor(20) as crowd:
        return list(crowd.map(lambda pair: shown(*pair), tokens_and_addresses))


def check_guesses(name, answers, most_looked_at):
    """None lets in, and after a few nothing is looked at any more."""
    print(f"  {name}: {answers.count('401')} times 401, {answers.count('429')} times 429, {answers.count('200')} times 200")
    if answers.count("401") + answers.count("429") != len(answers):
        faults.append(f"{name}: a guess was answered otherwise than by 401 or 429")
    if answers.count("401") > most_looked_at:
        faults.append(f"{name}: guesses are not slowed")


def check_let_in(name, address):
    status = shown(TOKEN, address)
    if status != "200":
        faults.append(f"{name}: the right token is answered by {status}")


def guesses(_):
    """Tokens that nobody has, from one address: who has the right one comes in from every other, and from one at which it
    was right before even when everybody guesses at that token."""
    guesser, pilot, neighbour = "127.0.2.1", "127.0.2.2", "127.0.2.3"
    check_let_in("before the guesses", pilot)
    unknown = ["floeplan_%016x_%064x" % (random.getrandbits(64), random.getrandbits(256)) for _ in range(1000)]
    check_guesses("1000 tokens from one address", tried((token, guesser) for token in unknown), 100)
    check_let_in("from where it was used before", pilot)
    check_let_in("from an address that is new", neighbour)
    public = TOKEN.rsplit("_", 1)[0]
    secrets = ["%s_%064x" % (public, random.getrandbits(256)) for _ in range(1000)]
    check_guesses("1000 secrets of one token, from 100 addresses",
                  tried((token, f"127.0.3.{1 + number % 100}") for number, token in enumerate(secrets)), 100)
    check_let_in("while others guess at it, from where it was used before", pilot)


def standing(wires):
    """How many of these connections the server has not ended."""
    alive = 0
    for wire in wires:
        wire.setblocking(False)
        try:
            alive += wire.recv(1) != b""
        except BlockingIOError:
            alive += 1
        except OSError:
            pass
    return alive


def idle(bystander, addresses):
    """Connections from this number of addresses that send nothing, held while the server waits for a first word (15 s). Of one
    address the server keeps no more than a tenth and lets go of those that wait longest."""
    wires, refused = [], 0
    for number in range(IDLE):
        try:
            wires.append(connected(f"127.0.1.{1 + number % addresses}"))
        except OSError:
            refused += 1
    bystander.watches(300)  # about 8 s
    print(f"  {IDLE} idle connections from {addresses} address(es): {standing(wires)} stand, {refused} were refused", flush=True)
    for wire in wires:
        wire.close()


def flooded(bystander):
    """Large answers that nobody reads, 300 at once every half second."""
    hold(bystander, 300, head("GET", "/api"), b"", 0.1)


def main():
    _, hard = resource.getrlimit(resource.RLIMIT_NOFILE)
    resource.setrlimit(resource.RLIMIT_NOFILE, (hard, hard))
    attacked("nothing", lambda bystander: bystander.watches(FEWEST_OTHERS))
    attacked("500 slow headers", lambda bystander: hold(bystander, 500, b"GET / HTTP/1.1\r\nHost: a\r\nX: ", b"a", 15))
    attacked("500 slow bodies", lambda bystander: hold(bystander, 500, head("POST", "/missions/check", {"Content-Length": 1_000_000}), b"a", 15))
    attacked("500 slow uploads", lambda bystander: hold(bystander, 500, head("POST", "/uploads", {"Content-Length": 10**9}), b"a", 15))
    if hard > IDLE + 100:
        attacked("10,000 idle, of one address", lambda bystander: idle(bystander, 1))
        attacked("10,000 idle, of 20 addresses", lambda bystander: idle(bystander, 20))
    else:
        print(f"not tried: {IDLE} idle connections, for this shell may open no more than {hard} files (ulimit -Hn)")
    attacked("answers that nobody reads", flooded)
    attacked("oversized everything", oversized)
    attacked("smuggling", smuggled)
    attacked("wrong bytes and paths", written_wrong)
    attacked("decompression bombs", bombs)
    attacked("2000 guessed tokens", guesses)
    os.kill(PID, 0)
    if SERVER and SERVER.end() != 0:
        faults.append("the server did not end well")
    print("\n".join(["broken:"] + faults) if faults else "every bound held")
    sys.exit(1 if faults else 0)


main()
