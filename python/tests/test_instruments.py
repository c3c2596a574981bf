"""The instruments: the figures are the command's, and functions are served as other kernels are."""
import json
import os
import signal
import subprocess
import sys
import time

import numpy as np
import pytest

import axiscert as ax
from conftest import BIN, nearest_point_test
from test_callables import run_script


def test_figures_are_those_of_the_command(command, tmp_path):
    words = ["--family", "tangent", "--trials", 40, "--format", "json"]
    assert ax.ladder(["ladder-0", "published"], family="tangent", trials=40, speed=False).bytes.decode() == command(
        "ladder", "ladder-0", "published", "--no-speed", *words)
    assert ax.precision("published", format=["bfloat16", "bits=12,emax=7"], family="tangent", trials=40, rounding="stochastic",
                        fused="dots", round_inputs=True).bytes.decode() == command(
        "precision", "published", "--number", "bfloat16", "--number", "bits=12,emax=7", "--rounding", "stochastic", "--contraction",
        "dots", "--round-inputs", *words)
    assert ax.condition("published", family="tangent", trials=40).bytes.decode() == command("condition", "published", *words)
    assert ax.diagnose("published").bytes.decode() == command("diagnose", "published", "--format", "json")
    assert ax.search("published", evaluations=3000).bytes.decode() == command("search", "published", "--evaluations", 3000, "--format",
                                                                             "json")


def test_figures_of_queries_are_those_of_their_file(tmp_path):
    q = ax.generate("tangent", 40, seed=2)
    q.save(tmp_path / "queries.jsonl")
    for figures in (lambda given: ax.ladder("published", queries=given, trials=40, speed=False), lambda given: ax.precision("published", queries=given, bits=8),
                    lambda given: ax.condition("published", queries=given)):
        of_queries, of_file = figures(q).json, figures(tmp_path / "queries.jsonl").json
        assert of_queries.pop("command", "") != of_file.pop("command", "no") and of_queries == of_file and "queries.jsonl" in json.dumps(of_file)


@pytest.mark.parametrize("call", [ax.ladder, ax.precision, ax.condition])
def test_an_interrupt_ends_figures_of_hours(call):
    def interrupts(done, units, queries, *more):
        if queries:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        call("published", family="general", trials=10**8, progress=interrupts)


def test_a_function_is_diagnosed_and_searched(tmp_path):
    found = ax.diagnose(ax.kernel(nearest_point_test, name="mine"))
    assert found.complete and found.json["kernel"] == "mine" and found.name in ("diagnosis", "diagnose")
    found = ax.search(ax.kernel(nearest_point_test, name="mine"), evaluations=2000)
    assert found.witnesses and sum(map(len, found.witness_queries())) == len(found.witnesses.splitlines())


def test_a_search_goes_on(tmp_path):
    whole = ax.search("published", evaluations=200000, seed=3, out=tmp_path / "whole")
    ax.search("published", evaluations=100000, seed=3, out=tmp_path / "part")
    again = ax.search("published", evaluations=100000, seed=3, out=tmp_path / "part", resume=True)
    assert again.json["finds"] == whole.json["finds"] if "finds" in whole.json else True
    with pytest.raises(ax.Error, match="give the folder of the search"):
        ax.search("published", resume=True)


def test_a_query_is_made_small(command, tmp_path):
    address = next(one["address"] for one in ax.judge("published", family="sliver", trials=2000, precision="binary32").witnesses if one["flips"])
    ours = ax.shrink(address, "published", evaluations=300)[0]
    theirs = json.loads(command("shrink", address, "published", "--evaluations", 300, "--format", "jsonl"))
    assert ours.json == theirs
    kernel = ax.kernel(nearest_point_test, name="mine", precisions=["binary32"])
    worst = next(one["address"] for one in ax.judge(kernel, family="general", trials=2000).witnesses if one["flips"])
    small = ax.shrink(ax.query_at(worst), kernel, evaluations=200)[0].query
    with np.errstate(all="ignore"):
        said = nearest_point_test(small.a, small.b, small.c, small.p, small.r)
    assert said[0] != ax.truth(small).contact[0]
    with pytest.raises(ax.Error, match="is not wrong on it|has no verdict"):
        ax.shrink(ax.generate("general", 1), "certified")


def test_two_runs_are_compared(command, tmp_path):
    before = ax.judge("published", family="tangent", trials=3000, precision="binary32", out=tmp_path / "before")
    after = ax.judge("published", family="tangent", trials=3000, precision="binary32", seed=2, out=tmp_path / "after")
    ours = ax.compare(before, after)
    assert isinstance(ours.passes, bool) and ours.markdown
    folders = ax.compare(tmp_path / "before", tmp_path / "after")
    theirs = subprocess.run([os.path.join(BIN, "axiscert"), "compare", str(tmp_path / "before"), str(tmp_path / "after"), "--format",
                             "json"], capture_output=True, text=True)
    assert folders.bytes.decode() == theirs.stdout and folders.passes == (theirs.returncode == 0)


def test_a_certificate(tmp_path):
    with pytest.raises(ax.Error, match="SHA-256 of the files of a kernel, and of mine there are none: .*by its name in a file"):
        ax.certify(ax.kernel(lambda *q: nearest_point_test(*q), name="mine"), tmp_path / "mine")
    with pytest.raises(ax.Error, match="there are none: .*tensors= is for this process"):
        ax.certify(ax.kernel(nearest_point_test, name="mine", tensors=np.asarray), tmp_path / "mine")
    certificate = ax.certify("published", tmp_path / "out", effort="smoke")
    assert certificate
    with pytest.raises(ax.Error, match="certify: .*--resume continues it"):
        ax.certify("published", tmp_path / "out", effort="smoke")


def test_a_certificate_of_a_function(tmp_path, command):
    """By its file, which has to be there and the same wherever it is verified."""
    source = tmp_path / "centres.py"
    source.write_text("import numpy as np\ndef centre_only(a, b, c, p, r):\n    return np.linalg.norm(a - p, axis=1) <= r\n")
    sys.path.insert(0, str(tmp_path))
    try:
        from centres import centre_only
    finally:
        sys.path.pop(0)
    kernel = ax.kernel(centre_only, precisions=["binary32"])
    certificate = ax.certify(kernel, tmp_path / "out", effort="smoke")
    assert "axiscert" in json.dumps(certificate)
    made = kernel._again().id
    assert made == kernel._again().id
    command("verify", tmp_path / "out" / "certificate.json", "--kernel", made)
    source.write_text(source.read_text() + "# changed\n")
    command("verify", tmp_path / "out" / "certificate.json", "--kernel", made, code=1)


def test_an_interrupt_ends_figures(tmp_path):
    process = run_script("""
        import axiscert as ax
        print("begun", flush=True)
        try:
            ax.search("published", seconds=600, out="found")
        except ax.Interrupted as ended:
            print(ended)
        print(ax.search("published", evaluations=1000, out="found", resume=True).complete)
        """, tmp_path, cwd=tmp_path)
    process.stdout.readline()
    time.sleep(3)
    process.send_signal(signal.SIGINT)
    out, err = process.communicate(timeout=120)
    assert out == "what was found, and the state of the search, are kept\nTrue\n", out + err


def interrupted_after(number):
    calls = []

    def interrupt(*news):
        calls.append(news)
        if len(calls) >= number:
            raise KeyboardInterrupt
    return interrupt


def test_an_interrupt_keeps_what_was_found():
    kernel = ax.kernel(nearest_point_test, name="mine", precisions=["binary32"])
    with pytest.raises(ax.Interrupted) as ended:
        ax.diagnose(kernel, progress=interrupted_after(1))
    assert isinstance(ended.value.found, ax.Report) and not ended.value.found.complete
    with pytest.raises(ax.Interrupted) as ended:
        ax.search("published", seconds=60, progress=interrupted_after(1))
    assert ended.value.found.name == "search" and not ended.value.found.complete
    addresses = [one["address"] for one in ax.judge(kernel, family="general", trials=3000).witnesses if one["flips"]]
    with pytest.raises(ax.Interrupted) as ended:
        ax.shrink(addresses * 20, kernel, evaluations=2000, progress=interrupted_after(1))
    assert 0 < len(ended.value.found) < 20 * len(addresses) and all(len(one.query) == 1 for one in ended.value.found)


def test_a_command_that_is_killed_has_made_no_certificate(tmp_path, monkeypatch):
    ax.certify("published", tmp_path / "out", effort="smoke")
    killed = subprocess.CompletedProcess([], -9, "", "")
    monkeypatch.setattr(subprocess, "run", lambda *given, **named: killed)
    with pytest.raises(ax.Error, match="certify: the command was ended by signal 9"):
        ax.certify("published", tmp_path / "out", effort="smoke", resume=True)


def test_formats(command):
    q = ax.generate("general", 300)
    own = ax.formulae("published", q)
    same = ax.formulae("published", q, format="binary32")
    assert np.array_equal(own.verdict, same.verdict) and np.array_equal(own.bits, same.bits)
    assert np.array_equal(own.lhs, same.lhs) and np.array_equal(own.rhs, same.rhs) and same.lhs.dtype == np.float64
    fused, own_fused = ax.formulae("published", q, format="binary32", fused="dots"), ax.formulae("published+fma", q)
    assert np.array_equal(fused.lhs, own_fused.lhs) and np.array_equal(fused.rhs, own_fused.rhs)
    for rounding in ("down", "stochastic"):
        rough = ax.formulae("published", q, format="bits=6", rounding=rounding)
        assert np.array_equal((rough.lhs > rough.rhs).T, rough.holds)
        significands = np.frexp(rough.lhs)[0] * 64
        assert np.array_equal(significands, np.round(significands))
    assert ax.formulae("closest-point", q, format="bfloat16").lhs is None
    kernel_says = (own.lhs > own.rhs).T
    assert np.array_equal(kernel_says, own.holds)
    rough = ax.formulae("published", q, format="fp8-e4m3", round_inputs=True)
    assert np.isnan(rough.lhs[:, ~rough.valid]).all()
    assert 0 < rough.valid.sum() <= 300 and (rough.verdict != own.verdict).any()
    assert not np.array_equal(ax.formulae("published", q, format="bits=6", rounding="stochastic", seed=1).bits,
                              ax.formulae("published", q, format="bits=6", rounding="stochastic", seed=2).bits)
    for named, said in ((dict(format="half"), "half"), (dict(format="bfloat16", rounding="odd"), "rounding='odd': there are: nearest"),
                        (dict(rounding="up"), "are of a format"), (dict(format="bfloat16", fused="all"), "fused='all'")):
        with pytest.raises(ax.Error, match=said):
            ax.formulae("published", q, **named)
    with pytest.raises(ax.Error, match="it is of sphere-triangle"):
        ax.formulae("published", ax.generate("box-box/general", 3))
    boxes = ax.generate("box-box/general", 30)
    assert ax.formulae(ax.kernels("box-box")[0]["id"], boxes).verdict.shape == (30,)


def test_certified_contacts():
    q = ax.generate("scene-walk", 500)
    t, found = ax.truth(q), ax.certified.contacts(q)
    assert np.array_equal(found.verdict, t.verdict) and np.array_equal(ax.certified.verdicts(q), t.verdict)
    separation = np.array([float(x) for x in np.sqrt(t.squared_distance)]) - q.r
    assert np.allclose(found.separation, separation, atol=1e-5)
    assert np.abs(found.point - t.fact("nearest_point")).max() < 1e-3
    assert (ax.certified.verdicts(q, "conservative") <= t.verdict).all()
    with pytest.raises(ax.Error, match="question='half'"):
        ax.certified.verdicts(q, "half")
    with pytest.raises(ax.Error, match="certified answers sphere-triangle"):
        ax.certified.contacts(ax.generate("box-box/general", 3))


@pytest.mark.parametrize("dtype", [np.float32, np.float64])
def test_certified_meshes(dtype):
    random = np.random.default_rng(3)
    vertices, faces = random.normal(size=(50, 3)).astype(dtype), random.integers(0, 50, (200, 3))
    sphere = np.array([0.1, 0.2, 0, 0.5], dtype)
    found = ax.certified.mesh(sphere, vertices, faces)
    corners = vertices[faces]
    q = ax.Queries.of("sphere-triangle", a=corners[:, 0], b=corners[:, 1], c=corners[:, 2], p=np.tile(sphere[:3], (200, 1)),
                      r=np.full(200, sphere[3]), precision="binary32" if dtype == np.float32 else "binary64")
    assert np.array_equal(found.triangles, np.flatnonzero(ax.truth(q).contact))
    some = ax.certified.mesh(sphere, vertices, faces, found.triangles[::2])
    assert np.array_equal(some.triangles, found.triangles[::2])
    wide = np.zeros((50, 5), dtype)
    wide[:, :3] = vertices
    assert np.array_equal(ax.certified.mesh(sphere, wide[:, :3], faces).triangles, found.triangles)
    for arguments, said in (((sphere, vertices, faces + 1), "an index is 50, and there are 50"), ((sphere, vertices, faces - 1), "an index is -1"),
                            ((sphere[:3], vertices, faces), r"the sphere has shape \(3,\)"), ((sphere, vertices[:, :2], faces), "vertices have shape"),
                            ((sphere, vertices, faces * 0.5), "indices have shape"), ((sphere, vertices, faces, [200]), "a triangle is number 200")):
        with pytest.raises(ax.Error, match=said):
            ax.certified.mesh(*arguments)


def test_a_daemon_thread_ends_with_the_script(tmp_path):
    script = run_script("""
        import threading, time
        import axiscert as ax
        begun = threading.Event()
        work = lambda: ax.judge("published", family="tangent", trials=10**9, progress=lambda *_: begun.set())
        threading.Thread(target=work, daemon=True).start()
        begun.wait()
        print("ends", flush=True)
    """, tmp_path)
    said, told = script.communicate(timeout=60)
    assert script.returncode == 0 and said == "ends\n", told
