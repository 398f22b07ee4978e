#!/usr/bin/python3
"""What scripts/measure_exports computes from OpenDRIVE files."""
import importlib.machinery
import math
import subprocess
import sys
import unittest
from pathlib import Path
from unittest.mock import Mock
from xml.etree import ElementTree

SCRIPT = Path(__file__).resolve().parents[2] / 'scripts' / 'measure_exports'
measure_exports = importlib.machinery.SourceFileLoader('measure_exports', str(SCRIPT)).load_module()


def lane(number, kind='driving', before=None, after=None):
    links = ''.join('<{} id="{}"/>'.format(name, to)
                    for name, to in (('predecessor', before), ('successor', after)) if to)
    width = '<width sOffset="0" a="3" b="0.1"/>'
    return '<lane id="{}" type="{}"><link>{}</link>{}</lane>'.format(number, kind, links, width)


def road(number, name, left, right, rule='RHT', link=''):
    """A straight road of 10 m along y = 0 whose right lanes begin at its reference line."""
    return ElementTree.fromstring(
        '<road id="{}" name="{}" rule="{}" length="10" junction="-1"><link>{}</link><planView>'
        '<geometry s="0" x="0" y="0" hdg="0" length="10"><line/></geometry></planView><lanes>'
        '<laneOffset s="0" a="0" b="0"/><laneSection s="0"><left>{}</left><right>{}</right></laneSection></lanes>'
        '</road>'.format(number, name, rule, link, ''.join(left), ''.join(right)))


class MeasureExportsTest(unittest.TestCase):
    def test_a_name_has_the_left_lanes_and_then_the_right_ones(self):
        one = road(1, 'in out near far', [lane(2), lane(1)], [lane(-1), lane(-2, 'none'), lane(-3)])
        self.assertEqual(measure_exports.lane_ids(one), {1: 'in', 2: 'out', -1: 'near', -3: 'far'})

    def test_links_lead_as_driven(self):
        link = '<successor elementType="road" elementId="2" contactPoint="start"/>'
        for rule, along, against in (('RHT', -1, 1), ('LHT', 1, -1)):
            lanes = {1: [lane(1, after=1)], -1: [lane(-1, after=-1)]}
            first = road(1, 'a b', lanes[1], lanes[-1], rule, link)
            second = road(2, 'c d', [lane(1)], [lane(-1)], rule)
            names = {1: ('a', 'c'), -1: ('b', 'd')}
            self.assertEqual(measure_exports.links_of([first, second]), {names[along], names[against][::-1]}, rule)

    def test_middles_follow_widths_and_may_be_extended(self):
        one = road(1, 'a', [], [lane(-1), lane(-2, 'sidewalk')])
        line, = measure_exports.middle_lines(one, beyond=2.0)
        self.assertEqual((line[0], line[1], line[-1]), ((-2.0, -1.5), (0.0, -1.5), (12.0, -2.0)))
        self.assertTrue(all(math.isclose(y, -1.5 - 0.05 * x) for x, y in line[1:-1]))

    def test_distances_are_from_the_lines_and_not_from_their_points(self):
        lines = measure_exports.Lines([[(0.0, 0.0), (10.0, 0.0)]])
        self.assertAlmostEqual(lines.distance_to(3.3, 0.4), 0.4)
        self.assertAlmostEqual(lines.distance_to(10.3, 0.4), 0.5)
        self.assertEqual(lines.distance_to(3.0, 9.0), math.inf)

    def test_figures_of_no_values_are_dashes(self):
        self.assertEqual(measure_exports.figure(max, [], '.2f'), '-')
        self.assertEqual(measure_exports.figure(max, [0.0, 0.125], '.3f'), '0.125')

    def test_a_contact_at_the_start_is_a_contact(self):
        play = Mock(contact=Mock(return_value=0.0))
        self.assertEqual(measure_exports.lateness(play, 0.5), -0.5)
        play.contact.return_value = None
        self.assertTrue(math.isnan(measure_exports.lateness(play, 0.5)))

    def test_only_a_finished_check_counts_errors(self):
        def errors(code):
            check = subprocess.run([sys.executable, '-c', code], capture_output=True, check=False, text=True)
            return measure_exports.files_with_errors(check)

        self.assertEqual(errors("print('2 files checked')"), set())
        found = "print('a.xodr: one: wrong\\na.xodr: two: wrong\\nb.xosc: one: wrong')\n"
        self.assertEqual(errors(found + "print('2 files checked')"), {'a.xodr', 'b.xosc'})
        for code in ("raise ValueError('broken rules')", found + "raise ValueError('broken rules')"):
            with self.assertRaisesRegex(SystemExit, 'broke off:(.|\\n)*broken rules'):
                errors(code)


if __name__ == '__main__':
    unittest.main()
