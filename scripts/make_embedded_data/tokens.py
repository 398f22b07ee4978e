"""Tokens that are the same on every run."""
import hashlib


def token(*parts):
    """The 32 hexadecimal digits that stand for a name."""
    return hashlib.md5(" ".join(str(part) for part in parts).encode()).hexdigest()
