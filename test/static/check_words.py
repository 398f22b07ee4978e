#!/usr/bin/python3
"""usage: check_words.py SOURCE_DIR: check the English of comments, messages and documents.

Searches comments and string literals of SOURCES, and the text of DOCUMENTS without code blocks and code spans, for
patterns that make a sentence hard to understand: relative clauses without a noun, sentences without a subject, and
words for which the field has a better one. A pattern may run over several lines of a comment or paragraph.
"""
import io
import re
import sys
import tokenize
from pathlib import Path

from check_prose import CODE_SPAN, HEADING, without_fenced_code

SOURCES = ['src/**/*', 'msg/*', 'srv/*', 'config/**/*', 'launch/*', 'python/**/*', 'scripts/**/*']
DOCUMENTS = ['README.md', 'CONTRIBUTING.md', 'docs/*.md']
PHRASES = [
    'those of', 'that of', 'of those', 'of which', 'what it', 'what they', 'who has', 'who have', 'who is', 'who are',
    'one who', 'whoever', 'whom', 'as asked', '(?:is|are|was|were) told', 'tells', 'tell',
    'rivals?', 'foretold', 'foretells?', 'foreseen?', 'foresees', 'g[ai]ve up', 'gives up', 'go(?:es)? home',
    'rooms? of', 'slides? to a stand', 'sees and reacts', 'see and react',
]
PHRASE = re.compile(r'\b(?:{})\b'.format('|'.join(PHRASES).replace(' ', r'\s+')), re.IGNORECASE)
SENTENCE = re.compile(r'(?:\A|[.!?]["\')]*\s+|\n\s*\n)\s*(Of|Who|Whom|What|None|Whether|Else)\b(?![^.!?]*\?)')

# (start of a path, text): a line of such a file that contains the text may have any pattern.
EXCEPTIONS = [
    ('CONTRIBUTING.md', 'ncludes what it uses'),
]

HASH_COMMENT = re.compile(r'(?:^|(?<=\s))#(.*)')
CPP_TOKEN = re.compile(r'//(?P<line>[^\n]*)|/\*(?P<block>.*?)\*/|R"(\w*)\((?P<raw>.*?)\)\3"'
                       r'|"(?P<string>(?:\\.|[^"\\\n])*)"|\'(?:\\.|[^\'\\\n])+\'', re.DOTALL)
LIST_MARKER = re.compile(r'^ *(?:[-*+]|\d+\.)(?= )', re.MULTILINE)
XML_TEXT = re.compile(r'<!--(.*?)-->|\bdoc="([^"]*)"', re.DOTALL)


def joined(pieces):
    """Join pieces on successive lines, (line, text, kind), to blocks: (first line, text). Omit strings of one word."""
    pieces = [piece for piece in pieces if piece[2] in ('comment', 'end') or ' ' in piece[1]]
    blocks = []
    for line, text, kind in pieces:
        if blocks and blocks[-1][2] == kind and line == blocks[-1][0] + blocks[-1][1].count('\n') + 1:
            blocks[-1] = (blocks[-1][0], blocks[-1][1] + '\n' + text, kind)
        else:
            blocks.append((line, text, kind))
    return [(line, text) for line, text, _ in blocks]


def cpp_blocks(text):
    pieces = []
    for token in CPP_TOKEN.finditer(text):
        kind = token.lastgroup
        if kind is None or text[text.rfind('\n', 0, token.start()) + 1:token.start()].lstrip().startswith('#include'):
            continue
        content = token.group(kind)
        if kind == 'line':
            content = content.lstrip('/<').strip()
            kind = 'comment' if content else 'end'
        pieces.append((text.count('\n', 0, token.start()) + 1, content.replace('\\n', ' '), kind))
    return joined(pieces)


def hash_blocks(text):
    pieces = []
    for number, line in enumerate(text.splitlines(), 1):
        comment = HASH_COMMENT.search(line)
        if comment and not line.startswith('#!'):
            pieces.append((number, comment.group(1).strip(), 'comment'))
    return joined(pieces)


def python_blocks(text):
    pieces = []
    for token in tokenize.generate_tokens(io.StringIO(text).readline):
        if token.type == tokenize.COMMENT and not token.string.startswith('#!'):
            pieces.append((token.start[0], token.string.lstrip('#').strip(), 'comment'))
        elif token.type == tokenize.STRING:
            pieces.append((token.start[0], token.string.lstrip('rbfuRBFU').strip('"\''), 'string'))
    return joined(pieces)


def xml_blocks(text):
    return [(text.count('\n', 0, found.start()) + 1, found.group(1) or found.group(2) or '')
            for found in XML_TEXT.finditer(text)]


def markdown_blocks(text):
    prose = '\n'.join('' if HEADING.match(line) else line for _, line in without_fenced_code(text))
    prose = CODE_SPAN.sub(lambda span: re.sub(r'[^\n]', 'x', span.group()), prose)
    return [(1, LIST_MARKER.sub('.', prose))]  # an item begins a sentence


def blocks_of(path):
    """The texts of a file: (line, text)."""
    try:
        text = path.read_text(encoding='utf-8')
    except UnicodeDecodeError:
        return []
    first = text.split('\n', 1)[0]
    if path.suffix in ('.h', '.cpp'):
        return cpp_blocks(text)
    if path.suffix == '.py' or 'python' in first and first.startswith('#!'):
        return python_blocks(text)
    if path.suffix == '.launch':
        return xml_blocks(text)
    if path.suffix == '.md':
        return markdown_blocks(text)
    if path.suffix in ('.yaml', '.msg', '.srv', '.bash', '.cmake', '.txt') or first.startswith('#!'):
        return hash_blocks(text)
    return []


def is_excepted(name, line):
    return any(name.startswith(path) and text in line for path, text in EXCEPTIONS)


def violations_in(path, name):
    """Numbers of lines, and the pattern that was found there."""
    blocks = blocks_of(path)
    lines = path.read_text(encoding='utf-8').split('\n') if blocks else []
    for first, text in blocks:
        found = [(match.start(), match.group()) for match in PHRASE.finditer(text)]
        found += [(match.start(1), match.group(1) + ' ...') for match in SENTENCE.finditer(text)]
        for start, pattern in sorted(found):
            number = first + text.count('\n', 0, start)
            if not is_excepted(name, lines[number - 1]):
                yield number, ' '.join(pattern.split())


def violations(source_dir):
    root = Path(source_dir)
    files = [path for pattern in SOURCES + DOCUMENTS for path in sorted(root.glob(pattern)) if path.is_file()]
    if not files:
        yield 'no source file in {}'.format(source_dir)
    for path in files:
        name = path.relative_to(root).as_posix()
        for number, pattern in violations_in(path, name):
            yield '{}:{}: "{}"'.format(name, number, pattern)


def main(source_dir):
    found = list(violations(source_dir))
    print('\n'.join(found) or 'comments, messages and documents have none of the patterns')
    return 1 if found else 0


if __name__ == '__main__':
    sys.exit(main(sys.argv[1]))
