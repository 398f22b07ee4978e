#!/usr/bin/python3
"""scripts/faults: faults that it finds in fake programs, forge passes, and invalid arguments are rejected."""
import os
import subprocess
import tempfile
import unittest
from pathlib import Path

FAULTS = Path(__file__).resolve().parent.parent.parent / 'scripts' / 'faults'


class FaultsTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def faults(self, *only):
        return subprocess.run([str(FAULTS), '--rounds', '1', '--seed', '1', '--only', *only], stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE, universal_newlines=True, timeout=300.0, check=False,
                              env=dict(os.environ, PATH='{}:{}'.format(self.folder, os.environ['PATH'])))

    def pretend(self, script):
        """Write a program that replaces forge; its output is $out."""
        path = self.folder / 'forge'
        path.write_text('#!/bin/bash\nfor out; do :; done\n' + script)
        path.chmod(0o755)

    def assert_fails(self, result, words):
        self.assertEqual((result.stdout.splitlines()[-1], result.returncode), ('1 rounds, 1 failures', 1))
        self.assertIn(words, result.stdout)

    def assert_passes(self, result):
        self.assertEqual((result.stdout.splitlines()[-1], result.returncode), ('1 rounds, 0 failures', 0),
                         result.stdout + result.stderr)

    def test_forge_passes(self):
        self.assert_passes(self.faults('requests', 'kill'))
        self.assert_passes(self.faults('requests', 'full'))

    def test_other_bytes_are_found(self):
        self.pretend('date +%N > "$out"')
        self.assert_fails(self.faults('requests', 'kill'),
                          'requests kill: round 1: output differs from the undisturbed run: out')
        self.pretend('echo same > "$out"')
        self.assert_passes(self.faults('requests', 'kill'))

    def test_what_is_left_beside_the_output_is_found(self):
        self.pretend('[[ $out == */alone/* ]] || touch "$out.part"; echo same > "$out"')
        self.assert_fails(self.faults('requests', 'kill'), 'output differs from the undisturbed run: out.part')

    def test_a_failure_must_name_what_could_not_be_written(self):
        full = '[[ $(ulimit -f) == unlimited ]] || {{ echo "{}" >&2; exit 1; }}; echo same > "$out"'
        self.pretend(full.format('no'))
        self.assert_fails(self.faults('requests', 'full'), 'requests full: round 1: exit code 1: no')
        self.pretend(full.format('forge requests: $out: no'))
        self.assert_passes(self.faults('requests', 'full'))


if __name__ == '__main__':
    unittest.main()
