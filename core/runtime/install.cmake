# What `cmake --install` gives a simulator: component libtactus1 (the library), libtactus-dev (everything to build with it).
include(CMakePackageConfigHelpers)

if(TACTUS_SHARED)
  install(TARGETS tactus_runtime_shared EXPORT tactus
          LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT libtactus1 NAMELINK_COMPONENT libtactus-dev
          RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}" COMPONENT libtactus1
          ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT libtactus-dev)
endif()
install(TARGETS tactus_runtime_static EXPORT tactus
        ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT libtactus-dev)
install(DIRECTORY include/ DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}" COMPONENT libtactus-dev)

set(package_folder "${CMAKE_INSTALL_LIBDIR}/cmake/tactus")
install(EXPORT tactus NAMESPACE tactus:: FILE tactusTargets.cmake DESTINATION "${package_folder}" COMPONENT libtactus-dev)
configure_package_config_file(tactusConfig.cmake.in "${CMAKE_CURRENT_BINARY_DIR}/tactusConfig.cmake"
                              INSTALL_DESTINATION "${package_folder}" NO_SET_AND_CHECK_MACRO)
configure_file(tactusConfigVersion.cmake.in "${CMAKE_CURRENT_BINARY_DIR}/tactusConfigVersion.cmake" @ONLY)
install(FILES "${CMAKE_CURRENT_BINARY_DIR}/tactusConfig.cmake" "${CMAKE_CURRENT_BINARY_DIR}/tactusConfigVersion.cmake"
        DESTINATION "${package_folder}" COMPONENT libtactus-dev)

# The folder of the .pc file leads to the others, so the prefix may be moved.
file(RELATIVE_PATH prefix_from_pkgconfig "/${CMAKE_INSTALL_LIBDIR}/pkgconfig" "/")
configure_file(tactus.pc.in "${CMAKE_CURRENT_BINARY_DIR}/tactus.pc" @ONLY)
install(FILES "${CMAKE_CURRENT_BINARY_DIR}/tactus.pc" DESTINATION "${CMAKE_INSTALL_LIBDIR}/pkgconfig"
        COMPONENT libtactus-dev)

install(FILES languages/tactus.py languages/Tactus.cs languages/TactusLink.cs
        DESTINATION "${CMAKE_INSTALL_DATADIR}/tactus/languages"
        COMPONENT libtactus-dev)
# The Unity package: its Tactus.cs and TactusLink.cs are those of the other programs in C#.
set(unity_folder "${CMAKE_INSTALL_DATADIR}/tactus/unity")
configure_file(unity/package.json.in "${CMAKE_CURRENT_BINARY_DIR}/package.json" @ONLY)
install(DIRECTORY unity/ DESTINATION "${unity_folder}" COMPONENT libtactus-dev PATTERN package.json.in EXCLUDE)
install(FILES "${CMAKE_CURRENT_BINARY_DIR}/package.json" DESTINATION "${unity_folder}" COMPONENT libtactus-dev)
install(FILES languages/Tactus.cs languages/TactusLink.cs DESTINATION "${unity_folder}/Runtime" COMPONENT libtactus-dev)
install(DIRECTORY examples/ DESTINATION "${CMAKE_INSTALL_DATADIR}/tactus/examples" COMPONENT libtactus-dev)
install(FILES "${PROJECT_SOURCE_DIR}/core/model_io/model_file.schema.json" DESTINATION "${CMAKE_INSTALL_DATADIR}/tactus"
        RENAME tactus-force-model.schema.json COMPONENT libtactus-dev)
install(DIRECTORY "${PROJECT_SOURCE_DIR}/docs/conformance" DESTINATION "${CMAKE_INSTALL_DATADIR}/tactus"
        COMPONENT libtactus-dev)
