"""The wheel of the package, as PEP 517 asks for it: CMake builds the extension module, and the process of plug-ins, in build/python,
which are put into an archive with what is written in Python. It needs no package of Python to build. The command, which `certify` alone
takes, is put in by `pip wheel --config-settings=command=yes`."""
import base64
import hashlib
import os
import re
import subprocess
import sys
import sysconfig
import zipfile

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
BUILD = os.path.join(ROOT, "build", "python")
TARGETS = ("axiscert_python", "axiscert_plugin_host")


def version():
    with open(os.path.join(ROOT, "CMakeLists.txt"), encoding="utf-8") as file:
        return re.search(r"project\(axiscert VERSION ([\d.]+)", file.read())[1]


def metadata():
    return (f"Metadata-Version: 2.1\nName: axiscert\nVersion: {version()}\nSummary: Judges collision kernels beside exact arithmetic\n"
            "License: Apache-2.0\nRequires-Python: >=3.9\nRequires-Dist: numpy>=1.22\n"
            "Provides-Extra: tables\nRequires-Dist: pandas; extra == 'tables'\n"
            "Provides-Extra: progress\nRequires-Dist: tqdm; extra == 'progress'\n")


def tag():
    python = f"cp{sys.version_info[0]}{sys.version_info[1]}"
    return f"{python}-{python}-{sysconfig.get_platform().replace('-', '_').replace('.', '_')}"


def get_requires_for_build_wheel(config_settings=None):
    return []


def prepare_metadata_for_build_wheel(metadata_directory, config_settings=None):
    folder = f"axiscert-{version()}.dist-info"
    os.makedirs(os.path.join(metadata_directory, folder), exist_ok=True)
    with open(os.path.join(metadata_directory, folder, "METADATA"), "w", encoding="utf-8") as file:
        file.write(metadata())
    return folder


def files(with_command):
    """(name in the archive, path) of each file."""
    package = os.path.join(ROOT, "python", "axiscert")
    for name in sorted(os.listdir(package)):
        if name.endswith((".py", ".pyi")) or name == "py.typed":
            yield f"axiscert/{name}", os.path.join(package, name)
    built = os.path.join(BUILD, "python", "axiscert")
    for name in sorted(os.listdir(built)):
        if name.startswith("_core.") and name.endswith(".so"):
            yield f"axiscert/{name}", os.path.join(built, name)
    for name in ("axiscert-plugin-host", *(["axiscert"] if with_command else [])):
        for folder in (BUILD, os.path.join(BUILD, "kernel"), os.path.join(BUILD, "cli")):
            if os.path.isfile(os.path.join(folder, name)):
                yield f"axiscert/bin/{name}", os.path.join(folder, name)
                break
        else:
            raise RuntimeError(f"{name} was not built: it is in none of {BUILD}, its kernel/ and its cli/")
    corpus = os.path.join(ROOT, "fuzz", "corpus")
    for name in sorted(os.listdir(corpus)):
        if name.endswith(".jsonl"):
            yield f"axiscert/share/axiscert/corpus/{name}", os.path.join(corpus, name)


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    python = [f"-DAXISCERT_PYTHON_PROGRAM={sys.executable}"]
    subprocess.run(["cmake", "--preset", "python", *python], cwd=ROOT, check=True)
    command = (config_settings or {}).get("command", "no")
    if command not in ("yes", "no"):
        raise ValueError(f"command={command} among the config settings: yes or no")
    with_command = command == "yes"
    subprocess.run(["cmake", "--build", BUILD, "--target", *TARGETS, *(["axiscert"] if with_command else [])], cwd=ROOT, check=True)
    info, record = f"axiscert-{version()}.dist-info", []
    name = f"axiscert-{version()}-{tag()}.whl"
    with zipfile.ZipFile(os.path.join(wheel_directory, name), "w", zipfile.ZIP_DEFLATED) as wheel:
        def put(where, content, mode=0o644):
            entry = zipfile.ZipInfo(where, (2020, 1, 1, 0, 0, 0))
            entry.external_attr, entry.compress_type = (0o100000 | mode) << 16, zipfile.ZIP_DEFLATED
            wheel.writestr(entry, content)
            digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
            record.append(f"{where},sha256={digest},{len(content)}")

        for where, path in files(with_command):
            with open(path, "rb") as file:
                put(where, file.read(), 0o755 if "/bin/" in where else 0o644)
        put(f"{info}/METADATA", metadata().encode())
        put(f"{info}/WHEEL", f"Wheel-Version: 1.0\nGenerator: axiscert\nRoot-Is-Purelib: false\nTag: {tag()}\n".encode())
        for name_of in ("LICENSE", "NOTICE"):
            with open(os.path.join(ROOT, name_of), "rb") as file:
                put(f"{info}/{name_of}", file.read())
        record.append(f"{info}/RECORD,,")
        wheel.writestr(f"{info}/RECORD", "\n".join(record) + "\n")
    return name
