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

# The models that consumers are compared on, and their points (points_test.cmake). In each folder of a consumer NAME.csv is the
# table of `tactus eval`, NAME.all what table.c adds to it.
set(MODELS ngt averaged swallow)
set(POINTS "${WORK}/../consumer_points")

# sameFile(FOUND WANTED WHOSE)
function(sameFile found wanted whose)
  file(SHA256 "${wanted}" wanted_sum)
  file(SHA256 "${found}" found_sum)
  if(NOT wanted_sum STREQUAL found_sum)
    message(FATAL_ERROR "${found} and what ${whose} wrote differ")
  endif()
endfunction()

# sameAsProgram(NAME FOUND): FOUND holds the table that `tactus eval` wrote for the points of the model NAME, byte by byte.
function(sameAsProgram name found)
  sameFile("${found}" "${POINTS}/${name}.wanted.csv" "tactus eval")
endfunction()

# consumerAgrees(WHAT COMMAND...): run with MODEL POINTS OUT ALL for each model, the command writes the table of `tactus eval`
# and all that the consumer in C writes (program_test.cmake).
function(consumerAgrees what)
  foreach(name IN LISTS MODELS)
    run(ignored ${ARGN} "${POINTS}/${name}.tactus.json" "${POINTS}/${name}.csv" "${WORK}/${what}-${name}.csv" "${WORK}/${what}-${name}.all")
    sameAsProgram(${name} "${WORK}/${what}-${name}.csv")
    sameFile("${WORK}/${what}-${name}.all" "${WORK}/../consumer_program/shared_c-${name}.all" "the program in C")
  endforeach()
endfunction()

# bundle(FOLDER): a small bundle, to be verified by the library.
function(bundle folder)
  run(ignored "${TACTUS}" bundle "${SOURCE}/docs/conformance/scale.tactus.json" --out "${folder}")
endfunction()

file(GLOB library_folders "${PREFIX}/lib" "${PREFIX}/lib64" "${PREFIX}/lib/*-linux-gnu*")
list(JOIN library_folders ":" library_path)
set(ENV{LD_LIBRARY_PATH} "${library_path}:$ENV{LD_LIBRARY_PATH}")
