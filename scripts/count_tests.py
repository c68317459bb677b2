#!/usr/bin/python3
"""Prints "PASSED FAILED" of a JUnit report of ctest; tests that did not run count as failed, those that say why they are
skipped as neither."""
import sys
import xml.etree.ElementTree as ElementTree

suite = ElementTree.parse(sys.argv[1]).getroot()
total = int(suite.get("tests"))
passed = sum(case.get("status") == "run" for case in suite.iter("testcase"))
skipped = 0
for case in suite.iter("testcase"):
    if case.find("skipped") is not None and case.get("status") == "notrun":
        skipped += "SKIP_" in (case.find("skipped").get("message") or "")
print(passed, total - passed - skipped)
