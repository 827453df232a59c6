# Specula @VERSION@: what a host sends to @NAME@_ip, for numpy.
"""View space is right-handed: x to the right, y up, z towards an eye at infinity. A host computes
what its vertices have, interpolates it linearly at the centres of spans' first and last pixels, and
has `packets` make the words of the spans' packets, bit for bit those of Specula.
"""
from dataclasses import dataclass

import numpy as np

# Words of a packet.
WORDS = @WORDS@
# The most pixels of a span.
LONGEST_SPAN = @LONGEST@

?material|@dataclass
?material|class Material:
?span_material|    """The materials of spans: arrays with an entry for each span."""
?frame_material|    """A material."""

@MATERIAL_FIELDS@

?frame|@dataclass
?frame|class Frame:
?frame|    """What holds for a frame."""

@FRAME_FIELDS@
?frame_material|    # the material of all surfaces
?frame_material|    material: Material

@dataclass
class Spans:
    """Runs of pixels of one triangle in one row: arrays with an entry for each span."""

    # pixels, 1 to @LONGEST@
    pixels: np.ndarray
    # whether it is the last span of its frame
    last: np.ndarray
?positions|    # column of the first pixel, 0 to 65535
?positions|    x: np.ndarray
?positions|    # row, 0 to 65535
?positions|    y: np.ndarray
@SPAN_FIELDS@
?span_material|    # the materials of the spans' triangles
?span_material|    material: Material

def _components(vectors):
    """Vectors with their components along the first axis."""
    return np.moveaxis(np.asarray(vectors, float), -1, 0)

def _rounded(value, ones):
    """The nearest whole numbers, ties up: 0 of what is no number, and no more than about 2^62."""
    scaled = value * float(ones)
    whole = np.floor(scaled)
    nearest = whole + (scaled - whole >= 0.5)
    largest = 4611685468671574016.0
    return np.clip(np.nan_to_num(nearest, nan=0.0), -largest, largest).astype(np.int64)

def _raw(value, ones, low, high):
    """Values in units of their last place, of which there are `ones` in 1, from low to high."""
    return np.clip(_rounded(value, ones), low, high)

?difference|def _raw_difference(start, end, ones, low, high):
?difference|    """Differences of values that are rounded before."""
?difference|    return np.clip(_rounded(end, ones) - _rounded(start, ones), low, high)

def _put(words, raw, first_bit, bits):
    """Puts the lowest bits of raw values into words."""
    rest = raw.astype(np.uint64) & np.uint64(2**bits - 1)
    for number in range(first_bit // @WORD@, (first_bit + bits - 1) // @WORD@ + 1):
        shift = first_bit - @WORD@ * number
        shifted = rest << np.uint64(shift) if shift >= 0 else rest >> np.uint64(-shift)
        words[:, number] |= shifted & np.uint64(2**@WORD@ - 1)

@FUNCTIONS@

?packet_frame|def packets(frame, spans):
!packet_frame|def packets(spans):
    """The words of the spans' packets: a row for each span, its first word first."""
    pixels = np.asarray(spans.pixels)
    words = np.zeros((len(pixels), WORDS), np.uint64)
    _put(words, pixels.astype(np.int64), 0, 16)
    _put(words, np.asarray(spans.last).astype(np.int64), 16, 1)
?positions|    _put(words, np.asarray(spans.x).astype(np.int64), 32, 16)
?positions|    _put(words, np.asarray(spans.y).astype(np.int64), 48, 16)
    with np.errstate(all="ignore"):
@PACKET_BODY@
    return words.astype(np.uint@WORD@)

?registers|def registers(frame):
?registers|    """The register writes of a frame, in any order: addresses and words."""
?registers|    writes = []
?registers|    with np.errstate(all="ignore"):
@REGISTERS_BODY@
?registers|    return writes
