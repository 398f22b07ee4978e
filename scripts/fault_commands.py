"""Commands of forge over data/embedded for scripts/faults, each a few seconds long."""
import re
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
DATA = ROOT / 'data' / 'embedded'
SCENES = ['scene-0001', 'scene-0007']
LOGS = ['--dataroot', DATA, '--version', 'v1.0-embedded']
SETTINGS = {  # by file of config/, so that commands take seconds
    'study/training.yaml': {'epochs': 3, 'min_vehicle_speed': 30.0},
    'study/generators.yaml': {'epochs': 3}, 'study/dataset.yaml': {'begin_stride': 2.0, 'junction_crossing': 1, 'ltap': 1}}
GRID = 'idm:\n  idm.standard.min_gap: [1.0, 4.0]\n'


def inputs(folder):
    """Return the arguments of forge that create each input of the commands, by the path of the input."""
    made = {folder / 'clips': ['study', 'dataset', *LOGS, '--scene', *SCENES],
            folder / 'bags': ['convert', *LOGS, '--scene', SCENES[0]]}
    asked = [('both', SCENES, '4'), *((scene, [scene], '8') for scene in SCENES)]
    for name, scenes, stride in asked:
        requests = folder / (name + '_requests.jsonl')
        made[requests] = ['requests', *LOGS, '--scene', *scenes, '--stride', stride, '--tta', '2', '4']
        made[folder / (name + '.jsonl')] = ['generate', *LOGS, '--requests', requests, '--mode', 'replay']
    return made


def commands(folder):
    """Return the arguments of every command but --out and --config, by name; the inputs are in `folder`."""
    requests, attacks = ['--requests', folder / 'both_requests.jsonl'], folder / 'both.jsonl'
    clips = ['--dataroot', DATA, '--collide', folder / 'clips', '--split', 'train']
    return {
        'convert': ['convert', *LOGS],
        'convert-scenarionet': ['convert', *LOGS, '--to', 'scenarionet'],
        'dataset': inputs(folder)[folder / 'clips'],
        'evaluate': ['study', 'evaluate', *LOGS, *requests],
        'evaluate-clips': ['study', 'evaluate', *clips, '--limit', '4'],
        'export': ['export', '--to', 'openscenario', *LOGS, '--scenarios', attacks],
        'export-commonroad': ['export', '--to', 'commonroad', *LOGS, '--scenarios', attacks],
        'export-mcap': ['export', '--to', 'mcap', '--bag', folder / 'bags' / (SCENES[0] + '.bag')],
        'export-scenarionet': ['export', '--to', 'scenarionet', *LOGS, '--scenarios', attacks],
        'generate': ['generate', *LOGS, *requests],
        'generate-clips': ['generate', *LOGS, *requests, '--format', 'csv-collide'],
        'inject': ['inject', '--bag', folder / 'bags' / (SCENES[0] + '.bag'), '--type', 'lane_change', '--tta', '3',
                   '--now', '5'],
        'report': ['report', attacks, *LOGS],
        'requests': inputs(folder)[folder / 'both_requests.jsonl'],
        'speeds': ['study', 'speeds', 'fit', *LOGS],
        'test': ['test', *LOGS, '--scenarios', attacks, '--planners', 'idm'],
        'test-clips': ['study', 'test', *clips, '--planners', 'idm'],
        'test-until-hit': ['test', *LOGS, '--until-hit', '--tries', '2', '--scene', *SCENES, '--planners', 'idm'],
        'train': ['study', 'train', *LOGS],
        'train-generator': ['study', 'train', '--generator', 'c_sgan', '--dataroot', DATA, '--collide', folder / 'clips'],
        'tune': ['tune', *LOGS, '--planner', 'idm', '--grid', folder / 'grid.yaml', '--train',
                 folder / (SCENES[0] + '.jsonl'), '--test', folder / (SCENES[1] + '.jsonl')]}


def write_settings(folder):
    """Write the configuration files with SETTINGS, and the grid of `tune`."""
    (folder / 'config' / 'study').mkdir(parents=True)
    (folder / 'grid.yaml').write_text(GRID)
    for name, values in SETTINGS.items():
        text = (ROOT / 'config' / name).read_text()
        for key, value in values.items():
            text, count = re.subn(r'(?m)^( +{}: )\S+'.format(key), r'\g<1>{}'.format(value), text)
            assert count, key
        (folder / 'config' / name).write_text(text)
