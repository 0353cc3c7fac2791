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


def machine(binary):
    """The kind of processor that an ELF file is for."""
    number = struct.unpack_from("<H", binary, 18)[0] if binary[:4] == b"\x7fELF" else None
    if number not in _MACHINES:
        raise SystemExit(f"found a file for the machine {number}, wanted one for Linux on {' or '.join(_MACHINES.values())}")
    return _MACHINES[number]


def glibc_minor(binary):
    """N of the newest glibc 2.N whose symbols an ELF file uses. 17 is the oldest that a wheel's name can say."""
    return max([17] + [int(minor) for minor in re.findall(rb"\0GLIBC_2\.(\d+)(?:\.\d+)?(?=\0)", binary)])


def platform_tag(library):
    """manylinux_2_N_MACHINE of a shared library for Linux, win_amd64 of a DLL."""
    if library[:2] == b"MZ":
        return "win_amd64"
    kind = machine(library)
    for needed in re.findall(rb"\0(lib(?:stdc\+\+|c\+\+|gcc_s)[^\0]*\.so[^\0]*)\0", library):
        raise SystemExit(f"--library: found that it needs {needed.decode()}, wanted the C++ runtime inside: "
                         "configure with TACTUS_STATIC_RUNTIME=ON")
    return f"manylinux_2_{glibc_minor(library)}_{kind}"


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
        "tactus.libs/" + ("tactus.dll" if tag.endswith("win_amd64") else "libtactus.so.1"): library,
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
    entries = [(name, data, name.startswith("tactus.libs/")) for name, data in sorted(files.items())]
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
