"""Tokens that are the same on every run."""
import hashlib


def token(*parts):
    """Return the MD5 hash of a name, 32 hexadecimal digits."""
    return hashlib.md5(" ".join(str(part) for part in parts).encode()).hexdigest()
