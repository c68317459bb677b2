#!/usr/bin/python3
"""Prints "PASSED FAILED" of a JUnit report of ctest; tests that did not run count as failed."""
import sys
import xml.etree.ElementTree as ElementTree

suite = ElementTree.parse(sys.argv[1]).getroot()
total = int(suite.get("tests"))
passed = sum(case.get("status") == "run" for case in suite.iter("testcase"))
print(passed, total - passed)
