#!/usr/bin/python3
"""Test that check_options.py finds misread keys and the members of options."""
import unittest

from check_options import members, misread


class CheckOptions(unittest.TestCase):
    def test_a_member_is_read_from_the_key_of_its_name(self):
        self.assertEqual([], misread('  options.step = section.positive("step");\n'))
        self.assertEqual([('step', 'tail')], misread('  options.step = section.positive("tail");\n'))
        self.assertEqual([('head', 'heads')], misread('  o.head =\n      section.choice<Head>(\n          "heads", {'))

    def test_members_of_options_are_found(self):
        header = ('/// config/a.yaml\nstruct RoadOptions : LaneOptions {\n  double step = 0.0;\n'
                  '  std::vector<double> offsets;  ///< m\n};\nstruct Road {\n  int lanes = 0;\n};\n')
        self.assertEqual([('RoadOptions', 'step'), ('RoadOptions', 'offsets')], members(header))


if __name__ == '__main__':
    unittest.main()
