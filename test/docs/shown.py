"""Compares the output that a document shows with the output that was printed, and rewrites the shown output.

In a document `...` alone in a line stands for any number of lines, and `...` inside a line for any text of that line.
White space does not count, and a printed line may be wrapped over several lines of the document.
"""
import re
import textwrap
from difflib import SequenceMatcher, unified_diff
from itertools import accumulate

WIDTH = 120  # columns of a document
DOTS = '...'
ANY_LINES = '\n' + DOTS  # stands for a line of dots only
NUMBER_OR_ID = re.compile(r'[0-9a-f]*\d[0-9a-f]*(\.\d+)?')


def matches(shown, printed):
    """Return True if `shown` describes all of `printed`."""
    text, position, anchored = normal(printed), 0, True
    parts = segments(shown)
    for number, part in enumerate(parts):
        if part:
            is_last = number == len(parts) - 1
            pattern = re.compile('^' + pattern_of(part) + r'$\n?' + (r'\Z' if is_last else ''), re.MULTILINE)
            found = pattern.match(text, position) if anchored else pattern.search(text, position)
            if not found:
                return False
            position = found.end()
        anchored = False  # dots follow
    return bool(parts[-1] == [] and len(parts) > 1) or position == len(text)


def difference(shown, printed):
    """Return the changes of rewritten() as a unified diff."""
    lines = unified_diff(shown.split('\n'), rewritten(shown, printed).split('\n'), 'shown', 'printed', n=1, lineterm='')
    return '\n'.join(lines)


def rewritten(shown, printed):
    """`shown` with the words of `printed`; dots stay where the words around them are still printed.

    Words are aligned once as they are and once with all numbers alike. The result is the text that keeps most of `shown`
    and describes `printed`; without such a text it is all of `printed`.
    """
    if matches(shown, printed):
        return shown
    texts = [laid_out(aligned(words_of(shown), printed, key), printed) for key in (str, masked)]
    return max([text for text in texts if matches(text, printed)], default=wrapped(printed),
               key=lambda text: SequenceMatcher(None, shown.split(), text.split(), autojunk=False).ratio())


def normal(text):
    """Return the text without empty lines, with one space between words."""
    return '\n'.join(' '.join(line.split()) for line in text.split('\n') if line.strip())


def segments(shown):
    """Return the groups of lines between lines of dots only."""
    found = [[]]
    for line in normal(shown).split('\n'):
        if line == DOTS:
            found.append([])
        elif line:
            found[-1].append(line)
    return found


def pattern_of(lines):
    """Return a regular expression for lines, any of which may be wrapped."""
    return '[ \n]'.join(pattern_of_line(line) for line in lines)


def pattern_of_line(text):
    return re.escape(text).replace(re.escape(DOTS), '[^\n]*')


def words_of(shown):
    return [word for line in shown.split('\n')
            for word in ([ANY_LINES] if line.strip() == DOTS else line.split())]


def aligned(words, printed, key):
    """Pieces of the new output in order: (begin, end, text) for printed words [begin, end); text None: as printed.

    Words with the same `key` are taken for the same.
    """
    lines = [line.split() for line in printed.split('\n')]
    new = [word for line in lines for word in line]
    line_ends = [0] + list(accumulate(len(line) for line in lines))
    matcher = SequenceMatcher(None, [key(word) for word in words], [key(word) for word in new], autojunk=False)
    pieces = [piece for _, begin, end, new_begin, new_end in matcher.get_opcodes()
              for piece in with_dots(words[begin:end], new, line_ends, new_begin, new_end)]
    return [piece for piece in pieces if piece[0] < piece[1] or piece[2] == ANY_LINES]


def with_dots(words, new, line_ends, begin, end):
    """Return the pieces for the printed words [begin, end) of `new`; the document has `words` there."""
    dots = [k for k, word in enumerate(words) if DOTS in word]
    if not dots:
        return [(begin, end, None)]
    if ANY_LINES not in words:
        first = min(begin + dots[0], end)                     # as many words stay as stood before the dots,
        last = max(end - (len(words) - 1 - dots[-1]), first)  # and after them
        last = min([last] + [stop for stop in line_ends if stop > first])
        fits = re.fullmatch(pattern_of_line(words[dots[0]]), ' '.join(new[first:last]))
        return [(begin, first, None), (first, last, words[dots[0]] if fits else DOTS), (last, end, None)]
    head, tail = words[:words.index(ANY_LINES)], words[len(words) - words[::-1].index(ANY_LINES):]
    stops = [stop for stop in line_ends if begin <= stop <= end] or [begin]
    fewest = [sum(DOTS not in word for word in part) for part in (head, tail)]  # words that the dots replace
    first = min([stop for stop in stops if stop >= begin + fewest[0]], default=stops[-1])
    last = max([stop for stop in stops if first <= stop <= end - fewest[1]], default=first)
    return (with_dots(head, new, line_ends, begin, first) + [(first, last, ANY_LINES)] +
            with_dots(tail, new, line_ends, last, end))


def masked(word):
    """Return the word with numbers and ids replaced by 0."""
    return NUMBER_OR_ID.sub('0', word)


def laid_out(pieces, printed):
    """The pieces with the white space that is printed between words; dots for lines have a line of their own."""
    spans = [found.span() for found in re.finditer(r'\S+', printed)]
    text, printed_end = '', 0
    for begin, end, word in pieces:
        if word == ANY_LINES:
            text = text.rstrip() + ANY_LINES + '\n'
        else:
            space = printed[printed_end:spans[begin][0]]
            text += space.lstrip('\n') if text.endswith('\n') else space
            text += word or printed[spans[begin][0]:spans[end - 1][1]]
        printed_end = spans[end - 1][1] if end else 0
    return wrapped(text)


def wrapped(text):
    lines = [part for line in text.strip('\n').split('\n')
             for part in textwrap.wrap(line, WIDTH, break_long_words=False, break_on_hyphens=False) or ['']]
    return '\n'.join(lines)
