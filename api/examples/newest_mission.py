#!/usr/bin/env python3
"""Fetches the mission files of the plan that was made last.

usage: newest_mission.py SERVER FOLDER

SERVER   address of Floeplan; FLOEPLAN_TOKEN holds the token where it wants one
FOLDER   the files go into a folder of the plan's name in it, which must not be there yet

Exit code: 0 fetched (prints the files), 1 not, 2 wrong usage.
"""
import io
import pathlib
import sys
import zipfile

import floeplan


def newest_plan(server):
    """The feature of the plan that was made last: the last one of the last page."""
    newest, address = None, "/collections/plans/items?limit=1000"
    while address:
        page = floeplan.ask(server, address)
        newest = page["features"][-1] if page["features"] else newest
        address = next((link["href"] for link in page["links"] if link["rel"] == "next"), None)
    return newest


def main():
    if len(sys.argv) != 3:
        print(__doc__.strip(), file=sys.stderr)
        return 2
    server, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    plan = newest_plan(server)
    if plan is None:
        print("the server holds no plan", file=sys.stderr)
        return 1
    with floeplan.opened(server, f"/collections/plans/items/{plan['id']}/mission.zip") as answer:
        for warning in answer.headers.get_all("Floeplan-Warning") or []:
            print(f"warning: {warning}", file=sys.stderr)
        archive = zipfile.ZipFile(io.BytesIO(answer.read()))
    place = folder / plan["id"]
    place.mkdir(parents=True)
    for name in archive.namelist():
        file = place / pathlib.PurePosixPath(name).name  # its last name alone: it must not reach out of the folder
        file.write_bytes(archive.read(name))
        print(file)
    return 0


floeplan.run(main)
