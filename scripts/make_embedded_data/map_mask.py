"""Draws the drivable area as a nuScenes map mask: a grey image, 255 on the road."""
import math
import struct
import zlib

PIXELS_PER_METRE = 10
# Bits per pixel. Readers return pixels of 1 bit as true and false instead of 255 and 0.
BITS = 2
SIGNATURE = b"\x89PNG\r\n\x1a\n"
AS_IT_IS, LESS_THE_ROW_ABOVE = b"\0", b"\2"   # filters of rows


def drivable_polygons(roads):
    """Return the drivable area's polygons as lists of points."""
    nodes = {row["token"]: (row["x"], row["y"]) for row in roads["node"]}
    polygons = {row["token"]: [nodes[node] for node in row["exterior_node_tokens"]]
                for row in roads["polygon"]}
    return [polygons[token] for row in roads["drivable_area"] for token in row["polygon_tokens"]]


def pixels_from(metres):
    """Return the first pixel at or after a position in metres. Pixel i is the point at i / 10 m."""
    return math.ceil(metres * PIXELS_PER_METRE)


def crossings(polygon):
    """Return, for each row of pixels, the positions of a polygon's sides (m), ascending."""
    places = {}
    for (x0, y0), (x1, y1) in zip(polygon, polygon[1:] + polygon[:1]):
        for height in range(pixels_from(min(y0, y1)), pixels_from(max(y0, y1))):
            ratio = (height / PIXELS_PER_METRE - y0) / (y1 - y0)
            places.setdefault(height, []).append(x0 + ratio * (x1 - x0))
    return {height: sorted(row) for height, row in places.items()}


def spans(polygons):
    """Return, for each row of pixels, the ranges of pixels in polygons: first, and past the last."""
    rows = {}
    for polygon in polygons:
        for height, places in crossings(polygon).items():
            rows.setdefault(height, []).extend(
                (pixels_from(a), pixels_from(b)) for a, b in zip(places[::2], places[1::2]))
    return rows


def row_bytes(stretches, size):
    """Return a row of pixels with all bits set in the ranges."""
    row = 0
    for first, end in stretches:
        row |= ((1 << BITS * (end - first)) - 1) << (8 * size - BITS * end)
    return row.to_bytes(size, "big")


def chunk(kind, content):
    return (struct.pack(">I", len(content)) + kind + content
            + struct.pack(">I", zlib.crc32(kind + content)))


def mask_png(roads):
    """Return the PNG file. Its first row is the north edge: y = height of the canvas."""
    width, height = (round(edge * PIXELS_PER_METRE) for edge in roads["canvas_edge"])
    rows = spans(drivable_polygons(roads))
    size = math.ceil(width * BITS / 8)
    packer, parts, above = zlib.compressobj(9), [], None
    for y in range(height, 0, -1):
        row = row_bytes(rows.get(y, ()), size)
        filtered = LESS_THE_ROW_ABOVE + bytes(size) if row == above else AS_IT_IS + row
        parts.append(packer.compress(filtered))
        above = row
    header = struct.pack(">IIBBBBB", width, height, BITS, 0, 0, 0, 0)
    return (SIGNATURE + chunk(b"IHDR", header)
            + chunk(b"IDAT", b"".join(parts) + packer.flush()) + chunk(b"IEND", b""))
