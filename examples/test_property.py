"""A property test of a kernel of one's own, by pytest and hypothesis: axiscert.truth is the oracle.

    pytest test_property.py
"""
import numpy as np
from hypothesis import given, settings, strategies as st
from hypothesis.extra.numpy import arrays

import axiscert as ax

SHAPE = ("sphere-triangle", "vertices")
finite = st.floats(-100, 100, width=32)


def bounding_sphere(a, b, c, p, r):
    """Whether the sphere comes near a sphere around the triangle: a test that may say contact too often, never too seldom."""
    centre = (a + b + c) / np.float32(3)
    reach = np.sqrt(np.max([((v - centre) ** 2).sum(axis=1) for v in (a, b, c)], axis=0))
    return np.sqrt(((p - centre) ** 2).sum(axis=1)) <= (reach + r) * np.float32(1.001) + np.float32(1e-4)


@settings(deadline=None, max_examples=50, derandomize=True)
@given(arrays(np.float32, (4, 8, 3), elements=finite), arrays(np.float32, 8, elements=st.floats(0, 100, width=32)))
def test_it_misses_no_contact(points, r):
    a, b, c, p = points
    exact = ax.truth(ax.Queries.of(*SHAPE, a=a, b=b, c=c, p=p, r=r))
    missed = exact.contact & ~bounding_sphere(a, b, c, p, r)
    assert not missed.any(), exact.facts[int(missed.argmax())]
