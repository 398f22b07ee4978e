"""Virtual environments with pinned packages of PyPI, one for each tool that reads exported files."""
import shutil
import subprocess
import sys
import unittest
from pathlib import Path

FOLDER = Path('out') / 'interop' / 'environments'
ASAM_CHECKS = Path(__file__).with_name('asam_checks.py')


def python_with(name, *requirements):
    """The interpreter of an environment with these packages, as 'mcap==1.6.0'; made anew when they are others.

    Raises unittest.SkipTest where PyPI cannot be reached, and RuntimeError where it can and pip fails.
    """
    folder = FOLDER / name
    python, mark = folder / 'bin' / 'python', folder / 'requirements.txt'
    wanted = ''.join(line + '\n' for line in requirements)
    if mark.exists() and mark.read_text() == wanted:
        return python.absolute()
    if folder.exists():
        shutil.rmtree(folder)
    subprocess.run([sys.executable, '-m', 'venv', folder], check=True)
    pip = [python, '-m', 'pip', '--disable-pip-version-check', '--quiet']
    result = subprocess.run([*pip, 'install', *requirements], stderr=subprocess.PIPE, text=True, check=False)
    if result.returncode != 0:
        reached = subprocess.run([*pip, 'download', '--no-deps', '--dest', folder, 'six==1.16.0'],
                                 stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False)
        if reached.returncode != 0:
            raise unittest.SkipTest('PyPI cannot be reached: ' + name + ' is not tried')
        raise RuntimeError('pip cannot install ' + ' '.join(requirements) + ': ' + result.stderr)
    mark.write_text(wanted)
    return python.absolute()


def nuscenes_python():
    """The interpreter of an environment with the devkit of nuScenes; raises as python_with()."""
    return python_with('nuscenes', 'nuscenes-devkit==1.2.0', 'numpy==1.26.4', 'shapely==2.0.7',
                       'opencv-python-headless==4.11.0.86')


def python_with_asams_rules():
    """The interpreter of an environment with ASAM's checkers of rules; raises as python_with()."""
    return python_with('asam', 'asam-qc-openscenarioxml==1.0.0', 'asam-qc-opendrive==1.0.0', 'asam-qc-baselib==1.1.0')
