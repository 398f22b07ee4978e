#!/usr/bin/python3
"""Test that check_words.py finds its patterns in each kind of file and ignores code."""
import tempfile
import unittest
from pathlib import Path
from unittest import mock

import check_words


def violations_of(name, content):
    """violations() of a tree with this one file, without its name."""
    with tempfile.TemporaryDirectory() as source_dir:
        path = Path(source_dir, name)
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(content)
        return [violation[len(name) + 1:] for violation in check_words.violations(source_dir)]


class Files(unittest.TestCase):
    def test_cpp_comments_and_strings_are_searched(self):
        text = ('int rival = 1;  // rival\n/// Returns the speed.\n/* whom */\n'
                'throw Error("was foretold");\nf("rival");\n')
        self.assertEqual(['1: "rival"', '3: "whom"', '4: "foretold"'], violations_of('src/a/b.h', text))

    def test_a_phrase_over_several_lines_is_found_at_its_first_line(self):
        self.assertEqual(['2: "those of"'], violations_of('src/a.h', '\n/// Adds those\n/// of the ego.\n'))
        self.assertEqual(['1: "those of"'], violations_of('src/a.cpp', 'f("adds those "\n  "of the ego");\n'))

    def test_python_comments_and_strings_are_searched(self):
        text = '"""Return the rival\n\nOf all files."""\nwhom = 1  # whom\n'
        self.assertEqual(['1: "rival"', '3: "Of ..."', '4: "whom"'], violations_of('python/a.py', text))
        self.assertEqual(['2: "rival"'], violations_of('scripts/a', '#!/usr/bin/python3\n"""A rival."""\n'))

    def test_comments_of_scripts_configuration_and_messages_are_searched(self):
        for name in ('config/a.yaml', 'config/study/a.yaml', 'msg/A.msg', 'srv/A.srv'):
            self.assertEqual(['1: "as asked"'], violations_of(name, 'rival: 1  # s, as asked\n'), name)
        self.assertEqual(['2: "as asked"'], violations_of('scripts/a', '#!/bin/bash\nrival=1 # as asked\n'))

    def test_comments_and_documentation_of_launch_files_are_searched(self):
        text = '<launch>\n<!-- rival -->\n<arg name="rival" doc="whom"/>\n</launch>\n'
        self.assertEqual(['2: "rival"', '3: "whom"'], violations_of('launch/a.launch', text))

    def test_documents_are_searched_without_code_and_headings(self):
        text = '# Who attacks\n\nA `rival`\n\n```\nrival\n```\n\n| rival |\n|---|\n\n- Of all\n'
        self.assertEqual(['9: "rival"', '12: "Of ..."'], violations_of('docs/a.md', text))

    def test_other_files_are_not_searched(self):
        self.assertEqual([], violations_of('src/a.txt', 'rival'))
        self.assertEqual(['no source file in {}'], [
            violation.split(' in ')[0] + ' in {}' for violation in check_words.violations('/nonexistent')])


class Patterns(unittest.TestCase):
    def found(self, text):
        return [violation.split(': ')[1].strip('"') for violation in violations_of('README.md', text)]

    def test_a_sentence_without_a_subject_is_found_where_it_begins(self):
        self.assertEqual(['Of ...'], self.found('Of all, the first.'))
        self.assertEqual(['Who ...', 'None ...'], self.found('It ends. Who comes stays. None is left.'))
        self.assertEqual([], self.found('The list of all. It is 0 of 1.'))

    def test_questions_pass(self):
        self.assertEqual([], self.found('What does the option do? It adds a file.'))

    def test_parts_of_words_pass(self):
        self.assertEqual([], self.found('The arrival. The storage room offers space. Totally intellectual.'))

    def test_an_exception_holds_for_its_file_and_line_alone(self):
        with mock.patch.object(check_words, 'EXCEPTIONS', [('README.md', 'what it uses')]):
            self.assertEqual(['what it'], self.found('It includes what it uses.\nIt is what it is.'))


if __name__ == '__main__':
    unittest.main()
