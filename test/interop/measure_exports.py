#!/usr/bin/python3
"""usage: measure_exports.py SOURCE_DIR SCENARIOS DATAROOT VERSION [EVERY]: see scripts/measure_exports."""
import json
import math
import os
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import commonroad_test
import scenarionet_test
import sumo_roads
from openscenario_test import python_with_asams_rules
from pages import forge
from scenarionet_test import first_touch

FORMATS = ('openscenario', 'commonroad', 'scenarionet')
HERE = Path(__file__).parent


class Exports:
    """The attacks of a scenario file in all formats."""

    def __init__(self, folder, scenarios, logs, every):
        self.folder, self.every = Path(folder), every
        for form in FORMATS:
            begin = time.perf_counter()
            forge('export', '--to', form, '--scenarios', scenarios, *logs, '--out', str(self.folder / form))
            seconds = time.perf_counter() - begin
            size = sum(path.stat().st_size for path in (self.folder / form).iterdir())
            print('{}: {} attacks in {:.1f} s, {:.0f} MB'.format(form, len(self.index(form)), seconds, size / 1e6))

    def index(self, form, every=1):
        lines = (self.folder / form / 'index.jsonl').read_text(encoding='utf-8').splitlines()
        return [json.loads(line) for line in lines][::every]

    def some(self, form):
        """A folder with links to some of the files, and their lines of the index."""
        entries = self.index(form, self.every)
        folder = self.folder / (form + '-some')
        shutil.rmtree(str(folder), ignore_errors=True)
        folder.mkdir()
        for entry in entries:
            for file in entry['files']:
                (folder / file).symlink_to(self.folder / form / file)
        return folder, entries


def measure_asams_rules(exports):
    result = subprocess.run([python_with_asams_rules(), HERE / 'asam_checks.py', exports.folder / 'openscenario'],
                            stdout=subprocess.PIPE, text=True, check=False)
    lines = result.stdout.splitlines()
    print("ASAM's rules: {}, {} errors".format(lines[-1], len(lines) - 1))
    for line in lines[:5 if len(lines) > 1 else 0]:
        print('  ' + line)


def measure_netconvert(exports):
    python = sumo_roads.python_with_netconvert()
    _, entries = exports.some('openscenario')
    distances, unread = [], []
    for entry in entries:
        try:
            distances.append(sumo_roads.farthest(python, exports.folder / 'openscenario' / entry['files'][0],
                                                 exports.folder / 'net.xml'))
        except sumo_roads.RoadsNotRead as error:
            unread.append(str(error))
    print('netconvert: {} maps read, {} not; lanes at most {:.3f} m off, {} maps over 0.2 m'.format(
        len(distances), len(unread), max(distances), sum(distance > 0.2 for distance in distances)))
    for line in unread[:3]:
        print('  ' + line)


def count_touches(name, touches, entries):
    """`touches`: by the names of crashes, s of the first step at which ego and attacker touch, or None."""
    with_contact = [entry for entry in entries if entry['contact_t'] is not None]
    late = [touches[entry['name']] - entry['contact_t'] if touches[entry['name']] is not None else math.inf
            for entry in with_contact]
    wrong = sum(1 for entry in entries if entry['contact_t'] is None and touches[entry['name']] is not None)
    print('{}: {} files read; of {} contacts {} are found within 0.1 s, the latest {:.3f} s after; of {} misses {} '
          'touch'.format(name, len(entries), len(with_contact), sum(-0.002 < delay < 0.1 + 1e-6 for delay in late),
                         max(late, default=0.0), len(entries) - len(with_contact), wrong))


def measure_commonroad(exports):
    folder, entries = exports.some('commonroad')
    found = commonroad_test.findings(commonroad_test.python_with_checker(), folder)
    count_touches('CommonRoad', {name: crash['dt'] * crash['touching'][0] if crash['touching'] else None
                                 for name, crash in found.items()}, entries)
    print('  {} of {} written again and read back the same'.format(
        sum(crash['rewritten'] for crash in found.values()), len(found)))


def measure_metadrive(exports):
    folder, entries = exports.some('scenarionet')
    python = scenarionet_test.python_with_metadrive()
    result = subprocess.run([python, HERE / 'metadrive_checks.py', exports.folder / 'scenarionet'],
                            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    sound = sum(line.startswith('sd_') for line in result.stdout.splitlines())
    print('MetaDrive: {} of {} files are sound'.format(sound, len(exports.index('scenarionet'))))
    touches = {entry['name']: first_touch(scenarionet_test.read_pickle(folder / entry['files'][0]))
               for entry in entries}
    count_touches('ScenarioNet', touches, entries)


def main(source_dir, scenarios, dataroot, version, every='1'):
    os.chdir(source_dir)
    with tempfile.TemporaryDirectory() as folder:
        exports = Exports(folder, scenarios, ['--dataroot', dataroot, '--version', version], int(every))
        for measure in (measure_asams_rules, measure_netconvert, measure_commonroad, measure_metadrive):
            measure(exports)


if __name__ == '__main__':
    main(*sys.argv[1:])
