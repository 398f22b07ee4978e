"""A node of ROS that ends whenever it is told to."""
import signal
from typing import Any, Callable

import rospy


def run_node(name: str, work: Callable[[], int], **options: Any) -> int:
    """Does `work` as a node of this name, and returns its exit code; 0 where a signal or another node ended it.

    A signal ends the work first, and the node then. rospy itself ends a node in the middle of what its main thread is
    at. If that is publishing, it holds a lock that the end needs as well, and the node hangs for ever."""
    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, _interrupt)
    try:
        rospy.init_node(name, disable_signals=True, **options)
        return work()
    except KeyboardInterrupt:
        return 0
    except rospy.ROSException:
        if not rospy.core.is_shutdown_requested():  # from then on nothing can be published
            raise
        return 0
    finally:
        rospy.signal_shutdown('the work is over')


def _interrupt(*_: Any) -> None:
    for number in (signal.SIGINT, signal.SIGTERM):
        signal.signal(number, signal.SIG_IGN)
    raise KeyboardInterrupt
