#!/usr/bin/env python3
"""The macros of axiscert/plugin.h take no name of a plug-in's author for one of their own, nor the other way round.

    short_names_test.py COMPILER...

A plug-in's functions, batch functions, variables and types bear every short name in turn, in each standard of C and C++,
by syntax alone. Then each local name of the macros loses its prefix, which has to be noticed.
"""
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

INCLUDE = Path(__file__).resolve().parents[1] / "include"
NAMES = [*"abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"]
NAMES += ("i0 i1 j0 k0 ii jj kk aa bb cc pp rr n1 n2 nx ny nz px py pz vx vy vz ab bc ca x0 x1 y0 y1 z0 z1 in out to at of lhs rhs "
          "ok id run predicate name size count column columns batch answers answer verdict query queries kernel index real "
          "precision entry source summary limits exposes touching measure comparisons bits abi result tmp dot cross side "
          "length radius center triangle sphere plugin line text one_query batch_function kernel_name").split()
ARGUMENTS = "const float axiscert_a[3], const float axiscert_b[3], const float axiscert_c[3], const float axiscert_p[3], float axiscert_r"
UNUSED = "(void)axiscert_a; (void)axiscert_b; (void)axiscert_c; (void)axiscert_p; (void)axiscert_r;"
HEADERS = "#include <axiscert/certified.h>\n#include <axiscert/plugin.h>\n"
PLUGIN = "AXISCERT_PLUGIN(float, \"x\", {0})\n"


def function(name, more=""):
    return f"static int {name}({ARGUMENTS}{more}) {{ {UNUSED} return 0; }}\n"


def bits_function(name):
    return function(name, ", uint64_t* axiscert_bits").replace("return", "*axiscert_bits = 0; return")


def as_functions():
    """Every name is a function of one query, and a plug-in of it; the names of what AXISCERT_PLUGIN exports differ."""
    text = HEADERS + "".join(function(name) for name in NAMES)
    for name in NAMES:
        text += f"#undef axiscert_plugin\n#define axiscert_plugin axiscert_plugin_{name}\n#undef axiscert_i_run\n"
        text += f"#define axiscert_i_run axiscert_run_{name}\n" + "const axiscert_kernel* axiscert_plugin(uint32_t);\n"
        text += PLUGIN.format(name)
    return text


def as_functions_with_comparisons():
    text = HEADERS + "".join(bits_function(name) for name in NAMES)
    for name in NAMES:
        text += f"AXISCERT_BATCH_WITH_COMPARISONS(axiscert_run_{name}, float, {name})\n"
    return text + "".join(f"(void)axiscert_run_{name};" for name in NAMES).join(["void axiscert_use(void);\nvoid axiscert_use(void) {", "}\n"])


def as_batch_functions():
    text = HEADERS + function("axiscert_test") + "".join(f"AXISCERT_BATCH({name}, float, axiscert_test)\n" for name in NAMES)
    return text + "void axiscert_use(void);\nvoid axiscert_use(void) {" + "".join(f"(void){name};" for name in NAMES) + "}\n"


def as_variables():
    return HEADERS + "".join(f"int {name} = 0;\n" for name in NAMES) + function("axiscert_test") + PLUGIN.format("axiscert_test")


def as_types():
    return HEADERS + "".join(f"typedef struct {{ int axiscert_x; }} {name};\n" for name in NAMES) + function("axiscert_test") + \
        PLUGIN.format("axiscert_test")


def as_motions():
    """Every name is a function that gives all that there is of a motion's contact."""
    numbers = ", ".join(["const float*"] * 5 + ["float"] + ["float*"] * 4)
    text = HEADERS + "".join(f"int {name}({numbers});\nAXISCERT_BATCH_OF(axiscert_run_{name}, float, {name}, MOTION, displacement, all)\n" for name in NAMES)
    return text + "void axiscert_use(void);\nvoid axiscert_use(void) {" + "".join(f"(void)axiscert_run_{name};" for name in NAMES) + "}\n"


def as_macros():
    """The words of the macros are macros of the author's."""
    words = "TRIANGLE MOTION BOX BOX_TRIANGLE vertices displacement endpoints matrix quaternion centre minmax minmax_quaternion none time all".split()
    text = HEADERS + "".join(f"#define {word} 1 +\n" for word in words)
    for number, (line, points, rest) in enumerate((("PLUGIN(float, \"x\", {})", 4, ", float"), ("MOTION_PLUGIN(float, \"x\", {}, endpoints, time)", 5, ", float, float*"),
                                                   ("BOX_PLUGIN(float, \"x\", {}, matrix)", 6, ""), ("BOX_TRIANGLE_PLUGIN(float, \"x\", {}, centre)", 5, ""),
                                                   ("BOX_PLUGIN(float, \"x\", {}, minmax_quaternion)", 5, ""),
                                                   ("PLUGIN_OF(float, \"x\", {}, BOX, quaternion, comparisons, )", 6, ", uint64_t*"))):
        names = "".join(f"#undef {name}\n#define {name} {name}_{number}\n" for name in ("axiscert_plugin", "axiscert_i_run"))
        text += f"{names}const axiscert_kernel* axiscert_plugin(uint32_t);\nint axiscert_{number}({', '.join(['const float*'] * points)}{rest});\n"
        text += f"AXISCERT_{line.format(f'axiscert_{number}')}\n"
    return text


SOURCES = [as_functions, as_functions_with_comparisons, as_batch_functions, as_variables, as_types, as_motions, as_macros]
STANDARDS = {"c": ["c99", "c11"], "c++": ["c++11", "c++17", "c++20"]}


def refusal(compiler, language, standard, text, include=INCLUDE):
    command = [compiler, "-x", language, f"-std={standard}", "-fsyntax-only", "-fno-builtin", "-Wall", "-Wextra", "-Wshadow",
               "-Werror", "-I", include, "-"]
    return subprocess.run(command, input=text, capture_output=True, text=True).stderr


def local_names():
    return sorted(set(re.findall(r"\baxiscert_i_(\w+)", re.sub(r"/\*.*?\*/", "", (INCLUDE / "axiscert/plugin.h").read_text(), flags=re.S))))


def main():
    compilers = [compiler for compiler in sys.argv[1:] if shutil.which(compiler)]
    absent = set(sys.argv[1:]) - set(compilers)
    if absent:
        print("NOT CHECKED, absent:", *sorted(absent))
    assert compilers, "no compiler to check with"
    for compiler in compilers:
        for language, standards in STANDARDS.items():
            for standard in standards:
                for source in SOURCES:
                    said = refusal(compiler, language, standard, source())
                    assert not said, f"{compiler} -std={standard}, short names {source.__name__}:\n{said[:2000]}"
    planted = [name for name in local_names() if name != "run"]  # a function, which AXISCERT_BATCH names
    assert len(planted) >= 8, planted
    with tempfile.TemporaryDirectory() as folder:
        header = Path(folder) / "axiscert/plugin.h"
        header.parent.mkdir()
        shutil.copy(INCLUDE / "axiscert/certified.h", header.parent)
        whole = (INCLUDE / "axiscert/plugin.h").read_text()
        for name in planted:
            header.write_text(re.sub(rf"\baxiscert_i_{name}\b", name, whole))
            noticed = any(refusal(compilers[0], "c", "c11", source(), folder) for source in SOURCES)
            assert noticed, f"a macro's own name '{name}' without its prefix goes unnoticed"
    print(f"{len(NAMES)} names, {len(compilers)} compilers, {len(planted)} planted captures")


if __name__ == "__main__":
    main()
