"""Functions in processes of their own, which find them by their names in their files."""
import importlib
import sys
import textwrap

import numpy as np
import pytest

import axiscert as ax
from conftest import PRELOADED
from test_callables import run_script

# The process of a supervised function has no sanitizer, which the binding of ./dev python --sanitized takes.
needs_the_binding = pytest.mark.skipif(bool(PRELOADED), reason="the binding is sanitized")


def test_a_supervised_function(tmp_path):
    (tmp_path / "mine.py").write_text(textwrap.dedent("""
        import os, time
        import numpy as np
        def right(a, b, c, p, r):
            print("this is no reply")
            return np.linalg.norm(p - a, axis=1) <= r
        def crashes(a, b, c, p, r):
            if (r > 1).any():
                os.kill(os.getpid(), 11)
            return np.ones(len(r), bool)
        def hangs(a, b, c, p, r):
            while (r > 1).any():
                pass
            return np.ones(len(r), bool)
        def raises(a, b, c, p, r):
            raise ValueError("no such thing")
        """))
    sys.path.insert(0, str(tmp_path))
    try:
        import mine
    finally:
        sys.path.pop(0)
    options = dict(family="general", trials=300, precision="binary32")
    apart = ax.judge(ax.kernel(mine.right, supervised=True), **options)
    here = ax.judge(ax.kernel(mine.right, name="right"), **options)
    assert apart.summary()[0]["missed"] == here.summary()[0]["missed"] > 0
    kinds = lambda record: {finding["kind"] for finding in record.json["findings"]}
    with pytest.warns(ax.Notice):
        assert kinds(ax.judge(ax.kernel(mine.crashes, supervised=True), **options)) == {"crash"}
        assert kinds(ax.judge(ax.kernel(mine.hangs, supervised=True), plugin_seconds=0.5, **options)) == {"hang"}
        record = ax.judge(ax.kernel(mine.raises, supervised=True), **options)
    assert kinds(record) == {"crash"} and "ValueError: no such thing" in record.json["findings"][0]["detail"]
    with pytest.raises(ax.Error, match="find the function .*lambda.* by its name in a file"):
        ax.kernel(lambda r: r, supervised=True)


@pytest.fixture
def module(tmp_path, monkeypatch):
    """Makes a module of a text."""
    monkeypatch.syspath_prepend(str(tmp_path))

    def made(name, text):
        (tmp_path / f"{name}.py").write_text("import numpy as np\n" + textwrap.dedent(text))
        return importlib.import_module(name)
    return made


FEW = dict(family="general", trials=300, precision="binary32")


@needs_the_binding
def test_a_script_that_judges_when_it_is_loaded(tmp_path):
    """It would begin itself again, in every process of its function."""
    script = """
        import numpy as np, axiscert as ax
        def centre_only(a, b, c, p, r):
            return np.linalg.norm(p - a, axis=1) <= r
        {0}print(ax.judge(ax.kernel(centre_only, supervised=True), family="tangent", trials=300, precision="binary32").summary()[0]["trials"])
        """
    out, err = run_script(script.format(""), tmp_path).communicate(timeout=100)
    assert not out and "judging begins when" in err and 'if __name__ == "__main__":' in err.splitlines()[-1], err
    out, err = run_script(script.format("if __name__ == '__main__': "), tmp_path).communicate(timeout=100)
    assert out.strip() == "300", err


@needs_the_binding
def test_a_decorated_function_is_supervised_and_certified(module, tmp_path):
    text = """
        import axiscert as ax
        @ax.kernel({0})
        def centre_only(a, b, c, p, r):
            return np.linalg.norm(p - a, axis=1) <= r
        """
    apart = ax.judge(module("apart", text.format("supervised=True")).centre_only, **FEW)
    kernel = module("here", text.format("precisions=['binary32']")).centre_only
    here = ax.judge(kernel, **FEW)
    assert apart.summary()[0]["missed"] == here.summary()[0]["missed"] > 0
    assert ax.certify(kernel, tmp_path / "out", effort="smoke")


def test_a_name_that_has_another_function(module):
    found = module("found", """
        class Slack:
            def answer(self, a, b, c, p, r):
                return np.ones(len(r), bool)
            @classmethod
            def of_class(cls, a, b, c, p, r):
                return np.ones(len(r), bool)
        def right(a, b, c, p, r):
            return np.ones(len(r), bool)
        old = right
        def right(a, b, c, p, r):
            return np.zeros(len(r), bool)
        """)
    with pytest.raises(ax.Error, match="it is a method of an object there"):
        ax.kernel(found.Slack().answer, supervised=True)
    with pytest.raises(ax.Error, match="that name has another value there"):
        ax.kernel(found.old, supervised=True)
    with pytest.raises(ax.Error, match="of answer there are none: supervised: .*it is a method of an object"):
        ax.certify(ax.kernel(found.Slack().answer), "out")
    assert ax.judge(ax.kernel(found.Slack.of_class, supervised=True), **FEW).summary()[0]["missed"] == 0
    kernel = ax.kernel(found.right, supervised=True)
    with pytest.raises(ax.Error, match="is a kernel already"):
        ax.kernel(kernel, supervised=True)
    found.right = found.old
    with pytest.raises(ax.Error, match="that name has another value there"):
        ax.judge(kernel, **FEW)


@needs_the_binding
def test_comparison_bits_of_a_supervised_function(module):
    of_bits = module("of_bits", """
        def bits(a, b, c, p, r):
            return (r > 1).astype(np.uint64)
        """).bits
    made = [ax.judge(ax.kernel(of_bits, name="bits", formulae="published", supervised=apart), **FEW) for apart in (False, True)]
    here, apart = (one.json["kernels"][0]["families"]["general"]["verdict"] for one in made)
    assert here == apart and here["false_separation"] + here["false_contact"] > 0


@pytest.mark.parametrize("answer, named, said", [
    ("r", {}, "its verdicts are float32; give bool"),
    ("np.ma.array(r > 0, mask=True)", {}, "its verdicts are a masked array"),
    ("r.astype(np.int64)", dict(formulae="published"), "its comparison bits are int64; give uint32 or uint64"),
    ("r > 0", dict(measures="separation"), "it returns ndarray; with measures="),
    ("{'verdict': r > 0, 'separation': r.astype(complex)}", dict(measures="separation"), "its numbers of separation are complex128; give float32"),
    ("{'verdict': r > 0, 'separation': r.astype(np.float64)}", dict(measures="separation"), "its numbers of separation are float64; give float32"),
])
def test_what_is_no_answer_of_a_supervised_function(answer, named, said, module):
    odd = module("odd", f"def odd(a, b, c, p, r): return {answer}\n")
    importlib.reload(odd)
    with pytest.warns(ax.Notice):
        record = ax.judge(ax.kernel(odd.odd, supervised=True, **named), **FEW)
    assert any(said in finding["detail"] for finding in record.json["findings"]), record
