"""What the examples share: asking a Floeplan server. Python 3.9 or later, no other packages.

The variable FLOEPLAN_TOKEN holds the token where the server wants one; it is never a part of an address.
"""
import json
import os
import sys
import time
import urllib.error
import urllib.request

MOST_TRIES = 5


class Refused(Exception):
    """What the server says of a request that it did not do."""

    def __init__(self, status, body):
        try:
            problem = json.loads(body)
        except ValueError:
            problem = {}
        lines = [problem.get("detail", f"the server answered {status}")]
        lines += [f"{fault['pointer']}: {fault['detail']}" for fault in problem.get("errors", [])]
        super().__init__("\n".join(lines))
        self.status = status


def opened(server, path, body=None, method=None, headers=None, timeout_s=60):
    """The answer, to be read and closed. `path` may be one of the server's own links; `body` is bytes, an open file
    or what JSON can write. A server that is busy (503) is asked again when it says."""
    address = path if path.startswith(server.rstrip("/") + "/") else server.rstrip("/") + path
    is_json = body is not None and not isinstance(body, bytes) and not hasattr(body, "read")
    data = json.dumps(body).encode() if is_json else body
    request = urllib.request.Request(address, data=data, method=method, headers=headers or {})
    if is_json:
        request.add_header("Content-Type", "application/json")
    if os.environ.get("FLOEPLAN_TOKEN"):
        request.add_header("Authorization", "Bearer " + os.environ["FLOEPLAN_TOKEN"])
    for tries_left in reversed(range(MOST_TRIES)):
        try:
            return urllib.request.urlopen(request, timeout=timeout_s)
        except urllib.error.HTTPError as error:
            if error.code != 503 or tries_left == 0 or hasattr(data, "read"):
                raise Refused(error.code, error.read()) from None
            time.sleep(min(60, int(error.headers.get("Retry-After") or 5)))
    raise AssertionError("the last try has returned or raised")


def ask(server, path, **how):
    """The answer's JSON."""
    with opened(server, path, **how) as answer:
        return json.load(answer)


def wait_for(server, job_id, tell=lambda job: None):
    """The job once it has ended; `tell` hears of every change until then. Asks again only after a change, or after
    20 seconds without one."""
    while True:
        job = ask(server, "/jobs/" + job_id, headers={"Prefer": "wait=20"})
        tell(job)
        if job["status"] not in ("accepted", "running"):
            return job


def run(main):
    """Runs a script's main function; what the server or the machine refused becomes one line for each reason."""
    try:
        sys.exit(main())
    except (Refused, OSError) as error:
        for line in str(error).splitlines():
            print(f"{os.path.basename(sys.argv[0])}: {line}", file=sys.stderr)
        sys.exit(1)
    except KeyboardInterrupt:
        sys.exit(130)
