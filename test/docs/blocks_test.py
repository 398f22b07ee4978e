#!/usr/bin/python3
"""usage: blocks_test.py SOURCE_DIR: test of the parser of documents; every entry of arrangements.py is needed."""
import re
import sys
import unittest
from pathlib import Path

from arrangements import INSTEAD, LEFT_OUT, NOT_RUN
from blocks import Command, blocks, commands, is_complete, with_outputs

PAGE = '''# A page

```
first --option
# in another terminal
second "of two
lines" \\
    --option

third
```

```text
output
```

```python
# folder/program.py
print(1)
```
'''


class Blocks(unittest.TestCase):
    def test_are_reported_with_line_and_language(self):
        self.assertEqual([(4, ''), (14, 'text'), (18, 'python')], [(block.line, block.language) for block in blocks(PAGE)])

    def test_without_a_language_hold_commands(self):
        self.assertEqual([(4, 'first --option'), (6, 'second "of two\nlines" \\\n    --option'), (10, 'third')],
                         commands(blocks(PAGE)[0]))

    def test_with_a_path_in_a_comment_are_saved(self):
        self.assertEqual([None, None, 'folder/program.py'], [block.path for block in blocks(PAGE)])

    def test_have_the_output_that_follows(self):
        self.assertEqual([(4, 14), (18, None)], [(block.line, shown and shown.line)
                                                 for block, shown in with_outputs(blocks(PAGE))])

    def test_output_blocks_follow_commands(self):
        for text in ('```text\noutput\n```', '```\nrun\n```\n```text\none\n```\n```text\ntwo\n```',
                     '```yaml\nkey: 1\n```\n```text\noutput\n```',
                     '```python\n# folder/program.py\n```\n```text\noutput\n```'):
            with self.assertRaisesRegex(ValueError, 'an output'):
                with_outputs(blocks(text))


class ExitCode(unittest.TestCase):
    def test_is_in_the_comment_at_the_end_of_a_command(self):
        for text, expected in (('run', 0), ('run  # exit code 3', 3), ('run "# exit code 3"', 0)):
            self.assertEqual(expected, Command(1, text).exit_code, text)


class Complete(unittest.TestCase):
    def test_is_a_command_that_bash_would_run(self):
        for text, expected in (('ls', True), ('ls \\', False), ('for i in 1 2; do', False),
                               ('for i in 1 2; do\nls; done', True), ("cat <<'END'\nline", False),
                               ("cat <<'END'\nline\nEND", True), ('echo "one', False)):
            self.assertEqual(expected, is_complete(text), text)


class Arrangements(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        pages = [page for page in [SOURCE / 'README.md', SOURCE / 'CONTRIBUTING.md', *SOURCE.glob('docs/*.md')]
                 if page.name not in LEFT_OUT]
        cls.commands = [command.text for page in pages for block in blocks(page.read_text()) if not block.language
                        for command in commands(block)]

    def test_are_all_needed(self):
        for pattern, *_ in NOT_RUN + INSTEAD:
            self.assertTrue(any(re.search(pattern, text, re.DOTALL) for text in self.commands),
                            'no command of the documents matches {}: take it out of arrangements.py'.format(pattern))

    def test_leave_out_documents_that_are_there(self):
        for name in LEFT_OUT:
            self.assertTrue((SOURCE / 'docs' / name).exists(), name)


if __name__ == '__main__':
    SOURCE = Path(sys.argv.pop())
    unittest.main()
