"""The messages Object and ObjectArray of derived_object_msgs, as genpy makes them of their definition."""
from pathlib import Path

from genpy.dynamic import generate_dynamic

_PACKAGE = 'derived_object_msgs'
_CLASSES = generate_dynamic(_PACKAGE + '/ObjectArray',
                            Path(__file__).with_name('ObjectArray.txt').read_text(encoding='utf-8'))
Object = _CLASSES[_PACKAGE + '/Object']
ObjectArray = _CLASSES[_PACKAGE + '/ObjectArray']
__all__ = ['Object', 'ObjectArray']
