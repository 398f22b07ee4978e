#!/usr/bin/python3
"""usage: rviz_pictures.py FOLDER: takes the pictures of scripts/rviz_pictures in the display of DISPLAY."""
import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import rospy
from std_srvs.srv import Trigger

from collision_forge import srv
from collision_forge.msg import CollisionReport
from collision_forge.suite import Master, Program
from collision_forge.waiting import Graph, wait_until

ROOT = Path(__file__).resolve().parent.parent
SCENE, TYPE, NOW, TTA = 'scene-0005', 'opposite_direction', 5.0, 4.0
AFTER = 2.0       # s after the contact
SETTLED = 5.0     # s of the wall clock until RViz has drawn all messages and its view has settled
TIMEOUT = 120.0   # s of the wall clock
COLORS = 256      # of a picture
LEAST_BYTES = 10000  # size of a picture that is not empty
SHOWN = ('/map_markers', '/scene_markers', '/attack_markers', '/shown_area')


def call(name, kind, **fields):
    """Return the response of a service; raise SystemExit if the service reports a failure."""
    answer = rospy.ServiceProxy(name, kind)(**fields)
    if not getattr(answer, 'success', True) or getattr(answer, 'code', 0) != 0:
        raise SystemExit('{}: {}'.format(name, answer.message))
    return answer


def take_picture(path):
    """Take pictures until RViz has drawn something: on a busy machine its window appears late."""
    def missing():
        time.sleep(SETTLED)
        subprocess.run(['import', '-window', 'root', '+dither', '-colors', str(COLORS), 'png8:{}'.format(path)],
                       check=True)
        return ['a picture in {}: RViz shows no scene'.format(path)] if path.stat().st_size < LEAST_BYTES else []
    wait_until(missing, TIMEOUT)
    print(path)


def wait_for_rviz():
    def missing():
        graph = Graph()
        return ['a connection of RViz to ' + topic for topic in SHOWN if '/rviz' not in graph.subscribers_of(topic)]
    wait_until(missing, TIMEOUT)
    rospy.wait_for_service('/player/seek', TIMEOUT)
    rospy.wait_for_service('/generate_collision', TIMEOUT)


def step_to_verdict():
    """Step until the verdict is published, with the first frame of agents after the contact."""
    reports = []
    rospy.Subscriber('/tested_report', CollisionReport, reports.append)
    while not reports:
        call('/player/step', Trigger)
        time.sleep(1.0)


def take_pictures(folder):
    call('/player/seek', srv.Seek, instant=NOW)
    take_picture(folder / 'before.png')
    attack = call('/generate_collision', srv.GenerateCollision, collision_type=TYPE, tta=TTA, mode='replay').attack
    take_picture(folder / 'plan.png')
    contact = NOW + (attack.report.contact_time - attack.header.stamp).to_sec()
    call('/player/seek', srv.Seek, instant=contact)
    step_to_verdict()
    take_picture(folder / 'contact.png')
    call('/player/seek', srv.Seek, instant=contact + AFTER)
    take_picture(folder / 'after.png')


def main():
    folder = Path(sys.argv[1]).resolve()
    with tempfile.TemporaryDirectory(prefix='collision_forge_pictures.') as name:
        made = Path(name)
        subprocess.run(['forge', 'convert', '--source', str(ROOT / 'data/embedded'), '--scene', SCENE, '--out', name],
                       check=True)
        os.environ.update(LIBGL_ALWAYS_SOFTWARE='1', XDG_RUNTIME_DIR=name)
        with Master(made, TIMEOUT):
            bag = made / (SCENE + '.bag')
            with Program(['roslaunch', 'collision_forge', 'replay.launch', 'bag:={}'.format(bag),
                          'start_paused:=true'], made / 'launch.log'):
                rospy.init_node('rviz_pictures', anonymous=True, disable_signals=True)
                wait_for_rviz()
                take_pictures(folder)
    return 0


if __name__ == '__main__':
    sys.exit(main())
