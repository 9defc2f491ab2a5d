"""A server of one's own for the scripts that try it hard. Python 3.9 or later, no other packages."""
import json
import pathlib
import re
import resource
import signal
import subprocess
import tempfile
import time
import urllib.error
import urllib.request


class Gone(Exception):
    """The server did not answer: it was killed, or is about to be."""


class Served:
    """The program serving a store on a free port of the loopback address."""

    def __init__(self, program, store, flags=(), limits=(), user=None):
        self.log = tempfile.NamedTemporaryFile(prefix="floeplan-log-", suffix=".txt")
        self.process = subprocess.Popen([program, "--data", str(store), "serve", "--listen", "127.0.0.1:0", *flags],
                                        stderr=self.log, user=user, preexec_fn=lambda: self._limit(limits))
        self.address = self._wait()

    @staticmethod
    def _limit(limits):
        for name, value in limits:
            resource.setrlimit(name, (value, value))

    def _wait(self):
        for _ in range(600):
            text = self.said()
            found = re.search(r"serving (http://127\.0\.0\.1:\d+)\n", text)
            if found:
                return found.group(1)
            if self.process.poll() is not None:
                return None
            time.sleep(0.05)
        raise Gone("the server does not listen")

    def said(self):
        return pathlib.Path(self.log.name).read_text(encoding="utf-8", errors="replace")

    def ask(self, method, path, body=None, headers=None, timeout_s=60):
        """Status, and the answer: of JSON what it holds, else its bytes."""
        data = body if body is None or isinstance(body, bytes) else json.dumps(body).encode()
        request = urllib.request.Request(self.address + path, data=data, method=method,
                                         headers={"Content-Type": "application/json", **(headers or {})})
        try:
            with urllib.request.urlopen(request, timeout=timeout_s) as answer:
                return answer.status, _read(answer)
        except urllib.error.HTTPError as refused:
            with refused:
                return refused.code, _read(refused)
        except (OSError, ValueError) as broken:
            raise Gone(str(broken)) from None

    def execute(self, process, inputs, key=None, wait=True):
        headers = {"Prefer": "respond-sync" if wait else "respond-async"}
        if key:
            headers["Idempotency-Key"] = key
        return self.ask("POST", f"/processes/{process}/execution", {"inputs": inputs}, headers)

    def upload(self, name, content):
        status, answer = self.ask("POST", "/uploads?name=" + name, content, {"Content-Type": "application/octet-stream"})
        return answer["id"] if status == 201 else None

    def end(self, how=signal.SIGTERM):
        """The exit code, as subprocess gives it."""
        self.process.send_signal(how)
        return self.process.wait(timeout=30)


def _read(answer):
    content = answer.read()
    return json.loads(content) if "json" in answer.headers.get("Content-Type", "") else content
