#!/usr/bin/python3
"""Counts test cases after ctest and prints `N passed, N failed` as the last line.

usage: count_tests.py BUILD_DIR CTEST_JUNIT_XML [PATTERN]

PATTERN is the value of ctest's option -R: other tests are not counted. Skipped cases are printed with their reason and
counted.

catkin's tests name their JUnit file on their command line; the cases of that file are counted. A missing, unreadable or
empty file counts as one failure, and so does a test that failed in ctest without a failed case in its file, for example
by a crash at exit. Any other test counts as one case. Exits 1 unless at least one case passed and none failed.
"""
import json
import subprocess
import sys
import xml.etree.ElementTree as ElementTree
from collections import Counter
from pathlib import Path


def ctest_outcomes(junit_file):
    """Return the outcome of each test in ctest, by name: passed, failed or skipped."""
    outcomes = {}
    for case in ElementTree.parse(junit_file).iter('testcase'):
        skipped = case.find('skipped')
        asked_for = skipped is not None and 'SKIP_RETURN_CODE' in skipped.get('message', '')
        if asked_for or case.get('status') == 'disabled':
            outcomes[case.get('name')] = 'skipped'
        else:
            outcomes[case.get('name')] = 'passed' if case.get('status') == 'run' else 'failed'
    return outcomes


def case_outcome(case):
    if case.find('failure') is not None or case.find('error') is not None:
        return 'failed'
    return 'skipped' if case.find('skipped') is not None or case.get('status') == 'notrun' else 'passed'


def describe_skips(junit_file):
    """Yield a line for each skipped case of the file."""
    for case in ElementTree.parse(junit_file).iter('testcase'):
        skipped = case.find('skipped')
        if skipped is not None:
            reason = (skipped.get('message') or '').strip().split('\n')[-1]
            yield 'skipped: {}.{}: {}'.format(case.get('classname'), case.get('name'), reason)


def junit_outcomes(junit_file):
    """Return the outcomes of the cases in one file.

    rostest writes one case for each program, named `test` plus the test name of the program. The cases of the program
    itself are in another file beside it."""
    outcomes = []
    for case in ElementTree.parse(junit_file).iter('testcase'):
        program_file = junit_file.parent / 'rosunit-{}.xml'.format(case.get('name', '')[len('test'):])
        if case.get('classname') == 'rostest.runner.RosTest' and program_file.exists():
            program = junit_outcomes(program_file)
            if case_outcome(case) == 'failed' and 'failed' not in program:
                program.append('failed')
            outcomes += program
        else:
            outcomes.append(case_outcome(case))
    return outcomes


def registered_tests(build_dir, pattern):
    """Yield (name, JUnit file or None) of every test in ctest whose name matches the pattern."""
    listing = subprocess.run(['ctest', '--test-dir', build_dir, '--show-only=json-v1', '-R', pattern], check=True,
                             stdout=subprocess.PIPE)
    results = str(Path(build_dir) / 'test_results')
    for test in json.loads(listing.stdout)['tests']:
        files = [word for word in test.get('command', []) if word.startswith(results) and word.endswith('.xml')]
        yield test['name'], Path(files[0]) if files else None


def outcomes_of(name, junit_file, by_ctest):
    whole = by_ctest.get(name, 'failed')
    if junit_file is None or whole == 'skipped':
        return [whole]
    try:
        cases = junit_outcomes(junit_file)
    except (OSError, ElementTree.ParseError):
        return ['failed']
    if not cases or (whole == 'failed' and 'failed' not in cases):
        cases.append('failed')
    return cases


def main(build_dir, ctest_junit, pattern='.'):
    by_ctest = ctest_outcomes(ctest_junit)
    count = Counter()
    for name, junit_file in registered_tests(build_dir, pattern):
        outcomes = outcomes_of(name, junit_file, by_ctest)
        count.update(outcomes)
        if 'failed' in outcomes:
            print('failed: {} ({} of {})'.format(name, outcomes.count('failed'), len(outcomes)))
        if junit_file and 'skipped' in outcomes:
            print('\n'.join(describe_skips(junit_file)))
    if count['skipped']:
        print('skipped: {}'.format(count['skipped']))
    print('{} passed, {} failed'.format(count['passed'], count['failed']))
    return 0 if count['passed'] and not count['failed'] else 1


if __name__ == '__main__':
    if len(sys.argv) not in (3, 4):
        sys.exit(__doc__)
    sys.exit(main(*sys.argv[1:]))
