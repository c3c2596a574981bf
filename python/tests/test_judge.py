"""Kernels judged: the record is the command's, byte for byte."""
import copy
import json
import os
import pickle
import re

import numpy as np
import pytest

import axiscert as ax
from conftest import BIN, nearest_point_test
from test_callables import run_script


def judged_by_command(command, tmp_path, *words, code=0):
    command("run", *words, "--out", tmp_path / "command", "--quiet", code=code)
    return (tmp_path / "command" / "record.json").read_bytes()


ENTRIES = [(predicate, entry["name"]) for predicate in ax.predicates() for entry in ax.describe(predicate)["entries"]]


@pytest.mark.parametrize("predicate, entry", ENTRIES)
def test_the_record_is_that_of_the_command(predicate, entry, command, tmp_path):
    """Two kernels and two families of each entry of each predicate, in both precisions."""
    of = lambda given, name: [one[name] for one in given if one["entry"] == entry]
    kernels, families = of(ax.kernels(predicate), "id")[-2:], of(ax.families(predicate), "name")
    if not families:
        pytest.skip("queries of this entry are given, not made")
    families = [families[0], families[-1]]
    words = [word for kernel in kernels for word in ("--kernel", kernel)] + [word for name in families for word in ("--family", name)]
    expected = judged_by_command(command, tmp_path, *words, "--trials", 100, "--seed", 2**64 - 4, "--require", "exact", "--require", "logic",
                                 code=None)
    asked = dict(family=families, trials=100, seed=2**64 - 4, require=["exact", "logic"])
    assert ax.judge(kernels, **asked).bytes == expected
    assert ax.judge(kernels, threads=3, **asked).bytes == expected


@pytest.mark.parametrize("kernel, options", [
    ("certified", dict(family="general", unit="mm", require="exact")),
    ("published+fma", dict(family="tangent", require="logic", allow_unchecked="logic", precision="binary32")),
    ("published", dict(family="sliver", tolerance=["0.1", "1e-3"], precision="binary64")),
    ("published", dict(preset="game")),
])
def test_options_are_those_of_the_command(kernel, options, command, tmp_path):
    words = []
    for name, value in options.items():
        for one in [value] if isinstance(value, str) else value:
            words += ["--" + name.replace("_", "-"), one]
    expected = judged_by_command(command, tmp_path, "--kernel", kernel, "--trials", 100, *words, code=None)
    assert ax.judge(kernel, trials=100, **options).bytes == expected


def test_levels_meshes_and_files_are_those_of_the_command(command, tmp_path):
    q = ax.generate("tangent", 50)
    q.save(tmp_path / "queries.jsonl")
    mesh = "/usr/share/assimp/models/OBJ/spider.obj"
    expected = judged_by_command(command, tmp_path, "--kernel", "published", "--queries", tmp_path / "queries.jsonl", "--mesh", mesh,
                                 "--trials", 200, "--require", "exact", "--require", "depth=1mm", "--unit", "m", "--precision",
                                 "binary32", code=1)
    options = dict(mesh=mesh, trials=200, require=["exact", "depth=1mm"], unit="m", precision="binary32")
    record = ax.judge("published", queries=tmp_path / "queries.jsonl", **options)
    assert record.bytes == expected and not record.met
    assert [outcome.state for outcome in record.outcomes][0] == "not met"
    assert ax.judge("published", queries=q, **options).bytes == expected  # of arrays, by the same name


def test_a_run_that_is_saved_is_the_folder_of_the_command(command, tmp_path):
    ax.judge("published", family="tangent", trials=300, require="conservative", allow_unchecked=[], out=tmp_path / "python")
    judged_by_command(command, tmp_path, "--kernel", "published", "--family", "tangent", "--trials", 300, "--require", "conservative", code=1)
    names = lambda folder: sorted(os.listdir(tmp_path / folder))
    assert names("python") == names("command")
    for name in ("record.json", "record.csv", "witnesses.jsonl"):
        assert (tmp_path / "python" / name).read_bytes() == (tmp_path / "command" / name).read_bytes(), name


def stopped_after(units):
    def stop(done, *news):
        if done >= units:
            raise KeyboardInterrupt
    return stop


def test_a_run_goes_on(tmp_path):
    kernel = ax.kernel(nearest_point_test, name="mine")
    options = dict(family=["tangent", "general"], trials=1 << 17, precision="binary32", require="conservative")
    whole = ax.judge(kernel, **options)
    calls = kernel.calls
    out = tmp_path / "out"
    with pytest.raises(ax.Interrupted, match=r"judge\(\.\.\., out='.*', resume=True\) does the rest") as ended:
        ax.judge(kernel, progress=stopped_after(1), out=out, threads=1, **options)
    assert not ended.value.record.complete and os.path.exists(out / "journal")
    begun = kernel.calls
    again = ax.judge(kernel, out=out, resume=True, **options)
    assert again.bytes == whole.bytes == (out / "record.json").read_bytes() and kernel.calls - begun < calls
    assert not os.path.exists(out / "journal")
    assert ax.judge(kernel, out=out, resume=True, **options).bytes == whole.bytes  # begins where there is none


def test_an_interrupt_at_the_end_leaves_a_whole_record(tmp_path):
    options = dict(family="tangent", trials=100, precision="binary32")
    with pytest.raises(ax.Interrupted, match="^all was done when it came: the record is whole$") as ended:
        ax.judge("published", progress=stopped_after(1), out=tmp_path / "out", **options)
    assert ended.value.record.complete and ended.value.record.bytes == ax.judge("published", **options).bytes


def test_a_run_that_was_killed_goes_on(tmp_path):
    script = """
        import os, sys, axiscert as ax
        def killed(done, *news):
            if done >= 3:
                os.kill(os.getpid(), 9)
        ax.judge("published", family="tangent", trials=1 << 20, precision="binary32", out="out", progress=killed)
        """
    assert run_script(script, tmp_path, cwd=tmp_path).wait(60) == -9
    options = dict(family="tangent", trials=1 << 20, precision="binary32")
    assert ax.judge("published", out=tmp_path / "out", resume=True, **options).bytes == ax.judge("published", **options).bytes


def test_another_run_does_not_go_on(tmp_path):
    slack = 0.0

    def mine(a, b, c, p, r):
        return nearest_point_test(a, b, c, p, r + a.dtype.type(slack))

    def begun(**named):
        given = dict(dict(family="tangent", trials=1 << 18, precision="binary32", out=tmp_path / "out"), **named)
        return ax.judge(ax.kernel(mine, name="mine"), **given)

    with pytest.raises(ax.Interrupted):
        begun(progress=stopped_after(1), threads=1)
    journal = (tmp_path / "out" / "journal").read_bytes()
    with pytest.raises(ax.Error, match="is not a journal of this plan"):
        begun(resume=True, trials=1 << 17)
    slack = 1e-3
    with pytest.raises(ax.Error, match="is not a journal of this plan.*begin again without --resume"):
        begun(resume=True)
    assert (tmp_path / "out" / "journal").read_bytes() == journal
    slack = 0.0
    assert begun(resume=True).complete
    with pytest.raises(ax.Error, match="give the folder"):
        begun(resume=True, out=None)
    with pytest.raises(ax.Error, match="seconds=3"):
        begun(resume=True, seconds=3, trials=None)


def test_what_the_record_shows(tmp_path):
    record = ax.judge("published", family=["tangent", "sliver"], trials=500, precision="binary32")
    frame = record.to_pandas()
    assert list(frame["family"]) == ["tangent", "sliver"] and frame["trials"].sum() == 1000
    assert "<table>" in record._repr_html_() and "published binary32: 1,000 queries" in repr(record)
    assert record.witnesses and all(len(q) == 1 for q in record.witness_queries())
    assert os.path.getsize(record.report()) > 10000 and record.run["threads"] >= 1
    with pytest.raises(ax.Error, match="no level was required"):
        record.met


def test_what_decided_nothing_is_not_said_to_be_right():
    kernel = ax.kernel(lambda *q: np.full(len(q[0]), 2, np.uint8), name="declines", may_decline=True)
    record = ax.judge([kernel, "published"], family="tangent", trials=300, precision="binary32")
    nothing, all_of_it = record.summary()
    assert [nothing[key] for key in ("decided", "missed", "phantom", "deepest")] == [0, None, None, None]
    assert "declines binary32: 300 queries, nothing was decided\n" in repr(record)
    assert "<td>300</td><td>nothing</td><td>not known</td><td>not known</td><td>-</td>" in record._repr_html_()
    assert all_of_it["decided"] == 300 and all_of_it["deepest"] > 0 and "300 queries, nothing" not in repr(record).split("declines")[0]
    verdicts = [kernel["families"]["tangent"]["verdict"] for kernel in record.json["kernels"]]
    figures = ("false_separation", "false_contact", "deepest", "farthest_false_contact")
    assert [[one[figure] is None for figure in figures] for one in verdicts] == [[True] * 4, [False] * 4]
    some = ax.kernel(lambda a, b, c, p, r: np.where(p[:, 0] > 0, 2, 0).astype(np.uint8), name="some", may_decline=True)
    assert re.search(r"phantom contacts among \d+ that it promises and decided", repr(ax.judge(some, family="tangent", trials=300, precision="binary32")))


def test_the_seconds_of_a_plug_in_are_of_one_call():
    before = ax._core.set_plugin_seconds(1.0)
    for family in ("tangent", "nosuch"):
        try:
            ax.judge("published", family=family, trials=10, plugin_seconds=np.float32(7))
        except ax.Error:
            pass
        assert ax._core.set_plugin_seconds(before) == 1.0
        ax._core.set_plugin_seconds(1.0)
    ax._core.set_plugin_seconds(before)


def test_a_record_is_pickled(tmp_path):
    record = ax.judge(ax.kernel(nearest_point_test, name="mine"), family=["tangent", "sliver"], trials=500, require=["exact", "depth=1mm"], unit="m")
    again = pickle.loads(pickle.dumps(record))
    assert again.bytes == record.bytes and again.run == record.run and repr(again) == repr(record) and again.met == record.met
    record.save(tmp_path / "one")
    copy.deepcopy(again).save(tmp_path / "two")
    for name in os.listdir(tmp_path / "one"):
        assert (tmp_path / "one" / name).read_bytes() == (tmp_path / "two" / name).read_bytes(), name


def test_witnesses_of_a_mesh_have_no_family():
    record = ax.judge("published", mesh="/usr/share/assimp/models/OBJ/spider.obj", family="tangent", trials=300, precision="binary32")
    families = [one["address"].split(":")[1] for one in record.witnesses]
    assert len(set(families)) == 2 and len(record.witness_queries()) == families.count("tangent")


def test_a_function_is_judged_as_a_plug_in_of_the_same_answers(tmp_path, command):
    """The kernel of examples/pipe/published.py, in NumPy: as a program of the command and as a function here."""
    import importlib.util
    root = os.path.dirname(os.path.dirname(os.path.dirname(os.path.realpath(__file__))))
    spec = importlib.util.spec_from_file_location("published", os.path.join(root, "examples/pipe/published.py"))
    published = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(published)

    def function(numbers):
        with np.errstate(all="ignore"):
            comparisons = published.separated(dict(zip(published.COLUMNS, numbers)))[1]
        return sum((holds.astype(np.uint64) << np.uint64(i) for i, holds in enumerate(comparisons)), np.uint64(0))

    kernel = ax.kernel(function, name="published-python", layout="columns", conforms_to="published")
    options = dict(family=["tangent", "far"], trials=700)
    ours = ax.judge(kernel, **options)
    words = ["--kernel", f"program:{root}/examples/pipe/published.json", "--family", "tangent", "--family", "far", "--trials", 700]
    theirs = json.loads(judged_by_command(command, tmp_path, *words))
    for one in ours.json["kernels"]:
        other = next(two for two in theirs["kernels"] if two["precision"] == one["precision"])
        for family, counts in one["families"].items():
            assert counts["verdict"] == other["families"][family]["verdict"]
            assert counts.get("comparisons") == other["families"][family].get("comparisons")
    assert kernel.calls > 0 and 0 < kernel.seconds < 60


@pytest.mark.parametrize("family", sorted({one["predicate"]: one["name"] for one in ax.families()}.values()))
def test_a_function_of_any_predicate(family):
    """The truth itself as a kernel, of each predicate: never wrong, where an answer is given as its groups say."""
    described = next(one for one in ax.families() if one["name"] == family)
    groups = [name for name, _, _ in next(
        entry for entry in ax.describe(described["predicate"])["entries"] if entry["name"] == described["entry"])["groups"]]

    def right(*arrays):
        q = ax.Queries.of(described["predicate"], described["entry"],
                          "binary32" if arrays[0].dtype == np.float32 else "binary64", dict(zip(groups, arrays)))
        return ax.truth(q, threads=1).verdict

    kernel = ax.kernel(right, name="right", predicate=described["predicate"], entry=described["entry"])
    record = ax.judge(kernel, family=family, trials=20, precision="binary32")
    assert [(one["trials"], one["missed"], one["phantom"]) for one in record.summary()] == [(20, 0, 0)]


def test_a_numpy_kernel_is_found_wrong():
    record = ax.judge(nearest_point_test, family="sliver", trials=2000, precision="binary32")
    assert record.summary()[0]["missed"] + record.summary()[0]["phantom"] > 0
    assert record.summary()[0]["kernel"] == "nearest_point_test"


def test_progress_is_told():
    told = []
    ax.judge("published", family="tangent", trials=200000, precision="binary32", progress=lambda *news: told.append(news))
    assert told and all(len(news) == 5 for news in told) and told[-1][2] <= 200000


def test_words_of_the_command():
    with pytest.raises(ax.Error, match="unknown kernel 'publshed'; did you mean 'published'"):
        ax.judge("publshed")
    with pytest.raises(ax.Error, match="unknown requirement 'exactt'; did you mean 'exact'"):
        ax.judge("published", family="tangent", trials=10, require="exactt")
    with pytest.raises(ax.Error, match="of the predicate"):
        ax.judge("published", family="box-box/general", trials=10)
    with pytest.raises(TypeError):
        ax.judge("published", familly="tangent")
    for named, said in ((dict(trials="many"), "trials='many': give a whole number"), (dict(trials=0), "trials=0: .* from 1"),
                        (dict(threads=-1), "threads=-1"), (dict(seconds=float("nan")), "seconds=nan: give a number above 0"),
                        (dict(family=3), "3: give a name"), (dict(trials=True), "trials=True: give a whole"), (dict(seconds=True), "seconds=True"),
                        (dict(family=[]), r"family=\[\]: that is none"), (dict(queries=[]), r"queries=\[\]: that is none"),
                        (dict(mesh=""), "mesh='': that is none"), (dict(queries=ax.generate("tangent", 0)), "<0 queries of .*give one or more"),
                        (dict(resume="no"), "resume='no': give True"), (dict(preset="nope"), "unknown preset 'nope'"), (dict(out=""), "out=''")):
        with pytest.raises(ax.Error, match=said):
            ax.judge("published", **named)
    with pytest.raises(ax.Error, match="no kernel is given"):
        ax.judge([])
    with pytest.raises(ax.Error, match="two kernels have the name"):
        ax.judge([nearest_point_test, nearest_point_test], family="tangent", trials=10)
    with pytest.warns(ax.Notice, match="no kernel of this run takes the 3 queries in binary64"):
        ax.judge(ax.kernel(nearest_point_test, precisions=["binary32"]), queries=[ax.generate("tangent", 3, precision="binary64"),
                                                                                  ax.generate("tangent", 3)])
