#!/usr/bin/env python3
"""Everything that a release hands out, into one folder, with SHA256SUMS.

    release.py --build BUILD_FOLDER --source SOURCES --version 0.2.0 --out FOLDER [--parts wheel,unity]

BUILD_FOLDER: of the preset `portable`, built. What cannot be made here (the Windows archive without mingw-w64, the workbench
without Qt) is named, and the rest is made. Run by `cmake --workflow --preset release`.
"""
import argparse
import glob
import hashlib
import os
import shutil
import subprocess
import sys

from archives import tar_folder, zip_folder

_PARTS = ("portable", "wheel", "amalgamation", "windows", "unity", "debs")


class Release:
    def __init__(self, given):
        self.given = given
        self.here = os.path.dirname(os.path.abspath(__file__))
        self.stages = os.path.join(given.build, "release-stages")

    def source(self, *names):
        return os.path.join(self.given.source, *names)

    def stage(self, name):
        """An empty folder."""
        folder = os.path.join(self.stages, name)
        shutil.rmtree(folder, ignore_errors=True)
        os.makedirs(folder)
        return folder

    def run(self, *command, folder=None):
        subprocess.run(command, check=True, cwd=folder, stdout=subprocess.DEVNULL)

    def script(self, name, **options):
        arguments = [text for key, value in options.items() for text in ("--" + key, value)]
        self.run(sys.executable, "-B", os.path.join(self.here, name), *arguments)

    def portable(self):
        self.script("portable.py", build=self.given.build, source=self.given.source, version=self.given.version,
                    work=self.stage("portable"), out=self.given.out)

    def make_wheel(self, library):
        self.script("wheel.py", library=library, version=self.given.version, out=self.given.out, license=self.source("LICENSE"),
                    module=self.source("core", "runtime", "languages", "tactus.py"), notices=self.source("packaging", "debian", "copyright"))

    def linux_library(self):
        return self.installed(self.given.build, "libtactus1", os.path.join("lib", "libtactus.so.1"))

    def installed(self, build, component, name):
        """A file of a component, stripped."""
        folder = self.stage(component)
        self.run("cmake", "--install", build, "--prefix", folder, "--component", component, "--strip")
        return os.path.join(folder, name)

    def wheel(self):
        self.make_wheel(self.linux_library())

    def amalgamation(self):
        folder = self.stage("amalgamation")
        self.script("amalgamate.py", root=self.given.source, list=os.path.join(self.given.build, "libtactus_sources.txt"),
                    notices=self.source("packaging", "debian", "copyright"), version=self.given.version, out=folder)
        shutil.copyfile(self.source("LICENSE"), os.path.join(folder, "LICENSE"))
        zip_folder(os.path.join(self.given.out, f"tactus-{self.given.version}-amalgamation.zip"), folder, "dist")

    def windows_build(self):
        """The folder of the preset mingw, built; None without a compiler."""
        if not (shutil.which("x86_64-w64-mingw32-g++-posix") or shutil.which("x86_64-w64-mingw32-g++")):
            return None
        self.run("cmake", "--preset", "mingw", folder=self.given.source)
        self.run("cmake", "--build", "--preset", "mingw", folder=self.given.source)
        return self.source("build", "mingw")

    def windows(self):
        build = self.windows_build()
        if build is None:
            print("left out: tactus-*-windows-x64.zip, because there is no mingw-w64 here (g++-mingw-w64-x86-64-posix)")
            return
        folder = self.stage("windows")
        self.run("cmake", "--install", build, "--prefix", folder)
        dll = os.path.join(folder, "bin", "tactus.dll")
        # Its linker takes libtactus.dll.a; Microsoft's takes this.
        self.run("x86_64-w64-mingw32-dlltool", "--deterministic-libraries", "-d", os.path.join(folder, "lib", "tactus.def"), "-D", "tactus.dll", "-l",
                 os.path.join(folder, "lib", "tactus.lib"))
        for text in ("LICENSE", "THIRD-PARTY.md"):
            shutil.copyfile(self.source(text), os.path.join(folder, text))
        zip_folder(os.path.join(self.given.out, f"tactus-{self.given.version}-windows-x64.zip"), folder, f"tactus-{self.given.version}-windows-x64")
        self.make_wheel(dll)

    def unity(self):
        unity = self.installed(self.given.build, "libtactus-dev", os.path.join("share", "tactus", "unity"))
        plugins = os.path.join(unity, "Runtime", "Plugins", "x86_64")
        shutil.copyfile(self.linux_library(), os.path.join(plugins, "libtactus.so"))
        dll = os.path.join(self.stages, "windows", "bin", "tactus.dll")
        if os.path.exists(dll):
            shutil.copyfile(dll, os.path.join(plugins, "tactus.dll"))
        else:  # a .meta of no file is an error in Unity
            os.remove(os.path.join(plugins, "tactus.dll.meta"))
            print("left out: tactus.dll of the Unity package, because it was not made")
        tar_folder(os.path.join(self.given.out, f"org.tactus.force-model-{self.given.version}.tgz"), unity, "package")

    def debs(self):
        if not shutil.which("dpkg-shlibdeps"):
            print("left out: the Debian packages, because there is no dpkg-dev here (dpkg-shlibdeps)")
            return
        configure = ["cmake", "--preset", "packages"]
        if subprocess.run(configure, cwd=self.given.source, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL).returncode != 0:
            print("left out: the package tactus-workbench, because Qt 6 or QCustomPlot is not here")
            self.run(*configure, "-DTACTUS_WORKBENCH=OFF", folder=self.given.source)
        self.run("cmake", "--build", "--preset", "packages", folder=self.given.source)
        folder = self.stage("debs")
        self.run("cpack", "-G", "DEB", "-B", folder, folder=self.source("build", "packages"))
        for package in glob.glob(os.path.join(folder, "*.deb")):
            shutil.copy(package, self.given.out)

    def sums(self):
        lines = []
        for name in sorted(os.listdir(self.given.out)):
            with open(os.path.join(self.given.out, name), "rb") as file:
                lines.append(f"{hashlib.sha256(file.read()).hexdigest()}  {name}\n")
        with open(os.path.join(self.given.out, "SHA256SUMS"), "w", encoding="utf-8") as file:
            file.writelines(lines)
        print("".join(lines), end="")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    for name in ("build", "source", "version", "out"):
        parser.add_argument("--" + name, required=True)
    parser.add_argument("--parts", default=",".join(_PARTS), help="of " + ", ".join(_PARTS))
    given = parser.parse_args()
    parts = given.parts.split(",")
    if unknown := set(parts) - set(_PARTS):
        raise SystemExit(f"--parts: found {', '.join(sorted(unknown))}, wanted of {', '.join(_PARTS)}")
    if "SOURCE_DATE_EPOCH" not in os.environ:
        # The time of the commit: the same files on each day.
        said = subprocess.run(["git", "-C", given.source, "log", "-1", "--format=%ct"], capture_output=True, text=True)
        if said.returncode == 0:
            os.environ["SOURCE_DATE_EPOCH"] = said.stdout.strip()
    shutil.rmtree(given.out, ignore_errors=True)
    os.makedirs(given.out)
    release = Release(given)
    for part in _PARTS:
        if part in parts:
            getattr(release, part)()
    release.sums()


if __name__ == "__main__":
    sys.exit(main())
