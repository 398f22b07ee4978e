#!/usr/bin/python3
"""usage: check_launch.py SOURCE_DIR: check that the launch files restart every node that ends.

Nodes in ENDS are excepted; comments in the launch files say why they may end.
"""
import sys
import xml.etree.ElementTree
from pathlib import Path

ENDS = {('rviz', 'rviz'), ('collision_forge', 'player'), ('collision_forge', 'master_watch')}  # package and program


def violations(root):
    files = sorted(root.glob('*.launch'))
    if not files:
        yield 'no launch file in {}'.format(root)
    for path in files:
        for node in xml.etree.ElementTree.parse(str(path)).iter('node'):
            if (node.get('pkg'), node.get('type')) not in ENDS and node.get('respawn') != 'true':
                yield '{}: the node {} has no respawn="true"'.format(path.name, node.get('name'))


def main(source_dir):
    found = list(violations(Path(source_dir, 'launch')))
    print('\n'.join(found) or 'every node is restarted when it ends')
    return 1 if found else 0


if __name__ == '__main__':
    sys.exit(main(sys.argv[1]))
