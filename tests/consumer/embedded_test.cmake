# Projects that take the sources, with add_subdirectory and with FetchContent: the library alone is built, nothing needs
# Qt or SQLite, and the forces are the same.
include("${CMAKE_CURRENT_LIST_DIR}/common.cmake")

# configured(HOST OPTIONS...): the host's project in HOST/, configured in WORK/HOST, knows the library and not the program.
function(configured host)
  run(ignored ${CMAKE_COMMAND} -S "${CMAKE_CURRENT_LIST_DIR}/${host}" -B "${WORK}/${host}" -G "${GENERATOR}"
      "-DCMAKE_C_COMPILER=${C_COMPILER}" "-DCMAKE_CXX_COMPILER=${CXX_COMPILER}"
      -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS=-g0  # compiles fast, and must give the same bits
      -DCMAKE_DISABLE_FIND_PACKAGE_Qt6=ON -DCMAKE_DISABLE_FIND_PACKAGE_SQLiteCpp=ON -DCMAKE_DISABLE_FIND_PACKAGE_CLI11=ON ${ARGN})
  run(targets ${CMAKE_COMMAND} --build "${WORK}/${host}" --target help)
  if(targets MATCHES "tactus_cli" OR NOT targets MATCHES "tactus_runtime_shared")
    message(FATAL_ERROR "${host}: targets: ${targets}")
  endif()
endfunction()

# built(HOST): the host builds, and writes the table of forces.
function(built host)
  run(ignored ${CMAKE_COMMAND} --build "${WORK}/${host}" --target host -j 2)
  consumerAgrees(${host} "${WORK}/${host}/host")
endfunction()

configured(embedded "-DTACTUS_SOURCES=${SOURCE}")
built(embedded)

# An archive, as FetchContent downloads it. Then the same host on the sources themselves, whose objects the compiler's
# cache knows from above.
execute_process(COMMAND ${CMAKE_COMMAND} -E tar czf "${WORK}/tactus.tar.gz" CMakeLists.txt cmake core
                WORKING_DIRECTORY "${SOURCE}" COMMAND_ERROR_IS_FATAL ANY)
configured(fetched "-DTACTUS_ARCHIVE=${WORK}/tactus.tar.gz")
configured(fetched "-DTACTUS_ARCHIVE=${WORK}/tactus.tar.gz" "-DFETCHCONTENT_SOURCE_DIR_TACTUS=${SOURCE}")
built(fetched)
