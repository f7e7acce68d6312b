"""Triangle setup once more, in plain integers, written from model/core, model/spec and
docs/numerics.md alone: a third opinion."""

from types import SimpleNamespace
from typing import NamedTuple, Optional, Tuple

# A design's parameters with the values of high_tile; those that setup does not read are left out.
HIGH_TILE = {
    "subpixel_bits": 8,
    "guard_bits": 14,
    "depth_test": True,
    "depth_bits": 24,
    "attributes": 4,
    "flat_attributes": 0,
    "attribute_bits": 8,
    "perspective": False,
    "inverse_w_bits": 20,
    "reciprocal_scheme": "newton",
    "reciprocal_lut_bits": 7,
    "reciprocal_newton_steps": 2,
    "reciprocal_bits": 30,
    "gradient_fraction_bits": 18,
    "tile_log2": 3,
    "hierarchical_z": False,
}

Z_FRACTION_BITS = 8  # of a vertex's z; an attribute has none
MAGNITUDE_FRACTION_BITS = 8
BIAS_FRACTION_BITS = 16
NO_SCISSOR_PX = 1 << 24


class Vertex(NamedTuple):
    x: int  # subpixels
    y: int
    z: int = 0  # units of 2^-8 codes
    attr: Tuple[int, ...] = ()  # interpolated ones, then flat ones
    inverse_w: int = 0
    inverse_w_shift: int = 0


class Triangle(NamedTuple):
    id: int
    vertices: Tuple[Vertex, Vertex, Vertex]


class Box(NamedTuple):
    """Samples, bounds inclusive."""
    x0: int
    y0: int
    x1: int
    y1: int


class FrameState(NamedTuple):
    width: int
    height: int
    cull: str = "none"  # "none", "back", "front"
    shade: str = "smooth"  # "smooth", "flat"
    scissor_x0: int = 0
    scissor_y0: int = 0
    scissor_x1: int = NO_SCISSOR_PX  # exclusive
    scissor_y1: int = NO_SCISSOR_PX
    bias_constant: int = 0  # codes
    bias_slope: int = 0  # units of 2^-8


class Edge(NamedTuple):
    a: int
    b: int
    e: int


class Plane(NamedTuple):
    dx: int
    dy: int
    ref: int


class Perspective(NamedTuple):
    """Of the three edges and vertices, in canonical order."""
    e_low: Tuple[int, ...]
    inverse_w: Tuple[int, ...]
    inverse_w_shift: Tuple[int, ...]
    attr: Tuple[Tuple[int, ...], ...]


class SetupPrim(NamedTuple):
    id: int
    box: Box
    edges: Tuple[Edge, ...]
    z: Plane  # zero in a design without planes of depth, as are the next two
    z_bias: int
    z_steep: bool
    attr: Tuple[Plane, ...]  # none with perspective
    flat: Tuple[int, ...]
    perspective: Optional[Perspective]


class Shape(NamedTuple):
    """A triangle's vertices 1 and 2 and its reference sample, seen from the anchor: subpixels."""
    x1: int
    y1: int
    x2: int
    y2: int
    rx: int
    ry: int

    @property
    def area2(self):
        return self.x1 * self.y2 - self.x2 * self.y1


class Reciprocal(NamedTuple):
    """1/area2 = mantissa * 2^(1 - k - length)."""
    mantissa: int
    length: int


NO_PLANE = Plane(0, 0, 0)


def design(parameters):
    """A design: high_tile but for these parameters."""
    unknown = set(parameters) - set(HIGH_TILE)
    if unknown:
        raise ValueError(f"unknown parameters: {sorted(unknown)}")
    return SimpleNamespace(**{**HIGH_TILE, **parameters})


def widths(d):
    """Bits of what goes into setup and comes out."""
    span = d.guard_bits + 1 + d.subpixel_bits
    plane = 2 + d.gradient_fraction_bits
    return SimpleNamespace(
        coord=span,
        edge_coeff=span + 1,
        edge=2 * span + 1 - d.subpixel_bits,
        depth_in=d.depth_bits + Z_FRACTION_BITS,
        depth_plane=d.depth_bits + plane,
        attr_plane=d.attribute_bits + plane,
        bias_constant=d.depth_bits + 1,
        bias_magnitude=d.depth_bits + 3 + MAGNITUDE_FRACTION_BITS,
        depth_bias=d.depth_bits + 2 + BIAS_FRACTION_BITS,
        frame_size=d.guard_bits + 1,
        pixel=d.guard_bits,
    )


# Numbers


def low_bits(value, bits):
    return value & ((1 << bits) - 1)


def wrap(value, bits):
    """The low bits, read as two's complement."""
    sign = 1 << (bits - 1)
    return (low_bits(value, bits) ^ sign) - sign


def round_half_up(value, shift):
    return (value + (1 << shift >> 1)) >> shift


def saturate(value, bits):
    """To a signed number of so many bits."""
    limit = 1 << (bits - 1)
    return max(-limit, min(value, limit - 1))


# The reciprocal of the doubled area


def rom_entry(lut_bits, index):
    """First guess for an interval of mantissas, without its leading 1."""
    denominator = (2 << lut_bits) + 1 + 2 * index
    return ((16 << 2 * lut_bits) + denominator) // (2 * denominator) - (2 << lut_bits)


def newton(d, m, bits):
    """1/(2m), by steps from a guess."""
    lut = d.reciprocal_lut_bits
    index = low_bits(m >> (bits - 1 - lut), lut)
    x = ((2 << lut) + rom_entry(lut, index)) << (bits - lut - 2)
    for _ in range(d.reciprocal_newton_steps):
        product = 2 * m * x >> bits
        x = x * ((2 << bits) - product) >> bits
    return x


def parabola(lut_bits, bits, index):
    """Coefficients of 1, t, t^2 in an interval of mantissas."""
    p = 16 * ((1 << lut_bits) + index) + 1
    q, r = p + 7, p + 14

    def nearest(numerator):
        return ((numerator << (lut_bits + bits + 1)) + p * q * r) // (2 * p * q * r)

    c0 = nearest(16 * q * r + 16 * r + 128)
    return min(c0, (1 << bits) - 1), nearest(256 * r + 2304), nearest(4096)


def quadratic(d, m, bits):
    """1/(2m), by a parabola."""
    t_bits = bits - 1 - d.reciprocal_lut_bits
    index = low_bits(m >> t_bits, d.reciprocal_lut_bits)
    t = low_bits(m, t_bits)
    c0, c1, c2 = parabola(d.reciprocal_lut_bits, bits, index)
    return c0 - (c1 * t >> t_bits) + (c2 * (t * t >> t_bits) >> t_bits)


def saturate_mantissa(mantissa, k):
    """Below 1, which a power of two would need."""
    return min(mantissa, (1 << k) - 1)


def reciprocal(d, area2):
    k = d.reciprocal_bits
    length = area2.bit_length()
    if d.reciprocal_scheme in ("restoring2", "restoring4"):
        mantissa = round_half_up((1 << (length + k)) // area2, 1)
    else:
        scheme = {"newton": newton, "quadratic": quadratic}[d.reciprocal_scheme]
        bits = k + 2
        mantissa = round_half_up(scheme(d, (area2 << bits) >> length, bits), 2)
    return Reciprocal(saturate_mantissa(mantissa, k), length)


# Boxes and order


def sample_range(low, high, subpixel_bits):
    """First and last sample in [low, high)."""
    half = 1 << (subpixel_bits - 1)
    return (low + half - 1) >> subpixel_bits, (high - half - 1) >> subpixel_bits


def sample_box(vertices, subpixel_bits):
    xs = [v.x for v in vertices]
    ys = [v.y for v in vertices]
    x0, x1 = sample_range(min(xs), max(xs), subpixel_bits)
    y0, y1 = sample_range(min(ys), max(ys), subpixel_bits)
    return Box(x0, y0, x1, y1)


def frame_box(frame):
    return Box(0, 0, frame.width - 1, frame.height - 1)


def scissor_box(frame):
    return Box(frame.scissor_x0, frame.scissor_y0, frame.scissor_x1 - 1, frame.scissor_y1 - 1)


def intersect(p, q):
    return Box(max(p.x0, q.x0), max(p.y0, q.y0), min(p.x1, q.x1), min(p.y1, q.y1))


def is_empty(box):
    return box.x0 > box.x1 or box.y0 > box.y1


def doubled_area(vertices):
    """Positive where they are clockwise on the screen."""
    u, v, w = vertices
    return (v.x - u.x) * (w.y - u.y) - (w.x - u.x) * (v.y - u.y)


def is_culled(cull, area2):
    return cull == ("back" if area2 > 0 else "front")


def anchor_index(vertices):
    """The topmost vertex, of several the leftmost one."""
    return min(range(3), key=lambda i: (vertices[i].y, vertices[i].x))


def canonical_order(vertices):
    """Clockwise from the anchor."""
    first = anchor_index(vertices)
    anchor, second, third = vertices[first:] + vertices[:first]
    return (anchor, second, third) if doubled_area(vertices) > 0 else (anchor, third, second)


def reference_sample(d, box):
    """The first sample of the box's first tile, subpixels."""
    def centre(pixel):
        first = pixel >> d.tile_log2 << d.tile_log2
        return (first << d.subpixel_bits) + (1 << (d.subpixel_bits - 1))
    return centre(box.x0), centre(box.y0)


def shape_of(ordered, reference):
    anchor, second, third = ordered
    return Shape(second.x - anchor.x, second.y - anchor.y, third.x - anchor.x,
                 third.y - anchor.y, reference[0] - anchor.x, reference[1] - anchor.y)


# Edges


def edge_biases(s):
    """1 for an edge that is neither top nor left; in canonical order the last one is left."""
    return int(s.y1 > 0), int(s.y2 >= s.y1), 0


def edge_values(s):
    """E - bias of the three edges at the reference sample."""
    e0 = s.x1 * s.ry - s.y1 * s.rx
    e2 = s.y2 * s.rx - s.x2 * s.ry
    e = (e0, s.area2 - e0 - e2, e2)
    return tuple(value - bias for value, bias in zip(e, edge_biases(s)))


def edges_of(d, s):
    steps = ((-s.y1, s.x1), (s.y1 - s.y2, s.x2 - s.x1), (s.y2, -s.x2))
    return tuple(Edge(a, b, e >> d.subpixel_bits) for (a, b), e in zip(steps, edge_values(s)))


# Planes


def gradients(d, s, r, values, value_fraction, fraction):
    """By x and y in px, with so many fraction bits, not wrapped."""
    d1 = values[1] - values[0]
    d2 = values[2] - values[0]
    shift = d.reciprocal_bits + r.length - 1 - fraction - d.subpixel_bits + value_fraction
    return (round_half_up((d1 * s.y2 - d2 * s.y1) * r.mantissa, shift),
            round_half_up((d2 * s.x1 - d1 * s.x2) * r.mantissa, shift))


def plane_of(d, s, r, values, value_fraction, bits):
    """Through three values at the vertices."""
    fraction = d.gradient_fraction_bits
    dx, dy = gradients(d, s, r, values, value_fraction, fraction)
    start = values[0] << (fraction - value_fraction + d.subpixel_bits)
    ref = round_half_up(start + dx * s.rx + dy * s.ry, d.subpixel_bits)
    return Plane(wrap(dx, bits), wrap(dy, bits), wrap(ref, bits))


def depth_magnitude(d, s, r, z):
    """The greater gradient without its sign, saturated as what it is made of."""
    bits = widths(d).bias_magnitude
    both = gradients(d, s, r, z, Z_FRACTION_BITS, MAGNITUDE_FRACTION_BITS)
    return max(abs(saturate(g, bits)) for g in both)


def depth_bias(d, frame, magnitude):
    bias = (frame.bias_constant << BIAS_FRACTION_BITS) + frame.bias_slope * magnitude
    return saturate(bias, widths(d).depth_bias)


def is_steep(d, magnitude):
    return magnitude >= 1 << (d.depth_bits - d.tile_log2 + 6)


def depth_of(d, frame, s, ordered):
    """Plane of depth, bias, and whether it is steep."""
    if not d.depth_test or d.reciprocal_scheme == "none":
        return NO_PLANE, 0, False
    r = reciprocal(d, s.area2)
    z = [v.z for v in ordered]
    magnitude = depth_magnitude(d, s, r, z)
    return (plane_of(d, s, r, z, Z_FRACTION_BITS, widths(d).depth_plane),
            depth_bias(d, frame, magnitude),
            d.hierarchical_z and is_steep(d, magnitude))


# Attributes


def painted_vertices(frame, vertices, ordered):
    """Whose attributes the vertices have."""
    return (vertices[0],) * 3 if frame.shade == "flat" else ordered


def attribute_planes(d, s, painted):
    if d.perspective or d.attributes == 0:
        return ()
    if d.reciprocal_scheme == "none":
        return (NO_PLANE,) * d.attributes
    r = reciprocal(d, s.area2)
    bits = widths(d).attr_plane
    return tuple(plane_of(d, s, r, [v.attr[i] for v in painted], 0, bits)
                 for i in range(d.attributes))


def perspective_of(d, s, ordered, painted):
    if not d.perspective:
        return None
    return Perspective(tuple(low_bits(e, d.subpixel_bits) for e in edge_values(s)),
                       tuple(v.inverse_w for v in ordered),
                       tuple(v.inverse_w_shift for v in ordered),
                       tuple(tuple(v.attr[:d.attributes]) for v in painted))


def flat_attributes(d, vertices):
    return tuple(vertices[0].attr[d.attributes:d.attributes + d.flat_attributes])


def setup(parameters, frame, triangle):
    """A triangle's SetupPrim; or what drops it: "zero_area", "facing", "no_sample", "outside"."""
    d = design(parameters)
    vertices = tuple(triangle.vertices)
    area2 = doubled_area(vertices)
    if area2 == 0:
        return "zero_area"
    if is_culled(frame.cull, area2):
        return "facing"
    box = sample_box(vertices, d.subpixel_bits)
    if is_empty(box):
        return "no_sample"
    box = intersect(box, intersect(scissor_box(frame), frame_box(frame)))
    if is_empty(box):
        return "outside"
    ordered = canonical_order(vertices)
    painted = painted_vertices(frame, vertices, ordered)
    s = shape_of(ordered, reference_sample(d, box))
    z, z_bias, z_steep = depth_of(d, frame, s, ordered)
    return SetupPrim(triangle.id, box, edges_of(d, s), z, z_bias, z_steep,
                     attribute_planes(d, s, painted), flat_attributes(d, vertices),
                     perspective_of(d, s, ordered, painted))
