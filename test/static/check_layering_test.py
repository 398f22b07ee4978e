#!/usr/bin/python3
"""What check_layering.py must find, and what it must let pass."""
import tempfile
import unittest
from pathlib import Path

from check_layering import DOCUMENT, HEADING, violations


def violations_of(rows, files):
    """violations() of a tree: rows are (room, includes, libraries); files are {path under src: 'header header'}."""
    with tempfile.TemporaryDirectory() as source_dir:
        table = ['', HEADING, '', '| room | what | includes | libraries |', '|---|---|---|---|']
        table += ['| `{}/` | text | {} | {} |'.format(room, includes, libraries) for room, includes, libraries in rows]
        table += ['', 'Of another table:', '', '| file | what |', '|---|---|', '| a | b |']
        contents = {DOCUMENT: '\n'.join(table)}
        for name, included in files.items():
            contents['src/' + name] = '\n'.join('#include <{}>'.format(header) for header in included.split())
        for name, content in contents.items():
            path = Path(source_dir, name)
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(content)
        return violations(source_dir)


def in_rooms(**files):
    """map__lane_h='a.h' is src/collision_forge/map/lane.h that includes a.h."""
    return {'collision_forge/' + '.'.join(key.replace('__', '/').rsplit('_', 1)): included
            for key, included in files.items()}


GEOMETRY = ('geometry', 'nothing', '')
MAP = ('map', 'geometry', '')
LANE = {'collision_forge/geometry/box.h': '', 'collision_forge/map/lane.h': 'collision_forge/geometry/box.h vector'}


class CheckLayering(unittest.TestCase):
    def test_a_room_may_include_what_its_row_names(self):
        self.assertEqual([], violations_of([GEOMETRY, MAP], LANE))

    def test_and_nothing_else(self):
        self.assertEqual(
            ['src/collision_forge/map/lane.h: collision_forge/geometry/box.h: map may not include geometry'],
            violations_of([GEOMETRY, ('map', 'nothing', '')], LANE))

    def test_a_row_names_rows_above_it_only(self):
        found = violations_of([('map', 'geometry', ''), ('geometry', 'map', '')],
                              in_rooms(geometry__a_h='collision_forge/map/b.h', map__b_h='collision_forge/geometry/a.h'))
        self.assertEqual([DOCUMENT + ': row map names geometry, which is no row above it'], found)

    def test_a_row_names_nothing_that_its_room_does_not_include(self):
        self.assertEqual([DOCUMENT + ': row map names geometry, which it does not include'],
                         violations_of([GEOMETRY, MAP], in_rooms(geometry__a_h='', map__b_h='')))
        self.assertEqual([DOCUMENT + ': row geometry names MPI, which it does not include'],
                         violations_of([('geometry', 'nothing', 'MPI')], in_rooms(geometry__a_h='')))

    def test_a_file_in_no_room_is_found(self):
        for file in ('collision_forge/physics/a.h', 'collision_forge/a.h', 'a.h', 'collision_forge/geometry/deep/a.h',
                     'other/geometry/a.h'):
            self.assertEqual(['src/{}: lies in no room of {}'.format(file, DOCUMENT)], violations_of([GEOMETRY], {file: ''}))

    def test_libraries_stay_in_their_rooms(self):
        for library, header in (('ROS', 'ros/ros.h'), ('ROS', 'nav_msgs/Path.h'), ('ROS', 'collision_forge/Agent.h'),
                                ('ROS', 'rviz/panel.h'), ('torch', 'torch/torch.h'), ('torch', 'ATen/ATen.h'),
                                ('MPI', 'mpi.h'), ('yaml-cpp', 'yaml-cpp/yaml.h'), ('RapidJSON', 'rapidjson/reader.h'),
                                ('CLI11', 'CLI/CLI.hpp'), ('cairo', 'cairo.h'), ('giflib', 'gif_lib.h'), ('Qt', 'QLabel')):
            self.assertEqual([], violations_of([('scene', 'nothing', library)], in_rooms(scene__a_cpp=header)))
            self.assertEqual(['src/collision_forge/scene/a.cpp: {}: {} has no place in scene'.format(header, library)],
                             violations_of([('scene', 'nothing', '')], in_rooms(scene__a_cpp=header)))

    def test_no_header_carries_a_library_out_of_its_room(self):
        rows = [('training', 'nothing', 'torch'), ('app', 'training', '')]
        files = in_rooms(training__a_h='collision_forge/training/b.h', training__b_h='torch/torch.h',
                         app__c_cpp='collision_forge/training/a.h')
        self.assertEqual(['src/collision_forge/app/c.cpp: collision_forge/training/a.h: torch has no place in app'],
                         violations_of(rows, files))
        files['collision_forge/training/a.h'] = ''
        files['collision_forge/training/a.cpp'] = 'collision_forge/training/b.h'
        self.assertEqual([], violations_of(rows, files))

    def test_our_own_rooms_are_no_library(self):
        self.assertEqual([], violations_of([('ros', 'nothing', ''), ('app', 'ros', '')],
                                           in_rooms(ros__a_h='', app__b_cpp='collision_forge/ros/a.h')))

    def test_headers_that_include_each_other_end(self):
        self.assertEqual([], violations_of([GEOMETRY], in_rooms(geometry__a_h='collision_forge/geometry/b.h',
                                                                geometry__b_h='collision_forge/geometry/a.h')))

    def test_a_library_that_nobody_knows_is_found(self):
        self.assertIn('row geometry names Fortran', violations_of([('geometry', 'nothing', 'Fortran')],
                                                                  in_rooms(geometry__a_h=''))[0])

    def test_no_table_and_no_file_are_no_success(self):
        self.assertEqual(1, len(violations_of([], in_rooms(geometry__a_h=''))))
        self.assertEqual(1, len(violations_of([GEOMETRY], {})))


if __name__ == '__main__':
    unittest.main()
