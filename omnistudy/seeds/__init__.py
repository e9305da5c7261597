"""Seeds as text and the generators that are made from them."""

import hashlib

import numpy as np


def seed_text(*parts: object) -> str:
    """Give the seed of whatever the parts name, as 64 hex digits of SHA-256.

    Parts are joined with an unprintable separator, so ("a", "bc") and ("ab", "c") differ.
    """
    return hashlib.sha256("\x1f".join(str(part) for part in parts).encode()).hexdigest()


def generator(seed: str, purpose: str) -> np.random.Generator:
    """Make the random generator of one purpose ("skill", "noise") from a stored seed.

    Purposes have independent streams, so that a new draw for one never shifts another.
    """
    return np.random.Generator(np.random.PCG64(int(seed_text(seed, purpose), 16)))
