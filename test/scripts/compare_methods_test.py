#!/usr/bin/python3
"""scripts/compare_methods: its table for the outputs of a fake forge."""
import os
import subprocess
import tempfile
import unittest
from pathlib import Path

PACKAGE = Path(__file__).resolve().parent.parent.parent
HEAD = '| method | LC | OD | RE | JC | LTAP | 0.5-1 s | all |\n|---|---|---|---|---|---|---|---|\n'

# Each rate encodes its method (the index among the known ones) and its mode.
STAND_IN = '''#!/usr/bin/python3
import pathlib, sys
words = sys.argv[2:]
value = lambda name: words[words.index(name) + 1]
known = ['recorded', 'constant_velocity', 'c_strive', 'network', 'network+search']
open({calls!r}, 'a').write(' '.join(words) + '\\n')
if pathlib.Path({stop!r}).exists() and pathlib.Path({stop!r}).read_text() in words:
    print('one\\n\\nno luck', file=sys.stderr)
    sys.exit(3)
head = {head!r}
sys.stdout = open(value('--out') + '/table.md', 'w')

def table(title, rows):
    print('\\n' + title + ', %\\n\\n' + head, end='')
    for name, rate in rows.items():
        print('| {{}} | {{}} | - | 3.0 | 4.0 | 5.0 | 99.9 | {{}} [1, 2] |'.format(name, rate, rate))
    print('| of | 1 | 0 | 1 | 1 | 1 | 1 | 5 |')

if words[0] == 'evaluate':
    print('COLLIDE val, 10 clips; rates')
    rows = {{'recorded': 98.0, 'constant_velocity': 28.0}}
    if value('--method') not in rows:
        rows[value('--method')] = 11.0 + known.index(value('--method')) + 0.2 * (value('--mode') == 'adaptive')
    if value('--protocol') == 'published':
        table('Collision rate', rows)
        table('Similarity, of the collisions', {{name: rate / 2 for name, rate in rows.items()}})
    else:
        table('All conditions, angle bands', rows)
        table('All conditions, full definitions', {{name: 0.0 for name in rows}})
elif words[0] == 'test':
    print('5 cases, tested: 4')
    table('Collisions with the attacker', {{name: 50.0 + i / 10
                                            for i, name in enumerate(value('--planners').split(','))}})
else:
    print('Training: 9 cases, tested: 7\\n\\nTest: 8 cases, tested: 6')
    tuned = 30.0 if value('--train-method') == 'c_strive' else 20.0
    table('Collisions with the attacker', {{'default': 70.0, 'tuned': tuned}})
'''


class CompareMethods(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name)
        self.calls, self.stop, self.out = self.root / 'calls.txt', self.root / 'stop', self.root / 'out'
        forge = self.root / 'bin' / 'forge'
        forge.parent.mkdir()
        forge.write_text(STAND_IN.format(calls=str(self.calls), stop=str(self.stop), head=HEAD), encoding='utf-8')
        forge.chmod(0o755)
        self.environment = dict(os.environ, PATH='{}:{}'.format(forge.parent, os.environ['PATH']))

    def compare(self, *words):
        command = [PACKAGE / 'scripts' / 'compare_methods', '--dataroot', 'ROOT', '--collide', 'CLIPS', '--out', self.out,
                   *words]
        return subprocess.run(command, env=self.environment, capture_output=True, text=True, check=False)

    def done(self, *words):
        result = self.compare(*words)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(result.stdout, (self.out / 'tables.md').read_text(encoding='utf-8'))
        return result.stdout

    def called(self):
        return self.calls.read_text(encoding='utf-8').splitlines()

    def test_published_rates_stand_beside_the_papers(self):
        text = self.done('--only', 'published', '--methods',
                         'recorded,constant_velocity,c_strive,network+search,network+search:adaptive')
        for scenes in ('seen', 'unseen'):
            title = 'Published protocol, collision rate / similarity, %, history mode, val, {} scenes'.format(scenes)
            part = next(part for part in text.split('## ') if part.startswith(title))
            for row in ('| recorded | 10 | 98.0 / 49.0 | - / - | 3.0 / 3.0 |', '| c_strive | 10 | 13.0 / 6.5 |',
                        '| 13.0 [1, 2] / 6.5 [1, 2] |\n', '| network+search | 10 | 15.0 / 7.5 |',
                        '| network+search:adaptive | 10 | 15.2 / 7.6 |',
                        '| C-STRIVE (paper, test split) | - | 32 / 52 | 21 / 75 | 39 / 93 | 16 / 52 | 15 / 18 | 25 / 68 |'):
                self.assertIn(row, part)
            self.assertNotIn('99.9', part, 'a column of times')
        self.assertEqual(len(self.called()), 8, 'the baselines share a run')
        self.assertIn('--seeds 3', self.called()[0])

    def test_tuning_is_compared_in_scenes_not_tuned_on(self):
        text = self.done('--only', 'tuning')
        for row in ('| default | - | 6 | 70.0 |', '| tuned on c_strive | 7 | 6 | 30.0 |',
                    '| tuned on network+search | 7 | 6 | 20.0 |', '| default (paper, test split) | - | - | 8.1 |'):
            self.assertIn(row, text)
        self.assertEqual(len(self.called()), 2, 'default and tuned are of one run')

    def test_a_run_that_fails_is_a_row_and_the_others_are_made(self):
        self.stop.write_text('network', encoding='utf-8')
        result = self.compare('--only', 'strict,planners', '--methods', 'network,c_strive')
        self.assertEqual(result.returncode, 1)
        self.assertIn('| network | failed | - | - | - | - | - | - |\n', result.stdout)
        self.assertIn('| c_strive | 10 | 13.0 |', result.stdout)
        self.assertIn('| pdm | recorded | 5 |', result.stdout)
        self.assertIn('strict/seen/network: exit status 3: no luck', result.stderr)


if __name__ == '__main__':
    unittest.main()
