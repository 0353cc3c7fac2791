"""A recipe of libtactus for Conan 2, from the sources that it lies in: conan create packaging/conan"""
import os

from conan import ConanFile
from conan.tools.build import check_min_cppstd
from conan.tools.cmake import CMake, CMakeToolchain, cmake_layout
from conan.tools.files import copy


class Tactus(ConanFile):
    name = "tactus"
    version = "0.2.0"
    license = "MIT"
    description = "Forces of experts for haptic simulators: position in, force out, at 1 kHz"
    topics = ("haptics", "fuzzy-logic", "simulation")
    package_type = "library"
    settings = "os", "arch", "compiler", "build_type"
    options = {"shared": [True, False], "fPIC": [True, False]}
    default_options = {"shared": False, "fPIC": True}
    generators = "CMakeDeps"

    def export_sources(self):
        root = os.path.join(self.recipe_folder, "..", "..")
        for name in ("CMakeLists.txt", "LICENSE", "cmake/*", "core/*", "docs/conformance/*", "packaging/debian/copyright"):
            copy(self, name, src=root, dst=self.export_sources_folder)

    def requirements(self):
        # Neither stands in the headers of the library.
        self.requires("nlohmann_json/3.11.3")
        self.requires("tl-expected/1.1.0")

    def layout(self):
        cmake_layout(self)

    def validate(self):
        check_min_cppstd(self, 17)

    def generate(self):
        toolchain = CMakeToolchain(self)
        for name in ("PROGRAM", "WORKBENCH", "TESTS"):
            toolchain.cache_variables["TACTUS_" + name] = False
        toolchain.cache_variables["TACTUS_SHARED"] = bool(self.options.shared)
        toolchain.generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build()

    def package(self):
        CMake(self).install()
        copy(self, "LICENSE", src=self.source_folder, dst=os.path.join(self.package_folder, "licenses"))
        copy(self, "copyright", src=os.path.join(self.source_folder, "packaging", "debian"), dst=os.path.join(self.package_folder, "licenses"))

    def package_info(self):
        self.cpp_info.libs = ["tactus"]
        self.cpp_info.set_property("cmake_target_name", "tactus::tactus")
        self.cpp_info.set_property("pkg_config_name", "tactus")
        if not self.options.shared:
            self.cpp_info.system_libs = ["stdc++", "m"]
