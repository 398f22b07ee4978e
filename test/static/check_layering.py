#!/usr/bin/python3
"""usage: check_layering.py SOURCE_DIR: do the includes under src/ keep the layers of the architecture?

1. A module includes itself and modules below it (LAYERS, lowest first).
2. ROS is included only in src/ros, src/rviz and src/tools.
3. torch is included only in src/network, and no file outside it includes a header that brings torch along.
4. MPI is included only in src/batch.
"""
import re
import sys
from pathlib import Path

LAYERS = [{'files', 'config', 'geometry'}, {'map'}, {'scene'}, {'forecast', 'verify', 'attack'}, {'network'}, {'planners', 'trials', 'drawing', 'training', 'data', 'batch', 'study', 'dataset', 'settings'},
          {'ros', 'rviz', 'app'}]
LAYER_OF = {module: level for level, modules in enumerate(LAYERS) for module in modules}

ROS_MODULES = {'ros', 'rviz', 'tools'}
ROS_INCLUDE = re.compile(
    r'(ros|rosbag|roscpp|rosconsole|nodelet|pluginlib|rviz|tf|tf2|tf2_\w+|std_srvs|\w+_msgs|collision_forge)/')
TORCH_INCLUDE = re.compile(r'(torch|ATen|c10|caffe2)/')
MPI_INCLUDE = re.compile(r'mpi\.h$')
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]', re.MULTILINE)


def read_includes(src):
    """Every file under src with what it includes, both as paths relative to src."""
    return {str(path.relative_to(src)): INCLUDE.findall(path.read_text(encoding='utf-8'))
            for path in sorted(src.rglob('*')) if path.suffix in ('.cpp', '.h')}


def module_of(file):
    return Path(file).parts[0]


def may_include_ros(file):
    return module_of(file) in ROS_MODULES


def shows_torch(file, includes, seen=()):
    """True if the file or one of ours that it includes, however far, includes torch."""
    return any(TORCH_INCLUDE.match(included) or
               (included in includes and included not in seen and
                shows_torch(included, includes, seen + (file,)))
               for included in includes[file])


def violations_in_file(file, includes):
    module = module_of(file)
    for included in includes[file]:
        if included in includes:  # a file of ours
            other = module_of(included)
            if other != module and LAYER_OF.get(other, 0) > LAYER_OF.get(module, -1):
                yield '{} is above {}'.format(other, module)
            if module != 'network' and other == 'network' and shows_torch(included, includes):
                yield '{} brings torch out of src/network'.format(included)
        elif ROS_INCLUDE.match(included) and not may_include_ros(file):
            yield '{}: ROS has no place in {}'.format(included, module)
        elif TORCH_INCLUDE.match(included) and module != 'network':
            yield '{}: torch has no place outside src/network'.format(included)
        elif MPI_INCLUDE.match(included) and module != 'batch':
            yield '{}: MPI has no place outside src/batch'.format(included)


def unknown_modules(includes):
    return sorted({module_of(file) for file in includes} - set(LAYER_OF))


def violations(src):
    includes = read_includes(src)
    if not includes:
        return ['no C++ file in {}'.format(src)]
    found = ['src/{} has no place in LAYERS of {}'.format(module, Path(__file__).name)
             for module in unknown_modules(includes)]
    for file in includes:
        found += ['src/{}: {}'.format(file, violation) for violation in violations_in_file(file, includes)]
    return found


def main(source_dir):
    found = violations(Path(source_dir, 'src'))
    print('\n'.join(found) or 'all includes keep the layers')
    return 1 if found else 0


if __name__ == '__main__':
    sys.exit(main(sys.argv[1]))
