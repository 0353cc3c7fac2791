# What the tests of this folder share.
file(REMOVE_RECURSE "${WORK}")
file(MAKE_DIRECTORY "${WORK}")

# run(OUT COMMAND...): stops the test where the command fails.
function(run out)
  execute_process(COMMAND ${ARGN} OUTPUT_VARIABLE text ERROR_VARIABLE errors RESULT_VARIABLE status)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${ARGN}\nended with ${status}:\n${text}${errors}")
  endif()
  set(${out} "${text}" PARENT_SCOPE)
endfunction()

# build(SOURCE_FOLDER BUILD_FOLDER OPTIONS...)
function(build source folder)
  run(ignored ${CMAKE_COMMAND} -S "${source}" -B "${folder}" -G "${GENERATOR}" "-DCMAKE_C_COMPILER=${C_COMPILER}"
      "-DCMAKE_CXX_COMPILER=${CXX_COMPILER}" -DCMAKE_BUILD_TYPE=Release ${ARGN})
  run(ignored ${CMAKE_COMMAND} --build "${folder}")
endfunction()

# sameAsProgram(FOUND): FOUND holds the table that `tactus eval` wrote for the points, byte by byte (points_test.cmake).
set(POINTS "${WORK}/../consumer_points/points.csv")
function(sameAsProgram found)
  file(SHA256 "${WORK}/../consumer_points/wanted.csv" wanted)
  file(SHA256 "${found}" is)
  if(NOT wanted STREQUAL is)
    message(FATAL_ERROR "${found} and what tactus eval wrote differ")
  endif()
endfunction()

# bundle(FOLDER): a small bundle, to be verified by the library.
function(bundle folder)
  run(ignored "${TACTUS}" bundle "${SOURCE}/docs/conformance/scale.tactus.json" --out "${folder}")
endfunction()

file(GLOB library_folders "${PREFIX}/lib" "${PREFIX}/lib64" "${PREFIX}/lib/*-linux-gnu*")
list(JOIN library_folders ":" library_path)
set(ENV{LD_LIBRARY_PATH} "${library_path}:$ENV{LD_LIBRARY_PATH}")
