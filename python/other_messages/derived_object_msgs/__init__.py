"""A stand-in for the package derived_object_msgs, which Debian does not have. A real one comes first in PYTHONPATH."""
