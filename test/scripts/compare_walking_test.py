#!/usr/bin/python3
"""What scripts/compare_walking computes."""
import importlib.machinery
import json
import tempfile
import unittest
from pathlib import Path

SCRIPT = Path(__file__).resolve().parents[2] / 'scripts' / 'compare_walking'
compare = importlib.machinery.SourceFileLoader('compare_walking', str(SCRIPT)).load_module()


class CompareWalkingTest(unittest.TestCase):
    def test_the_area_is_half_for_equal_and_one_for_separate_samples(self):
        self.assertEqual(compare.area([1.0, 2.0], [1.0, 2.0]), 0.5)
        self.assertEqual(compare.area([1.0, 2.0], [3.0, 4.0]), 1.0)
        self.assertEqual(compare.area([3.0, 4.0], [1.0, 2.0]), 1.0)

    def test_attackers_count_from_t0_to_the_contact_while_they_move(self):
        def line(agent_class):
            points = [{'t': t, 'v': v} for t, v in ((0.0, 0.0), (1.0, 1.0), (2.0, 2.0), (3.0, 9.0))]
            return json.dumps({'attacker': {'class': agent_class, 'trajectory': points}, 'report': {'contact_t': 2.0}})
        self.assertEqual(list(compare.attackers([line('pedestrian'), line('car'), '{"attacker": null}'])), [1.5])

    def test_recorded_people_are_adults_and_children_that_move(self):
        def table(name, rows):
            (Path(folder) / (name + '.json')).write_text(json.dumps(rows), encoding='utf-8')
        with tempfile.TemporaryDirectory() as folder:
            table('sample', [{'token': 's' + str(i), 'timestamp': i * 1000000} for i in range(3)])
            table('category', [{'token': 'c', 'name': 'human.pedestrian.child'}, {'token': 'v', 'name': 'vehicle.car'}])
            table('instance', [{'token': 'child', 'category_token': 'c'}, {'token': 'car', 'category_token': 'v'}])
            table('sample_annotation', [{'instance_token': who, 'sample_token': 's' + str(i), 'translation': [x, 0, 0]}
                                        for who in ('child', 'car') for i, x in enumerate((0.0, 1.2, 1.3))])
            self.assertEqual(list(compare.recorded(Path(folder))), [1.2])


if __name__ == '__main__':
    unittest.main()
