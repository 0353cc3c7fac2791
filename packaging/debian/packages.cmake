# Three Debian packages, one for each component of the installation: libtactus1, libtactus-dev, tactus.
set(CPACK_GENERATOR DEB)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_COMPONENTS_ALL libtactus1 libtactus-dev tactus)
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
set(CPACK_DEBIAN_LIBTACTUS-DEV_PACKAGE_SUGGESTS "cmake, pkgconf, python3, mono-mcs, tactus")
set(CPACK_DEBIAN_LIBTACTUS-DEV_PACKAGE_CONTROL_EXTRA "${CMAKE_CURRENT_SOURCE_DIR}/debian/prerm")
set(CPACK_DEBIAN_LIBTACTUS-DEV_DESCRIPTION "force models of experts for haptic simulators (development)
libtactus reads a model file and gives its force: one call, without
allocation, in a tenth of a microsecond, on any number of threads.

This package holds headers for C and C++, the static library, the CMake
package, modules for Python and C#, examples, and the documentation.")

set(CPACK_DEBIAN_TACTUS_PACKAGE_NAME tactus)
set(CPACK_DEBIAN_TACTUS_PACKAGE_SECTION science)
set(CPACK_DEBIAN_TACTUS_PACKAGE_SHLIBDEPS ON)
if(TACTUS_WORKBENCH)
  # What Qt loads while it runs: dpkg-shlibdeps does not see it. The fonts carry the symbols and the Chinese screens.
  set(CPACK_DEBIAN_TACTUS_PACKAGE_DEPENDS "qt6-qpa-plugins, fonts-dejavu-core")
  set(CPACK_DEBIAN_TACTUS_PACKAGE_RECOMMENDS "fonts-noto-cjk, qt6-image-formats-plugins")
endif()
set(CPACK_DEBIAN_TACTUS_PACKAGE_SUGGESTS "libtactus-dev")
set(CPACK_DEBIAN_TACTUS_DESCRIPTION "tactile knowledge of experts as a force model for haptic simulators
Tactus takes insertion strokes, judgements of forces and answers to 45
questions, and makes of them a fuzzy force model: one for each expert, and
their average.

This package holds the program tactus, the workbench with a window, and the
rules that let the person at the computer use force-feedback devices.")

# Each package has its license and its changes.
foreach(package IN LISTS CPACK_COMPONENTS_ALL)
  set(folder "${CMAKE_INSTALL_DATADIR}/doc/${package}")
  install(FILES debian/copyright DESTINATION "${folder}" COMPONENT ${package})
  tactus_compressed("${CMAKE_CURRENT_SOURCE_DIR}/debian/changelog" "${folder}" changelog ${package})
endforeach()
install(DIRECTORY "${PROJECT_SOURCE_DIR}/docs/" DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/libtactus-dev" COMPONENT libtactus-dev
        FILES_MATCHING PATTERN "*.md" PATTERN "guide/pictures/*.png" PATTERN "bench/*")
# Python finds the module by its name; elsewhere than in /usr the caller says where it is.
if(CMAKE_INSTALL_PREFIX STREQUAL "/usr")
  install(CODE "file(MAKE_DIRECTORY \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/lib/python3/dist-packages\")
  file(CREATE_LINK ../../../share/tactus/languages/tactus.py
       \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/lib/python3/dist-packages/tactus.py\" SYMBOLIC)" COMPONENT libtactus-dev)
endif()

include(CPack)
