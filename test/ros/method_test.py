#!/usr/bin/python3
"""A method of a shared library (test/methods) is available in forge, in the live node and in the panel."""
import csv
import json
import shutil
import tempfile
from pathlib import Path

import live
import road
from road import DATAROOT, VERSION

METHOD = 'first_verified_quintic'
ROOT = ('--dataroot', DATAROOT, '--version', VERSION)
SCENE = 'scene-0001'


def library():
    """Return the path of the method's library, built by test/ros/CMakeLists.txt."""
    return Path(shutil.which('forge')).resolve().parent.parent / 'lib' / 'libfirst_verified_quintic.so'


def config_with_method(folder):
    """Create a folder for --config that names the method's library."""
    folder.mkdir()
    (folder / 'methods.yaml').write_text('libraries: [{}]\n'.format(library()))
    return folder


class MethodOfALibraryTest(road.RoadTest):
    """In the commands of forge."""
    SCENES = [SCENE]

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.config = config_with_method(cls.folder / 'config')
        cls.requests = cls.folder / 'requests.jsonl'
        cls.scenarios = cls.folder / 'scenarios.jsonl'
        cls.run_all('requests', *ROOT, '--scene', SCENE, '--stride', 4, '--out', cls.requests)
        cls.run_all('generate', *ROOT, '--config', cls.config, '--method', METHOD, '--mode', 'replay',
                    '--requests', cls.requests, '--out', cls.scenarios)

    @staticmethod
    def run_all(*arguments):
        result = road.run(*arguments)
        assert result.returncode == 0, result.stderr
        return result

    def methods_in(self, out):
        with open(str(out / 'results.csv')) as file:
            return {row['method'] for row in csv.DictReader(line for line in file if not line.startswith('#'))}

    def test_evaluate_measures_it_on_logs(self):
        out = self.path('logs')
        self.run_all('study', 'evaluate', *ROOT, '--config', self.config, '--method', METHOD, '--requests', self.requests,
                     '--out', out)
        self.assertIn(METHOD, self.methods_in(out))

    def test_evaluate_measures_it_on_clips(self):
        clips, out = self.path('clips'), self.path('rates')
        self.run_all('generate', *ROOT, '--config', self.config, '--method', METHOD, '--mode', 'replay',
                     '--requests', self.requests, '--format', 'csv-collide', '--out', clips)
        self.run_all('study', 'evaluate', '--dataroot', DATAROOT, '--config', self.config, '--method', METHOD,
                     '--collide', clips, '--out', out)
        self.assertIn(METHOD, self.methods_in(out))

    def test_inject_attacks_by_it(self):
        found = [json.loads(line) for line in self.scenarios.read_text().splitlines()]
        attack = next(line for line in found if line['status']['code'] == 'OK')
        start = road.read(self.bag(SCENE), '/agents')[0][0].header.stamp.to_sec()
        request = attack['request']
        result = road.inject(self.bag(SCENE), self.path('out.bag'), request['type'], request['tta'],
                             attack['now'] - start + 1e-3, '--mode', 'replay', '--method', METHOD, '--config', self.config)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertEqual(road.read_one(self.path('out.bag'), '/attack').method, METHOD)


class LiveMethodTest(live.LiveTest):
    """In the live suite, and on the topic that the panel lists methods by."""
    SCENES = [SCENE]
    HEARD = ['/encoded_scene', '/attack_methods', '/attack']

    @classmethod
    def setUpClass(cls):
        temporary = tempfile.TemporaryDirectory(prefix='collision_forge_test_')
        cls.addClassCleanup(temporary.cleanup)
        cls.ARGUMENTS = {'config_dir': config_with_method(Path(temporary.name, 'config'))}
        super().setUpClass()

    def test_it_answers_the_service(self):
        self.play_to(10.0)
        codes = {road.CODES[live.ask(kind, tta, mode='replay', method=METHOD).code]
                 for kind in ('rear_end', 'lane_change', 'opposite_direction') for tta in (2.0, 3.0, 4.0)}
        self.assertLessEqual(codes, {'OK', 'NO_ATTACK_WITHIN_LIMITS', 'NO_CANDIDATE', 'ROAD_DOES_NOT_ALLOW'})
        self.assertIn('OK', codes)
        self.assertEqual(self.heard['/attack'].wait(lambda attack: attack.trajectory.attacker_id).method, METHOD)

    def test_methods_that_are_not_there_are_refused(self):
        self.play_to(10.0)
        answer = live.ask('rear_end', 4.0, method='magic')
        self.assertEqual(road.CODES[answer.code], 'INVALID_INPUT')
        self.assertIn('magic', answer.message)


if __name__ == '__main__':
    live.main('method_test')
