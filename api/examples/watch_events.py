#!/usr/bin/env python3
"""Prints a line for every change of every job, as it happens, or of one job until it has ended.

usage: watch_events.py SERVER [JOB_ID]

After a broken connection it goes on where it was: the server is told the last event that was seen.

SERVER   address of Floeplan; FLOEPLAN_TOKEN holds the token where it wants one
Exit code: 0 the job ended successfully, 1 it did not or there is none, 2 wrong usage, 130 interrupted.
"""
import http.client
import json
import sys
import time

import floeplan


def events(stream):
    """Id and data of each event of a stream; lines that are neither are left out."""
    event = {}
    for line in stream:
        name, _, value = line.decode().rstrip("\r\n").partition(": ")
        if name:
            event[name] = value
            continue
        if "data" in event:
            yield event["id"], json.loads(event["data"])
        event = {}


def main():
    if len(sys.argv) not in (2, 3):
        print(__doc__.strip(), file=sys.stderr)
        return 2
    server = sys.argv[1]
    path = f"/jobs/{sys.argv[2]}/events" if len(sys.argv) == 3 else "/events"
    seen = {}
    while True:
        try:
            with floeplan.opened(server, path, headers=seen) as stream:  # silent for 15 seconds at the most
                for number, job in events(stream):
                    seen = {"Last-Event-ID": number}
                    print(job["updated"], job["jobID"], job["processID"], job["status"], f"{job['progress']} %",
                          job["stage"], flush=True)
                    if len(sys.argv) == 3 and job["status"] not in ("accepted", "running"):
                        return 0 if job["status"] == "successful" else 1
        except (OSError, http.client.HTTPException) as broken:
            print(f"{broken}; asking again", file=sys.stderr)
        time.sleep(2)


floeplan.run(main)
