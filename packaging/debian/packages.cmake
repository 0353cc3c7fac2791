# The Debian packages, one for each component of the installation.
set(CPACK_GENERATOR DEB)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL libtactus1 libtactus-dev tactus-doc ${programs})
set(CPACK_PACKAGE_NAME tactus)
set(CPACK_PACKAGE_CONTACT "The Tactus maintainers <maintainers@tactus.invalid>" CACHE STRING "Maintainer field of the packages")
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ
    WORLD_EXECUTE)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)

set(CPACK_DEBIAN_LIBTACTUS1_PACKAGE_NAME libtactus1)
set(CPACK_DEBIAN_LIBTACTUS1_PACKAGE_SECTION libs)
set(CPACK_DEBIAN_LIBTACTUS1_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_LIBTACTUS1_DESCRIPTION "force models of experts for haptic simulators (library)
libtactus reads a model file and gives its force: one call, without
allocation, in a tenth of a microsecond, on any number of threads.

This package holds the shared library.")
# A program that links the library needs this version or a later one of the same interface.
# The linker's cache is renewed by a trigger. CPack would add scripts that do it again; naming scripts that are not there
# keeps it from that.
set(CPACK_DEBIAN_LIBTACTUS1_PACKAGE_CONTROL_EXTRA "${CMAKE_CURRENT_BINARY_DIR}/shlibs;${CMAKE_CURRENT_BINARY_DIR}/triggers"
    "${CMAKE_CURRENT_BINARY_DIR}/none/postinst" "${CMAKE_CURRENT_BINARY_DIR}/none/postrm")
file(CONFIGURE OUTPUT shlibs CONTENT "libtactus 1 libtactus1 (>= ${PROJECT_VERSION})\n")
file(CONFIGURE OUTPUT triggers CONTENT "activate-noawait ldconfig\n")

set(CPACK_DEBIAN_LIBTACTUS-DEV_PACKAGE_NAME libtactus-dev)
set(CPACK_DEBIAN_LIBTACTUS-DEV_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_LIBTACTUS-DEV_PACKAGE_DEPENDS "libtactus1 (= ${PROJECT_VERSION})")
set(CPACK_DEBIAN_LIBTACTUS-DEV_PACKAGE_SUGGESTS "cmake, pkgconf, python3, mono-mcs, tactus, tactus-doc")
set(CPACK_DEBIAN_LIBTACTUS-DEV_PACKAGE_CONTROL_EXTRA "${CMAKE_CURRENT_SOURCE_DIR}/debian/prerm")
set(CPACK_DEBIAN_LIBTACTUS-DEV_DESCRIPTION "force models of experts for haptic simulators (development)
libtactus reads a model file and gives its force: one call, without
allocation, in a tenth of a microsecond, on any number of threads.

This package holds headers for C and C++, the static library, the CMake
package, modules for Python and C#, and examples.")

set(CPACK_DEBIAN_TACTUS_PACKAGE_NAME tactus)
set(CPACK_DEBIAN_TACTUS_PACKAGE_SECTION science)
set(CPACK_DEBIAN_TACTUS_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_TACTUS_PACKAGE_SUGGESTS "libtactus-dev, tactus-doc")
set(purpose "Tactus takes insertion strokes, judgements of forces and answers to 45
questions, and makes of them a fuzzy force model: one for each expert, and
their average.")
set(CPACK_DEBIAN_TACTUS_DESCRIPTION "tactile knowledge of experts as a force model for haptic simulators
${purpose}

This package holds the program tactus, and the rules that let the person at
the computer use force-feedback devices. It needs no display.")

set(CPACK_DEBIAN_TACTUS-WORKBENCH_PACKAGE_NAME tactus-workbench)
set(CPACK_DEBIAN_TACTUS-WORKBENCH_PACKAGE_SECTION science)
set(CPACK_DEBIAN_TACTUS-WORKBENCH_PACKAGE_SHLIBDEPS ON)
# With it come the types of the files and the rules for devices. Then what Qt loads while it runs, which dpkg-shlibdeps does not
# see. The fonts carry the symbols and the Chinese screens.
set(CPACK_DEBIAN_TACTUS-WORKBENCH_PACKAGE_DEPENDS "tactus (= ${PROJECT_VERSION}), qt6-qpa-plugins, fonts-dejavu-core")
set(CPACK_DEBIAN_TACTUS-WORKBENCH_PACKAGE_RECOMMENDS "fonts-noto-cjk, qt6-image-formats-plugins")
set(CPACK_DEBIAN_TACTUS-WORKBENCH_PACKAGE_SUGGESTS "tactus-doc")
set(CPACK_DEBIAN_TACTUS-WORKBENCH_DESCRIPTION "tactile knowledge of experts as a force model (workbench)
${purpose}

This package holds the workbench: a window that shows where each force of a
model comes from, in which it is tuned and felt, and the screens of the
participants of a study.")

set(CPACK_DEBIAN_TACTUS-DOC_PACKAGE_NAME tactus-doc)
set(CPACK_DEBIAN_TACTUS-DOC_PACKAGE_SECTION doc)
set(CPACK_DEBIAN_TACTUS-DOC_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_TACTUS-DOC_DESCRIPTION "tactile knowledge of experts as a force model (documentation)
${purpose}

This package holds the documentation: guides with pictures, the formats of
the files, what was measured, and the models of the conformance test.")

# Each package has its license and its changes.
foreach(package IN LISTS CPACK_COMPONENTS_ALL)
  set(folder "${CMAKE_INSTALL_DATADIR}/doc/${package}")
  install(FILES debian/copyright DESTINATION "${folder}" COMPONENT ${package})
  tactus_compressed("${CMAKE_CURRENT_SOURCE_DIR}/debian/changelog" "${folder}" changelog ${package})
endforeach()
# Python finds the module by its name; elsewhere than in /usr the caller says where it is.
if(CMAKE_INSTALL_PREFIX STREQUAL "/usr")
  install(CODE "file(MAKE_DIRECTORY \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/lib/python3/dist-packages\")
  file(CREATE_LINK ../../../share/tactus/languages/tactus.py
       \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/lib/python3/dist-packages/tactus.py\" SYMBOLIC)" COMPONENT libtactus-dev)
endif()

include(CPack)
