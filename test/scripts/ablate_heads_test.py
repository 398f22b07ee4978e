#!/usr/bin/python3
"""What scripts/ablate_heads makes of forge's answers; a stand-in answers for forge."""
import csv
import os
import subprocess
import tempfile
import unittest
from pathlib import Path

PACKAGE = Path(__file__).resolve().parent.parent.parent

STAND_IN = '''#!/usr/bin/python3
import json, pathlib, sys
words = [word for word in sys.argv[1:] if word != 'study']
value = lambda name: words[words.index(name) + 1]
open({calls!r}, 'a').write(' '.join(words) + '\\n')
config = pathlib.Path(value('--config'))
head = (config / 'study' / 'training.yaml').read_text().split('head: ')[1].split()[0]
exec((pathlib.Path(__file__).parent / (words[0] + '.py')).read_text())
'''
TRAIN = '''
if pathlib.Path({stop!r}).exists():
    sys.exit(3)
run = pathlib.Path(value('--out'))
run.mkdir(exist_ok=True)
(run / 'run.txt').write_text('seed ' + value('--seed'))
left_out = ['scene-2'] if value('--fold') == '1' else []
(run / 'weights.bin').write_bytes((json.dumps({{'left_out_scenes': left_out}}) + '\\n').encode() + bytes([255, 0]))
'''
PATTERNS = '''
seed = int((config.parent / 'run' / 'run.txt').read_text().split()[1])
meters = {'regression': 4, 'target_points': 3, 'region_proposal': 2}[head] + seed
print('| clips | | displacement, m | median | kinematic | network | heading, deg |')
print('| all | 10 | {} | 9 | 9 | 9 | {} |'.format(meters, 10 * meters))
'''
EVALUATE = '''
out = pathlib.Path(value('--out'))
out.mkdir()
(out / 'results.csv').write_text("""name,scene,type,tta,method,seed,status,collision,similar,note
a,scene-1,ltap,1,network,0,OK,0,0,
b,scene-1,ltap,1,network,0,OK,1,1,
c,scene-2,ltap,1,network,0,OK,1,1,
d,scene-2,ltap,1,network,0,OK,1,0,
d,scene-2,ltap,1,nominal,0,OK,0,0,
""")
'''


class AblateHeads(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.root = Path(self.folder.name)
        self.calls = self.root / 'calls.txt'
        self.stop = self.root / 'stop'
        forge = self.root / 'bin' / 'forge'
        forge.parent.mkdir()
        forge.write_text(STAND_IN.format(calls=str(self.calls)), encoding='utf-8')
        forge.chmod(0o755)
        for name, body in (('train', TRAIN.format(stop=str(self.stop))), ('measure', PATTERNS), ('evaluate', EVALUATE)):
            (forge.parent / (name + '.py')).write_text(body, encoding='utf-8')
        self.environment = dict(os.environ, PATH='{}:{}'.format(forge.parent, os.environ['PATH']))

    def ablate(self, *words):
        command = [PACKAGE / 'scripts' / 'ablate_heads', '--dataroot', 'ROOT', '--version', 'V', '--collide', 'C',
                   '--out', self.root / 'out', '--seeds', '2', *words]
        return subprocess.run(command, env=self.environment, capture_output=True, text=True, check=False)

    def called(self, command):
        return [line for line in self.calls.read_text(encoding='utf-8').splitlines() if line.startswith(command + ' ')]

    def test_tells_means_and_deviations(self):
        result = self.ablate()
        self.assertEqual(result.returncode, 0, result.stderr)
        table = (self.root / 'out' / 'table.md').read_text(encoding='utf-8')
        self.assertEqual(result.stdout, table)
        self.assertIn('| published | target_points | 2 | 3.50 +- 0.71 | 35.0 +- 7.1 | 0.750 +- 0.000 | 0.667 +- 0.000 |',
                      table)
        self.assertIn('| by_scene | region_proposal | 2 | 2.50 +- 0.71 | 25.0 +- 7.1 | 1.000 +- 0.000 | 0.500 +- 0.000 |',
                      table)
        with open(self.root / 'out' / 'runs.csv', encoding='utf-8', newline='') as file:
            rows = list(csv.DictReader(file))
        self.assertEqual(len(rows), 12)
        self.assertEqual(rows[0]['head'], 'regression')
        self.assertEqual(float(rows[0]['displacement']), 4.0)

    def test_goes_on_where_it_was_stopped(self):
        self.assertEqual(self.ablate('--seeds', '1').returncode, 0)
        self.assertEqual(len(self.called('train')), 6)
        self.stop.touch()
        result = self.ablate()
        self.assertEqual(result.returncode, 1)
        self.assertIn('train: exit status 3', result.stderr)
        self.stop.unlink()
        self.assertEqual(self.ablate().returncode, 0)
        self.assertEqual(len(self.called('train')), 13)  # six, the one that failed, six
        self.assertEqual(self.ablate().returncode, 0)
        self.assertEqual(len(self.called('train')), 13)


if __name__ == '__main__':
    unittest.main()
