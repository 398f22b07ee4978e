#!/usr/bin/python3
"""usage: check_layering.py SOURCE_DIR: do the includes keep to the table of rooms in docs/architecture.md?

The table is the first one under the heading HEADING. Of its columns `room`, `includes` and `libraries` are read.
1. Every C++ file under src/ is src/collision_forge/ROOM/NAME, and ROOM is in the table.
2. A room includes itself and the rooms that its row names, and every room that its row names.
3. A row names rows above it only, so that there is no cycle.
4. A library of LIBRARIES is included only by rooms whose row names it, and no header of ours carries it further.
"""
import itertools
import re
import sys
from pathlib import Path

DOCUMENT = 'docs/architecture.md'
HEADING = '## The rooms of src/collision_forge'
NOTHING = 'nothing'
LIBRARIES = {
    'ROS': r'(ros|rosbag|rosconsole|nodelet|pluginlib|rviz|tf2?|tf2_\w+|std_srvs|\w+_msgs)/|collision_forge/[A-Z]\w*\.h$',
    'torch': r'(torch|ATen|c10|caffe2)/',
    'MPI': r'mpi\.h$',
    'yaml-cpp': r'yaml-cpp/',
    'RapidJSON': r'rapidjson/(?!fwd\.h)',
    'CLI11': r'CLI/',
    'cairo': r'cairo',
    'giflib': r'gif_lib\.h$',
    'pugixml': r'pugixml',
    'LZ4': r'lz4frame\.h$',
    'zlib': r'zlib\.h$',
    'Qt': r'(Qt\w+/)?Q[A-Z]\w+$',
}
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', re.MULTILINE)


def cells(line):
    return [cell.strip() for cell in line.strip()[1:-1].split('|')]


def names(cell):
    return [name for name in re.split(r'[,\s]+', cell.replace('`', '').replace('/', '')) if name and name != NOTHING]


def read_table(text):
    """{room: (rooms it may include, libraries it may include)}, in the order of the table."""
    section = text.partition(HEADING + '\n')[2].partition('\n## ')[0]
    table = itertools.takewhile(lambda line: line.startswith('|'),
                                itertools.dropwhile(lambda line: not line.startswith('|'), section.splitlines()))
    rows = [cells(line) for line in table]
    if not rows:
        return {}
    room, includes, libraries = (rows[0].index(title) for title in ('room', 'includes', 'libraries'))
    return {names(row[room])[0]: (names(row[includes]), names(row[libraries])) for row in rows[2:]}


def read_includes(src):
    """Every C++ file under src with what it includes, both as paths relative to src."""
    return {str(path.relative_to(src)): INCLUDE.findall(path.read_text(encoding='utf-8'))
            for path in sorted(src.rglob('*')) if path.suffix in ('.cpp', '.h')}


def room_of(file):
    """None for a file that lies in no room."""
    parts = Path(file).parts
    return parts[1] if len(parts) == 3 and parts[0] == 'collision_forge' else None


def table_violations(table):
    known = []
    for room, (rooms, libraries) in table.items():
        for other in rooms:
            if other not in known:
                yield '{}: row {} names {}, which is no row above it'.format(DOCUMENT, room, other)
        for library in libraries:
            if library not in LIBRARIES:
                yield '{}: row {} names {}, which is none of {}'.format(DOCUMENT, room, library, ', '.join(LIBRARIES))
        known.append(room)


def brings(included, library, includes, seen):
    """True if a header is of the library, or of ours and includes one that is, however far."""
    if included not in includes:
        return re.match(LIBRARIES[library], included) is not None
    if included in seen:
        return False
    seen.add(included)
    return any(brings(further, library, includes, seen) for further in includes[included])


def file_violations(file, includes, table):
    room = room_of(file)
    if room not in table:
        yield 'lies in no room of ' + DOCUMENT
        return
    rooms, libraries = table[room]
    for included in includes[file]:
        if included in includes and room_of(included) not in [room] + rooms:
            yield '{}: {} may not include {}'.format(included, room, room_of(included))
        for library in LIBRARIES:
            if library not in libraries and brings(included, library, includes, set()):
                yield '{}: {} has no place in {}'.format(included, library, room)


def unused(includes, table):
    """What rows name and no file of their room includes."""
    used = {(room_of(file), room_of(included)) for file in includes for included in includes[file]
            if included in includes}
    used |= {(room_of(file), library) for file in includes for included in includes[file]
             for library in LIBRARIES if included not in includes and re.match(LIBRARIES[library], included)}
    for room, (rooms, libraries) in table.items():
        for name in rooms + libraries:
            if (room, name) not in used:
                yield '{}: row {} names {}, which it does not include'.format(DOCUMENT, room, name)


def violations(source_dir):
    table = read_table(Path(source_dir, DOCUMENT).read_text(encoding='utf-8'))
    if not table:
        return ['no table under "{}" in {}'.format(HEADING, DOCUMENT)]
    includes = read_includes(Path(source_dir, 'src'))
    if not includes:
        return ['no C++ file in {}/src'.format(source_dir)]
    found = list(table_violations(table))
    for file in includes:
        found += ['src/{}: {}'.format(file, violation) for violation in file_violations(file, includes, table)]
    return found + list(unused(includes, table))


def main(source_dir):
    found = violations(source_dir)
    print('\n'.join(found) or 'all includes keep to the table')
    return 1 if found else 0


if __name__ == '__main__':
    sys.exit(main(sys.argv[1]))
