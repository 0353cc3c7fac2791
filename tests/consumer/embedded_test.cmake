# A project that takes the sources with add_subdirectory configures; the library alone is there, and nothing needs Qt or SQLite.
include("${CMAKE_CURRENT_LIST_DIR}/common.cmake")
run(ignored ${CMAKE_COMMAND} -S "${SOURCE}/tests/consumer/embedded" -B "${WORK}/build" -G "${GENERATOR}"
    "-DCMAKE_C_COMPILER=${C_COMPILER}" "-DCMAKE_CXX_COMPILER=${CXX_COMPILER}" "-DTACTUS_SOURCES=${SOURCE}"
    -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS=-g0  # compiles fast, and must give the same bits
    -DCMAKE_DISABLE_FIND_PACKAGE_Qt6=ON -DCMAKE_DISABLE_FIND_PACKAGE_SQLiteCpp=ON -DCMAKE_DISABLE_FIND_PACKAGE_CLI11=ON)
run(targets ${CMAKE_COMMAND} --build "${WORK}/build" --target help)
if(targets MATCHES "tactus_cli" OR NOT targets MATCHES "tactus_runtime_shared")
  message(FATAL_ERROR "targets: ${targets}")
endif()
run(ignored ${CMAKE_COMMAND} --build "${WORK}/build" --target host -j 2)
points("${WORK}/points.csv" 200)
run(ignored "${WORK}/build/host" "${MODEL}" "${WORK}/points.csv" "${WORK}/found.csv")
sameAsProgram("${WORK}/points.csv" "${WORK}/found.csv")
