#!/usr/bin/python3
"""forge possible: collisions possible at a time, for a bag and for a nuScenes root."""
import re

import road
from road import DATAROOT, VERSION

SCENE = 'scene-0003'
NOW = 6
ROW = re.compile(r'(?P<type>[a-z_]+) +(?P<tta>\d+) s +(?P<manoeuvre>[a-z_]+) +(?P<id>\S{1,6}) +(?P<attacker>[a-z_, ]+?) +'
                 r'(?P<confidence>\d+) % +(?P<contact>[\d.]+) s +(?P<impact>[\d.]+) m/s')


def possible(*arguments):
    return road.run('possible', '--now', NOW, *arguments)


def of_the_root(*arguments):
    return possible('--dataroot', DATAROOT, '--version', VERSION, '--scene', SCENE, *arguments)


def rows(result):
    return [match.groupdict() for match in map(ROW.fullmatch, result.stdout.splitlines()) if match]


class PossibleTest(road.RoadTest):
    SCENES = [SCENE]

    def test_a_bag_and_a_root_give_the_same_list(self):
        for result in (of_the_root('--mode', 'history'), possible('--bag', self.bag(SCENE), '--mode', 'history')):
            self.assertEqual(result.returncode, 0, result.stderr)
            self.assertGreaterEqual(len(rows(result)), 8)

    def test_every_type_and_time_is_possible_or_has_a_reason(self):
        table, reasons = of_the_root().stdout.split('\nrejected\n')
        asked = {tuple(line.split()[:2]) for line in table.splitlines()[1:]}
        declined = {tuple(line.split()[:2]) for line in reasons.splitlines()}
        self.assertEqual(len(asked) + len(declined), 25)
        self.assertFalse(asked & declined)
        for line in reasons.splitlines():
            self.assertRegex(line, r's  [A-Z_]+: .+')

    def test_listed_collisions_equal_those_of_inject(self):
        row = next(row for row in rows(possible('--bag', self.bag(SCENE))) if 'added' not in row['attacker'])
        out = self.path('listed.bag')
        result = road.inject(self.bag(SCENE), out, row['type'], row['tta'], NOW)
        self.assertEqual(result.returncode, 0, result.stderr)
        attack = road.read_one(out, '/attack')
        self.assertEqual(attack.trajectory.attacker_id[:6], row['id'])
        self.assertEqual(attack.report.manoeuvre, row['manoeuvre'])
        self.assertAlmostEqual(100.0 * attack.report.confidence, float(row['confidence']), delta=0.51)
        by_short_id = road.inject(self.bag(SCENE), out.with_name('short.bag'), row['type'], row['tta'], NOW,
                                  '--attacker', row['id'])
        self.assertEqual(by_short_id.returncode, 0, by_short_id.stderr)

    def test_nothing_possible_is_an_exit_code(self):
        result = of_the_root('--type', 'ltap', '--tta', '2')
        self.assertEqual(result.returncode, 3)
        self.assertRegex(result.stdout, '\nrejected\nltap  .* [A-Z_]+: ')


if __name__ == '__main__':
    road.main()
