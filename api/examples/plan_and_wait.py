#!/usr/bin/env python3
"""Plans a route as a job, waits for it and prints the plan.

usage: plan_and_wait.py SERVER INPUTS.json

SERVER       address of Floeplan, as http://127.0.0.1:8080; FLOEPLAN_TOKEN holds the token where it wants one
INPUTS.json  the inputs of process plan-route, as {"from": [-53, 69], "to": [-52.5, 69.3], "depart": "2026-11-22T06:00:00Z"}

Exit code: 0 there is a plan, 1 there is none (the answer says why), 2 wrong usage.
"""
import json
import sys
import uuid

import floeplan


def main():
    if len(sys.argv) != 3:
        print(__doc__.strip(), file=sys.stderr)
        return 2
    server, file = sys.argv[1:]
    with open(file, encoding="utf-8") as stream:
        inputs = json.load(stream)

    # With a key of its own the request can be sent again after a broken connection, and is still one job.
    headers = {"Prefer": "respond-async", "Idempotency-Key": str(uuid.uuid4())}
    job = floeplan.ask(server, "/processes/plan-route/execution", body={"inputs": inputs}, headers=headers)
    job = floeplan.wait_for(server, job["jobID"], lambda now: print(
        f"{now['status']} {now['progress']} % {now['stage']}", file=sys.stderr))
    if job["status"] != "successful":
        print(f"the job ended {job['status']}: {job['message']}", file=sys.stderr)
        return 1
    plan = floeplan.ask(server, f"/jobs/{job['jobID']}/results")["plan"]
    print(json.dumps(plan, indent=1))
    return 0 if plan["status"] == "ok" else 1


floeplan.run(main)
