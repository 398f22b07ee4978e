#!/usr/bin/python3
"""Errors of the launch files for wrong arguments, before a node starts."""
import subprocess

import live
import road
from derived_object_msgs.msg import ObjectArray

TIMEOUT = 60.0  # s


class LaunchTest(road.RoadTest):
    SCENES = ['scene-0007']

    def refusal(self, launch, *arguments):
        """Return the error line of a launch that ends at once."""
        result = subprocess.run(['/usr/bin/roslaunch', road.PACKAGE, launch, *arguments], stdout=subprocess.PIPE,
                                stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL, universal_newlines=True,
                                timeout=TIMEOUT, check=False)
        self.assertNotEqual(result.returncode, 0)
        self.assertNotIn('process[', result.stdout, 'a node was started')
        line, = [line for line in result.stdout.splitlines() if line.startswith('launch argument')]
        return line

    def test_a_missing_bag_is_named_with_its_absolute_path(self):
        self.assertEqual(self.refusal('replay.launch', 'bag:=/nowhere.bag', 'rviz:=false'),
                         'launch argument bag:=/nowhere.bag: no such file or folder')

    def test_an_unknown_word_of_after_contact_is_named_with_those_that_are_known(self):
        for launch, arguments in (('collision_forge.launch', []),
                                  ('replay.launch', ['bag:={}'.format(self.bag('scene-0007')), 'rviz:=false'])):
            self.assertEqual(self.refusal(launch, 'after_contact:=fly', *arguments),
                             'launch argument after_contact:=fly: neither stop nor drive_on')

    def test_a_missing_folder_of_configuration_is_named(self):
        for launch, arguments in (('collision_forge.launch', []),
                                  ('replay.launch', ['bag:={}'.format(self.bag('scene-0007')), 'rviz:=false'])):
            self.assertIn('config_dir:=/nowhere: no such file',
                          self.refusal(launch, 'config_dir:=/nowhere', *arguments))

    def test_a_mistyped_key_of_configuration_is_named_with_its_file_and_a_near_match(self):
        folder = self.path('config')
        folder.mkdir()
        (folder / 'live.yaml').write_text('live: {kept: 20.0}\n')
        line = self.refusal('collision_forge.launch', 'config_dir:={}'.format(folder))
        self.assertIn('live.kept = 20.0 is an unknown key; did you mean kept_for?', line)


class MessageClassTest(road.RoadTest):
    def test_the_class_of_injected_objects_has_the_checksum_of_derived_object_msgs(self):
        self.assertEqual(ObjectArray._md5sum, '492c83cd255b9a57845d0c197d7977be')


if __name__ == '__main__':
    live.main('launch_test')
