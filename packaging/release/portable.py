#!/usr/bin/env python3
"""An archive of program, library, headers and documents that works where it is unpacked, on any Linux with the same glibc.

    portable.py --build BUILD_FOLDER --source SOURCES --version 0.2.0 --work FOLDER --out FOLDER

BUILD_FOLDER: of the preset `portable`. FOLDER of --work is emptied. Prints the name of the archive. Libraries that the program
needs beyond glibc go along, with their licenses.
"""
import argparse
import os
import re
import shutil
import subprocess
import sys

from archives import files_below, tar_folder
from wheel import glibc_minor, machine

_COMPONENTS = ("libtactus1", "libtactus-dev", "tactus", "tactus-doc")
_OF_GLIBC = re.compile(r"^(ld-linux.*|lib(c|m|dl|rt|pthread|resolv|util))\.so\.")
_README = """\
Tactus {version} for Linux ({machine}), with glibc 2.{glibc} or later. Unpack it anywhere, and move it as you like.

    bin/tactus --version
    cc share/tactus/examples/force.c $(PKG_CONFIG_PATH=lib/pkgconfig pkg-config --cflags --libs tactus) -Wl,-rpath,$PWD/lib -o force
    cmake -S share/tactus/examples -B build -DCMAKE_PREFIX_PATH=$PWD     # find_package(tactus 1)
    PYTHONPATH=share/tactus/languages python3 share/tactus/examples/force.py MODEL 1 45 30 30

Documents: share/doc, first guide/simulator.md. Licenses: LICENSE, THIRD-PARTY.md, share/doc/third-party. The window of
the workbench is not in here: it comes as a Debian package.
"""


def needed(program):
    """The paths of the shared libraries that `program` loads, without those of glibc."""
    said = subprocess.run(["ldd", program], check=True, capture_output=True, text=True).stdout
    if "not found" in said:
        raise SystemExit(f"{program}: found that a library is missing:\n{said}")
    paths = re.findall(r"=> (/\S+)", said)
    return [path for path in paths if not _OF_GLIBC.match(os.path.basename(path))]


def licenses_of(libraries, folder):
    """The license of the package that each library comes from."""
    for path in libraries:
        names = [path, os.path.realpath(path), "/usr" + path, os.path.realpath(path).replace("/usr/lib/", "/lib/", 1)]
        found = subprocess.run(["dpkg-query", "-S"] + names, capture_output=True, text=True).stdout
        package = re.match(r"([^:,\s]+)", found)
        text = package and f"/usr/share/doc/{package.group(1)}/copyright"
        if not text or not os.path.exists(text):
            raise SystemExit(f"{path}: found no license of its package, wanted one to go along")
        os.makedirs(folder, exist_ok=True)
        shutil.copyfile(text, os.path.join(folder, package.group(1)))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    for name in ("build", "source", "version", "work", "out"):
        parser.add_argument("--" + name, required=True)
    given = parser.parse_args()
    shutil.rmtree(given.work, ignore_errors=True)
    for component in _COMPONENTS:
        subprocess.run(["cmake", "--install", given.build, "--prefix", given.work, "--component", component, "--strip"], check=True,
                       stdout=subprocess.DEVNULL)
    program = os.path.join(given.work, "bin", "tactus")
    libraries = needed(program)
    along = os.path.join(given.work, "lib", "tactus")
    os.makedirs(along, exist_ok=True)
    for path in libraries:
        shutil.copyfile(path, os.path.join(along, os.path.basename(path)))
    licenses_of(libraries, os.path.join(given.work, "share", "doc", "third-party"))
    for text in ("LICENSE", "THIRD-PARTY.md"):
        shutil.copyfile(os.path.join(given.source, text), os.path.join(given.work, text))

    binaries = []
    for path, _ in files_below(given.work):
        with open(path, "rb") as file:
            data = file.read()
        if data[:4] == b"\x7fELF" and not path.endswith((".o", ".a")):
            binaries.append(data)
    glibc = max(glibc_minor(data) for data in binaries)
    kind = machine(binaries[0])
    with open(os.path.join(given.work, "README.txt"), "w", encoding="utf-8") as file:
        file.write(_README.format(version=given.version, machine=kind, glibc=glibc))
    os.makedirs(given.out, exist_ok=True)
    top = f"tactus-{given.version}-linux-{kind}"
    path = os.path.join(given.out, top + ".tar.gz")
    tar_folder(path, given.work, top)
    print(path)


if __name__ == "__main__":
    sys.exit(main())
