"""The fenced blocks of a document: commands of the shell, Python to run, files to save, and outputs."""
import re
import subprocess
from typing import List, NamedTuple, Optional, Tuple

OUTPUT = 'text'  # the language of a block with the output of the previous block
SAVED = re.compile(r'(?:#|//|<!--) *([\w.-]+/[\w./-]+)(?: *-->)?')  # a first line with nothing but a path
EXIT_CODE = re.compile(r'# exit code (\d+)$')


class Block(NamedTuple):
    line: int      # of its first line, from 1 on
    language: str  # empty: commands of the shell
    text: str

    @property
    def path(self) -> Optional[str]:
        """Return the path in the comment of the first line, where a reader saves the block; None without one."""
        found = SAVED.fullmatch(self.text.split('\n', 1)[0].strip())
        return found.group(1) if self.language and found else None


class Command(NamedTuple):
    line: int
    text: str

    @property
    def exit_code(self) -> int:
        """Return the exit code in the comment at the end; 0 without one."""
        found = EXIT_CODE.search(self.text)
        return int(found.group(1)) if found else 0


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


def with_outputs(found: List[Block]) -> List[Tuple[Block, Optional[Block]]]:
    """Return each block that is not an output, with the output block that follows it, if any."""
    pairs = []
    for block, following in zip(found, found[1:] + [None]):
        shown = following if following and following.language == OUTPUT else None
        if block.language != OUTPUT:
            if shown and (block.path or block.language not in ('', 'python')):
                raise ValueError('line {}: an output of nothing that runs'.format(shown.line))
            pairs.append((block, shown))
        elif shown or not pairs:
            raise ValueError('line {}: an output without commands before it'.format((shown or block).line))
    return pairs


def is_complete(text: str) -> bool:
    """Return True if bash would not wait for another line."""
    if text.endswith('\\'):
        return False
    checked = subprocess.run(['bash', '-n'], input=text, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                             check=False)
    return checked.returncode == 0 and not checked.stdout  # warnings: an unfinished here-document


def commands(block: Block) -> List[Command]:
    """Return the commands of a block, which may span lines, without empty lines and comments."""
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
