#!/usr/bin/python3
"""train: on embedded logs, and how it resumes."""
import csv
import re
import resource
import subprocess

import road
from road import DATAROOT, VERSION

FEW = {'max_agents': 4, 'max_lanes': 4, 'lane_points': 4, 'max_ways': 2, 'way_anchors': 7, 'hidden': 8, 'scene': 8,
       'anchor': 8, 'epochs': 3, 'min_vehicle_speed': 30.0}  # no other vehicle is treated as the ego


class TrainTest(road.RoadTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.config = road.copy_config(cls.folder / 'config')
        path = cls.config / 'study/training.yaml'
        text = path.read_text()
        for key, value in FEW.items():
            text, count = re.subn(r'(?m)^(  {}: )\S+'.format(key), r'\g<1>{}'.format(value), text)
            assert count == 1, key
        path.write_text(text)

    def train(self, out, *arguments, room=None):
        """Run forge train. `room`: maximum file size (bytes), simulates a full disk."""
        command = ['forge', 'study', 'train', '--config', self.config, '--dataroot', DATAROOT, '--version', VERSION,
                   '--out', out, *arguments]

        def limit():
            if room is not None:
                resource.setrlimit(resource.RLIMIT_FSIZE, (room, room))

        return subprocess.run([str(word) for word in command], stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE, universal_newlines=True, timeout=road.TIMEOUT, check=False,
                              preexec_fn=limit, restore_signals=False)

    def trained(self, name, *arguments):
        out = self.folder / name
        result = self.train(out, *arguments)
        self.assertEqual(result.returncode, 0, result.stderr)
        return out

    def losses(self, out):
        with open(str(out / 'metrics.csv')) as file:
            return [float(row['ego']) for row in csv.DictReader(file)]

    def test_logs_of_every_kind_train_the_same_network(self):
        whole = self.trained('tables', '--stop-after', 1)
        for kind in ('bag', 'scenarionet'):
            logs, out = self.folder / kind, self.folder / ('of_' + kind)
            result = road.run('convert', '--source', DATAROOT, '--to', kind, '--out', logs)
            self.assertEqual(result.returncode, 0, result.stderr)
            result = road.run('study', 'train', '--config', self.config, '--source', logs, '--out', out, '--stop-after', 1)
            self.assertEqual(result.returncode, 0, result.stderr)
            self.assertEqual((whole / 'weights.bin').read_bytes(), (out / 'weights.bin').read_bytes(), kind)

    def test_speeds_that_no_model_fits_are_reported(self):
        result = road.run('study', 'speeds', 'fit', '--source', DATAROOT, '--folds', 11, '--out', self.folder / 'speeds.jsonl')
        self.assert_refused(result, '{}: no model can be fitted: 11 folds of 10 scenes'.format(DATAROOT), 'study speeds fit')
        self.assertFalse((self.folder / 'speeds.jsonl').exists())

    def assert_refused(self, result, message, command='study train'):
        self.assertEqual(result.returncode, 1, result.stderr)
        complaints = [line for line in result.stderr.splitlines() if line.startswith('forge {}: '.format(command))]
        self.assertEqual(result.stderr.splitlines()[-1:], complaints, result.stderr)
        self.assertIn(message, complaints[0])


if __name__ == '__main__':
    road.main()
