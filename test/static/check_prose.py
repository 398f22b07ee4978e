#!/usr/bin/python3
"""usage: check_prose.py SOURCE_DIR: check lines, sentences and links of the documents.

No line is longer than 120 columns, except rows of tables, which Markdown cannot break. No sentence outside tables,
headings and fenced code blocks has more than 45 words. README.md has at most 150 lines. Every link to a file of
SOURCE_DIR, or to a heading in it, has a target.
"""
import os
import re
import sys
from pathlib import Path
from urllib.parse import unquote

DOCUMENTS = ['README.md', 'CONTRIBUTING.md', 'docs/*.md', 'data/**/README.md']
MOST_COLUMNS = 120
MOST_WORDS = 45
MOST_README_LINES = 150

FENCE = re.compile(r'\s*(?:(?:[-*+]|\d+[.)])\s+)?(`{3,}|~{3,})')
HEADING = re.compile(r'#{1,6}\s+(.*?)\s*#*$')
TABLE_ROW = re.compile(r'\s*\|')
LIST_ITEM = re.compile(r'\s*(?:[-*+]|\d+[.)])\s+')
CODE_SPAN = re.compile(r'(?<!`)(`+)(?!`)((?:(?!\n\s*\n).)+?)(?<!`)\1(?!`)', re.DOTALL)
LINK = re.compile(r'!?\[((?:[^\[\]]|\[[^\[\]]*\])*)\]\(([^()\s]*)(?:\s+"[^"]*")?\)')
IMAGE_IN_LINK = re.compile(r'!\[[^\[\]]*\]\(([^()\s]*)\)')
ELSEWHERE = re.compile(r'[a-z][a-z0-9+.-]*:|//')
SENTENCE_END = re.compile(r'(?<=[.!?])["\')*_]*\s+(?=[^\sa-z])')
ABBREVIATION = re.compile(r'(?:\be\.g|\bi\.e|\bal|\bvs|\bFig|\b[A-Z])\.$')


def without_fenced_code(text):
    """Yield the number, from 1, and text of each line; lines of fenced code blocks are empty."""
    fence = None
    for number, line in enumerate(text.splitlines(), 1):
        mark = FENCE.match(line)
        is_code = fence is not None or mark
        if fence is None:
            fence = mark.group(1) if mark else None
        elif line.strip().startswith(fence) and not line.strip().strip(fence[0]):
            fence = None
        yield number, '' if is_code else line


def paragraphs(text):
    """Yield the first line number and the lines of each paragraph and list item, without tables and headings."""
    first, lines = 0, []
    for number, line in [*without_fenced_code(text), (0, '')]:
        is_apart = not line.strip() or HEADING.match(line) or TABLE_ROW.match(line)
        if lines and (is_apart or LIST_ITEM.match(line)):
            yield first, lines
            lines = []
        if not is_apart:
            first = first if lines else number
            lines.append(line if lines else LIST_ITEM.sub('', line, count=1))


def sentences(lines):
    """Yield each sentence of a paragraph: the offset of its first line, and its words."""
    def one_word(match):
        return 'Word' + '\n' * match.group().count('\n')

    text = LINK.sub(one_word, CODE_SPAN.sub(one_word, '\n'.join(lines)))
    start = 0
    for end in [*SENTENCE_END.finditer(text), None]:
        if end and ABBREVIATION.search(text[:end.start()]):
            continue
        words = text[start:end.start() if end else None].split()
        yield text.count('\n', 0, start), [word for word in words if re.search(r'\w', word)]
        start = end.end() if end else start


def anchors(text):
    """Yield the anchors of the headings, as GitHub makes them."""
    counts = {}
    for _, line in without_fenced_code(text):
        heading = HEADING.match(line)
        if heading:
            shown = LINK.sub(r'\1', heading.group(1)).replace('`', '').strip().lower()
            slug = re.sub(r'[^\w\- ]', '', shown).replace(' ', '-')
            counts[slug] = counts.get(slug, -1) + 1
            yield '{}-{}'.format(slug, counts[slug]) if counts[slug] else slug


def links(text):
    """Yield the line number and target of each link within this tree."""
    prose = '\n'.join(line for _, line in without_fenced_code(text))
    prose = CODE_SPAN.sub(lambda span: re.sub(r'[^\n]', 'x', span.group()), prose)
    # An image within a link is taken out first: a link within a link would hide the outer one.
    places = [(image.start(), image.group(1)) for image in IMAGE_IN_LINK.finditer(prose)]
    prose = IMAGE_IN_LINK.sub(lambda image: re.sub(r'[^\n]', 'x', image.group()), prose)
    places += [(link.start(), link.group(2)) for link in LINK.finditer(prose)]
    for start, target in sorted(places):
        if not ELSEWHERE.match(target):
            yield prose.count('\n', 0, start) + 1, unquote(target)


def link_error(document, target):
    """Return the error message for a link of a document, or None."""
    name, _, anchor = target.partition('#')
    path = Path(os.path.normpath(document.parent / name)) if name else document
    if not path.exists():
        return 'the link {} leads to no file'.format(target)
    if anchor and path.suffix == '.md' and anchor not in anchors(path.read_text()):
        return 'the link {} leads to no heading'.format(target)
    return None


def violations_in(document, most_lines):
    """Yield the line number and message of each violation."""
    text = document.read_text()
    lines = text.splitlines()
    if most_lines and len(lines) > most_lines:
        yield len(lines), 'the file has {} lines, more than {}'.format(len(lines), most_lines)
    for number, line in enumerate(lines, 1):
        if len(line) > MOST_COLUMNS and not TABLE_ROW.match(line):
            yield number, 'the line has {} columns, more than {}'.format(len(line), MOST_COLUMNS)
    for first, paragraph in paragraphs(text):
        for below, words in sentences(paragraph):
            if len(words) > MOST_WORDS:
                yield first + below, 'the sentence "{} ..." has {} words, more than {}'.format(
                    ' '.join(words[:5]), len(words), MOST_WORDS)
    for number, target in links(text):
        wrong = link_error(document, target)
        if wrong:
            yield number, wrong


def violations(source_dir):
    root = Path(source_dir)
    for document in [path for pattern in DOCUMENTS for path in sorted(root.glob(pattern))]:
        most_lines = MOST_README_LINES if document == root / 'README.md' else None
        for number, wrong in sorted(violations_in(document, most_lines)):
            yield '{}:{}: {}'.format(document.relative_to(root), number, wrong)


def main(source_dir):
    found = list(violations(source_dir))
    print('\n'.join(found) or 'the documents have short lines and sentences and valid links')
    return 1 if found else 0


if __name__ == '__main__':
    sys.exit(main(sys.argv[1]))
