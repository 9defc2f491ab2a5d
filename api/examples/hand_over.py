#!/usr/bin/env python3
"""Hands the mission files of a plan over to a dockserver.

usage: hand_over.py SERVER PLAN_ID GLIDER_FOLDER [--replace] [--query full=true&mission=disko]

SERVER         address of Floeplan, as http://127.0.0.1:8080; FLOEPLAN_TOKEN holds the token where it wants one
GLIDER_FOLDER  the glider's folder on the dockserver; files go into its folder to-glider, from where the glider
               fetches them at its next surfacing
--replace      replace files that are there already; without it nothing is written when one is
--query        which files: parameters of /collections/plans/items/{plan_id}/mission.zip

Python 3.9 or later, no other packages. Exit code: 0 handed over, 1 not, 2 wrong usage.
"""
import argparse
import io
import os
import pathlib
import sys
import urllib.parse
import zipfile

import floeplan


def fetch(server, plan_id, query):
    """The archive's files by name, and what the server warns of."""
    path = f"/collections/plans/items/{urllib.parse.quote(plan_id, safe='')}/mission.zip"
    with floeplan.opened(server, path + ("?" + query if query else "")) as answer:
        warnings = answer.headers.get_all("Floeplan-Warning") or []
        archive = zipfile.ZipFile(io.BytesIO(answer.read()))
    # By their last names alone: wherever the archive puts a file, it must not reach out of the folder.
    files = {pathlib.PurePosixPath(name).name: archive.read(name) for name in archive.namelist()}
    return {name: content for name, content in files.items() if name not in ("", "..")}, warnings


def write_whole(folder, files):
    """All files are complete before the first one appears: a dockserver may look at any moment."""
    folder.mkdir(parents=True, exist_ok=True)
    parts = []
    for name, content in files.items():
        part = folder / f".{name}.part"
        with open(part, "wb") as stream:
            stream.write(content)
            stream.flush()
            os.fsync(stream.fileno())
        parts.append((part, folder / name))
    for part, place in parts:
        os.replace(part, place)


def main():
    arguments = argparse.ArgumentParser(description="Hands the mission files of a plan over to a dockserver.")
    arguments.add_argument("server")
    arguments.add_argument("plan_id")
    arguments.add_argument("glider_folder", type=pathlib.Path)
    arguments.add_argument("--replace", action="store_true")
    arguments.add_argument("--query", default="")
    given = arguments.parse_args()
    try:
        files, warnings = fetch(given.server, given.plan_id, given.query)
    except (OSError, zipfile.BadZipFile) as error:
        print(f"hand_over: {given.server} gave no files: {error}", file=sys.stderr)
        return 1
    for warning in warnings:
        print(f"warning: {warning}", file=sys.stderr)

    folder = given.glider_folder / "to-glider"
    there = [name for name in files if (folder / name).exists()]
    if there and not given.replace:
        print(f"hand_over: {folder / there[0]} exists; nothing was written; --replace replaces it", file=sys.stderr)
        return 1
    write_whole(folder, files)
    for name in files:
        print(folder / name)
    return 0


floeplan.run(main)
