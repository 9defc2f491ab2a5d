"""Database servers of one's own for the scripts that try nodes hard: ordinary users' processes in a temporary folder."""
import os
import pathlib
import pwd
import re
import shutil
import signal
import subprocess
import threading


def programs():
    """Where the programs of the newest PostgreSQL are; None: it is not installed."""
    found = list(pathlib.Path("/usr/lib/postgresql").glob("*/bin/initdb"))
    return max(found, key=lambda path: int(re.sub(r"\D", "", path.parts[-3]))).parent if found else None


class Database:
    """A server that listens at a socket in its folder alone. Its data survive a kill: it waits for the disk."""

    def __init__(self, folder, copy_of=None, settings=(), starts=True):
        self.folder, self.copy_of = pathlib.Path(folder), copy_of
        self.folder.mkdir()
        self.data = self.folder / "data"
        # The server refuses to run as root.
        self.user = "nobody" if os.getuid() == 0 else pwd.getpwuid(os.getuid()).pw_name
        if os.getuid() == 0:
            shutil.chown(self.folder, self.user)
        if copy_of is None:
            self._run("initdb", "--pgdata", self.data, "--username", "floeplan", "--auth", "trust", "--encoding", "UTF8",
                      "--locale", "C")
        else:
            self._run("pg_basebackup", "--pgdata", self.data, "--host", copy_of.folder, "--username", "floeplan",
                      "--write-recovery-conf", "--checkpoint", "fast", "--dbname", "application_name=standby")
        self.process = None
        if starts:
            self.start(settings)

    def start(self, settings=(), ready="ready to accept"):
        """Returns when the server has logged `ready`: that it accepts connections, by default also such that only read."""
        words = [programs() / "postgres", "-D", self.data, "-c", "listen_addresses=", "-c",
                 f"unix_socket_directories={self.folder}", "-c", "max_connections=200"]
        for setting in settings:
            words += ["-c", setting]
        self.process = subprocess.Popen(words, cwd=self.folder, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True,
                                        errors="replace", **self._as_user())
        log = []
        for line in self.process.stderr:
            log.append(line)
            if ready in line:
                break
        else:
            raise RuntimeError("".join(log))
        threading.Thread(target=self.process.stderr.read, daemon=True).start()  # so that the pipe never fills up

    @property
    def address(self):
        return f"postgresql://floeplan@/postgres?host={self.folder}"

    def query(self, text):
        """Rows, each a list of texts."""
        said = subprocess.run([programs() / "psql", self.address, "--no-psqlrc", "--tuples-only", "--no-align", "--command", text],
                              capture_output=True, text=True, check=True)
        return [line.split("|") for line in said.stdout.splitlines()]

    def kill(self):
        """As a machine that loses its power. No process of it lives on."""
        children = subprocess.run(["pgrep", "--parent", str(self.process.pid)], capture_output=True, text=True, check=False)
        for process in [str(self.process.pid), *children.stdout.split()]:
            try:
                os.kill(int(process), signal.SIGKILL)
            except ProcessLookupError:
                pass
        self.process.wait()

    def promote(self):
        self._run("pg_ctl", "--pgdata", self.data, "promote", "--wait")

    def end(self):
        if self.process.poll() is None:
            self.process.send_signal(signal.SIGINT)
            self.process.wait(60)

    def _as_user(self):
        return {"user": self.user, "group": pwd.getpwnam(self.user).pw_gid, "extra_groups": []} if os.getuid() == 0 else {}

    def _run(self, name, *words):
        subprocess.run([programs() / name, *words], cwd=self.folder, check=True, stdout=subprocess.DEVNULL, **self._as_user())
