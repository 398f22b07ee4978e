#!/usr/bin/python3
"""Test that check_prose.py finds long lines, long sentences and broken links."""
import tempfile
import unittest
from pathlib import Path

from check_prose import violations


def words(count):
    return ' '.join(['word'] * count)


def violations_of(text, name='README.md'):
    """violations() of a tree with the page docs/page.md, which has two headings, and a document with this text."""
    with tempfile.TemporaryDirectory() as source_dir:
        page = Path(source_dir, 'docs', 'page.md')
        page.parent.mkdir()
        page.write_text('# The page\n\n## What it does, `now`\n\n## Files\n\n## Files\n')
        document = Path(source_dir, name)
        document.parent.mkdir(parents=True, exist_ok=True)
        document.write_text(text)
        return list(violations(source_dir))


class Lines(unittest.TestCase):
    def test_a_line_over_120_columns_is_found(self):
        self.assertEqual([], violations_of('x' * 120))
        self.assertEqual(['README.md:2: the line has 121 columns, more than 120'], violations_of('x\n' + 'x' * 121))

    def test_a_readme_over_150_lines_is_found_at_the_root_alone(self):
        self.assertEqual([], violations_of('\n' * 150))
        self.assertEqual(['README.md:151: the file has 151 lines, more than 150'], violations_of('\n' * 151))
        self.assertEqual([], violations_of('\n' * 151, 'data/weights/README.md'))


class Sentences(unittest.TestCase):
    def found(self, text):
        violations = [violation.split(' the sentence') for violation in violations_of(text)]
        return [violation[0] for violation in violations if len(violation) == 2]

    def test_a_sentence_over_45_words_is_found_where_it_starts(self):
        self.assertEqual([], violations_of(words(45).replace(' ', '\n') + '.'))
        self.assertEqual(['README.md:3: the sentence "A word word word word ..." has 46 words, more than 45'],
                         violations_of('x\n\nFirst. A ' + words(22) + '\n' + words(23) + '.'))

    def test_no_sentence_ends_within_a_number_or_at_an_abbreviation(self):
        self.assertEqual(['README.md:1:'], self.found('{0} 1.5 {0}'.format(words(23))))
        self.assertEqual(['README.md:1:'], self.found('{0}, e.g. A\n{0}'.format(words(23))))


class Links(unittest.TestCase):
    def test_links_to_existing_files_and_headings_pass(self):
        self.assertEqual([], violations_of('# Here\n[a](docs) [a](docs/page.md) ![a](docs/page.md)\n[a](#here)'))
        self.assertEqual([], violations_of('[a](docs/page.md#what-it-does-now) [b](docs/page.md#files-1)'))
        self.assertEqual([], violations_of('[a](../../docs/page.md#files)', 'data/weights/README.md'))

    def test_a_link_to_a_missing_file_is_found(self):
        self.assertEqual(['README.md:2: the link docs/way.md leads to no file',
                          'README.md:3: the link a.png leads to no file',
                          'README.md:3: the link docs/way.md#a leads to no file'],
                         violations_of('`a`\n[`a`](docs/way.md)\n[![a](a.png)](docs/way.md#a)'))

    def test_a_link_to_a_missing_heading_is_found(self):
        self.assertEqual(['README.md:1: the link docs/page.md#files-2 leads to no heading'],
                         violations_of('[a](docs/page.md#files-2)'))
        self.assertEqual(['README.md:3: the link #there leads to no heading'],
                         violations_of('# Here\n\n[a](#there)'))


if __name__ == '__main__':
    unittest.main()
