#!/usr/bin/python3
"""usage: example_package_test.py BUILD_DIR: another package builds against the installed one, and forge loads it."""
import json
import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

PACKAGE_FOLDER = Path(__file__).resolve().parents[2]
ROOT = ('--dataroot', PACKAGE_FOLDER / 'data' / 'embedded', '--version', 'v1.0-embedded')


class ExamplePackage(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = Path(folder.name)
        install = cls.folder / 'install'
        cls.environment = dict(os.environ, LD_LIBRARY_PATH=str(install / 'lib'), ROS_PACKAGE_PATH=str(install / 'share'))
        cls.run_program('cmake', '--install', BUILD_DIR, '--prefix', cls.folder / 'install')
        cls.run_program('cmake', '-S', PACKAGE_FOLDER / 'test' / 'example_package', '-B', cls.folder / 'build',
                        '-DCMAKE_PREFIX_PATH={}'.format(cls.folder / 'install'),
                        '-DPYTHON_EXECUTABLE=/usr/bin/python3', '-DCMAKE_BUILD_TYPE=Debug')
        cls.run_program('cmake', '--build', cls.folder / 'build')

    @classmethod
    def run_program(cls, *command):
        """Run a command; return its output."""
        done = subprocess.run([str(word) for word in command], env=cls.environment, text=True, check=False,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        if done.returncode != 0:
            raise AssertionError('{}: exit code {}\n{}'.format(command, done.returncode, done.stdout))
        return done.stdout

    def forge(self, *arguments):
        return self.run_program(self.folder / 'install' / 'bin' / 'forge', *arguments)

    def test_headers_are_installed_under_the_name_of_the_package_alone(self):
        include = self.folder / 'install' / 'include'
        self.assertEqual(['collision_forge'], [path.name for path in include.iterdir()])
        self.assertTrue((include / 'collision_forge' / 'attack' / 'search' / 'attack_method.h').exists())

    def test_the_python_client_is_installed_beside_the_messages(self):
        folder = self.folder / 'install' / 'lib' / 'python3' / 'dist-packages'
        program = ('from collision_forge import CollisionForge; from collision_forge.msg import Attack; '
                   'import collision_forge.pytest_plugin; print(collision_forge.__path__, CollisionForge, Attack)')
        environment = {'PATH': '/usr/bin', 'PYTHONPATH': str(folder), 'PYTHONDONTWRITEBYTECODE': '1'}
        printed = subprocess.run(['/usr/bin/python3', '-c', program], env=environment, cwd=str(self.folder), text=True,
                                 check=True, stdout=subprocess.PIPE).stdout
        self.assertTrue(printed.startswith("['{}']".format(folder / 'collision_forge')), printed)

    def test_its_planner_plans(self):
        self.assertEqual('7\n', self.run_program(self.folder / 'build' / 'devel' / 'lib' / 'example_package' / 'example_planner'))

    def test_forge_generates_with_its_method(self):
        config = self.folder / 'config'
        config.mkdir()
        library = self.folder / 'build' / 'devel' / 'lib' / 'libexample_method.so'
        (config / 'methods.yaml').write_text('libraries: ["{}"]\n'.format(library))
        requests, scenarios = self.folder / 'requests.jsonl', self.folder / 'scenarios.jsonl'
        self.forge('requests', *ROOT, '--out', requests, '--config', config)
        self.forge('generate', *ROOT, '--requests', requests, '--out', scenarios, '--config', config, '--mode', 'replay',
                   '--method', 'example')
        codes = [json.loads(line)['status']['code'] for line in scenarios.read_text().splitlines()]
        self.assertIn('OK', codes)


if __name__ == '__main__':
    BUILD_DIR = sys.argv.pop()
    unittest.main()
