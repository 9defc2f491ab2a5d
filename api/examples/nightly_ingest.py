#!/usr/bin/env python3
"""Sends files to the server and has them ingested together: a forecast's U and V files, a chart and its updates.

usage: nightly_ingest.py SERVER FILE...

For cron, after the download:  17 3 * * *  nightly_ingest.py http://127.0.0.1:8080 /data/today/*.nc
A file that the store holds already is "unchanged", so that sending it twice does no harm.

SERVER   address of Floeplan; FLOEPLAN_TOKEN holds the token of a pilot where it wants one
Exit code: 0 everything is stored, 1 could not be done, 2 wrong usage, 3 a file was refused (the others are stored).
"""
import hashlib
import os
import sys
import urllib.parse

import floeplan


def upload(server, path):
    """The id of the upload. What arrives with another digest is refused."""
    with open(path, "rb") as file:
        digest = hashlib.sha256()
        while block := file.read(1 << 20):
            digest.update(block)
        size = file.tell()
        file.seek(0)
        query = urllib.parse.urlencode({"name": os.path.basename(path), "sha256": digest.hexdigest()})
        return floeplan.ask(server, "/uploads?" + query, body=file, method="POST", timeout_s=3600,
                            headers={"Content-Length": str(size), "Content-Type": "application/octet-stream"})["id"]


def main():
    if len(sys.argv) < 3:
        print(__doc__.strip(), file=sys.stderr)
        return 2
    server, paths = sys.argv[1], sys.argv[2:]
    uploads = [upload(server, path) for path in paths]
    job = floeplan.ask(server, "/processes/ingest/execution", body={"inputs": {"uploads": uploads}},
                       headers={"Prefer": "respond-async"})
    job = floeplan.wait_for(server, job["jobID"])
    if job["status"] != "successful":
        print(f"the job ended {job['status']}: {job['message']}", file=sys.stderr)
        return 1
    datasets = floeplan.ask(server, f"/jobs/{job['jobID']}/results")["report"]["datasets"]
    for dataset in datasets:
        print(dataset["status"], dataset["file"], dataset.get("dataset_id") or "")
        for line in dataset["errors"] + dataset["warnings"]:
            print("  " + line)
    return 3 if any(dataset["status"] == "refused" for dataset in datasets) else 0


floeplan.run(main)
