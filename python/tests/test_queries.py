"""Queries as arrays: what generates, selects and reads them, and what is refused."""
import json
import pickle
import threading
import time
import warnings
from fractions import Fraction

import numpy as np
import pytest

import axiscert as ax


@pytest.mark.parametrize("family", sorted({one["predicate"]: one["name"] for one in ax.families()}.values()))
@pytest.mark.parametrize("precision", ["binary32", "binary64"])
def test_the_queries_are_those_of_the_command(family, precision, command):
    """Of a family of every predicate: the numbers, bit for bit, and the addresses."""
    lines = command("generate", "--family", family, "--trials", 40, "--precision", precision, "--seed", 3).splitlines()
    q = ax.generate(family, 40, seed=3, precision=precision)
    assert [json.loads(line)["id"] for line in lines] == q.addresses
    assert q.lines().splitlines() == lines


def test_a_part_of_a_family_is_where_the_whole_has_it():
    whole, part = ax.generate("sliver", 3000), ax.generate("sliver", 1000, first=1500, threads=3)
    assert np.array_equal(whole.numbers[:, 1500:2500], part.numbers)
    assert whole[1500:2500].addresses == part.addresses


def test_every_predicate_has_its_groups():
    for predicate in ax.predicates():
        for entry in ax.describe(predicate)["entries"]:
            numbers = np.arange(len(entry["columns"]) * 5, dtype=np.float64).reshape(-1, 5)
            q = ax.Queries(predicate, numbers, entry["name"])
            again = ax.Queries.of(predicate, entry["name"], "binary64", {name: q[name] for name in q.groups})
            assert np.array_equal(q.numbers, again.numbers)
            for name, first, size in entry["groups"]:
                assert np.shares_memory(getattr(q, name.replace(".", "_")), q.numbers)


def test_files_come_back(tmp_path):
    q = ax.generate("scene-walk", 20, precision="binary64")
    q.save(tmp_path / "mine.jsonl")
    again = ax.load_queries(tmp_path / "mine.jsonl")
    assert np.array_equal(q.numbers, again.numbers) and again.ids == q.addresses
    both = (tmp_path / "mine.jsonl").read_text() + ax.generate("box-box/general", 3).lines()
    (tmp_path / "both.jsonl").write_text(both)
    assert [len(part) for part in ax.load_all_queries(tmp_path / "both.jsonl")] == [20, 3]
    with pytest.raises(ax.Error, match="it has 20 queries of sphere-triangle.*3 queries of box-box"):
        ax.load_queries(tmp_path / "both.jsonl")


def test_an_address_makes_its_query_again():
    q = ax.generate("tangent", 50, seed=9)
    assert np.array_equal(ax.query_at(q.addresses[10:20]).numbers, q[10:20].numbers)
    with pytest.raises(ax.Error, match="from version 99"):
        ax.query_at("1:tangent:99:binary32:0:7")


@pytest.mark.parametrize("given, said", [
    (dict(a=[[0, 0]]), "'a' has shape"),
    (dict(z=[1]), "there is no column or group 'z'.*there are: a, b, c, p, r"),
    (dict(a=[[0, 0, 0]]), "no numbers are given for bx, by"),
    (dict(a=[[0, 0, 0]], ax=[1]), "the column ax is given twice"),
    (dict(a=[[0, 0, 0]], r=[1, 2]), "'r' is of 2 queries, and others are of 1"),
])
def test_arrays_that_are_no_queries(given, said):
    with pytest.raises(ax.Error, match=said):
        ax.Queries.of("sphere-triangle", **given)


@pytest.mark.parametrize("numbers, said", [
    (np.zeros((13, 2), np.int32), "int32; give float32"),
    (np.zeros((13, 2), np.float16), "float16; give float32"),
    (np.zeros((2, 13), np.float32), r"shape \(13, n\)"),
    (np.zeros(13, np.float32), r"have shape \(13,\)"),
])
def test_numbers_of_another_shape_or_type(numbers, said):
    with pytest.raises(ax.Error, match=said):
        ax.Queries("sphere-triangle", numbers)


@pytest.mark.parametrize("given", [[["x", "0", "0"]], np.zeros((1, 3), complex), [[0, 0], [0]], [[None, object(), 0]], [[None, 0, 0]], [[10**400, 0, 0]]])
def test_what_is_no_number_is_named(given):
    with pytest.raises(ax.Error, match="'a' is of .* no numbers of one shape; give float32"):
        ax.Queries.of(a=given, b=[[1, 0, 0]], c=[[0, 1, 0]], p=[[0, 0, 1]], r=[1])


ONE = dict(b=[[1, 0, 0]], c=[[0, 1, 0]], p=[[0, 0, 1]], r=[1])
THIRD = np.full((1, 3), 1 / 3)


def test_numbers_that_would_be_rounded_are_refused():
    of = lambda a, **named: ax.Queries.of(a=a, **ONE, **named)
    for a in (THIRD, THIRD.astype(">f8"), [THIRD[0]], [list(THIRD[0])], memoryview(THIRD)):
        assert of(a).precision == "binary64" and of(a).a[0, 0] == 1 / 3
        with pytest.raises(ax.Error, match="'a' is of float64, which float32 would round; give float32, or precision=\"binary64\""):
            of(a, precision="binary32")
    for precision in ("binary32", "binary64"):
        with pytest.raises(ax.Error, match="'a' is of float128, which .* would round"):
            of(THIRD.astype(np.longdouble), precision=precision)
        with pytest.raises(ax.Error, match="'a' is of object with 1/3, which is no number of"):
            of([[Fraction(1, 3), 0, 0]], precision=precision)
    with pytest.raises(ax.Error, match="'a' is of int64 with 16777217, which is no number of float32"):
        of([[2**24 + 1, 0, 0]])
    for a in ([[2**24, 0.0, 0]], THIRD.astype(np.float16), THIRD.astype(">f4"), [[Fraction(1, 4), 0, 0]], [[0.1, 0, 0]], np.float32([[0.1, 0, 0]])):
        assert of(a).precision == "binary32"
    assert ax.Queries.of(a=[0, 0, 0], b=[1, 0, 0], c=[0, 1, 0], p=[0, 0, 1], r=np.float32(1)).r[0] == 1


def test_tensors_are_not_rounded():
    torch = pytest.importorskip("torch")
    assert ax.Queries.of(a=torch.tensor(THIRD), **ONE).precision == "binary64"


def test_nothing_is_written():
    given = np.zeros((13, 2), np.float32)
    q, generated = ax.Queries("sphere-triangle", given), ax.generate("tangent", 3)
    for each in (q, generated, generated[1:], ax.query_at(generated.addresses), ax.Queries.of(a=THIRD, **ONE), pickle.loads(pickle.dumps(generated))):
        for array in (each.numbers, each.a, each["ax"]):
            with pytest.raises(ValueError, match="read-only"):
                array[0] = 1
    given[:] = 1
    assert not q.numbers.any()
    for array in (ax.truth(generated).verdict, ax.truth(generated).touching, ax.truth(generated).depth):
        with pytest.raises(ValueError, match="read-only"):
            array[0] = 1


def test_arrays_in_any_order_of_memory_are_the_same_queries():
    q = ax.generate("general", 100)
    expected = ax.truth(q).verdict
    rows = np.ascontiguousarray(q.numbers.T)  # (n, columns)
    swapped = q.numbers.astype(q.numbers.dtype.newbyteorder())
    padded = np.zeros((13, 200), np.float32)
    padded[:, ::2] = q.numbers
    shifted = np.frombuffer(b"x" + q.numbers.tobytes(), np.uint8)[1:].view(np.float32).reshape(13, 100)
    for numbers in (rows.T, swapped, padded[:, ::2], shifted, q.numbers[::-1].copy()[::-1]):
        assert np.array_equal(ax.truth(ax.Queries("sphere-triangle", numbers)).verdict, expected)


def test_words_that_are_not_known():
    with pytest.raises(ax.Error, match="did you mean 'tangent'"):
        ax.generate("tangnet", 5)
    with pytest.raises(ax.Error, match="sphere-triangle"):
        ax.families("sphere")
    with pytest.raises(ax.Error, match="binary32"):
        ax.generate("tangent", 5, precision="half")
    with pytest.raises(ax.Error, match="n=-1: give a whole number from 0"):
        ax.generate("tangent", -1)


Q = ax.generate("tangent", 2)


@pytest.mark.parametrize("call, said", [
    (lambda: ax.families(3), "predicate=3: give a text"),
    (lambda: ax.kernels(3), "predicate=3: give a text"),
    (lambda: ax.generate("tangent", 3, precision=np.float32), "give a text"),
    (lambda: ax.Queries.of(numbers=3), "numbers= is of int; give a dictionary"),
    (lambda: ax.truth(Q).signs(3), "kernel=3: give a text"),
    (lambda: ax.certified.verdicts(Q, 3), "question=3: give a text"),
    (lambda: ax.certified.mesh([0, 0, 0, 1], [[0, 0, 0], [1]], [[0, 0, 0]]), "vertices are of list that are no numbers"),
    (lambda: ax.certified.mesh([0, 0, 0, 1], np.zeros((3, 3), complex), [[0, 0, 0]]), "vertices are of complex128"),
    (lambda: ax.formulae("published", Q, format="bfloat16", round_inputs="yes"), "round_inputs='yes': give True or False"),
    (lambda: ax.judge("published", queries=Q.numbers), r"an array of shape \(13, 2\); Queries.of"),
    (lambda: ax.judge("published", progress=3), "progress=3: give True"),
    (lambda: ax.judge("published", exact_only="no"), "exact_only='no': give True or False"),
    (lambda: ax.judge("published", precision=32), "precision=32: give a text"),
    (lambda: ax.diagnose("published", out=3), "out=3: give the path of a folder"),
    (lambda: ax.search(None), "a kernel is a function, or an id as a text, not NoneType"),
    (lambda: ax.compare("here", None), "after='': give the path"),
    (lambda: ax.certify("published", "out", effort=3), "effort=3: give a text"),
    (lambda: ax.shrink(None, "published"), "no query is given to shrink"),
    (lambda: ax.precision("published", bits=8.5), "bits=8.5: give a whole number"),
    (lambda: ax.precision("published", bits=[]), r"bits=\[\]: that is none"),
    (lambda: ax.load_queries(3), "path=3: give a path"),
    (lambda: ax.load_mesh(3, 5), "path=3: give a path"),
    (lambda: ax.load_queries("none", precision=3), "precision=3: give a text"),
    (lambda: ax.corpus(folder=3), "folder=3: give a path"),
    (lambda: ax.corpus(precision=3), "precision=3: give a text"),
    (lambda: ax.query_at(3), "address=3: give a text"),
    (lambda: ax.query_at("1:a:1:binary32:0:7", mesh=3), "mesh=3: give a path"),
    (lambda: Q.save(3), "path=3: give a path"),
    (lambda: ax.nearest_sqrt(None), "None is no fraction"),
    (lambda: ax.compare("here", "there", replay="no"), "replay='no': give True or False"),
    (lambda: ax.ladder("published", speed="no"), "speed='no': give True or False"),
    (lambda: ax.ladder([]), "no kernel is given"),
    (lambda: ax.certify("published", "out", key=3), "key=3: give a path"),
    (lambda: ax.certified.mesh([0, 0, 0, 1], np.zeros((3, 3)), [[0, 1], [2]]), "indices are of list that are no numbers"),
    (lambda: ax.certified.mesh(np.zeros(4), np.zeros((3, 3), np.float32), [[0, 1, 2]]), "the sphere is of float64, which float32 would round; "
     "give float32, or vertices of float64"),
    (lambda: ax.certified.mesh([0, 0, 0, 1], np.zeros((3, 3), np.longdouble), [[0, 1, 2]]), "vertices are of float128, which float64 would round"),
])
def test_an_argument_of_another_kind_is_named(call, said):
    with pytest.raises(ax.Error, match=said):
        call()


def test_no_triangles_of_a_mesh_are_asked():
    assert len(ax.certified.mesh([0, 0, 0, 1], np.zeros((3, 3)), [[0, 1, 2]], []).triangles) == 0


def test_a_field_that_is_not_read_is_told(tmp_path):
    line = Q[0].lines().rstrip()
    (tmp_path / "slip.jsonl").write_text(line[:-1] + ', "Iid": 3}\n')
    with pytest.warns(ax.Notice, match="slip.jsonl:1: field 'Iid' is not read"):
        ax.load_queries(tmp_path / "slip.jsonl")


def test_other_threads_go_on_while_queries_are_read(tmp_path):
    q = ax.generate("general", 60000)
    q.save(tmp_path / "many.jsonl")
    for call in (q.lines, lambda: ax.load_queries(tmp_path / "many.jsonl"), lambda: ax.query_at(q.addresses[:30000])):
        ticks, done = [], threading.Event()

        def tick():
            while not done.is_set():
                ticks.append(time.monotonic())
                time.sleep(0.001)

        thread = threading.Thread(target=tick)
        thread.start()
        began = time.monotonic()
        call()
        took = time.monotonic() - began
        done.set()
        thread.join()
        assert max(np.diff(ticks), default=took) < max(0.7 * took, 0.2)


def test_a_file_of_queries_that_is_none(tmp_path):
    (tmp_path / "bad.jsonl").write_text('{"a": 1}\n')
    with pytest.raises(ax.Error, match="bad.jsonl"):
        ax.load_queries(tmp_path / "bad.jsonl")
    with pytest.raises(ax.Error, match="none.jsonl"):
        ax.load_queries(tmp_path / "none.jsonl")


def test_no_queries_are_queries():
    q = ax.generate("general", 0)
    assert len(q) == 0 and q.addresses == [] and ax.truth(q).verdict.shape == (0,) and ax.truth(q).facts == []


def test_queries_are_pickled():
    for q in (ax.generate("tangent", 5), ax.Queries.of(a=[[0, 0, 0]], b=[[1, 0, 0]], c=[[0, 1, 0]], p=[[0, 0, 2]], r=[1])):
        again = pickle.loads(pickle.dumps(q))
        assert np.array_equal(again.numbers, q.numbers) and again.addresses == q.addresses and again.ids == q.ids


def test_a_table_of_queries():
    frame = ax.generate("tangent", 3).to_pandas()
    assert list(frame.columns)[:2] == ["address", "ax"] and len(frame) == 3
