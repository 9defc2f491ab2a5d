#!/usr/bin/env python3
"""Counts the results of an executable test suite (TestNG) and prints what failed, was skipped or was not run.

usage: count_tests.py NAME FOLDER [METHOD...]

FOLDER  holds testng-results.xml, at any depth
METHOD  needs what is not there (the Internet): listed as not run when it failed, not counted

The last line is "NAME: passed N failed N skipped N". Exit code: 0 no failure, 1 failures, or no results at all.
"""
import pathlib
import sys
import xml.etree.ElementTree as xml

name, folder, not_possible = sys.argv[1], pathlib.Path(sys.argv[2]), set(sys.argv[3:])
reports = sorted(folder.rglob("testng-results.xml"))
if not reports:
    print(f"{name}: the suite left no results; its log: {folder / 'log.txt'}")
    print(f"{name}: passed 0 failed 1 skipped 0")
    sys.exit(1)

counts = {"PASS": 0, "FAIL": 0, "SKIP": 0}
for method in xml.parse(reports[-1]).iter("test-method"):
    status = method.get("status")
    if method.get("is-config") == "true" and status != "FAIL":
        continue
    where = method.get("signature", "").split("(")[0] or method.get("name")
    message = (method.findtext(".//message") or "").strip().splitlines()
    if status == "FAIL" and method.get("name") in not_possible:
        print(f"{name}: not run (schemas.opengis.net cannot be reached): {where}")
        continue
    counts[status] += 1
    if status != "PASS":
        print(f"{name}: {status.lower()}: {where}: {message[0][:200] if message else ''}")
print(f"{name}: passed {counts['PASS']} failed {counts['FAIL']} skipped {counts['SKIP']}")
sys.exit(1 if counts["FAIL"] else 0)
