#!/usr/bin/env python3
"""libtactus as two files, tactus.h and tactus.cpp, for a project that takes sources and no library.

    amalgamate.py --root SOURCES --list FILE --notices FILE --version 0.2.0 --out FOLDER [--headers FOLDER ...]

FILE names the sources, one a line. Headers of the project, nlohmann-json and tl::expected stand in tactus.cpp once, before
the first file that needs them; what the compiler brings stays an #include. Python's standard library alone is needed.
"""
import argparse
import os
import re
import sys

_INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*(?:"([^"]+)"|<([^>]+)>)', re.MULTILINE)
_INLINED = ("nlohmann/", "tl/")  # of what is included as <...>
# What Windows does without, and has no file of its own for: libtactus writes no files there.
_POSIX_ONLY = ("core/base/clock.cpp", "core/base/files/unfinished.cpp", "core/model_io/write_model.cpp")
_START = """\
// libtactus {version} in one file; made by packaging/release/amalgamate.py, not to be edited. Compile it as C++20:
//     g++ -std=c++20 -O2 -c tactus.cpp
// The same bits everywhere: the compiler must not join a multiplication and an addition.
#if defined(__clang__)
#pragma clang fp contract(off)
#elif defined(__GNUC__)
#pragma GCC optimize("fp-contract=off")
#endif
#ifdef _WIN32
#define TACTUS_STATIC
#endif
#define TACTUS_VERSION "{version}"
#include "tactus.h"
"""


def read(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def local_names(text):
    """The names that the unnamed namespaces of a source declare."""
    names = set()
    for body in re.findall(r"^namespace \{\n(.*?)^\}  // namespace$", text, re.DOTALL | re.MULTILINE):
        body = re.sub(r"//[^\n]*|/\*.*?\*/", "", body, flags=re.DOTALL)
        names.update(re.findall(r"^(?:struct|class|enum class|using) (\w+)(?! *::|;)", body, re.MULTILINE))
        # A declaration begins at the margin; what is inside of it does not.
        names.update(re.findall(r"^(?!template|struct|class|enum|using|return)[A-Za-z_][^\n=({;]*?\b(\w+)(?: ?[=({;\[])", body, re.MULTILINE))
    return names


def renamed(text, names, tail):
    """Two files may give what is local to each the same name: here it gets the file's name too. What stands in a string or a
    comment, and a member of that name, stay."""
    if not names:
        return text
    pattern = re.compile(r'"(?:\\.|[^"\\\n])*"|//[^\n]*|(?<![\w.:])(?<!->)(' + "|".join(sorted(names)) + r")\b")
    return pattern.sub(lambda match: f"{match.group(1)}_of_{tail}" if match.group(1) else match.group(0), text)


class Amalgamation:
    def __init__(self, root, folders):
        self.root, self.folders = root, folders
        self.written = set()
        self.out = []

    def found(self, quoted, bracketed, beside):
        """The file to put in the place of an #include; None where it stays."""
        if quoted:
            for folder in (self.root, beside):
                path = os.path.normpath(os.path.join(folder, quoted))
                if os.path.exists(path):
                    return path
            raise SystemExit(f"{beside}: found an include of {quoted}, wanted a file of the project")
        if bracketed.startswith(_INLINED):
            for folder in self.folders:
                path = os.path.join(folder, bracketed)
                if os.path.exists(path):
                    return path
            raise SystemExit(f"--headers: found no {bracketed}")
        return None

    def with_includes(self, path):
        """The text of a file, with the files in it that it includes."""
        text = read(path)
        once = "#pragma once" in text or path.endswith("expected.hpp")
        if once and path in self.written:
            return ""
        if once:
            self.written.add(path)

        def put(match):
            quoted, bracketed = match.groups()
            if "tactus/tactus.h" in (quoted, bracketed):
                return ""
            file = self.found(quoted, bracketed, os.path.dirname(path))
            return match.group(0) if file is None else self.with_includes(file)

        text = re.sub(r"^[ \t]*#[ \t]*pragma once[^\n]*\n", "", text, flags=re.MULTILINE)
        return re.sub(_INCLUDE.pattern + r"[^\n]*", put, text, flags=re.MULTILINE).rstrip("\n")

    def add(self, source, clashing):
        """One source: first the headers that it brings, then what is its own."""
        path = os.path.join(self.root, source)
        text = read(path)
        end = 0
        for match in _INCLUDE.finditer(text):
            if "\nnamespace " in text[:match.start()] or "\n#if" in text[end:match.start()]:
                break
            end = text.index("\n", match.start()) + 1
        head, body = text[:end], text[end:]
        stays = []
        for match in _INCLUDE.finditer(head):
            quoted, bracketed = match.groups()
            file = None if "tactus/tactus.h" in (quoted, bracketed) else self.found(quoted, bracketed, os.path.dirname(path))
            if file is not None:
                self.out.append(self.with_includes(file))
            elif "tactus/tactus.h" not in (quoted, bracketed):
                stays.append(match.group(0))
        body = re.sub(_INCLUDE.pattern + r"[^\n]*", lambda m: m.group(0) if self.found(*m.groups(), os.path.dirname(path)) is None
                      else self.with_includes(self.found(*m.groups(), os.path.dirname(path))), body, flags=re.MULTILINE)
        twin = os.path.exists(path[:-len(".cpp")] + "_windows.cpp")
        condition = {True: "#ifdef _WIN32", False: "#ifndef _WIN32" if twin or source in _POSIX_ONLY else ""}[source.endswith("_windows.cpp")]
        tail = re.sub(r"\W", "_", source[:-len(".cpp")])
        body = renamed(body.strip("\n"), local_names(text) & clashing, tail)
        self.out.append("\n".join([f"// ---- {source}"] + ([condition] if condition else []) + stays + [body] +
                                  (["#endif"] if condition else [])))
        if twin:
            self.add(source[:-len(".cpp")] + "_windows.cpp", clashing)


def notices(text):
    """Of a Debian copyright file the paragraphs about what is in the library, as a comment."""
    wanted = ("Files: *\n", "Files: nlohmann/", "Files: tl/", "License: Expat\n", "License: CC0-1.0\n")
    paragraphs = [one for one in re.split(r"\n\n", text) if one.startswith(wanted)]
    if len(paragraphs) != len(wanted):
        raise SystemExit(f"--notices: found {len(paragraphs)} of the paragraphs {wanted}")
    return "\n".join(("// " + line).rstrip() for line in "\n\n".join(paragraphs).splitlines())


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    for name in ("root", "list", "notices", "version", "out"):
        parser.add_argument("--" + name, required=True)
    parser.add_argument("--headers", action="append", default=[], help="where nlohmann/ and tl/ are, before /usr/include")
    given = parser.parse_args()
    sources = read(given.list).split()
    every = {}
    for source in sources:
        for name in local_names(read(os.path.join(given.root, source))):
            every.setdefault(name, []).append(source)
    clashing = {name for name, owners in every.items() if len(owners) > 1}
    whole = Amalgamation(given.root, given.headers + ["/usr/local/include", "/usr/include"])
    whole.out.append(_START.format(version=given.version))
    whole.out.append(notices(read(given.notices)))
    for source in sources:
        whole.add(source, clashing)
    os.makedirs(given.out, exist_ok=True)
    with open(os.path.join(given.out, "tactus.cpp"), "w", encoding="utf-8") as file:
        file.write("\n\n".join(part for part in whole.out if part) + "\n")
    with open(os.path.join(given.out, "tactus.h"), "w", encoding="utf-8") as file:
        file.write(read(os.path.join(given.root, "core/runtime/include/tactus/tactus.h")))


if __name__ == "__main__":
    sys.exit(main())
