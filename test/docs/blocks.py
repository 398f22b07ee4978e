"""The fenced blocks of a document: commands of the shell, files to save, and output, which is for reading alone."""
import re
import subprocess
from typing import List, NamedTuple, Optional

SAVED = re.compile(r'(?:#|//|<!--) *([\w.-]+/[\w./-]+)(?: *-->)?')  # a first line with nothing but a path


class Block(NamedTuple):
    line: int      # of its first line, from 1 on
    language: str  # empty: commands of the shell
    text: str

    @property
    def path(self) -> Optional[str]:
        """Where a reader saves it: what the comment in its first line names."""
        found = SAVED.fullmatch(self.text.split('\n', 1)[0].strip())
        return found.group(1) if self.language and found else None


class Command(NamedTuple):
    line: int
    text: str


def blocks(text: str) -> List[Block]:
    found, begin, language, lines = [], None, '', text.split('\n')
    for number, line in enumerate(lines, 1):
        if not line.startswith('```'):
            continue
        if begin is None:
            begin, language = number + 1, line[3:].strip()
        else:
            found.append(Block(begin, language, '\n'.join(lines[begin - 1:number - 1])))
            begin = None
    if begin is not None:
        raise ValueError('line {}: a block that does not end'.format(begin - 1))
    return found


def is_complete(text: str) -> bool:
    """Bash would not wait for another line."""
    if text.endswith('\\'):
        return False
    checked = subprocess.run(['bash', '-n'], input=text, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                             check=False)
    return checked.returncode == 0 and not checked.stdout  # it warns of a here-document without an end


def commands(block: Block) -> List[Command]:
    """Line by line, but for commands that go on in the next; without empty lines and comments."""
    found, begun = [], []
    lines = block.text.split('\n')
    for number, line in enumerate(lines, block.line):
        if not begun and (not line.strip() or line.lstrip().startswith('#')):
            continue
        begun.append(line)
        if is_complete('\n'.join(begun)) or number == block.line + len(lines) - 1:
            found.append(Command(number - len(begun) + 1, '\n'.join(begun)))
            begun = []
    return found
