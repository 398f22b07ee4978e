#!/usr/bin/python3
"""usage: shown_test.py: comparison of shown with printed outputs, and rewriting of shown outputs."""
import unittest

from shown import difference, matches, rewritten

PRINTED = '''reading
1 cut_in: touches nobody in 6.0 s
2 drift: touches the attacker 0c96e8bc after 4.53 s
3 lead_slow: touches nobody in 6.0 s
all: 3 drives
'''


class Matches(unittest.TestCase):
    def check(self, expected, shown, printed=PRINTED):
        self.assertEqual(expected, matches(shown, printed), '{}\n-- of --\n{}'.format(shown, printed))

    def test_the_same_text(self):
        self.check(True, PRINTED)
        self.check(True, '', '\n')

    def test_no_other_number(self):
        self.check(False, PRINTED.replace('4.53', '4.54'))

    def test_no_line_that_is_not_printed(self):
        self.check(False, PRINTED + '4 more\n')
        self.check(False, '...\n4 more\n')
        self.check(False, '4 more\n...\n')

    def test_dots_in_a_line_of_their_own_as_any_lines(self):
        self.check(True, '...')
        self.check(True, '...\n2 drift: touches the attacker 0c96e8bc after 4.53 s\n...')
        self.check(True, 'reading\n...\nall: 3 drives')
        self.check(True, PRINTED + '...')

    def test_lines_in_the_printed_order_alone(self):
        self.check(False, '...\n3 lead_slow: touches nobody in 6.0 s\n...\n1 cut_in: touches nobody in 6.0 s\n...')

    def test_dots_in_a_line_as_any_text_of_that_line(self):
        self.check(True, '...\n2 drift: touches ... after 4.53 s\n...')
        self.check(True, 'Point(x=...)', 'Point(x=1.5, y=2)')
        self.check(False, 'reading\n1 cut_in: ...\nall: 3 drives')
        self.check(False, 'reading ...\nall: 3 drives')

    def test_lines_that_the_document_wraps(self):
        self.check(True, 'one two\nthree\nfour', 'one two three\nfour\n')
        self.check(True, '...\ntwo ...\nfour', 'one\ntwo three four\n')


class Rewritten(unittest.TestCase):
    def check(self, expected, shown, printed=PRINTED):
        self.assertEqual(expected, rewritten(shown, printed))
        self.assertTrue(matches(expected, printed))

    def test_stays_as_it_is_where_it_matches(self):
        shown = '...\n2 drift: touches the\nattacker ...\n...'
        self.check(shown, shown)

    def test_gets_the_printed_numbers(self):
        self.check(PRINTED.strip(), PRINTED.replace('4.53', '4.9').replace('0c96e8bc', '85a5ada5'))

    def test_keeps_dots_for_lines(self):
        self.check('reading\n...\n3 lead_slow: touches nobody in 6.0 s\n...',
                   'reading\n...\n3 lead_slow: touches nobody in 5.8 s\n...')

    def test_keeps_dots_in_a_line(self):
        self.check('...\n2 drift: ... after 4.53 s\n...', '...\n2 drift: ... after 4.60 s\n...')
        self.check('A(x=..., z=4)', 'A(x=..., z=5)', 'A(x=1, y=2, z=4)')

    def test_is_wrapped_as_a_document(self):
        text = rewritten('old', ' '.join(['word'] * 50))
        self.assertEqual([119, 119, 9], [len(line) for line in text.split('\n')])


class Difference(unittest.TestCase):
    def test_shows_only_the_changes(self):
        shown = PRINTED.replace('4.53', '4.60')
        changed = [line for line in difference(shown.strip(), PRINTED).split('\n') if line[0] in '+-'][2:]
        self.assertEqual(['-2 drift: touches the attacker 0c96e8bc after 4.60 s',
                          '+2 drift: touches the attacker 0c96e8bc after 4.53 s'], changed)


if __name__ == '__main__':
    unittest.main()
