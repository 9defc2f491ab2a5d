#!/usr/bin/env python3
"""Adds up the JUnit reports of a test run and says once more what failed, which a long log buries.

usage: test_report.py REPORT.xml|FOLDER...

FOLDER  holds the reports FOLDER.PART.xml of the test executables, and `parts`, CTest's report of the processes they ran in:
        one that ended without a report of its own, in a crash, counts as a failed test

Prints each failed test with the first lines of what it said, then the totals of each report, then, as the last line,
"N passed, N failed, N skipped" over all of them. Exit code: 0 nothing failed, 1 something failed or a report is missing,
damaged or empty.
"""
import pathlib
import re
import sys
import xml.etree.ElementTree as xml

SHOWN_LINES = 6  # of each failure: where and what; the log has the rest


def outcome(case):
    if case.get("status") == "fail" or case.find("failure") is not None or case.find("error") is not None:
        return "failed"
    if case.get("status") in ("notrun", "disabled") or case.find("skipped") is not None:
        return "skipped"
    return "passed"


def said(case):
    """What the test printed, from its first complaint on."""
    for tag in ("failure", "error"):
        found = case.find(tag)
        if found is not None and ((found.text or "").strip() or found.get("message")):
            text = (found.text or "").strip() or found.get("message")
            if text != "Failed":
                return text
    output = case.findtext("system-out") or ""
    complaint = re.search(r"^.*(Failure$|ERROR: |runtime error: )", output, re.MULTILINE)
    return output[complaint.start():] if complaint else output


def cases_in(path):
    """(name, <testcase>) of every test of a report or a folder of reports."""
    if not path.is_dir():
        return [(case.get("name"), case) for case in xml.parse(path).iter("testcase")]
    cases = []
    for report in sorted(path.glob("*.xml")):
        folder = report.name.split(".")[0]
        cases += [(f"{folder}.{case.get('classname')}.{case.get('name')}", case) for case in xml.parse(report).iter("testcase")]
    ran = {report.stem for report in path.glob("*.xml")}
    cases += [(f"{case.get('name')}, which ended without a report", case)
              for case in xml.parse(path / "parts").iter("testcase")
              if outcome(case) == "failed" and case.get("name") not in ran]
    return cases


def main(paths):
    total = {"passed": 0, "failed": 0, "skipped": 0}
    whole = True
    for path in map(pathlib.Path, paths):
        try:
            cases = cases_in(path)
        except (OSError, xml.ParseError) as trouble:
            print(f"{path}: no report: {trouble}")
            whole = False
            continue
        counts = {"passed": 0, "failed": 0, "skipped": 0}
        for name, case in cases:
            result = outcome(case)
            counts[result] += 1
            if result == "failed":
                print(f"FAILED: {path.stem}: {name}")
                lines = [line for line in said(case).splitlines() if line.strip()]
                print("".join(f"    {line}\n" for line in lines[:SHOWN_LINES]), end="")
        whole = whole and bool(cases)
        print(f"{path.stem}: {counts['passed']} passed, {counts['failed']} failed, {counts['skipped']} skipped")
        for key, count in counts.items():
            total[key] += count
    print(f"{total['passed']} passed, {total['failed']} failed, {total['skipped']} skipped")
    return 0 if whole and total["failed"] == 0 else 1


sys.exit(main(sys.argv[1:]))
