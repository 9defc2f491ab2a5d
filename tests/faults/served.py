"""A server of one's own for the scripts that try it hard. Python 3.9 or later, no other packages."""
import json
import re
import resource
import signal
import subprocess
import threading
import urllib.error
import urllib.request


class Gone(Exception):
    """The server did not answer: it was killed, or is about to be."""


class Served:
    """The program serving a store on a free port of the loopback address.

    `before` are flags of the program that come before the command, `command` is serve or worker."""

    def __init__(self, program, store, flags=(), limits=(), user=None, before=(), command="serve", environment=None):
        self.process = subprocess.Popen([program, "--data", str(store), *before, command, "--listen", "127.0.0.1:0", *flags],
                                        text=True, errors="replace", stderr=subprocess.PIPE, user=user, env=environment,
                                        preexec_fn=lambda: self._limit(limits))
        self.lines, self.address, self.begun, self.logged = [], None, threading.Event(), threading.Condition()
        self.reader = threading.Thread(target=self._read_log, daemon=True)
        self.reader.start()
        if not self.begun.wait(30):
            raise Gone("the server does not listen")

    @staticmethod
    def _limit(limits):
        for name, value in limits:
            resource.setrlimit(name, (value, value))

    def _read_log(self):
        """To its end, which is the server's; it has begun when it listens, or will never."""
        for line in self.process.stderr:
            with self.logged:
                self.lines.append(line)
                self.logged.notify_all()
            found = re.search(r"(?:serving|health at) (http://127\.0\.0\.1:\d+)\n", line)
            if found and not self.address:
                self.address = found.group(1)
                self.begun.set()
        self.begun.set()

    def says(self, words, most_s):
        """Waits until it has logged these words. False: it has not in that time."""
        with self.logged:
            return self.logged.wait_for(lambda: any(words in line for line in self.lines), most_s)

    def said(self):
        """All that it has logged; once it has ended, to the last line."""
        if self.process.poll() is not None:
            self.reader.join(30)
        return "".join(self.lines)

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
