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

# points(FILE COUNT): random points of the NGT model, some outside its universes.
function(points file count)
  set(text "lubrication,neck_flexion,depth,speed\n")
  set(ends 1100 100000 700000 450000)  # thousandths, from -50 on
  string(RANDOM LENGTH 1 RANDOM_SEED 7 ignored)
  foreach(i RANGE 1 ${count})
    set(row "")
    foreach(end IN LISTS ends)
      string(RANDOM LENGTH 7 ALPHABET 0123456789 digits)
      math(EXPR value "(1${digits} * 7919) % ${end} - 50")
      list(APPEND row "${value}e-3")
    endforeach()
    list(JOIN row "," row)
    string(APPEND text "${row}\n")
  endforeach()
  file(WRITE "${file}" "${text}")
endfunction()

# sameAsProgram(POINTS FOUND): FOUND holds the table that `tactus eval` writes for POINTS, byte by byte.
function(sameAsProgram points found)
  run(ignored "${TACTUS}" eval "${MODEL}" --in "${points}" --out "${WORK}/wanted.csv")
  file(SHA256 "${WORK}/wanted.csv" wanted)
  file(SHA256 "${found}" is)
  if(NOT wanted STREQUAL is)
    message(FATAL_ERROR "${found} and ${WORK}/wanted.csv differ")
  endif()
endfunction()

# bundle(FOLDER): a small bundle, to be verified by the library.
function(bundle folder)
  run(ignored "${TACTUS}" bundle "${SOURCE}/docs/conformance/scale.tactus.json" --out "${folder}")
endfunction()

file(GLOB library_folders "${PREFIX}/lib" "${PREFIX}/lib64" "${PREFIX}/lib/*-linux-gnu*")
list(JOIN library_folders ":" library_path)
set(ENV{LD_LIBRARY_PATH} "${library_path}:$ENV{LD_LIBRARY_PATH}")
