"""usage: metadrive_checks.py FOLDER: the scenarios that MetaDrive lists there, if it finds all of them valid.

Run by the interpreter of an environment with metadrive-simulator. Prints their files, one a line.
"""
import pickle
import sys
from pathlib import Path

from metadrive.scenario.scenario_description import ScenarioDescription
from metadrive.scenario.utils import read_dataset_summary, read_scenario_data


def check(path, metadata):
    scenario = pickle.loads(path.read_bytes())
    ScenarioDescription.sanity_check(scenario, check_self_type=True, valid_check=True)
    told = scenario['metadata']
    if told.keys() != metadata.keys() or told['object_summary'] != metadata['object_summary']:
        raise ValueError('{}: the summary has other metadata'.format(path))
    check_summaries(path, told)


def check_summaries(path, told):
    """Check that the summary in the file equals MetaDrive's own counts."""
    own = read_scenario_data(path, centralize=True)
    ScenarioDescription.update_summaries(own)
    for track, counted in own['metadata']['object_summary'].items():
        summary = told['object_summary'][track]
        if abs(counted.pop('moving_distance') - summary['moving_distance']) > 1e-6:
            raise ValueError('{}: {} drives another distance'.format(path, track))
        if any(summary[key] != value for key, value in counted.items()):
            raise ValueError('{}: {} is told as {}, not {}'.format(path, track, summary, counted))
    for key, counted in own['metadata']['number_summary'].items():
        told_number = told['number_summary'][key]
        is_same = counted == set(told_number) if isinstance(counted, set) else counted == told_number
        if key != 'map_height_diff' and not is_same:  # infinite in MetaDrive if there are no lane lines
            raise ValueError('{}: {} is {}, not {}'.format(path, key, told_number, counted))


def main(folder):
    summary, files, subfolders = read_dataset_summary(folder)
    for name in files:
        check(Path(folder, subfolders[name], name), summary[name])
        print(name)


if __name__ == '__main__':
    main(sys.argv[1])
