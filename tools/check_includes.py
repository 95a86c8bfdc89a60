#!/usr/bin/env python3
"""Refuses an #include that the layers do not allow.

Reads the trocar_module lines of engine/CMakeLists.txt, so there is one list. A module may include itself and the
modules on its line; the rules for ui and app, and the one owner of each library, are the tables below.

    tools/check_includes.py [ROOT]        exit 0: clean, 1: forbidden includes, one a line
    tools/check_includes.py --self-test   proves that forbidden includes are refused
"""
import pathlib
import re
import sys
import tempfile

UI_MAY_SEE = {"core", "spatial", "peg_board", "statistics", "plot", "media", "scene", "demonstration", "control", "learning", "review",
              "figure", "trial", "study", "exchange", "workbench"}
# One table of GL functions and one off-screen context serve the pictures and the window; a film is asked for in words and numbers.
UI_MAY_INCLUDE = {"engine/render/gl_functions.h", "engine/render/osmesa_context.h", "engine/film/composition_words.h", "engine/film/pace.h", "engine/film/property.h"}

# Pattern of an include in <…> or "…": who alone may write it. "app", "ui" and "tests" are owners like any module.
OWNERS = [
    (r"ode/", {"simulation"}),
    (r"assimp/", {"scene"}),
    (r"(GL/|KHR/|EGL/)", {"render", "ui"}),
    (r"(opencv2/|libav|libswscale/|gif_lib\.h)", {"media"}),
    (r"sqlite3\.h", {"store"}),
    (r"(H5|hdf5|highfive/)", {"exchange"}),
    (r"(cairo|fontconfig/)", {"canvas"}),
    (r"(imgui|imgui_internal|misc/freetype/imgui)", {"ui"}),
    (r"(GLFW/|stb)", {"ui", "app"}),
    (r"(ft2build|freetype/)", {"ui", "canvas"}),
    (r"CLI/", {"app"}),
    (r"boost/math/", {"statistics"}),
    (r"(asio|rclcpp/)", {"link"}),
    (r"(google/protobuf/|link/hand\.pb\.h)", {"link"}),
    (r"spnav", {"device"}),
    (r"(doctest|rapidcheck|benchmark/)", {"tests"}),
]
# Headers of our own may not show these: whoever includes the header would depend on them too.
SOURCES_ONLY = r"nlohmann/"

INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^">]+)[">]')


def read_modules(root):
    """Module name to the set of modules it may include."""
    text = (root / "engine/CMakeLists.txt").read_text()
    modules = {}
    for body in re.findall(r"^trocar_module\(([^)]*(?:\$\{[^}]*\}[^)]*)*)\)", text, re.MULTILINE):
        words = body.split()
        allowed, keyword = {words[0]}, ""
        for word in words[1:]:
            if word in ("DEPS", "USES", "PUBLIC_USES"):
                keyword = word
            elif keyword == "DEPS":
                allowed.add(word)
        modules[words[0]] = allowed
    return modules


def owner_of(path):
    return path.parts[1] if path.parts[0] == "engine" else path.parts[0]


def layer_fault(owner, included, modules):
    """What is wrong with `owner` including our own header `included`, or None."""
    parts = included.split("/")
    if parts[0] == "app":
        return None if owner in ("app", "tests") else "nobody includes app"
    if parts[0] == "ui":
        return None if owner in ("ui", "app", "tests") else "the engine does not know the window"
    if parts[0] != "engine":
        return None
    target = parts[1]
    if target not in modules:
        return f"there is no module {target}"
    if owner == "ui" and target not in UI_MAY_SEE and included not in UI_MAY_INCLUDE:
        return f"ui may not see {target}"
    if owner in modules and target not in modules[owner]:
        return f"{owner} may not include {target} (engine/CMakeLists.txt)"
    return None


def faults_of(path, text, modules):
    owner = owner_of(path)
    for number, line in enumerate(text.splitlines(), 1):
        match = INCLUDE.match(line)
        if not match:
            continue
        included = match.group(1)
        fault = layer_fault(owner, included, modules)
        if fault is None and included.startswith("."):
            fault = "includes are rooted at the repository"
        for pattern, owners in OWNERS:
            if re.match(pattern, included) and owner not in owners:
                fault = f"only {' and '.join(sorted(owners))} may use it"
        if re.match(SOURCES_ONLY, included) and path.suffix == ".h" and owner not in ("app", "tests"):
            fault = "in .cpp files only"
        if fault:
            yield f"{path}:{number}: {included}: {fault}"


def check(root):
    modules = read_modules(root)
    if not modules:
        return ["engine/CMakeLists.txt names no module"]
    faults = []
    for top in ("engine", "ui", "app", "tests"):
        for path in sorted((root / top).rglob("*")):
            if path.suffix not in (".h", ".cpp"):
                continue
            relative = path.relative_to(root)
            if relative.parts[0] == "engine" and len(relative.parts) > 2 and relative.parts[1] not in modules:
                faults.append(f"{relative}:1: engine/CMakeLists.txt has no module {relative.parts[1]}")
                continue
            faults.extend(faults_of(relative, path.read_text(), modules))
    return faults


SELF_TEST_MODULES = "trocar_module(core)\ntrocar_module(learning DEPS core\n USES PkgConfig::x ${CMAKE_DL_LIBS})\n" \
                    "trocar_module(simulation DEPS core USES PkgConfig::ode)\n"
SELF_TEST_CASES = [  # file, its include line, is it a fault?
    ("engine/learning/a.h", '#include "engine/core/b.h"', False),
    ("engine/learning/a.h", '#include "engine/learning/b.h"', False),
    ("engine/learning/a.h", '#include "engine/simulation/b.h"', True),
    ("engine/core/a.cpp", '#include "engine/learning/b.h"', True),
    ("engine/core/a.cpp", '#include "engine/absent/b.h"', True),
    ("engine/absent/a.cpp", "#include <vector>", True),
    ("engine/core/a.cpp", '#include "ui/b.h"', True),
    ("engine/core/a.cpp", '#include "../core/b.h"', True),
    ("engine/simulation/a.cpp", "#include <ode/ode.h>", False),
    ("engine/learning/a.cpp", "  #  include <ode/ode.h>", True),
    ("engine/learning/a.cpp", "#include <opencv2/core.hpp>", True),
    ("engine/film/a.cpp", "#include <libavcodec/avcodec.h>", True),
    ("engine/core/a.cpp", "#include <nlohmann/json.hpp>", False),
    ("engine/core/a.h", "#include <nlohmann/json.hpp>", True),
    ("engine/core/a.cpp", "#include <imgui.h>", True),
    ("ui/a.cpp", "#include <imgui.h>", False),
    ("ui/a.cpp", '#include "engine/learning/b.h"', False),
    ("ui/a.cpp", '#include "engine/simulation/b.h"', True),
    ("app/a.cpp", '#include "ui/b.h"', False),
    ("ui/a.cpp", '#include "app/b.h"', True),
    ("app/a.cpp", "#include <sqlite3.h>", True),
    ("engine/learning/a.cpp", "// #include <sqlite3.h>", False),
]


def self_test():
    for name, line, expected in SELF_TEST_CASES:
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            (root / "engine").mkdir()
            (root / "engine/CMakeLists.txt").write_text(SELF_TEST_MODULES)
            path = root / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text(line + "\n")
            if bool(check(root)) != expected:
                print(f"check_includes --self-test: {name}: {line}: expected {'a fault' if expected else 'none'}")
                return 1
    print(f"check_includes --self-test: {len(SELF_TEST_CASES)} cases")
    return 0


def main():
    if "--self-test" in sys.argv:
        return self_test()
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).resolve().parent.parent)
    faults = check(root)
    print("\n".join(faults) if faults else "check_includes: clean")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
