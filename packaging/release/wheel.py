#!/usr/bin/env python3
"""A wheel of libtactus: the module tactus.py, with the shared library beside it.

    wheel.py --library libtactus.so.1 --module tactus.py --license LICENSE --notices copyright --version 0.2.0 --out FOLDER

Prints the name of the wheel. Its tag names the glibc whose symbols the library uses; the C++ runtime must be inside it
(TACTUS_STATIC_RUNTIME), because no tag can promise one. Python's standard library alone is needed.
"""
import argparse
import base64
import hashlib
import os
import re
import struct
import sys

from archives import write_zip

_MACHINES = {62: "x86_64", 183: "aarch64"}
_SUMMARY = "Forces of experts in a haptic simulator: position in, force out, at 1 kHz"


def platform_tag(library):
    """manylinux_2_N_MACHINE of a shared library for Linux, from its head and the versions of the symbols that it needs."""
    if library[:4] != b"\x7fELF":
        raise SystemExit("--library: found no ELF file, wanted a shared library for Linux")
    machine = struct.unpack_from("<H", library, 18)[0]
    if machine not in _MACHINES:
        raise SystemExit(f"--library: found the machine {machine}, wanted one of {_MACHINES}")
    for needed in re.findall(rb"\0(lib(?:stdc\+\+|c\+\+|gcc_s)[^\0]*\.so[^\0]*)\0", library):
        raise SystemExit(f"--library: found that it needs {needed.decode()}, wanted the C++ runtime inside: "
                         "configure with TACTUS_STATIC_RUNTIME=ON")
    minors = [int(minor) for minor in re.findall(rb"\0GLIBC_2\.(\d+)(?:\.\d+)?(?=\0)", library)]
    if not minors:
        raise SystemExit("--library: found no symbol of glibc, wanted a shared library for Linux")
    # Tags begin with glibc 2.5; the oldest one that pip and the index know with a number is 2.17.
    return f"manylinux_2_{max([17] + minors)}_{_MACHINES[machine]}"


def description(text):
    """What the module says of itself."""
    return re.search(r'"""(.*?)"""', text, re.DOTALL).group(1)


def entries_of(library, module, texts, version):
    info = f"tactus-{version}.dist-info"
    tag = f"py3-none-{platform_tag(library)}"
    metadata = "\n".join([
        "Metadata-Version: 2.1", "Name: tactus", f"Version: {version}", f"Summary: {_SUMMARY}", "License: MIT",
        "Requires-Python: >=3.7", "Provides-Extra: numpy", 'Requires-Dist: numpy; extra == "numpy"',
        "Description-Content-Type: text/plain", "", description(module.decode())])
    wheel = f"Wheel-Version: 1.0\nGenerator: tactus wheel.py\nRoot-Is-Purelib: false\nTag: {tag}\n"
    files = {
        "tactus.py": module,
        "tactus.libs/libtactus.so.1": library,
        f"{info}/METADATA": metadata.encode(),
        f"{info}/WHEEL": wheel.encode(),
        f"{info}/top_level.txt": b"tactus\n",
    }
    for name, text in texts.items():
        files[f"{info}/licenses/{name}"] = text
    record = ""
    for name, data in sorted(files.items()):
        digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
        record += f"{name},sha256={digest},{len(data)}\n"
    entries = [(name, data, name.endswith(".so.1")) for name, data in sorted(files.items())]
    return tag, entries + [(f"{info}/RECORD", (record + f"{info}/RECORD,,\n").encode(), False)]


def read(path):
    with open(path, "rb") as file:
        return file.read()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    for name in ("library", "module", "license", "notices", "version", "out"):
        parser.add_argument("--" + name, required=True)
    given = parser.parse_args()
    texts = {"LICENSE": read(given.license), "NOTICES": read(given.notices)}
    tag, entries = entries_of(read(given.library), read(given.module), texts, given.version)
    os.makedirs(given.out, exist_ok=True)
    path = os.path.join(given.out, f"tactus-{given.version}-{tag}.whl")
    write_zip(path, entries)
    print(path)


if __name__ == "__main__":
    sys.exit(main())
