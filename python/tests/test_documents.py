"""What the documents and docstrings say runs, and the examples make the pictures of docs/python.md: plots/python-numpy.svg and
plots/python-figure.svg."""
import doctest
import importlib
import os
import re
import subprocess
import sys

import pytest

import axiscert as ax
from conftest import PRELOADED

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.realpath(__file__))))
MODULES = ("_queries", "_truth", "_kernels", "_judge", "_formulae", "_instruments", "certified")


@pytest.mark.parametrize("name", MODULES)
def test_docstrings_run(name):
    module = importlib.import_module(f"axiscert.{name}")
    assert doctest.testmod(module).failed == 0


def test_every_public_name_says_what_it_is():
    for name in ax.__all__:
        thing = getattr(ax, name)
        assert name.isupper() or thing.__doc__, name


def test_the_page_runs(tmp_path, monkeypatch):
    with open(os.path.join(ROOT, "docs/python.md"), encoding="utf-8") as file:
        fences = re.findall(r"^```python\n(.*?)^```$", file.read(), re.M | re.S)
    assert len(fences) >= 3
    monkeypatch.chdir(tmp_path)
    names = {}
    for fence in fences:
        exec(compile(fence, "docs/python.md", "exec"), names)
    assert os.path.exists("out/report.html")


def test_types_are_right():
    mypy = pytest.importorskip("mypy.api")
    out, err, code = mypy.run(["--config-file", os.path.join(ROOT, "pyproject.toml"), os.path.join(ROOT, "python/axiscert")])
    assert code == 0, out + err


def run(*words, cwd):
    environment = dict(os.environ, PYTHONPATH=os.pathsep.join(sys.path), **PRELOADED)
    ended = subprocess.run([sys.executable, *words], cwd=cwd, env=environment, capture_output=True, text=True)
    assert ended.returncode == 0, ended.stderr
    return ended.stdout


@pytest.mark.slow
@pytest.mark.parametrize("script, picture", [("numpy_kernel.py", "python-numpy.svg"), ("figure.py", "python-figure.svg")])
def test_examples_make_the_pictures(script, picture, tmp_path):
    pytest.importorskip("matplotlib")
    run(os.path.join(ROOT, "examples", script), "made.svg", cwd=tmp_path)
    with open(os.path.join(ROOT, "docs/plots", picture), "rb") as committed:
        assert (tmp_path / "made.svg").read_bytes() == committed.read()


@pytest.mark.slow
def test_the_example_of_tensors(tmp_path):
    pytest.importorskip("torch")
    out = run(os.path.join(ROOT, "examples/tensors.py"), "2000", cwd=tmp_path)
    assert "bounding_box binary64: 6,000 queries, 0 missed" in out and "in the kernel itself" in out


@pytest.mark.slow
def test_the_example_of_a_property(tmp_path):
    pytest.importorskip("hypothesis")
    run("-m", "pytest", "-q", "-p", "no:cacheprovider", os.path.join(ROOT, "examples/test_property.py"), cwd=tmp_path)
