# An overlay port: it builds the sources that it lies in. `vcpkg install tactus --overlay-ports=packaging/vcpkg`
get_filename_component(SOURCE_PATH "${CMAKE_CURRENT_LIST_DIR}/../../.." ABSOLUTE)
if(VCPKG_LIBRARY_LINKAGE STREQUAL "static")
  set(shared OFF)
else()
  set(shared ON)
endif()
vcpkg_cmake_configure(SOURCE_PATH "${SOURCE_PATH}" OPTIONS -DTACTUS_PROGRAM=OFF -DTACTUS_WORKBENCH=OFF -DTACTUS_TESTS=OFF
                      -DTACTUS_INSTALL=ON -DTACTUS_SHARED=${shared})
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(CONFIG_PATH lib/cmake/tactus)
vcpkg_fixup_pkgconfig()
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug/include" "${CURRENT_PACKAGES_DIR}/debug/share")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE" "${SOURCE_PATH}/packaging/debian/copyright")
