"""Setup in plain integers against vector files, and faults of it that the files must catch.

python3 setup_test.py VECTOR_FILE...
"""

import random
import re
import sys
import unittest
from typing import List, NamedTuple
from unittest import mock

import setup

MIN_TRIANGLES = 1000
CULL = ("none", "back", "front")
SHADE = ("smooth", "flat")
FILES = []  # of the command line


def point(lut_bits, newton_steps, k, fraction, **others):
    return dict(reciprocal_lut_bits=lut_bits, reciprocal_newton_steps=newton_steps,
                reciprocal_bits=k, gradient_fraction_bits=fraction, **others)


# As in model/spec/design.cpp.
DESIGNS = {
    "low": point(8, 1, 19, 10),
    "med": point(10, 1, 22, 14),
    "med_plus": point(12, 1, 26, 16),
    "high": {},
    "high_tile": {},
    "high_plus": point(8, 2, 32, 20),
    "div28": point(0, 0, 28, 18, reciprocal_scheme="restoring2"),
    "persp": {"perspective": True},
    "flat": {"depth_test": False, "attributes": 0, "flat_attributes": 4},
    "wide": {},
    "tiny": point(9, 1, 23, 13, subpixel_bits=4, guard_bits=10, depth_bits=16),
    "exact": point(0, 0, 0, 0, reciprocal_scheme="none"),
}


class Refused(Exception):
    """A file that is no vector file of setup."""


# Words


class Field(NamedTuple):
    name: str
    is_signed: bool
    bits: int
    count: int = 1

    def columns(self):
        return [self.name] if self.count == 1 else [f"{self.name}[{i}]" for i in range(self.count)]

    def parse(self, word):
        digits = (self.bits + 3) // 4
        if not re.fullmatch(f"[0-9a-f]{{{digits}}}", word) or int(word, 16) >> self.bits:
            raise Refused(f"{self.name}: '{word}' has not the format of {self.bits} bits")
        return setup.wrap(int(word, 16), self.bits) if self.is_signed else int(word, 16)

    def format(self, value):
        """The word, or the number itself where it is wider than the field."""
        low = -(1 << (self.bits - 1)) if self.is_signed else 0
        if not low <= value < low + (1 << self.bits):
            return f"{value} in {self.bits} bits"
        return f"{setup.low_bits(value, self.bits):0{(self.bits + 3) // 4}x}"


def frame_fields(d):
    w = setup.widths(d)
    depth = int(d.depth_test)
    clip = [Field(f"clip_{bound}", False, w.frame_size) for bound in ("x0", "y0", "x1", "y1")]
    return [Field("width", False, w.frame_size), Field("height", False, w.frame_size),
            Field("cull", False, 2), Field("depth", False, 4, depth),
            Field("depth_write", False, 1, depth),
            Field("shade", False, 1, int(d.attributes > 0)), *clip,
            Field("bias_constant", True, w.bias_constant, depth),
            Field("bias_slope", True, 16, depth)]


def triangle_fields(d):
    w = setup.widths(d)
    weights = 3 if d.perspective else 0
    return [Field("id", False, 32), Field("x", True, w.coord, 3), Field("y", True, w.coord, 3),
            Field("z", False, w.depth_in, 3 if d.depth_test else 0),
            Field("inverse_w", False, d.inverse_w_bits, weights),
            Field("inverse_w_shift", False, 8, weights),
            Field("attr", False, d.attribute_bits, 3 * d.attributes),
            Field("flat", False, d.attribute_bits, d.flat_attributes)]


def prim_fields(d):
    w = setup.widths(d)
    depth = int(d.depth_test)
    planes = 0 if d.perspective else d.attributes
    corners = 3 if d.perspective else 0
    return [Field("id", False, 32),
            *[Field(bound, False, w.pixel) for bound in setup.Box._fields],
            Field("a", True, w.edge_coeff, 3), Field("b", True, w.edge_coeff, 3),
            Field("e", True, w.edge, 3), Field("z_steep", False, 1, int(d.hierarchical_z)),
            *[Field(f"z_{part}", True, w.depth_plane, depth) for part in setup.Plane._fields],
            Field("z_bias", True, w.depth_bias, depth),
            *[Field(f"attr_{part}", True, w.attr_plane, planes) for part in setup.Plane._fields],
            Field("e_low", False, d.subpixel_bits, corners),
            Field("inverse_w", False, d.inverse_w_bits, corners),
            Field("inverse_w_shift", False, 8, corners),
            Field("vertex_attr", False, d.attribute_bits, corners * d.attributes),
            Field("flat", False, d.attribute_bits, d.flat_attributes)]


def columns_of(fields):
    return [column for field in fields for column in field.columns()]


def parse_words(fields, words):
    """The numbers of each field, a list by its name."""
    if len(words) != len(columns_of(fields)):
        raise Refused(f"{len(words)} words, not {len(columns_of(fields))}")
    rest = iter(words)
    return {f.name: [f.parse(next(rest)) for _ in range(f.count)] for f in fields}


# From words to what setup takes, and back


def frame_of(v):
    shade = SHADE[v["shade"][0]] if v["shade"] else "smooth"
    return setup.FrameState(v["width"][0], v["height"][0], CULL[v["cull"][0]], shade,
                            v["clip_x0"][0], v["clip_y0"][0], v["clip_x1"][0], v["clip_y1"][0],
                            *(v["bias_constant"] or [0]), *(v["bias_slope"] or [0]))


def triangle_of(d, v):
    z, inverse_w, shift = (v[name] or [0] * 3 for name in ("z", "inverse_w", "inverse_w_shift"))
    n = d.attributes
    attr = [v["attr"][i * n:(i + 1) * n] + (v["flat"] if i == 0 else [0] * d.flat_attributes)
            for i in range(3)]
    corners = zip(v["x"], v["y"], z, attr, inverse_w, shift)
    return setup.Triangle(v["id"][0], tuple(setup.Vertex(*corner) for corner in corners))


def prim_values(prim):
    """The numbers of a SetupPrim, a list by the name of the field."""
    values = {"id": [prim.id], "z_steep": [int(prim.z_steep)], "z_bias": [prim.z_bias],
              "flat": prim.flat}
    values.update((name, [bound]) for name, bound in prim.box._asdict().items())
    for name in setup.Edge._fields:
        values[name] = [getattr(edge, name) for edge in prim.edges]
    for name in setup.Plane._fields:
        values[f"z_{name}"] = [getattr(prim.z, name)]
        values[f"attr_{name}"] = [getattr(plane, name) for plane in prim.attr]
    if prim.perspective:
        values.update(prim.perspective._asdict())
        values["vertex_attr"] = [a for corner in values.pop("attr") for a in corner]
    return values


def format_prim(fields, prim):
    values = prim_values(prim)
    return [f.format(value) for f in fields if f.count for value in values[f.name]]


# Files


class Case(NamedTuple):
    name: str
    frame: setup.FrameState
    triangles: List[setup.Triangle]
    expected: List[List[str]]  # the lines' words


class VectorFile(NamedTuple):
    path: str
    design: str
    cases: List[Case]


def fnv1a(data):
    value = 0xcbf29ce484222325
    for byte in data:
        value = (value ^ byte) * 0x100000001b3 & 0xffffffffffffffff
    return value


class Reader:
    """The lines of a file, blank ones skipped."""

    def __init__(self, data):
        self.lines = [line.split(" ") for line in data.decode("ascii").split("\n") if line]
        self.next = 0

    def peek(self):
        return self.lines[self.next][0] if self.next < len(self.lines) else ""

    def take(self, word):
        """The words behind this one on the next line."""
        if self.peek() != word:
            raise Refused(f"expected '{word}', found '{self.peek()}'")
        self.next += 1
        return self.lines[self.next - 1][1:]

    def take_one(self, word, expected=None):
        words = self.take(word)
        if len(words) != 1 or expected not in (None, words[0]):
            raise Refused(f"{word}: expected {expected or 'a word'}, found {words}")
        return words[0]


def read_case(reader, d, formats):
    name = reader.take_one("case")
    frame = frame_of(parse_words(formats["frame"], reader.take("frame")))
    if reader.peek() == "clear_depth":  # nothing that setup looks at
        Field("clear_depth", False, d.depth_bits).parse(reader.take_one("clear_depth"))
    if reader.peek() == "stalls":  # nor these: no bit depends on them
        reader.take("stalls")
    triangles, expected = [], []
    while reader.peek() == "triangle":
        words = reader.take("triangle")
        triangles.append(triangle_of(d, parse_words(formats["triangle"], words)))
    while reader.peek() in ("setup_prim", "drop"):
        kind = reader.peek()
        words = reader.take(kind)
        if kind == "setup_prim":
            parse_words(formats["setup_prim"], words)
        expected.append([kind] + words)
    reader.take("end")
    if len(triangles) != len(expected):
        raise Refused(f"{name}: {len(triangles)} triangles, {len(expected)} outputs")
    return Case(name, frame, triangles, expected)


def read_header(reader):
    """Name of the design."""
    reader.take_one("pineda-vectors", "2")
    reader.take_one("unit", "setup")
    name = reader.take_one("design")
    if name not in DESIGNS:
        raise Refused(f"unknown design {name}")
    for word in ("level", "seed", "formats"):
        reader.take_one(word)
    return name


def read_file(path):
    with open(path, "rb") as file:
        data = file.read()
    reader = Reader(data)
    name = read_header(reader)
    d = setup.design(DESIGNS[name])
    formats = {"frame": frame_fields(d), "triangle": triangle_fields(d),
               "setup_prim": prim_fields(d)}
    for struct, fields in formats.items():
        if reader.take("columns") != [struct] + columns_of(fields):
            raise Refused(f"other columns of {struct}")
    cases = []
    while reader.peek() == "case":
        cases.append(read_case(reader, d, formats))
    count = int(reader.take_one("cases"))
    content = data[data.index(b"\n", data.index(b"\nformats ") + 1) + 1:data.rindex(b"\ncases ") + 1]
    if len(cases) != count or f"{fnv1a(content):016x}" != reader.take_one("content"):
        raise Refused("a wrong count of cases, or a wrong hash of the content")
    return VectorFile(path, name, cases)


# Comparison


class Difference(NamedTuple):
    case: str
    triangle: int
    field: str
    expected: str
    got: str

    def __str__(self):
        return (f"case {self.case}, triangle {self.triangle}, {self.field}: "
                f"expected {self.expected}, got {self.got}")


def first_field(fields, expected, result):
    """Name, expected and got of the first word that differs, or None."""
    dropped = isinstance(result, str)
    if expected[0] == "drop" or dropped:
        got = ["drop", result] if dropped else ["setup_prim"]
        return None if got == expected else ("drop", " ".join(expected[:2]), " ".join(got))
    got = format_prim(fields, result)
    for name, want, have in zip(columns_of(fields), expected[1:], got):
        if want != have:
            return name, want, have
    return None if len(got) == len(expected) - 1 else ("words", len(expected) - 1, len(got))


def differences(file):
    """The first of every triangle that has one."""
    parameters = DESIGNS[file.design]
    fields = prim_fields(setup.design(parameters))
    for case in file.cases:
        for i, (triangle, expected) in enumerate(zip(case.triangles, case.expected)):
            result = setup.setup(parameters, case.frame, triangle)
            found = first_field(fields, expected, result)
            if found:
                yield Difference(case.name, i, *found)


def count_triangles(file):
    return sum(len(case.triangles) for case in file.cases)


class VectorTest(unittest.TestCase):
    def test_every_output(self):
        for file in FILES:
            with self.subTest(file=file.path):
                found = list(differences(file))
                print(f"{file.path}: {file.design}, {len(file.cases)} cases, "
                      f"{count_triangles(file)} triangles, {len(found)} wrong")
                if found:
                    self.fail(str(found[0]))

    def test_enough_triangles(self):
        self.assertGreaterEqual(sum(map(count_triangles, FILES)), MIN_TRIANGLES)


class Mutants(unittest.TestCase):
    def assert_caught(self, name, fault):
        with mock.patch.object(setup, name, fault):
            found = next((d for file in FILES for d in differences(file)), None)
        self.assertIsNotNone(found, f"no vector catches this fault of {name}")


class MutantTest(Mutants):
    """Each test puts one fault in; some output of the files must then differ."""

    def test_no_edge_biased(self):
        self.assert_caught("edge_biases", lambda s: (0, 0, 0))

    def test_every_edge_biased(self):
        self.assert_caught("edge_biases", lambda s: (1, 1, 1))

    def test_top_edge_biased(self):
        self.assert_caught("edge_biases", lambda s: (int(s.y1 >= 0), int(s.y2 >= s.y1), 0))

    def test_bottom_edge_not_biased(self):
        self.assert_caught("edge_biases", lambda s: (int(s.y1 > 0), int(s.y2 > s.y1), 0))

    def test_edge_biased_after_shift(self):
        def edges_of(d, s):
            biases = setup.edge_biases(s)
            with mock.patch.object(setup, "edge_biases", lambda s: (0, 0, 0)):
                edges = original(d, s)
            return tuple(edge._replace(e=edge.e - bias) for edge, bias in zip(edges, biases))
        original = setup.edges_of
        self.assert_caught("edges_of", edges_of)

    def test_half_down(self):
        self.assert_caught("round_half_up", lambda v, shift: (v + ((1 << shift) - 1 >> 1)) >> shift)

    def test_half_away_from_zero(self):
        def half_away(v, shift):
            magnitude = (abs(v) + (1 << shift >> 1)) >> shift
            return magnitude if v >= 0 else -magnitude
        self.assert_caught("round_half_up", half_away)

    def test_anchor_leftmost_before_topmost(self):
        def anchor_index(v):
            return min(range(3), key=lambda i: (v[i].x, v[i].y))
        self.assert_caught("anchor_index", anchor_index)

    def test_anchor_rightmost_of_topmost(self):
        def anchor_index(v):
            return min(range(3), key=lambda i: (v[i].y, -v[i].x))
        self.assert_caught("anchor_index", anchor_index)

    def test_anchor_first_vertex(self):
        self.assert_caught("anchor_index", lambda v: 0)

    def test_rom_entries_one_more(self):
        original = setup.rom_entry
        self.assert_caught("rom_entry", lambda lut_bits, i: original(lut_bits, i) + 1)

    def test_rom_entries_one_less(self):
        original = setup.rom_entry
        self.assert_caught("rom_entry", lambda lut_bits, i: original(lut_bits, i) - 1)

    def test_first_rom_entry_one_more(self):
        original = setup.rom_entry
        self.assert_caught("rom_entry", lambda lut_bits, i: original(lut_bits, i) + (i == 0))

    def test_reciprocal_not_saturated(self):
        self.assert_caught("saturate_mantissa", lambda mantissa, k: mantissa)

    def test_scissor_right_edge_inclusive(self):
        original = setup.scissor_box
        self.assert_caught("scissor_box", lambda f: original(f)._replace(x1=f.scissor_x1))

    def test_scissor_bottom_edge_inclusive(self):
        original = setup.scissor_box
        self.assert_caught("scissor_box", lambda f: original(f)._replace(y1=f.scissor_y1))

    def test_right_border_inclusive(self):
        original = setup.sample_range
        self.assert_caught("sample_range", lambda low, high, s: original(low, high + 1, s))

    def test_reference_at_box(self):
        def reference_sample(d, box):
            return tuple((2 * pixel + 1) << d.subpixel_bits >> 1 for pixel in box[:2])
        self.assert_caught("reference_sample", reference_sample)

    def test_flat_shading_by_anchor(self):
        self.assert_caught("painted_vertices",
                           lambda f, v, order: order[:1] * 3 if f.shade == "flat" else order)

    def test_gradients_wrapped_before_reference(self):
        def plane_of(d, s, r, values, value_fraction, bits):
            def wrapped(*arguments):
                return tuple(setup.wrap(g, bits) for g in gradients(*arguments))
            with mock.patch.object(setup, "gradients", wrapped):
                return original(d, s, r, values, value_fraction, bits)
        gradients, original = setup.gradients, setup.plane_of
        self.assert_caught("plane_of", plane_of)

    def test_depth_bias_wraps(self):
        def depth_bias(d, frame, magnitude):
            bias = (frame.bias_constant << 16) + frame.bias_slope * magnitude
            return setup.wrap(bias, setup.widths(d).depth_bias)
        self.assert_caught("depth_bias", depth_bias)

    def test_magnitude_not_saturated(self):
        def magnitude(d, s, r, z):
            return max(map(abs, setup.gradients(d, s, r, z, 8, 8)))
        self.assert_caught("depth_magnitude", magnitude)

    def test_magnitude_of_wrapped_gradients(self):
        def magnitude(d, s, r, z):
            both = setup.plane_of(d, s, r, z, 8, setup.widths(d).depth_plane)[:2]
            return max(abs(setup.round_half_up(g, d.gradient_fraction_bits - 8)) for g in both)
        self.assert_caught("depth_magnitude", magnitude)

    def test_magnitude_rounded_twice(self):
        def magnitude(d, s, r, z):
            fraction = d.gradient_fraction_bits
            both = [setup.round_half_up(g, fraction - 8)
                    for g in setup.gradients(d, s, r, z, 8, fraction)]
            return max(abs(setup.saturate(g, setup.widths(d).bias_magnitude)) for g in both)
        self.assert_caught("depth_magnitude", magnitude)


class NumericsTest(unittest.TestCase):
    """What docs/numerics.md states in numbers, also of schemes that the files do not have."""

    BOUNDS = (("newton", 10, 0, 16, 10.62), ("newton", 8, 1, 19, 17.29),
              ("newton", 10, 1, 22, 21.04), ("quadratic", 7, 0, 26, 23.99),
              ("newton", 12, 1, 26, 24.97), ("newton", 7, 2, 30, 29.41),
              ("newton", 8, 2, 32, 31.41), ("restoring2", 0, 0, 28, 28.),
              ("restoring4", 0, 0, 28, 28.))

    def test_reciprocal_error(self):
        numbers = random.Random(1)
        areas = [1 << i for i in range(47)]
        areas += [numbers.randrange(1, 1 << numbers.randint(1, 46)) for _ in range(2000)]
        for scheme, lut_bits, steps, k, good_bits in self.BOUNDS:
            d = setup.design(point(lut_bits, steps, k, 8, reciprocal_scheme=scheme))
            for area2 in areas:
                r = setup.reciprocal(d, area2)
                one = 1 << (k + r.length - 1)
                self.assertLessEqual(abs(r.mantissa * area2 - one) / one, 2 ** -good_bits,
                                     (scheme, lut_bits, area2))

    def test_quadratic_rom_bits(self):
        c1_bits, c2_bits = (c.bit_length() for c in setup.parabola(7, 28, 0)[1:])
        self.assertEqual(128 * (28 - 1 + c1_bits + c2_bits), 7936)

    def test_widths(self):
        names = ("coord", "edge_coeff", "edge", "depth_in", "depth_plane", "attr_plane",
                 "bias_magnitude", "depth_bias")
        for design, bits in (("high_tile", (23, 24, 39, 32, 44, 28, 35, 42)),
                             ("tiny", (15, 16, 27, 24, 31, 23, 27, 34))):
            w = setup.widths(setup.design(DESIGNS[design]))
            self.assertEqual(tuple(getattr(w, name) for name in names), bits)


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    FILES = [read_file(path) for path in sys.argv[1:]]
    unittest.main(argv=sys.argv[:1])
