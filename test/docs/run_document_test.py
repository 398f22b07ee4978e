#!/usr/bin/python3
"""usage: run_document_test.py SOURCE_DIR: errors of run_document.py for small pages, and its rewriting."""
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SOURCE = Path(sys.argv.pop(1)).resolve()
RUN = Path(__file__).resolve().parent / 'run_document.py'
TIMEOUT = 120.0  # s


def page(*parts):
    """Fenced blocks of (language, text)."""
    return '# A page\n' + ''.join('\n```{}\n{}\n```\n'.format(*part) for part in parts)


class RunDocument(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.page = Path(folder.name) / 'page.md'

    def run_page(self, text, *options):
        self.page.write_text(text)
        return subprocess.run(['/usr/bin/python3', RUN, *options, SOURCE, self.page], stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, text=True, timeout=TIMEOUT, check=False)

    def check_passes(self, *parts):
        result = self.run_page(page(*parts))
        self.assertEqual(0, result.returncode, result.stdout)

    def check_fails(self, message, *parts):
        result = self.run_page(page(*parts))
        self.assertEqual(1, result.returncode, result.stdout)
        self.assertIn(message, result.stdout)

    def test_passes_a_page_with_the_output_of_all_commands_of_a_block(self):
        self.check_passes(('', 'echo one\necho two >&2'), ('text', 'one\ntwo'))

    def test_does_not_count_progress_ended_programs_and_warnings_of_ros(self):
        self.check_passes(('', "echo 'scenes 100 %, 26.1/s, 0 s left'\necho 'planner tests  15 % in 3 s'\n"
                               "echo '[WARN] [1795861170.3]: late'\nsleep 60 &\nkill $!\nwait; echo one"),
                          ('text', 'one'))

    def test_names_page_line_and_both_texts_of_another_output(self):
        self.check_fails('page.md:8: shows another output', ('', 'echo hit in 4 tests'), ('text', 'hit in 3 tests'))
        self.check_fails('-hit in 3 tests\n+hit in 4 tests', ('', 'echo hit in 4 tests'), ('text', 'hit in 3 tests'))

    def test_rewrites_a_page_so_that_it_passes(self):
        parts = [('', 'seq 9'), ('text', '1\n...\n7\n8\n10'), ('', 'echo end'), ('text', 'end')]
        self.assertEqual(0, self.run_page(page(*parts), '--rewrite').returncode)
        parts[1] = ('text', '1\n...\n7\n8\n9')
        self.assertEqual(page(*parts), self.page.read_text())
        self.check_passes(*parts)

    def test_wants_the_exit_code_that_the_page_names(self):
        self.check_passes(('', '(exit 3)  # exit code 3'))
        self.check_fails('page.md:4: (exit 3)\nexit code 3, not 0', ('', '(exit 3)'))
        self.check_fails('exit code 0, not 1', ('', 'true  # exit code 1'))

    def test_runs_all_python_of_a_page_in_one_interpreter(self):
        self.check_passes(('python', 'number = 6'), ('', 'true'), ('python', 'print(7 * number)'), ('text', '42'))

    def test_saves_a_block_that_names_its_file(self):
        self.check_passes(('python', '# folder/program.py\nprint(1)'), ('', 'python3 folder/program.py'), ('text', '1'))

    def test_refuses_an_output_without_commands(self):
        self.check_fails('page.md: line 4: an output without commands before it', ('text', 'words'))


if __name__ == '__main__':
    unittest.main()
