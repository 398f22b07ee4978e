#!/usr/bin/python3
"""usage: check_layering.py SOURCE_DIR: check includes against the table of folders in docs/architecture.md.

The table is the first one under the heading HEADING. The check reads its columns `folder` and `libraries`.
1. Every C++ file under src/ is src/collision_forge/FOLDER/NAME, and FOLDER (as base/map) is in the table.
2. A file includes only files of its own folder and of folders above it in the table.
3. Only folders with a library of LIBRARIES in their row include it, directly or through other headers of the tree.
4. Files of one folder have no include cycles. A header and its source count as one file.
"""
import itertools
import re
import sys
from pathlib import Path, PurePath

DOCUMENT = 'docs/architecture.md'
HEADING = '## The folders of the modules'
ROOT = 'collision_forge/'
LIBRARIES = {
    'ROS': r'(ros|rosbag|rosconsole|nodelet|pluginlib|rviz|tf2?|tf2_\w+|std_srvs|\w+_msgs)/|collision_forge/[A-Z]\w*\.h$',
    'torch': r'(torch|ATen|c10|caffe2)/',
    'yaml-cpp': r'yaml-cpp/',
    'RapidJSON': r'rapidjson/(?!fwd\.h)',
    'CLI11': r'CLI/',
    'cairo': r'cairo',
    'giflib': r'gif_lib\.h$',
    'pugixml': r'pugixml',
    'GeographicLib': r'GeographicLib/',
    'LZ4': r'lz4frame\.h$',
    'zlib': r'zlib\.h$',
    'Qt': r'(Qt\w+/)?Q[A-Z]\w+$',
}
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', re.MULTILINE)


def cells(line):
    return [cell.strip() for cell in line.strip()[1:-1].split('|')]


def read_table(text):
    """Return {folder: libraries that it may include}, in the order of the table."""
    section = text.partition(HEADING + '\n')[2].partition('\n## ')[0]
    table = itertools.takewhile(lambda line: line.startswith('|'),
                                itertools.dropwhile(lambda line: not line.startswith('|'), section.splitlines()))
    rows = [cells(line) for line in table]
    if not rows:
        return {}
    folder, libraries = (rows[0].index(title) for title in ('folder', 'libraries'))
    return {row[folder].strip('`/'): re.findall(r'[\w-]+', row[libraries]) for row in rows[2:]}


def read_includes(src):
    """Return {C++ file under src: its includes}, as paths relative to src."""
    return {str(path.relative_to(src)): INCLUDE.findall(path.read_text(encoding='utf-8'))
            for path in sorted(src.rglob('*')) if path.suffix in ('.cpp', '.h')}


def folder_of(file):
    """Return the folder of a file below ROOT, None for other files."""
    return str(PurePath(file[len(ROOT):]).parent) if file.startswith(ROOT) else None


def brings(included, library, includes, seen):
    """Return True if a header belongs to the library or includes, also indirectly, a header that does."""
    if included not in includes:
        return re.match(LIBRARIES[library], included) is not None
    if included in seen:
        return False
    seen.add(included)
    return any(brings(further, library, includes, seen) for further in includes[included])


def file_violations(file, includes, table):
    folder, order = folder_of(file), list(table)
    if folder not in table:
        yield 'lies in no folder of ' + DOCUMENT
        return
    for included in includes[file]:
        of = folder_of(included)
        if included in includes and (of not in order or order.index(of) > order.index(folder)):
            yield '{}: {} is below {} in {}'.format(included, of, folder, DOCUMENT)
        for library in LIBRARIES:
            if library not in table[folder] and brings(included, library, includes, set()):
                yield '{}: {} has no place in {}'.format(included, library, folder)


def table_violations(includes, table):
    """Yield rows whose folder has no file, and libraries of rows that the folder does not include."""
    used = {(folder_of(file), library) for file in includes for included in includes[file]
            for library in LIBRARIES if included not in includes and re.match(LIBRARIES[library], included)}
    folders = {folder_of(file) for file in includes}
    for folder, libraries in table.items():
        if folder not in folders:
            yield '{}: row {} has no file'.format(DOCUMENT, folder)
        for library in libraries:
            if library not in LIBRARIES:
                yield '{}: row {} names {}, which is none of {}'.format(DOCUMENT, folder, library, ', '.join(LIBRARIES))
            elif (folder, library) not in used:
                yield '{}: row {} names {}, which it does not include'.format(DOCUMENT, folder, library)


def cycles(includes):
    """Yield include cycles within one folder: for each file on a cycle, the shortest one, each only once."""
    units = {}
    for file, included in includes.items():
        unit = str(PurePath(file).with_suffix(''))
        inside = {str(PurePath(other).with_suffix('')) for other in included
                  if other in includes and folder_of(other) == folder_of(file)}
        units.setdefault(unit, set()).update(inside - {unit})
    seen = set()
    for start in units:
        paths, reached = [[start]], {start}
        for path in paths:
            for following in sorted(units[path[-1]]):
                if following == start and not seen & set(path):
                    seen.update(path)
                    yield 'src/' + ' -> '.join(PurePath(unit).name for unit in path + [start]) + \
                        ': a cycle in ' + folder_of(start)
                elif following not in reached:
                    reached.add(following)
                    paths.append(path + [following])


def violations(source_dir):
    table = read_table(Path(source_dir, DOCUMENT).read_text(encoding='utf-8'))
    if not table:
        return ['no table under "{}" in {}'.format(HEADING, DOCUMENT)]
    includes = read_includes(Path(source_dir, 'src'))
    if not includes:
        return ['no C++ file in {}/src'.format(source_dir)]
    found = list(table_violations(includes, table))
    for file in includes:
        found += ['src/{}: {}'.format(file, violation) for violation in file_violations(file, includes, table)]
    return found + list(cycles(includes))


def main(source_dir):
    found = violations(source_dir)
    print('\n'.join(found) or 'all includes comply with the table')
    return 1 if found else 0


if __name__ == '__main__':
    sys.exit(main(sys.argv[1]))
