#!/usr/bin/python3
"""What scripts/compare_methods makes of forge's answers; a stand-in answers for forge."""
import json
import os
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

PACKAGE = Path(__file__).resolve().parent.parent.parent
HEAD = '| method | LC | OD | RE | JC | LTAP | 0.5-1 s | all |\n|---|---|---|---|---|---|---|---|\n'

# Every rate tells what it is of: the method's place among the known ones, then what is asked.
STAND_IN = '''#!/usr/bin/python3
import json, os, pathlib, sys
words = [word for word in sys.argv[1:] if word != 'study']
value = lambda name: words[words.index(name) + 1]
known = ['recorded', 'constant_velocity', 'c_strive', 'strive_optimised', 'network', 'network+search']
if '--requests' in words:
    known.remove('recorded')
if '--method' in words and value('--method') == '?':
    sys.exit('forge study evaluate: --method: method "?" is none of ' + ', '.join(known))
open({calls!r}, 'a').write(' '.join(words) + '\\n')
if pathlib.Path({stop!r}).exists() and pathlib.Path({stop!r}).read_text() in words:
    print('one\\n\\nno luck', file=sys.stderr)
    sys.exit(3)
head = {head!r}

def table(title, rows):
    print('\\n' + title + ', %\\n\\n' + head, end='')
    for name, rate in rows.items():
        print('| {{}} | {{}} | - | 3.0 | 4.0 | 5.0 | 99.9 | {{}} [1, 2] |'.format(name, rate, rate))
    print('| of | 1 | 0 | 1 | 1 | 1 | 1 | 5 |')

trained = open(value('--config') + '/weights.bin', 'rb').read()[0] - 1
if words[0] == 'evaluate' and '--collide' in words:
    clips = len(os.listdir(pathlib.Path(value('--collide'), 'trajectory', value('--split'))))
    print('COLLIDE val, {{}} clips; rates'.format(clips))
    rate = 10.0 + known.index(value('--method')) + trained + 0.2 * (value('--mode') == 'adaptive')
    rows = {{'recorded': 98.0, 'constant_velocity': 28.0, value('--method'): rate}}
    if value('--method') in ('recorded', 'constant_velocity'):
        rows = {{'recorded': 98.0, 'constant_velocity': 28.0}}
    if value('--protocol') == 'published':
        table('Collision rate', rows)
        table('Similarity, of the collisions', {{name: rate / 2 for name, rate in rows.items()}})
    else:
        table('All conditions, angle bands', {{name: rate + 0.5 * ('--seen-scenes' in words)
                                               for name, rate in rows.items()}})
        table('All conditions, full definitions', {{name: 0.0 for name in rows}})
elif words[0] == 'evaluate':
    print('v, strict protocol, {{}} requests of 2 scenes'.format(len(open(value('--requests')).readlines())))
    adaptive = {{'adaptive': 55.0}} if value('--mode') == 'adaptive' else {{}}
    table('All conditions, full definitions', {{'constant_velocity': 1.0, **adaptive, value('--method'): 44.0}})
elif words[0] == 'test':
    sys.stdout = open(value('--out') + '/table.md', 'w')
    print('5 cases, tested: 4')
    base = 50.0 if value('--drive') == 'recorded' else 60.0 + known.index(value('--method'))
    table('Collisions with the attacker', {{name: base + i / 10
                                            for i, name in enumerate(value('--planners').split(','))}})
elif words[0] == 'tune':
    train = value('--train-method')
    if value('--test-method') != 'network+search':
        sys.exit('not compared on ours')
    if 'none' in value('--config') and train == 'c_strive':
        sys.exit('forge tune: there is no avoidable collision')
    sys.stdout = open(value('--out') + '/table.md', 'w')
    print('Training: 9 cases, tested: 7\\n\\nTest: 8 cases, tested: 6')
    table('Collisions with the attacker', {{'default': 70.0, 'tuned': 30.0 if train == 'c_strive' else 20.0}})
elif words[0] == 'measure':
    print('| method | clips | median ms | mean ms | 95 % ms |\\n|---|---|---|---|---|')
    print('| {{}} | 2 | 1.500 | 2.500 | 3.500 |'.format(value('--methods')))
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
        clips = self.root / 'collide' / 'trajectory' / 'val'
        clips.mkdir(parents=True)
        for number in range(10):
            (clips / 'clip{}.csv'.format(number)).touch()
        self.config = self.root / 'config'
        self.config.mkdir()
        (self.config / 'models.yaml').write_text('pattern_network: weights.bin\n', encoding='utf-8')
        (self.config / 'weights.bin').write_bytes(bytes([1]))
        self.requests = self.root / 'requests.jsonl'
        self.requests.write_text(''.join(json.dumps({'scene': 'scene-{}'.format(number % 4), 'now': number}) + '\n'
                                         for number in range(8)), encoding='utf-8')

    def compare(self, *words):
        command = [PACKAGE / 'scripts' / 'compare_methods', '--dataroot', 'ROOT', '--version', 'V', '--collide',
                   self.root / 'collide', '--out', self.out, '--config', self.config, *words]
        return subprocess.run(command, env=self.environment, capture_output=True, text=True, check=False)

    def done(self, *words):
        result = self.compare(*words)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(result.stdout, (self.out / 'tables.md').read_text(encoding='utf-8'))
        return result.stdout

    def called(self):
        return self.calls.read_text(encoding='utf-8').splitlines() if self.calls.exists() else []

    def section(self, text, title):
        return next(part for part in text.split('## ') if part.startswith(title))

    def test_published_rates_stand_beside_the_papers(self):
        text = self.done('--only', 'published')
        for scenes in ('seen', 'unseen'):
            title = 'Published protocol, collision rate / similarity, %, history mode, val, '
            part = self.section(text, title + scenes)
            self.assertIn('| recorded | 10 | 98.0 / 49.0 | - / - | 3.0 / 3.0 |', part)
            self.assertIn('| c_strive | 10 | 12.0 / 6.0 |', part)
            self.assertIn('| 12.0 [1, 2] / 6.0 [1, 2] |\n', part)
            self.assertIn('| C-STRIVE (paper, test split) | - | 32 / 52 | 21 / 75 | 39 / 93 | 16 / 52 | 15 / 18 | '
                          '25 / 68 |', part)
            self.assertNotIn('99.9', part, 'a column of times')
            self.assertNotIn('| c_mid |', part)
            self.assertIn('| network+search | 10 | 15.0 / 7.5 |', part)
            self.assertIn('| network+search:adaptive | 10 | 15.2 / 7.6 |', part)
            self.assertIn('Left out', part)
            self.assertIn('`c_mid`', part)
        self.assertIn('--seeds 3', self.called()[0])

    def test_trainings_are_averaged_with_their_interval(self):
        others = []
        for number in (1, 2):
            others.append(self.root / 'seed{}'.format(number))
            shutil.copytree(self.config, others[-1])
            (others[-1] / 'weights.bin').write_bytes(bytes([number + 1]))
        text = self.done('--only', 'trainings', '--trainings', *others)
        # 12, 13 and 14 %: mean 13, standard deviation 1, 4.30 / sqrt(3) of it; similarities are half of them.
        self.assertIn('| c_strive | 3 | 13.0 [11, 15] / 6.5 [5, 8] | - / - | 3.0 [3, 3] / 3.0 [3, 3] |', text)
        self.assertIn('| C-STRIVE (paper, test split) | - | 32 / 52 |', text)
        self.assertNotIn('| network |', text)
        self.assertEqual(len(self.called()), 3)
        self.assertEqual(self.compare('--only', 'trainings').returncode, 2)
        self.assertEqual(self.compare('--only', 'trainings', '--trainings', *others * 3).returncode, 2)

    def test_tuning_is_compared_in_scenes_not_tuned_on(self):
        text = self.done('--only', 'tuning', '--tuning-clips', '4')
        for row in ('| default | - | 6 | 70.0 |', '| tuned on c_strive | 7 | 6 | 30.0 |',
                    '| tuned on network+search | 7 | 6 | 20.0 |', '| default (paper, test split) | - | - | 8.1 |'):
            self.assertIn(row, text)
        self.assertEqual(len(self.called()), 2, 'default and tuned are of one run')
        self.assertIn('/clips/val-4 ', self.called()[0])

    def test_a_run_that_is_done_is_not_done_again(self):
        words = ('--only', 'strict', '--methods', 'network')
        before = self.done(*words)
        self.assertEqual(self.done(*words), before)
        self.assertEqual(len(self.called()), 2)
        (self.config / 'weights.bin').write_bytes(bytes([2]))
        self.done(*words)
        self.assertEqual(len(self.called()), 4, 'with other weights')

    def test_a_run_that_fails_is_told_and_the_others_are_made(self):
        self.stop.write_text('network', encoding='utf-8')
        words = ('--only', 'strict,planners', '--methods', 'network,c_strive')
        result = self.compare(*words)
        self.assertEqual(result.returncode, 1)
        self.assertIn('| network | failed | - | - | - | - | - | - |\n', result.stdout)
        self.assertIn('| c_strive | 10 | 12.0 |', result.stdout)
        self.assertIn('| pdm | recorded | 5 |', result.stdout)
        self.assertIn('strict/seen/network: exit status 3: no luck', result.stderr)
        self.stop.unlink()
        self.calls.unlink()
        self.assertIn('| network | 10 | 14.0 |', self.done(*words))
        self.assertEqual(len(self.called()), 2)


if __name__ == '__main__':
    unittest.main()
