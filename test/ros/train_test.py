#!/usr/bin/python3
"""train: on embedded logs, alone and over ranks, and how it goes on."""
import csv
import os
import re
import subprocess

import road
from road import DATAROOT, VERSION

FEW = {'max_agents': 4, 'max_lanes': 4, 'lane_points': 4, 'max_ways': 2, 'way_anchors': 7, 'hidden': 8, 'scene': 8,
       'anchor': 8, 'epochs': 3, 'min_vehicle_speed': 30.0}  # no vehicle in the ego's place


class TrainTest(road.RoadTest):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.config = road.copy_config(cls.folder / 'config')
        path = cls.config / 'training.yaml'
        text = path.read_text()
        for key, value in FEW.items():
            text, count = re.subn(r'(?m)^(  {}: )\S+'.format(key), r'\g<1>{}'.format(value), text)
            assert count == 1, key
        path.write_text(text)

    def train(self, out, *arguments, ranks=1):
        command = [road.tool('train'), '--config', self.config, '--dataroot', DATAROOT, '--version', VERSION,
                   '--out', out, *arguments]
        if ranks > 1:
            command = ['mpirun', '--oversubscribe', '-np', ranks, *command]
        environment = dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT='1', OMPI_ALLOW_RUN_AS_ROOT_CONFIRM='1')
        return subprocess.run([str(word) for word in command], env=environment, stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE, universal_newlines=True, timeout=road.TOOL_TIMEOUT, check=False)

    def trained(self, name, *arguments, ranks=1):
        out = self.folder / name
        result = self.train(out, *arguments, ranks=ranks)
        self.assertEqual(result.returncode, 0, result.stderr)
        return out

    def losses(self, out):
        with open(str(out / 'metrics.csv')) as file:
            return [float(row['ego']) for row in csv.DictReader(file)]

    def test_two_ranks_learn_together(self):
        out = self.trained('ranks', ranks=2)
        losses = self.losses(out)
        self.assertEqual(len(losses), 3)
        self.assertLess(losses[-1], losses[0] - 0.1)
        again = self.trained('ranks_again', '--stop-after', 2, ranks=2)
        self.trained('ranks_again', '--resume', ranks=2)
        for name in ('weights.bin', 'metrics.csv'):
            self.assertEqual((out / name).read_bytes(), (again / name).read_bytes(), name)

    def test_other_ranks_do_not_go_on(self):
        out = self.trained('two', '--stop-after', 1, ranks=2)
        result = self.train(out, '--resume')
        self.assertEqual(result.returncode, 1)
        self.assertIn('"ranks = 2", not "ranks = 1"', result.stderr)

    def test_a_stopped_run_ends_the_same(self):
        whole = self.trained('whole')
        stopped = self.trained('stopped', '--stop-after', 1)
        self.trained('stopped', '--resume')
        for name in ('weights.bin', 'metrics.csv'):
            self.assertEqual((whole / name).read_bytes(), (stopped / name).read_bytes(), name)


if __name__ == '__main__':
    road.main()
