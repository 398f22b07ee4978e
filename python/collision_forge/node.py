"""A ROS node that ends reliably on a signal and whose log lines appear immediately."""
import io
import signal
import sys
from typing import Any, Callable

import rospy


def run_node(name: str, work: Callable[[], int], **options: Any) -> int:
    """Run `work` as the node `name` and return its exit code; 0 if a signal or another node ended it.

    A signal ends `work` first, then the node. rospy would shut down while the main thread runs: if that thread is
    publishing, it holds a lock that the shutdown needs, and the node hangs.

    If stdout is a file or a pipe, Python collects output in a buffer, and rospy does not flush it. The function
    therefore makes stdout line-buffered, so that each line of `rospy.loginfo` is written at once.
    """
    if isinstance(sys.stdout, io.TextIOWrapper):
        sys.stdout.reconfigure(line_buffering=True)
    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, _interrupt)
    try:
        rospy.init_node(name, disable_signals=True, **options)
        return work()
    except KeyboardInterrupt:
        return 0
    except rospy.ROSException:
        if not rospy.core.is_shutdown_requested():  # after a shutdown request publishing raises
            raise
        return 0
    finally:
        rospy.signal_shutdown('the work is over')


def _interrupt(*_: Any) -> None:
    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, signal.SIG_IGN)
    raise KeyboardInterrupt
