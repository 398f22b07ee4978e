#!/usr/bin/python3
"""Test the charts of the study: their input files, and that pictures are reproducible."""
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

PROGRAMS = Path(__file__).resolve().parents[3] / 'python' / 'collision_forge_study'
sys.path.insert(0, str(PROGRAMS))
import charts  # noqa: E402

TABLE = '''measure,method,group,trials,value,low,high
hit,a,RE,0,,,
hit,a,all,200,0.8125,0.7760,0.8440
hit,b,RE,20,0.8500,,
fair,a,all,10,0.5000,,
'''
CALIBRATION = 'column,decile,attacks,promised,kept,low,high\nfull,1,20,0.2500,0.3000,,\nfull,2,20,0.7500,0.7000,0.6,0.9\n'
METRICS = 'epoch,loss,validation\n1,2.0,3.0\n2,nan,2.5\n'


class ChartsTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        for name, text in (('table.csv', TABLE), ('calibration.csv', CALIBRATION), ('metrics.csv', METRICS)):
            (self.folder / name).write_text(text)

    def draw(self, *arguments):
        subprocess.run(['/usr/bin/python3', str(PROGRAMS / 'charts.py'), '--title', 'A title', *map(str, arguments)],
                       check=True)
        return {path.name: path.read_bytes() for path in self.folder.glob('*.png')}

    def test_rates_without_trials_are_omitted_and_intervals_are_optional(self):
        self.assertEqual(charts.read_rates(self.folder / 'table.csv'),
                         [('hit', 'a', 'all', 0.8125, (0.776, 0.844)), ('hit', 'b', 'RE', 0.85, None),
                          ('fair', 'a', 'all', 0.5, None)])

    def test_each_file_has_a_chart_and_charts_are_reproducible(self):
        arguments = ('--rates', self.folder / 'table.csv', '--measures', 'hit', '--calibration',
                     self.folder / 'calibration.csv', '--curves', self.folder / 'metrics.csv', '--columns', 'loss',
                     'validation')
        drawn = self.draw(*arguments)
        self.assertEqual(set(drawn), {'hit.png', 'calibration.png', 'curves.png'})
        for picture in drawn.values():
            self.assertEqual(picture[:4], b'\x89PNG')
        self.assertEqual(self.draw(*arguments), drawn)

    def test_an_unreadable_file_is_named_and_nothing_is_drawn(self):
        result = subprocess.run(['/usr/bin/python3', str(PROGRAMS / 'charts.py'), '--rates', str(self.folder / 'none.csv')],
                                stderr=subprocess.PIPE, universal_newlines=True, check=False)
        self.assertEqual(result.returncode, 1)
        self.assertRegex(result.stderr, "^charts.py: FileNotFoundError: .*none.csv'\n$")
        self.assertEqual(list(self.folder.glob('*.png')), [])


if __name__ == '__main__':
    unittest.main()
