#!/usr/bin/python3
"""forge possible: collisions possible at a time, for a bag and for a nuScenes root."""
import json
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

    def test_a_bag_as_a_source_and_a_root_give_the_same_list(self):
        of_root = of_the_root('--mode', 'history')
        self.assertEqual(of_root.returncode, 0, of_root.stderr)
        self.assertGreaterEqual(len(rows(of_root)), 8)
        of_source = possible('--source', self.bag(SCENE), '--scene', SCENE, '--mode', 'history')
        self.assertEqual(rows(of_source), rows(of_root), of_source.stderr)

    def test_a_bag_gives_the_list_of_the_live_nodes(self):
        """--bag sorts the agents by id and derives velocities, as live: its list need not be that of the root."""
        result = possible('--bag', self.bag(SCENE), '--mode', 'history')
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

    def test_a_catalogue_is_listed_with_the_reasons(self):
        result = of_the_root('--catalogue', 'un_r157', '--tta', '4')
        self.assertEqual(result.returncode, 0, result.stderr)
        table, reasons = result.stdout.split('\nrejected\n')
        self.assertRegex(table, r'(?m)^un_r157/4\.2\.3_crossing_pedestrian from_side=\w+\n  junction_crossing ')
        self.assertIn('un_r157/4.1.1_free_driving  cannot be requested: there is no crash\n', reasons)
        wrong = of_the_root('--catalogue', 'un_r157', '--name', '4.2.1_fully_blocking_targt')
        self.assertEqual(wrong.returncode, 1)
        self.assertIn('did you mean 4.2.1_fully_blocking_target?', wrong.stderr)

    def test_requests_of_a_catalogue_are_named_and_take_the_other_options(self):
        out = self.path('named.jsonl')
        result = road.run('requests', '--dataroot', DATAROOT, '--version', VERSION, '--scene', SCENE, '--tta', 4,
                          '--stride', 5, '--catalogue', 'nhtsa', '--name', '24_lead_vehicle_slower', '--attackers', 'each',
                          '--believable', 'false', '--out', out)
        self.assertEqual(result.returncode, 0, result.stderr)
        listed = [json.loads(line) for line in out.read_text(encoding='utf-8').splitlines()]
        self.assertGreater(len(listed), 3)
        for request in listed:
            self.assertEqual(request['name'], 'nhtsa/24_lead_vehicle_slower')
            self.assertEqual((request['type'], request['manoeuvre']), ('rear_end', 'lead_slow'))
            self.assertIsNotNone(request['attacker'])
            self.assertIs(request['believable'], False)

    def test_nothing_possible_is_an_exit_code(self):
        result = of_the_root('--type', 'ltap', '--tta', '2')
        self.assertEqual(result.returncode, 3)
        self.assertRegex(result.stdout, '\nrejected\nltap  .* [A-Z_]+: ')


if __name__ == '__main__':
    road.main()
