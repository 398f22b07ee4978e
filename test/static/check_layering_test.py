#!/usr/bin/python3
"""Test that check_layering.py finds includes that violate the table of folders."""
import tempfile
import unittest
from pathlib import Path

from check_layering import DOCUMENT, HEADING, violations


def violations_of(rows, files):
    """Return violations() of a tree: rows are (folder, libraries); files are {path: 'header header'}."""
    with tempfile.TemporaryDirectory() as source_dir:
        table = ['', HEADING, '', '| folder | what | libraries |', '|---|---|---|']
        table += ['| `{}/` | text | {} |'.format(folder, libraries) for folder, libraries in rows]
        table += ['', 'Another table:', '', '| file | what |', '|---|---|', '| a | b |']
        contents = {DOCUMENT: '\n'.join(table)}
        for name, included in files.items():
            contents['src/' + name] = '\n'.join('#include <{}>'.format(header) for header in included.split())
        for name, content in contents.items():
            path = Path(source_dir, name)
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(content)
        return violations(source_dir)


def ours(**files):
    """base__map__lane_h='a.h' is collision_forge/base/map/lane.h that includes a.h."""
    return {'collision_forge/' + '.'.join(key.replace('__', '/').rsplit('_', 1)): included
            for key, included in files.items()}


GEOMETRY, MAP = ('base/geometry', ''), ('base/map', '')
LANE = ours(base__geometry__box_h='', base__map__lane_h='collision_forge/base/geometry/box.h vector')


class CheckLayering(unittest.TestCase):
    def test_a_folder_includes_folders_above_it(self):
        self.assertEqual([], violations_of([GEOMETRY, MAP], LANE))

    def test_a_folder_does_not_include_folders_below_it(self):
        self.assertEqual(
            ['src/collision_forge/base/map/lane.h: collision_forge/base/geometry/box.h: base/geometry is below base/map in '
             + DOCUMENT], violations_of([MAP, GEOMETRY], LANE))

    def test_a_row_with_an_unused_library_is_found(self):
        self.assertEqual([DOCUMENT + ': row base/geometry names Qt, which it does not include'],
                         violations_of([('base/geometry', 'Qt')], ours(base__geometry__a_h='')))

    def test_a_row_without_a_file_is_found(self):
        self.assertEqual([DOCUMENT + ': row base/map has no file'],
                         violations_of([GEOMETRY, MAP], ours(base__geometry__a_h='')))

    def test_a_file_outside_the_folders_is_found(self):
        for file in ('collision_forge/base/physics/a.h', 'collision_forge/a.h', 'a.h', 'collision_forge/base/geometry/b/a.h',
                     'other/base/geometry/a.h'):
            self.assertIn('src/{}: lies in no folder of {}'.format(file, DOCUMENT), violations_of([GEOMETRY], {file: ''}))

    def test_a_library_in_another_folder_is_found(self):
        for library, header in (('ROS', 'ros/ros.h'), ('ROS', 'nav_msgs/Path.h'), ('ROS', 'collision_forge/Agent.h'),
                                ('ROS', 'rviz/panel.h'), ('torch', 'torch/torch.h'), ('torch', 'ATen/ATen.h'),
                                ('yaml-cpp', 'yaml-cpp/yaml.h'), ('RapidJSON', 'rapidjson/reader.h'),
                                ('CLI11', 'CLI/CLI.hpp'), ('cairo', 'cairo.h'), ('giflib', 'gif_lib.h'), ('Qt', 'QLabel')):
            self.assertEqual([], violations_of([('base/scene', library)], ours(base__scene__a_cpp=header)))
            self.assertEqual(['src/collision_forge/base/scene/a.cpp: {}: {} has no place in base/scene'.format(
                header, library)], violations_of([('base/scene', '')], ours(base__scene__a_cpp=header)))

    def test_a_library_included_through_a_header_is_found(self):
        rows = [('study/training', 'torch'), ('app', '')]
        files = ours(study__training__a_h='collision_forge/study/training/b.h', study__training__b_h='torch/torch.h',
                     app__c_cpp='collision_forge/study/training/a.h')
        self.assertEqual(['src/collision_forge/app/c.cpp: collision_forge/study/training/a.h: torch has no place in app'],
                         violations_of(rows, files))
        files['collision_forge/study/training/a.h'] = ''
        files['collision_forge/study/training/a.cpp'] = 'collision_forge/study/training/b.h'
        self.assertEqual([], violations_of(rows, files))

    def test_an_include_cycle_is_found_once(self):
        files = ours(base__map__a_h='', base__map__a_cpp='collision_forge/base/map/b.h',
                     base__map__b_h='collision_forge/base/map/c.h', base__map__c_h='collision_forge/base/map/a.h')
        self.assertEqual(['src/a -> b -> c -> a: a cycle in base/map'], violations_of([MAP], files))


if __name__ == '__main__':
    unittest.main()
