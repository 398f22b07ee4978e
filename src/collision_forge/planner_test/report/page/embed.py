#!/usr/bin/python3
"""usage: embed.py OUT.cpp: the files of this folder as the C++ texts that planner_test/report/page_parts.h declares.

Joins the modules into one script in the order of MODULES, without import lines and the word export. The page's
Content-Security-Policy allows only style and script with these hashes, so nothing else runs and nothing is fetched.
"""
import base64
import hashlib
import re
import sys
from pathlib import Path

MODULES = ('words', 'records', 'geometry', 'table', 'filters', 'overview', 'top_view', 'timelines', 'severity',
           'detail', 'main')
FOLDER = Path(__file__).parent


def bundle(sources):
    """Return the modules as one script; each must come after the modules that it imports from."""
    text = '\n'.join(sources)
    text = re.sub(r'^import [^;]*;\n', '', text, flags=re.MULTILINE)
    return re.sub(r'^export ', '', text, flags=re.MULTILINE)


def source_hash(text):
    return "'sha256-" + base64.b64encode(hashlib.sha256(text.encode()).digest()).decode() + "'"


def literal(text):
    """Return a C++ string literal of any length, split because compilers limit the length of one literal."""
    pieces = [text[i:i + 8000] for i in range(0, len(text), 8000)]
    return '\n'.join('R"__page__(' + piece + ')__page__"' for piece in pieces)


def main(out):
    style = (FOLDER / 'style.css').read_text(encoding='utf-8')
    script = bundle((FOLDER / (name + '.js')).read_text(encoding='utf-8') for name in MODULES)
    page = (FOLDER / 'page.html').read_text(encoding='utf-8')
    page = page.replace('{policy}', "default-src 'none'; img-src data:; style-src {}; script-src {}".format(
        source_hash(style), source_hash(script)))
    head, foot = page.replace('{style}', style).replace('{script}', script).split('{data}\n')
    Path(out).write_text('#include "collision_forge/planner_test/report/page_parts.h"\n\nnamespace forge {\n'
                         'const char* const kPageHead =\n' + literal(head) + ';\n'
                         'const char* const kPageFoot =\n' + literal(foot) + ';\n}  // namespace forge\n',
                         encoding='utf-8')


if __name__ == '__main__':
    main(*sys.argv[1:])
