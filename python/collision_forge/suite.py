"""Start the suite in separate processes under a separate ROS master, for tests."""
import ctypes
import os
import signal
import socket
import subprocess
from pathlib import Path
from typing import Any, List, Optional, Sequence, TypeVar

import rosgraph

from collision_forge.errors import ForgeError
from collision_forge.waiting import wait_until

STOP_TIMEOUT = 20.0  # s; nodes still running after it are killed
SHOWN = 2000         # characters of a log in an error
Running = TypeVar('Running', bound='Program')
LIBC = ctypes.CDLL(None)
PR_SET_PDEATHSIG = 1  # of prctl(2)


def interrupt_with_parent() -> None:
    """Make the kernel send SIGINT to this process when its parent ends."""
    LIBC.prctl(PR_SET_PDEATHSIG, signal.SIGINT)


class Program:
    """A running program with its children, until `stop()` or the end of this process; its output is in `log`."""

    def __init__(self, command: Sequence[str], log: Path) -> None:
        self.name = command[0]
        self.log = log
        with open(log, 'w', encoding='utf-8') as output:
            self._process = subprocess.Popen(list(command), stdin=subprocess.DEVNULL, stdout=output,
                                             stderr=subprocess.STDOUT, start_new_session=True,
                                             preexec_fn=interrupt_with_parent)

    def check(self) -> None:
        """Raise ForgeError if the program has ended."""
        if self._process.poll() is not None:
            raise ForgeError('{} has ended: {}'.format(self.name, self.output()[-SHOWN:]))

    def output(self) -> str:
        return self.log.read_text(errors='replace')

    def stop(self) -> None:
        """Interrupt the program, and kill the rest of its process group after STOP_TIMEOUT."""
        self._signal(signal.SIGINT)
        try:
            self._process.wait(STOP_TIMEOUT)
        except subprocess.TimeoutExpired:
            pass
        self._signal(signal.SIGKILL)
        self._process.wait()

    def _signal(self, sign: signal.Signals) -> None:
        try:
            os.killpg(self._process.pid, sign)
        except ProcessLookupError:
            pass  # the group has ended

    def __enter__(self: Running) -> Running:
        return self

    def __exit__(self, *_: Any) -> None:
        self.stop()


class Master(Program):
    """A roscore on a free port. Sets the environment of this process, so that it and its children use it."""

    def __init__(self, folder: Path, timeout: float) -> None:
        with socket.socket() as free:
            free.bind(('localhost', 0))
            port = free.getsockname()[1]
        os.environ.update(ROS_MASTER_URI='http://localhost:{}'.format(port), ROS_HOSTNAME='localhost',
                          ROS_LOG_DIR=str(folder / 'ros_log'))
        os.environ.pop('ROS_IP', None)
        super().__init__(['roscore', '-p', str(port)], folder / 'roscore.log')
        try:
            wait_until(self._missing, timeout)
        except ForgeError:
            self.stop()
            raise

    def _missing(self) -> List[str]:
        self.check()
        return [] if rosgraph.is_master_online() else ['a master at ' + os.environ['ROS_MASTER_URI']]


class Suite(Program):
    """collision_forge.launch with arguments; `recording`: bag for replay mode and test_planner."""

    def __init__(self, folder: Path, recording: Optional[Path] = None, **arguments: str) -> None:
        if recording is not None:
            arguments['recording'] = str(Path(recording).resolve())
        super().__init__(['roslaunch', 'collision_forge', 'collision_forge.launch'] +
                         ['{}:={}'.format(*argument) for argument in arguments.items()], folder / 'roslaunch.log')
