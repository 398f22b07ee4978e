#!/usr/bin/python3
"""usage: published_idm_parity.py RESULTS [FIXTURE]: is idm_published hit in the clips in which the published test is?

Compares `published_hit` of idm_published in results.csv of `forge study test` clip by clip with what the published
program returned (FIXTURE, by default test/parity/fixtures/idm_published.json), names every clip in which they differ,
and prints both rates by type. Exit code 1 if a clip differs or none was compared."""
import csv
import json
import sys
from pathlib import Path

FIXTURE = Path(__file__).resolve().parents[2] / 'parity' / 'fixtures' / 'idm_published.json'


def published_hits(path):
    """Whether the attacker hits the ego, by the clip's name."""
    fixture = json.loads(Path(path).read_text())
    column = fixture['out_fields'].index('hit')
    return {case['in'][:-len('.csv')]: case['out'][column] for case in fixture['cases']}


def our_hits(path):
    """(type, hit) by the clip's name; hit is None where the clip was not tested."""
    with open(str(path)) as file:
        rows = [row for row in csv.DictReader(file) if row['planner'] in ('idm_published', '')]
    return {row['name']: (row['type'], int(row['published_hit']) if row['published_hit'] else None) for row in rows}


def main(results, fixture=FIXTURE):
    expected = published_hits(fixture)
    counts = {}
    untested = differing = 0
    for name, (kind, hit) in sorted(our_hits(results).items()):
        if name not in expected:
            continue
        if hit is None:
            untested += 1
            continue
        if hit != expected[name]:
            differing += 1
            print('{}: {} here, {} published'.format(name, hit, expected[name]))
        for group in (kind, 'all'):
            number, here, there = counts.get(group, (0, 0, 0))
            counts[group] = (number + 1, here + hit, there + expected[name])
    for group, (number, here, there) in sorted(counts.items()):
        print('{}: {} clips, hit in {:.4f} here and {:.4f} published'.format(group, number, here / number,
                                                                            there / number))
    print('{} clips differ, {} were not tested'.format(differing, untested))
    return 1 if differing or not counts else 0


if __name__ == '__main__':
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__.split('\n', maxsplit=1)[0])
    sys.exit(main(*sys.argv[1:]))
