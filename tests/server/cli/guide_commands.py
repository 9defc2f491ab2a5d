#!/usr/bin/env python3
"""Runs the commands of a page of the guide, or of README.md: every line of its blocks that are marked sh, as they stand there.

usage: guide_commands.py PROGRAM PAGE        (README.md, web/guide/planning.md ...)

A page has a folder of its own. Where it writes the demonstration data itself the folder is empty; else it holds them in demo/, and
read into a store with two plans. The files of FILES are made first. In a command
  PLAN, OTHER              are the plan that the page planned last, and the one before it;
  http://127.0.0.1:8080    is the address of a server of the page's store.
Commands that do not end, or cannot run here, are checked in another way, none is left out:
  floeplan ... serve       listens, answers, and ends when it is told to;
  floeplan ... simulate    flies once and without the obstacle avoidance system, which takes a minute;
  deploy/SCRIPT            is a script of the tree whose usage names its flags and arguments;
  cmake                    is configured; what it builds takes minutes;
  apt install              installs a package: deploy/package.sh --try does.
Exits with 77, naming it, where a program of the system that a command needs is not installed, or the log nav.csv is not there.
"""

import json
import os
import pathlib
import re
import shlex
import shutil
import ssl
import subprocess
import sys
import tempfile
import urllib.error
import urllib.request

ROOT = pathlib.Path(__file__).resolve().parents[3]
ADDRESS = "http://127.0.0.1:8080"
START = "2026-11-22"
ASKED = ["--from=-53.20,69.20", "--to=-52.90,69.20", "--depart", f"{START}T06:00:00Z"]
SYSTEM = ("curl", "ogrinfo", "cmake")

LINE = {"type": "LineString", "coordinates": [[-53.20, 69.20], [-53.05, 69.21], [-52.90, 69.20]]}
FILES = {
    "route.geojson": json.dumps({"type": "Feature", "properties": {}, "geometry": LINE}),
    "vehicle.json": json.dumps({"vehicle": {"profile": "slocum-g3-200", "hotel_w": 2.4}}),
}
# A real log, which lies outside the tree.
LOG = ROOT / "../shared/data/env/glider/slocum_comet-2019-222-02-154_nav.csv"


def commands_of(page):
    """The lines of the blocks marked sh, without remarks; a line that ends in a backslash goes on."""
    blocks = re.findall(r"^```sh\n(.*?)^```", page, flags=re.M | re.S)
    lines = "".join(blocks).replace("\\\n", " ").splitlines()
    return [line for line in (re.sub(r"\s+#\s.*$", "", line).strip() for line in lines) if line]


class Page:
    def __init__(self, program, folder, commands):
        self.program, self.folder, self.commands = program, folder, commands
        self.plans, self.server, self.address = [], None, None
        (folder / "bin").mkdir()
        (folder / "bin/floeplan").symlink_to(program)
        self.environment = {**os.environ, "PATH": f"{folder / 'bin'}:{os.environ['PATH']}", "HOME": str(folder)}
        for name, text in FILES.items():
            (folder / name).write_text(text)
        (folder / "inbox").mkdir()
        if any(" nav.csv" in command for command in commands):
            shutil.copy(LOG, folder / "nav.csv")
        if any("--tls-cert" in command for command in commands):
            self.run("openssl req -x509 -newkey rsa:2048 -nodes -keyout key.pem -out chain.pem -subj /CN=127.0.0.1 -days 2 2>&1")
        if not any(command.startswith("floeplan demo ") for command in commands):
            self.run(f"floeplan demo demo/ --start {START} && floeplan --data store ingest demo/disko-*")
            for end in ("-52.95", "-52.90"):
                self.run("floeplan --data store plan " + " ".join(ASKED).replace("-52.90", end) + " --max-waypoints 6")

    def run(self, command):
        """Runs a command in the page's folder. Fails, saying what it printed, where it does."""
        done = subprocess.run(["bash", "-euo", "pipefail", "-c", command], cwd=self.folder, env=self.environment,
                              capture_output=True, text=True, timeout=300)
        if done.returncode != 0:
            raise SystemExit(f"{command}\nends with {done.returncode}:\n{done.stdout[-2000:]}{done.stderr[-2000:]}")
        if planned := re.match(r"p[0-9a-f]{12}(?=  )", done.stdout):
            self.plans.append(planned[0])

    def serve(self, words):
        """Starts a server. Its address, once it listens."""
        listen = words.index("--listen") + 1
        words = words[:listen] + ["127.0.0.1:0"] + words[listen + 1:]
        self.server = subprocess.Popen(words, cwd=self.folder, env=self.environment, stderr=subprocess.PIPE, text=True)
        for line in self.server.stderr:
            if found := re.match(r"floeplan: serving (https?)://\S*?(:\d+)?/?(\s|$)", line):
                return f"{found[1]}://127.0.0.1{self.port()}"
        raise SystemExit(f"{shlex.join(words)}\nended before it listened")

    def port(self):
        """Where it listens, whatever its public address."""
        inodes = {os.readlink(link)[8:-1] for link in pathlib.Path(f"/proc/{self.server.pid}/fd").iterdir()
                  if os.readlink(link).startswith("socket:")}
        for line in pathlib.Path("/proc/net/tcp").read_text().splitlines()[1:]:
            fields = line.split()
            if fields[3] == "0A" and fields[9] in inodes:
                return f":{int(fields[1].split(':')[1], 16)}"
        raise SystemExit("the server listens nowhere")

    def stop(self):
        if self.server is None:
            return
        self.server.terminate()
        code = self.server.wait(timeout=60)
        self.server.stderr.close()
        self.server, self.address = None, None
        if code != 0:
            raise SystemExit(f"a server ended with {code}")

    def check_server(self, command):
        self.stop()
        address = self.serve(shlex.split(command))
        trusting = ssl.create_default_context()
        trusting.check_hostname, trusting.verify_mode = False, ssl.CERT_NONE
        try:
            with urllib.request.urlopen(f"{address}/healthz", context=trusting, timeout=60) as answer:
                status = answer.status
        except urllib.error.HTTPError as refusal:
            status = refusal.code
        self.stop()
        if status not in (200, 421):  # 421: it goes by another name, which --public-url gave it
            raise SystemExit(f"{command}\nanswers {status}")

    def check(self, command):
        words = shlex.split(command)
        if words[0].startswith("deploy/"):
            check_script(words)
        elif words[0] == "apt":
            if words[1] != "install":
                raise SystemExit(f"{command}\nis not checked by any rule")
        elif words[0] == "cmake":
            self.run(command.split(" && ")[0].replace("-S .", f"-S {ROOT}"))
        elif words[0] == "floeplan" and "serve" in words:
            self.check_server(command)
        else:
            if ADDRESS.removeprefix("http://") in command and self.address is None:
                self.address = self.serve(["floeplan", "--data", "store", "serve", "--listen", "127.0.0.1:0"])
            command = command.replace(ADDRESS, self.address or ADDRESS)
            if "simulate" in words:
                command = re.sub(r"--runs \d+", "--runs 1 --no-avoidance", command)
            if len(self.plans) > 0:
                command = re.sub(r"\bPLAN\b", self.plans[-1], command)
            if len(self.plans) > 1:
                command = re.sub(r"\bOTHER\b", self.plans[-2], command)
            self.run(command)


def check_script(words):
    """The script is there, can be run, and its beginning names what it is given."""
    script = ROOT / words[0]
    if not os.access(script, os.X_OK):
        raise SystemExit(f"{words[0]} is no script of the tree")
    usage = "".join(line for line in script.read_text(encoding="utf-8").splitlines(keepends=True)[:40])
    for word in words[1:]:
        if word.startswith("-") and word not in usage:
            raise SystemExit(f"{words[0]} does not say that it takes {word}")


def main():
    program, name = pathlib.Path(sys.argv[1]).resolve(), sys.argv[2]
    commands = commands_of((ROOT / name).read_text(encoding="utf-8"))
    if not commands:
        return
    for needed in SYSTEM:
        if shutil.which(needed) is None and any(re.search(rf"\b{needed} ", command) for command in commands):
            print(f"{needed} is not installed")
            sys.exit(77)
    if any(" nav.csv" in command for command in commands) and not LOG.exists():
        print(f"{LOG} is not there")
        sys.exit(77)
    with tempfile.TemporaryDirectory() as folder:
        page = Page(program, pathlib.Path(folder), commands)
        try:
            for command in commands:
                page.check(command)
        finally:
            page.stop()
    print(f"{name}: {len(commands)} commands")


if __name__ == "__main__":
    main()
