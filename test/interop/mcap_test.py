#!/usr/bin/python3
"""MCAP files of forge export, read by PyPI's mcap, equal their bags, read by rosbag."""
import hashlib
import json
import math
import os
import subprocess
import tempfile
import unittest
from collections import Counter
from pathlib import Path

import rosbag

from pages import LOGS, forge
from virtual_environments import python_with

SCENE = 'scene-0005'
ATTACK = ['--type', 'opposite_direction', '--now', '5', '--tta', '4', '--mode', 'replay']
MADE = '/collision_forge/'  # prefix of the topics that the export adds


def in_bag(path):
    """Return the sorted [topic, time, hash of the bytes] of all messages."""
    with rosbag.Bag(str(path)) as bag:
        return sorted([topic, time.to_nsec(), hashlib.sha256(raw[1]).hexdigest()]
                      for topic, raw, time in bag.read_messages(raw=True))


def connections_of(path):
    """Return topic, type, definition and other header fields of each connection."""
    taken = ('topic', 'type', 'message_definition')
    with rosbag.Bag(str(path)) as bag:
        return sorted([connection.topic, connection.datatype, connection.msg_def,
                       sorted([key, value.decode() if isinstance(value, bytes) else value]
                              for key, value in connection.header.items() if key not in taken)]
                      for connection in bag._get_connections())


def entities_of(update):
    return {entity['id']: entity for entity in update['entities']}


class McapTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        python = python_with('mcap', 'mcap==1.6.0', 'mcap-ros1-support==0.9.0')
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder, cls.out = Path(folder.name), Path(folder.name, 'mcap')
        forge('convert', *LOGS, '--scene', SCENE, '--out', folder.name)
        cls.bags = {'recorded': cls.folder / (SCENE + '.bag'), 'attacked': cls.folder / 'head_on.bag'}
        forge('inject', '--bag', str(cls.bags['recorded']), *ATTACK, '--out', str(cls.bags['attacked']))
        cls.export(*cls.bags.values())
        reader = Path(__file__).parent / 'mcap_checks.py'
        cls.read = {name: json.loads(subprocess.run([python, reader, cls.file_of(bag)], stdout=subprocess.PIPE,
                                                    check=True).stdout) for name, bag in cls.bags.items()}

    @classmethod
    def export(cls, *bags):
        return forge('export', '--to', 'mcap', '--bag', *map(str, bags), '--out', str(cls.out))

    @classmethod
    def file_of(cls, bag):
        return cls.out / (bag.stem + '.mcap')

    def updates(self, name, topic):
        return [(time, update) for shown, time, update in self.read[name]['shown'] if shown == topic]

    def contact(self):
        with rosbag.Bag(str(self.bags['attacked'])) as bag:
            report = next(message for _, message, _ in bag.read_messages('/tested_report'))
        self.assertTrue(report.contact)
        return report.attacker_id, report.contact_time.to_nsec()

    def test_every_message_has_its_topic_time_and_bytes(self):
        for name, bag in self.bags.items():
            messages = self.read[name]['messages']
            copied = sorted([topic, time, digest] for topic, time, _, _, _, digest in messages
                            if not topic.startswith(MADE))
            self.assertEqual(copied, in_bag(bag))
            self.assertTrue(all(logged == published for _, logged, published, *_ in messages))
            self.assertEqual([message[1] for message in messages], sorted(message[1] for message in messages))

    def test_every_connection_is_a_channel_with_its_definition(self):
        for name, bag in self.bags.items():
            channels = self.read[name]['channels']
            self.assertEqual({channel[2] for channel in channels}, {'ros1'})
            self.assertEqual({channel[5] for channel in channels}, {'ros1msg'})
            copied = sorted([topic, kind, text, sorted(map(list, metadata.items()))]
                            for _, topic, _, metadata, kind, _, text in channels if not topic.startswith(MADE))
            self.assertEqual(copied, connections_of(bag))

    def test_the_summary_lists_the_contents(self):
        for read in self.read.values():
            messages, statistics, chunks = read['messages'], read['statistics'], read['chunks']
            self.assertEqual(read['profile'], 'ros1')
            self.assertEqual(statistics['messages'], len(messages))
            self.assertEqual(statistics['channels'], len(read['channels']))
            self.assertEqual((statistics['start'], statistics['end']), (messages[0][1], messages[-1][1]))
            self.assertEqual({int(channel): count for channel, count in statistics['counts'].items()},
                             Counter(message[4] for message in messages))
            self.assertEqual(statistics['chunks'], len(chunks))
            self.assertEqual(read['records'].count('ChunkIndex'), len(chunks))
            self.assertEqual((min(chunk[0] for chunk in chunks), max(chunk[1] for chunk in chunks)),
                             (statistics['start'], statistics['end']))
            self.assertEqual({chunk[2] for chunk in chunks}, {'lz4'})
            self.assertTrue(all(chunk[3] < chunk[4] for chunk in chunks))
            self.assertEqual(read['records'].count('SummaryOffset'), 4)

    def test_indexes_find_a_topic_from_a_time_on(self):
        for read in self.read.values():
            late = [message for message in read['messages'] if message[0] == '/tf' and message[1] >= read['middle']]
            self.assertEqual(read['late'], len(late))
            self.assertGreater(len(late), 10)

    def test_lanes_and_edges_are_shown_once(self):
        (_, update), = self.updates('recorded', '/collision_forge/map')
        entities = entities_of(update)
        self.assertEqual(set(entities), {'lanes', 'connectors', 'drivable_area'})
        for name in ('lanes', 'drivable_area'):
            lines, = entities[name]['lines']
            self.assertEqual((lines['type'], len(lines['points']) % 2), (2, 0))
            self.assertGreater(len(lines['points']), 20)

    def test_every_frame_shows_all_present_agents(self):
        for name, bag in self.bags.items():
            shown = self.updates(name, '/collision_forge/scene')
            with rosbag.Bag(str(bag)) as source:
                frames = {time.to_nsec(): message for _, message, time in source.read_messages('/agents')}
            self.assertGreaterEqual(len(shown), len(frames) - 1)
            for time, update in shown:
                self.assertEqual([deletion['type'] for deletion in update['deletions']], [1])
                cubes = {entity['id'] for entity in update['entities'] if entity['cubes']}
                self.assertEqual(cubes, {'ego'} | {'agent ' + agent.id for agent in frames[time].agents})

    def test_ego_and_attacker_touch_at_the_contact(self):
        attacker, contact = self.contact()
        shown = self.updates('attacked', '/collision_forge/scene')
        gaps = {}
        for time, update in shown:
            entities = entities_of(update)
            label = [text['text'] for text in entities['agent ' + attacker]['texts']] if 'attack' in entities else []
            self.assertEqual(label, ['attacker'] if 'attack' in entities else [])
            if 'attack' in entities:
                poses = [entities[name]['cubes'][0]['pose']['position'] for name in ('ego', 'agent ' + attacker)]
                gaps[time] = math.hypot(poses[0]['x'] - poses[1]['x'], poses[0]['y'] - poses[1]['y'])
        at_contact = min(gaps, key=lambda time: abs(time - contact))
        self.assertLess(abs(at_contact - contact), 2e6)
        self.assertLess(gaps[at_contact], 6.0)  # m between the middles of two cars, front to front
        self.assertGreater(gaps[min(gaps)], 40.0)


if __name__ == '__main__':
    os.chdir(Path(__file__).parents[2])
    unittest.main()
