"""What a function can do wrong: each is an error that says it, or a finding, and the next run is as ever."""
import os
import signal
import subprocess
import sys
import textwrap
import threading
import time
import warnings

import numpy as np
import pytest

import axiscert as ax
from conftest import PRELOADED, nearest_point_test, squared_distance

ONE = dict(family="tangent", trials=3000, precision="binary32")


def contact(n):
    return np.ones(n, bool)


@pytest.mark.parametrize("answer, said", [
    (lambda r: contact(len(r))[:, None], r"verdicts have shape \(251, 1\), of 251 queries; give shape \(251,\)"),
    (lambda r: contact(len(r) - 1), r"verdicts have shape \(250,\)"),
    (lambda r: True, r"verdicts are bool, no array; give shape \(251,\)"),
    (lambda r: None, "verdicts are NoneType, no array"),
    (lambda r: "contact", "verdicts are str, no array"),
    (lambda r: np.ma.array(contact(len(r)), mask=True), "verdicts are a masked array"),
    (lambda r: np.ones(len(r)), "verdicts are float64; give bool, where True is contact, or uint8"),
    (lambda r: np.full(len(r), np.nan), "verdicts are float64"),
    (lambda r: np.ones(len(r), int), "verdicts are int64"),
    (lambda r: np.ones(len(r), np.uint32), "comparison bits take formulae="),
    (lambda r: np.array(["x"] * len(r)), "verdicts are <U1"),
    (lambda r: np.array(True), "verdicts are ndarray, no array"),
    (lambda r: contact(len(r)).astype(object), "verdicts are object"),
    (lambda r: np.zeros(len(r), [("verdict", "u1")]), r"verdicts are \[\('verdict', 'u1'\)\]"),
    (lambda r: (True for _ in r), "verdicts are generator, no array"),
    (lambda r: {"verdict": contact(0)}, r"verdicts have shape \(0,\)"),
    (lambda r: [[1], [1, 2]], "verdicts are list, of which NumPy makes no array"),
    (lambda r: {"contact": contact(len(r))}, 'has no "verdict"'),
    (lambda r: {"verdict": contact(len(r)), "time": r}, 'has "time"; it may have: verdict$'),
])
def test_what_is_no_answer(answer, said):
    kernel = ax.kernel(lambda a, b, c, p, r: answer(r), name="odd")
    with pytest.raises(ax.KernelRaised, match=said) as raised:
        ax.judge(kernel, **ONE)
    assert len(raised.value.queries) in (251, 1024)


def test_answers_of_any_stride_and_library():
    def strided(a, b, c, p, r):
        twice = np.zeros((len(r), 3), bool)
        twice[:, 1] = nearest_point_test(a, b, c, p, r)
        return twice[:, 1]

    class Tensor:  # what has __dlpack__ alone
        def __init__(self, array):
            self.array = array
        def __dlpack__(self, *given, **named):
            return self.array.__dlpack__()

    class OnItsDevice(Tensor):
        def __dlpack_device__(self):
            return self.array.__dlpack_device__()

    tensor_of = lambda kind: lambda *q: kind((~nearest_point_test(*q)).astype(np.uint8))

    expected = ax.judge(ax.kernel(nearest_point_test, name="one"), **ONE).bytes
    for function in (strided, lambda *q: list(nearest_point_test(*q)), tensor_of(Tensor), tensor_of(OnItsDevice),
                     lambda *q: np.asfortranarray(nearest_point_test(*q))):
        assert ax.judge(ax.kernel(function, name="one"), **ONE).bytes == expected


def unaligned(numbers):
    shifted = np.zeros(numbers.nbytes + 1, np.uint8)[1:].view(numbers.dtype)
    shifted[:] = numbers
    return shifted


@pytest.mark.parametrize("change", [unaligned, lambda numbers: numbers.astype(numbers.dtype.newbyteorder()), lambda numbers: numbers[::-1].copy()[::-1]])
def test_numbers_of_any_memory(change):
    def measured(changed):
        def function(a, b, c, p, r):
            with np.errstate(all="ignore"):
                squared = squared_distance(a, b, c, p)
                return {"verdict": squared <= r * r, "separation": changed(np.sqrt(squared) - r)}
        return ax.judge(ax.kernel(function, name="one", measures="separation"), **ONE).bytes

    def in_bits(changed):
        bits = lambda a, b, c, p, r: changed((r > 1).astype(np.uint64))
        return ax.judge(ax.kernel(bits, name="one", formulae="published"), **ONE).bytes

    for judged in (measured, in_bits):
        assert judged(change) == judged(lambda numbers: numbers)


def test_a_dictionary_that_changes_while_it_is_read():
    class Key(str):
        def __str__(self):
            self.answers.clear()
            return "separation"
        __hash__ = str.__hash__

    class Verdicts:
        def __array__(self, *given, **named):
            self.answers.clear()
            return contact(self.size)

    def emptied(a, b, c, p, r):
        key, verdicts = Key("separation"), Verdicts()
        answers = {"verdict": verdicts, key: np.ones(len(r), r.dtype), "normal": np.ones((len(r), 3), r.dtype)}
        key.answers = verdicts.answers = answers
        verdicts.size = len(r)
        return answers

    assert ax.judge(ax.kernel(emptied, measures="normal"), **ONE).json["kernels"][0]["families"]["tangent"]["contacts"]["answers"] > 0


def test_tensors_of_torch():
    torch = pytest.importorskip("torch")

    def in_torch(a, b, c, p, r):
        assert isinstance(a, torch.Tensor) and a.shape == (len(r), 3)
        centre = (a + b + c) / 3
        return ((p - centre).norm(dim=1) <= r)

    def in_numpy(a, b, c, p, r):
        centre = (a + b + c) / a.dtype.type(3)
        with np.errstate(all="ignore"):
            return np.sqrt(((p - centre) ** 2).sum(axis=1)) <= r

    in_tensors = ax.judge(ax.kernel(in_torch, name="one", tensors=torch.from_dlpack), **ONE).summary()
    in_arrays = ax.judge(ax.kernel(in_numpy, name="one"), **ONE).summary()
    assert abs(in_tensors[0]["missed"] - in_arrays[0]["missed"]) < 30  # the order of additions is torch's own


def test_the_arrays_are_read_only_and_may_be_kept():
    kept = []

    def keeps(a, b, c, p, r):
        kept.append((a, a.copy()))
        return contact(len(r))

    ax.judge(ax.kernel(keeps, name="keeps"), **ONE)
    assert kept and all(np.array_equal(a, copy) for a, copy in kept)

    def writes(a, b, c, p, r):
        a[0, 0] = 1
        return contact(len(r))

    with pytest.raises(ax.KernelRaised, match="ValueError: assignment destination is read-only") as raised:
        ax.judge(ax.kernel(writes, name="writes"), **ONE)
    assert isinstance(raised.value.__cause__, ValueError) and raised.value.__cause__.__traceback__ is not None


def test_an_exception_is_raised_or_recorded():
    def fails(a, b, c, p, r):
        if (r > 1).any():
            raise ZeroDivisionError("by zero")
        return contact(len(r))

    with pytest.raises(ax.KernelRaised, match="kernel fails: it raised ZeroDivisionError: by zero"):
        ax.judge(fails, family="general", trials=500, precision="binary32")
    record = ax.judge(ax.kernel(fails, on_error="record"), family="general", trials=500, precision="binary32", require="conservative")
    found = [finding for finding in record.json["findings"] if finding["kind"] == "crash"]
    assert found and "it raised ZeroDivisionError: by zero" in found[0]["detail"] and not record.met
    q = ax.generate("general", 500)
    counts = record.json["kernels"][0]["families"]["general"]["verdict"]
    assert counts["unanswered"] == int((q.r > 1).sum())


def raiser(raised):
    def raises(a, b, c, p, r):
        raise raised
    return raises


class NoText(Exception):
    def __str__(self):
        raise RuntimeError("no text")


@pytest.mark.parametrize("raised, said", [(NoText(), "NoText: \\(which has no text\\)"), (ValueError("a\udc80"), r"ValueError: a.*udc80")])
def test_an_exception_without_a_text(raised, said):
    with pytest.raises(ax.KernelRaised, match=said) as caught:
        ax.judge(ax.kernel(raiser(raised), name="odd"), **ONE)
    assert caught.value.__cause__ is raised
    with pytest.warns(ax.Notice, match=said):
        ax.judge(ax.kernel(raiser(raised), name="odd", on_error="record"), **ONE)


@pytest.mark.parametrize("on_error", ["raise", "record"])
def test_what_ends_a_program_is_no_finding(on_error):
    with pytest.raises(SystemExit):
        ax.judge(ax.kernel(raiser(SystemExit(3)), on_error=on_error), **ONE)


def test_answers_that_change_are_findings():
    calls = []

    def changes(a, b, c, p, r):
        calls.append(1)
        return np.full(len(r), len(calls) % 2 == 0)

    def by_place(a, b, c, p, r):
        return np.arange(len(r)) % 2 == 0

    def by_size(a, b, c, p, r):
        return np.full(len(r), len(r) > 600)

    for function, kind in ((changes, "nondeterministic"), (by_place, "order_dependent"), (by_size, "batch_dependent")):
        findings = ax.judge(function, **ONE).json["findings"]
        assert kind in [finding["kind"] for finding in findings], function


def test_no_verdict_is_a_finding():
    with pytest.warns(ax.Notice, match="it answers none of 251 queries"):
        record = ax.judge(ax.kernel(lambda a, b, c, p, r: np.full(len(r), 7, np.uint8), name="seven"), **ONE)
    assert [(one["kind"], one["detail"]) for one in record.json["findings"]] == [("inconsistent", "verdict 7, which is no verdict")]
    with pytest.warns(ax.Notice, match="it answers none of 251 queries"):
        record = ax.judge(ax.kernel(lambda a, b, c, p, r: np.full(len(r), 1 << 20, np.uint32), name="bits", formulae="published"), **ONE)
    assert "its comparison bit 20 is 1; there are comparisons 0 to 15" in record.json["findings"][0]["detail"]


def test_queries_that_overflow_warn_of_nothing():
    def naive(a, b, c, p, r):
        return ((p - a) ** 2).sum(axis=1) <= r * r

    with warnings.catch_warnings():
        warnings.simplefilter("error", RuntimeWarning)
        assert not ax.judge(ax.kernel(naive, precisions=["binary32"]), family="general", trials=300).json["findings"]


def test_exchanged_verdicts_are_said_first():
    with pytest.warns(ax.Notice, match="kernel exchanged: its verdicts are exchanged"):
        ax.judge(ax.kernel(lambda *q: ~nearest_point_test(*q), name="exchanged"), family="general", trials=3000, precision="binary32")


def test_measures_are_judged():
    def measured(a, b, c, p, r):
        with np.errstate(all="ignore"):
            squared = squared_distance(a, b, c, p)
            return {"verdict": squared <= r * r, "separation": np.sqrt(squared) - r}

    kernel = ax.kernel(measured, measures="separation", precisions=["binary64"])
    record = ax.judge(kernel, family="general", trials=300)
    told = record.json["kernels"][0]["families"]["general"]["contacts"]
    assert told["answers"] > 0, told
    for numbers, said in ((np.ones(len("x")), r"have shape \(1,\)"), ("float64", "separation are float64; give numbers, as float32"),
                          (np.longdouble, "separation are float128; give numbers"), ("complex64", "its numbers of separation are complex64; give numbers"),
                          ("U1", "its numbers of separation are <U1"), (object, "its numbers of separation are object")):
        def odd(a, b, c, p, r):
            return {"verdict": contact(len(r)), "separation": numbers if isinstance(numbers, np.ndarray) else np.ones(len(r), numbers)}
        with pytest.raises(ax.KernelRaised, match=said):
            ax.judge(ax.kernel(odd, name="odd", measures="separation"), **ONE)
    assert ax.kernel(measured, margin=np.float32(0.5), touching="contact", measures=np.int64(1)).id == "measured"
    with pytest.raises(ax.Error, match="there is no measure 'colour'.*there are: separation"):
        ax.kernel(measured, measures="colour")
    with pytest.raises(ax.KernelRaised, match="with measures= it returns a dictionary"):
        ax.judge(ax.kernel(lambda a, b, c, p, r: contact(len(r)), name="none", measures="all"), **ONE)


def test_threads_inside_a_function():
    def threaded(a, b, c, p, r):
        out = np.zeros(len(r), bool)
        half = len(r) // 2
        parts = [threading.Thread(target=lambda s=s: out.__setitem__(s, nearest_point_test(a[s], b[s], c[s], p[s], r[s])))
                 for s in (slice(0, half), slice(half, None))]
        for part in parts:
            part.start()
        for part in parts:
            part.join()
        return out

    assert ax.judge(ax.kernel(threaded, name="one"), **ONE).bytes == ax.judge(ax.kernel(nearest_point_test, name="one"), **ONE).bytes


def test_a_name_that_another_function_took(tmp_path):
    first = ax.kernel(nearest_point_test, name="taken")
    second = ax.kernel(lambda *q: contact(len(q[0])), name="taken")
    assert ax.judge(second, **ONE).summary()[0]["missed"] == 0
    for use in (lambda: ax.judge(first, **ONE), lambda: ax.diagnose(first)):
        with pytest.raises(ax.Error, match="kernel taken: another function has been given that name since"):
            use()

    def takes(*news):
        ax.kernel(nearest_point_test, name="taken")

    with pytest.raises(ax.Error, match="has been given that name since"):
        ax.judge(second, progress=takes, **ONE)


def test_a_function_that_judges():
    def nested(a, b, c, p, r):
        ax.judge("certified", family="tangent", trials=10, threads=1)
        return contact(len(r))

    assert ax.judge(ax.kernel(nested), family="tangent", trials=300, precision="binary32").summary()[0]["trials"] == 300


def run_script(text, tmp_path, **named):
    script = tmp_path / "script.py"
    script.write_text(textwrap.dedent(text))
    environment = dict(os.environ, PYTHONPATH=os.pathsep.join(sys.path), **PRELOADED)
    return subprocess.Popen([sys.executable, str(script)], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, env=environment, **named)


def test_a_function_that_forks_and_returns_twice(tmp_path):
    process = run_script("""
        import os, numpy as np, axiscert as ax
        def forks(a, b, c, p, r):
            if not forked:
                forked.append(1)
                os.fork()
            return np.ones(len(r), bool)
        forked = []
        print(ax.judge(forks, family="tangent", trials=500, precision="binary32").summary()[0]["trials"])
        """, tmp_path)
    out, err = process.communicate(timeout=60)
    assert out.strip() == "500" and "returned in a process that it forked" in err


@pytest.mark.parametrize("end, code", [("sys.exit(3)", 3), ("sys.exit()", 0), ("raise ValueError('no')", 70)])
def test_a_forked_process_that_ends_by_an_exception(end, code, tmp_path):
    """The function waits for it, and would for ever."""
    process = run_script(f"""
        import os, sys, numpy as np, axiscert as ax
        def forks(a, b, c, p, r):
            if not codes:
                child = os.fork()
                if not child:
                    {end}
                codes.append(os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]))
            return np.ones(len(r), bool)
        codes = []
        ax.judge(forks, family="tangent", trials=500, precision="binary32")
        print(codes)
        """, tmp_path)
    out, err = process.communicate(timeout=60)
    assert out.strip() == f"[{code}]", err


def test_a_second_interrupt_ends_no_other_judge(tmp_path):
    process = run_script("""
        import os, signal, threading, time, numpy as np, axiscert as ax
        def slow(a, b, c, p, r):
            time.sleep(0.01)
            return np.ones(len(r), bool)
        def interrupts(a, b, c, p, r):
            os.kill(os.getpid(), signal.SIGINT)
            time.sleep(0.3)
            return np.ones(len(r), bool)
        records = []
        def other():
            records.append(ax.judge(slow, family="general", trials=100000, precision="binary32", threads=1))
        thread = threading.Thread(target=other)
        thread.start()
        try:
            ax.judge(interrupts, family="general", trials=10**6, precision="binary32", threads=1)
        except KeyboardInterrupt:
            print("ended", thread.is_alive())
        thread.join()
        print(records[0].complete)
        """, tmp_path)
    out, err = process.communicate(timeout=120)
    assert out == "ended True\nTrue\n", out + err


def test_a_function_that_knows_its_kernel_is_let_go():
    import gc
    import weakref

    def made():
        @ax.kernel(name="knows")
        def knows(a, b, c, p, r):
            return contact(len(r) + 0 * len(knows.id))
        ax.judge(knows, **ONE)
        return weakref.ref(knows._function)

    gone = made()
    gc.collect()
    assert gone() is None


def test_the_code_of_a_long_list_is_known_soon():
    numbers = [[i] for i in range(40000)]
    began = time.monotonic()
    ax.kernel(lambda a, b, c, p, r: contact(len(numbers)), name="long").code
    assert time.monotonic() - began < 5


def test_a_forked_process_judges(tmp_path):
    process = run_script("""
        import multiprocessing, axiscert as ax
        def judged(seed):
            return len(ax.judge("published", family="tangent", trials=500, seed=seed, threads=1).bytes)
        judged(1)
        with multiprocessing.get_context("fork").Pool(2) as pool:
            print(pool.map(judged, [1, 1]) == [judged(1)] * 2)
        """, tmp_path)
    out, err = process.communicate(timeout=120)
    assert out.strip() == "True", err


@pytest.mark.parametrize("method", ["fork", "spawn"])
def test_a_kernel_is_judged_in_processes(method, tmp_path):
    """One that was judged before they were made; the records come back."""
    process = run_script(f"""
        import multiprocessing, axiscert as ax
        def centre_only(a, b, c, p, r):
            return ((p - a) ** 2).sum(axis=1) <= r * r
        kernel = ax.kernel(centre_only)
        def judged(seed):
            return ax.judge(kernel, family="tangent", trials=1 << 17, seed=seed, precision="binary32", threads=2)
        if __name__ == "__main__":
            expected = judged(1).bytes
            with multiprocessing.get_context("{method}").Pool(2) as pool:
                print([record.bytes == expected for record in pool.map_async(judged, [1, 1]).get(100)])
        """, tmp_path)
    out, err = process.communicate(timeout=200)
    assert out.strip() == "[True, True]", err


def test_an_interrupt_keeps_what_was_done(tmp_path):
    process = run_script("""
        import axiscert as ax
        try:
            ax.judge("published", family="general", trials=10**11, precision="binary32", progress=lambda units, *more: units and print(units, flush=True))
        except ax.Interrupted as ended:
            print("kept", ended.record.complete, ended.record.summary()[0]["trials"] > 0)
        print("next", ax.judge("published", family="tangent", trials=100).complete)
        """, tmp_path)
    process.stdout.readline()
    process.send_signal(signal.SIGINT)
    out, err = process.communicate(timeout=60)
    assert "kept False True\nnext True\n" in out, out + err


def test_a_second_interrupt_ends_a_slow_function(tmp_path):
    process = run_script("""
        import time, numpy as np, axiscert as ax
        def slow(a, b, c, p, r):
            print("asked", flush=True)
            time.sleep(0.2)
            return np.ones(len(r), bool)
        try:
            ax.judge(slow, family="general", trials=10**6, precision="binary32")
        except KeyboardInterrupt:
            print("ended")
        """, tmp_path)
    process.stdout.readline()
    began = time.monotonic()
    for _ in range(2):
        time.sleep(0.5)
        process.send_signal(signal.SIGINT)
    out, err = process.communicate(timeout=60)
    assert "ended" in out and time.monotonic() - began < 20, out + err


@pytest.mark.parametrize("named, said", [
    (dict(layout="rows"), "layout='rows': there are: groups, columns"),
    (dict(on_error="ignore"), "on_error='ignore'"),
    (dict(touching="maybe"), "touching='maybe'"),
    (dict(name="a b"), "name='a b': give 1 to 100 letters"),
    (dict(name="published"), "that is a built-in kernel"),
    (dict(predicate="sphere"), "sphere-triangle"),
    (dict(predicate="box-box", entry="none"), "quaternion"),
    (dict(precisions=["half"]), "binary32"),
    (dict(precisions=[]), r"precisions=\[\]: give"),
    (dict(measures=1.5), 'measures=1.5: give "all"'),
    (dict(margin=-1), "margin=-1: give a number from 0"),
    (dict(margin=True), "margin=True: give a number from 0"),
    (dict(measures=True), "measures=True: give a whole number"),
    (dict(supervised="no"), "supervised='no': give True or False"),
    (dict(margin=float("nan")), "margin=nan: give a number from 0"),
    (dict(tensors=3), "tensors=3: give a function"),
    (dict(name=3), "name=3: give a text"),
    (dict(formulae="closest-point"), "it has no comparisons"),
    (dict(conforms_to="eigen"), "conforms-to"),
    (dict(predicate="box-box", sides="front"), "no triangle with a front"),
    (dict(margin=0.1, touching="separated"), "--margin 0.1"),
    (dict(measures=99), "the predicate sphere-triangle has"),
])
def test_claims_that_cannot_be(named, said):
    with pytest.raises((ax.Error), match=said):
        ax.kernel(nearest_point_test, **named)
