#!/usr/bin/python3
"""Test that check_type_names.py finds type names that are defined twice."""
import shutil
import sys
import tempfile
import unittest
from pathlib import Path

from check_type_names import SKIPPED, violations


def violations_of(*contents):
    """Return violations() of a tree with headers src/0.h, src/1.h and so on, each wrapped into namespace forge."""
    with tempfile.TemporaryDirectory() as source_dir:
        for i, content in enumerate(contents):
            path = Path(source_dir, 'src', '{}.h'.format(i))
            path.parent.mkdir(exist_ok=True)
            path.write_text('namespace forge {{\n{}\n}}  // namespace forge\n'.format(content))
        return violations(source_dir)


class CheckTypeNames(unittest.TestCase):
    def test_different_names_pass(self):
        self.assertEqual([], violations_of('struct A { int a; };', 'struct B { int a; };'))

    def test_two_types_with_one_name_are_found(self):
        self.assertEqual(['forge::A is defined 2 times: src/0.h:2, src/1.h:2'],
                         violations_of('struct A { int a; };', 'struct A { double b; };'))

    def test_types_in_unnamed_namespaces_and_functions_may_share_names(self):
        own = 'namespace {\nstruct A { int a; };\n}  // namespace\nint f() { struct B {}; return 0; }'
        self.assertEqual([], violations_of(own, own, 'struct A { int a; };\nstruct B {};'))


if __name__ == '__main__':
    if shutil.which('ctags') is None:
        print('ctags is not installed')
        sys.exit(SKIPPED)
    unittest.main()
