#!/usr/bin/env python3
"""Judges a frame that numpy drew: coverage of two triangles by edge functions, in whole arrays.

    judge_numpy.py [libpineda_golden.so.0]
"""
import ctypes
import ctypes.util
import sys

import numpy as np

DRAWN = 64  # px a side


class Frame(ctypes.Structure):  # pineda_frame
    _fields_ = [(name, ctypes.c_int32) for name in (
        "width", "height", "cull", "depth_func", "depth_write", "shade", "has_scissor", "scissor_x",
        "scissor_y", "scissor_width", "scissor_height", "bias_slope")] + [
            ("bias_constant", ctypes.c_int64), ("clear_depth", ctypes.c_double)]


class Tolerance(ctypes.Structure):  # pineda_tolerance
    _fields_ = [(name, ctypes.c_int32) for name in ("subpixel_bits", "guard_bits", "depth_bits")] + [
        ("depth_ulp", ctypes.c_double), ("color_lsb", ctypes.c_double)]


class Dump(ctypes.Structure):  # pineda_dump
    _fields_ = [(name, ctypes.c_void_p) for name in ("hits", "depth", "rgba")] + [
        ("samples", ctypes.c_size_t)]


class Verdict(ctypes.Structure):  # pineda_verdict
    _fields_ = [("samples_wrong", ctypes.c_uint64)] + [
        (name, ctypes.c_int32) for name in ("x", "y", "rule")] + [
            ("triangle", ctypes.c_int64), ("what", ctypes.c_char * 256)]


# pineda_screen_triangle
VERTEX = np.dtype([("position", "<f4", 4), ("rgba", "u1", 4)])
TRIANGLE = np.dtype([("id", "<u4"), ("v", VERTEX, 3)])


def hits_of(triangles, rule):
    """How many triangles cover each sample: edges by `rule`(value, is top or left)."""
    y, x = np.mgrid[0:DRAWN, 0:DRAWN] + 0.5
    hits = np.zeros((DRAWN, DRAWN), np.uint16)
    for triangle in triangles:
        p = triangle["v"]["position"][:, :2].astype(float)
        if np.cross(p[1] - p[0], p[2] - p[0]) < 0:
            p = p[[0, 2, 1]]
        inside = np.ones_like(hits, bool)
        for i in range(3):
            a, b = p[i], p[(i + 1) % 3]
            value = (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0])
            top_left = b[1] < a[1] or (b[1] == a[1] and b[0] > a[0])
            inside &= rule(value, top_left)
        hits += inside
    return hits


def judged(library, triangles, hits):
    """The verdict, and the map of wrong samples."""
    library.pineda_default_frame.restype = Frame
    library.pineda_default_tolerance.restype = Tolerance
    library.pineda_last_error.restype = ctypes.c_char_p
    frame = library.pineda_default_frame(DRAWN, DRAWN)
    tolerance = library.pineda_default_tolerance()
    dump = Dump(hits.ctypes.data, None, None, hits.size)
    verdict, wrong = Verdict(), np.zeros(hits.shape, np.uint8)
    status = library.pineda_judge(
        ctypes.byref(frame), ctypes.byref(tolerance), ctypes.c_void_p(triangles.ctypes.data),
        ctypes.c_size_t(len(triangles)), ctypes.byref(dump), ctypes.byref(verdict),
        ctypes.c_void_p(wrong.ctypes.data))
    if status != 0:
        raise RuntimeError(library.pineda_last_error().decode())
    return verdict, wrong


def main():
    name = sys.argv[1] if len(sys.argv) > 1 else ctypes.util.find_library("pineda_golden")
    library = ctypes.CDLL(name or "libpineda_golden.so.0")
    triangles = np.zeros(2, TRIANGLE)  # a square, cut along a diagonal that runs through samples
    triangles["v"]["position"] = [[(8, 8, .5, 1), (8, 56, .5, 1), (56, 56, .5, 1)],
                                  [(8, 8, .5, 1), (56, 56, .5, 1), (56, 8, .5, 1)]]
    rules = {"top-left rule": lambda e, top_left: (e > 0) | ((e == 0) & top_left),
             "inclusive edges": lambda e, top_left: e >= 0}
    counts = []
    for text, rule in rules.items():
        verdict, wrong = judged(library, triangles, hits_of(triangles, rule))
        assert verdict.samples_wrong == wrong.sum()
        counts.append(verdict.samples_wrong)
        print(f"{text:16} {verdict.samples_wrong} samples wrong"
              + (f"; ({verdict.x}, {verdict.y}): {verdict.what.decode()}" if counts[-1] else ""))
    return 0 if counts[0] == 0 and counts[1] > 0 else 1


if __name__ == "__main__":
    sys.exit(main())
