#!/usr/bin/env python3
"""Counts the test cases in meson's log: prints what failed with its reasons,
then `N passed, N failed`.

usage: count.py build/meson-logs/testlog.json

A case is a line `ok` or `not ok` of TAP, or a whole test that prints none.  A
test that failed without saying which case (a crash, a missing case, a time
out) counts as one failure more.  Exit code 1 if anything failed or nothing
ran.
"""
import json
import re
import sys

GOOD = ('OK', 'EXPECTEDFAIL', 'SKIP')


def cases(test):
    lines = re.findall(r'^(not ok|ok)\b(.*)$', test.get('stdout', ''), re.M)
    ran = [word for word, rest in lines if not re.search(r'(?i)# *skip', rest)]
    passed, failed = ran.count('ok'), ran.count('not ok')
    if test['result'] not in GOOD and failed == 0:
        failed = 1
    if test['result'] in GOOD[:2] and not lines:
        passed = 1
    return passed, failed


def complaints(test):
    reasons = re.findall(r'^not ok\b.*(?:\n#.*)*', test.get('stdout', ''), re.M)
    if not reasons and test['result'] not in GOOD:
        reasons = [test['result']]
    return ''.join(f'{test["name"]}: {reason}\n' for reason in reasons)


def main(path):
    try:
        with open(path, encoding='utf-8') as log:
            tests = [json.loads(line) for line in log]
    except OSError:
        tests = []
    counts = [cases(test) for test in tests]
    passed, failed = (sum(column) for column in zip(*counts, (0, 0)))
    print(''.join(complaints(test) for test in tests), end='')
    if passed + failed == 0:
        print('no test ran')
    print(f'{passed} passed, {failed} failed')
    return failed > 0 or passed == 0


if __name__ == '__main__':
    sys.exit(main(sys.argv[1]))
