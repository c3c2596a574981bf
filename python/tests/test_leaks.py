"""Calls leave nothing behind, however they end: objects of Python are counted here, the memory of the binding is watched by
./dev python --sanitized."""
import gc
import sys
import warnings

import numpy as np
import pytest

import axiscert as ax
from conftest import nearest_point_test, squared_distance

ONE = dict(family="tangent", trials=600, precision="binary32")
Q = ax.generate("scene-walk", 50)


def measured(a, b, c, p, r):
    with np.errstate(all="ignore"):
        squared = squared_distance(a, b, c, p)
        return {"verdict": squared <= r * r, "separation": np.sqrt(squared) - r, "normal": p - a}


def raises(a, b, c, p, r):
    raise ValueError(a)


def refused(call):
    def run():
        with pytest.raises(ax.Error):
            call()
    return run


CALLS = {
    "judge": lambda: ax.judge(ax.kernel(nearest_point_test, name="same"), **ONE),
    "tensors": lambda: ax.judge(ax.kernel(nearest_point_test, name="same", tensors=np.asarray), **ONE),
    "measures": lambda: ax.judge(ax.kernel(measured, name="same", measures="normal"), **ONE),
    "an exception": refused(lambda: ax.judge(ax.kernel(raises, name="same"), **ONE)),
    "an exception recorded": lambda: ax.judge(ax.kernel(raises, name="same", on_error="record"), **ONE),
    "an answer refused": refused(lambda: ax.judge(ax.kernel(lambda *q: q[0], name="same"), **ONE)),
    "options refused": refused(lambda: ax.judge("published", family="nosuch")),
    "queries": lambda: (ax.generate("tangent", 50).lines(), ax.query_at(Q.addresses[:5])),
    "truth": lambda: (ax.truth(Q).facts, ax.truth(Q).depth, ax.truth(Q).squared_distance, ax.truth(Q).signs("published")),
    "formulae": lambda: (ax.formulae("published", Q), ax.formulae("published", Q, format="bfloat16")),
    "certified": lambda: ax.certified.contacts(Q),
    "ladder": lambda: ax.ladder("published", family="tangent", trials=10, speed=False),
}


@pytest.mark.parametrize("name", CALLS)
def test_calls_leave_no_objects(name):
    def some(times):
        for _ in range(times):
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")
                CALLS[name]()
        gc.collect()
        sys._clear_type_cache()  # which keeps names that were looked up
        return sys.getallocatedblocks()

    some(3)
    before = some(1)
    assert some(20) - before < 20, "one block of memory or more is left by each call"
