"""Differences between the test of the documents and a reader, with reasons."""

# Documents that are not run.
LEFT_OUT = {
    'results.md': 'figures measured on data that is not in the repository, over hours',
}

# Commands that are not run: a pattern and the reason. An entry that matches no command of any document is an error.
NOT_RUN = [
    (r'^(scripts/(demo|sanitize|test|test_interop|setup)|\.ci/run)\b', 'they build and test, this test among others'),
    (r'^python3 test/docs/run_document', 'it is this test'),
    (r'^scripts/api_docs\b', 'wants doxygen, which is optional'),
    (r'^git clone|apt-get install', 'wants a network and changes the machine'),
    (r'^(cmake|ctest|catkin_make)\b|~/ws', 'builds'),
    (r'(^|\s)\.\.\.(\s|$)', 'leaves words out'),
    (r'^rviz\b', 'opens a window'),
    (r'^esmini\b', 'wants esmini, which Debian does not have'),
    (r'--collide (DIR|COLLIDE|out/set)\b', 'wants the data set COLLIDE, or a data set of many scenes'),
    (r'^forge study train\b|^cat RUN', 'trains for hours, or takes what was trained'),
    (r'venv/bin|model:traffic\.pt', 'wants a torch from the network'),
    (r'YOUR_(BAGS|ROS2_BAG)|--source drive\.bag', 'wants bags of another stack'),
]

# Commands that are run in another form: a pattern and its replacement.
INSTEAD = [
    # The test uses fewer times t0 than a reader.
    (r'^(forge requests (?!.*--stride).*)$', r'\1 --stride 8'),
    (r'--tries \d+', '--tries 8'),
    # A reader ends it with Ctrl-C.
    (r'^(rostopic echo .*)$', r'timeout 60 \1 -n 1'),
    # Another collision type is feasible in the embedded scene of this name.
    (r'--type LTAP --now 4 ', '--type lane_change --now 4 '),
]

# Files that a reader has from earlier pages, by path: the command that makes a missing one.
LOGS = '--dataroot DATAROOT --version v1.0-mini'
EARLIER = {
    'out/demo/scene-{}.bag'.format(number): 'forge convert --dataroot data/embedded --version v1.0-embedded '
                                            '--out out/demo --scene scene-' + number
    for number in ('0001', '0003', '0005', '0007')
}
EARLIER.update({
    'bags/scene-0061.bag': 'forge convert {} --scene scene-0061 --out bags'.format(LOGS),
    'ltap.bag': 'forge convert {} --scene scene-0061 --out ltap && forge inject --bag ltap/scene-0061.bag '
                '--type lane_change --now 4 --tta 4 --out ltap.bag'.format(LOGS),
    'requests.jsonl': 'forge requests {} --stride 8 --tta 4 --out requests.jsonl'.format(LOGS),
    'my_planner.pt': 'cp data/weights/planner.pt my_planner.pt',
    'out/planners/results.jsonl': 'forge test {} --scenarios scenarios.jsonl --planners idm --out out/planners'
                                  .format(LOGS),
})
for name, mode, scene in (('scenarios', 'replay', '0103'), ('history', 'history', '0103'), ('replay', 'replay', '0103'),
                          ('a', 'replay', '0061'), ('b', 'replay', '0103')):
    EARLIER[name + '.jsonl'] = (
        'forge requests {logs} --scene scene-{scene} --stride 8 --tta 4 --out {name}.list && '
        'forge generate {logs} --requests {name}.list --mode {mode} --out {name}.all && '
        'grep \'"code":"OK"\' {name}.all > {name}.jsonl'.format(
            logs=LOGS, name=name, mode=mode, scene=scene))

# DATAROOT and NUSCENES in the documents are the reader's nuScenes root: here the embedded scenes, renamed.
DATAROOT, VERSIONS = ('DATAROOT', 'NUSCENES'), ('v1.0-mini', 'v1.0-trainval')
SCENES = {'scene-0001': 'scene-0061', 'scene-0005': 'scene-0103'}
