# The library as one file: compiled by two compilers without a flag of ours, it gives the bits of `tactus eval`, and reads a bundle.
include("${CMAKE_CURRENT_LIST_DIR}/common.cmake")
if(NOT PYTHON)
  message("SKIPPED: there is no Python here (python3), so the library is not put into one file")
  return()
endif()
function(amalgamate folder)
  run(ignored "${PYTHON}" -B "${SOURCE}/packaging/release/amalgamate.py" --root "${SOURCE}" --list "${BUILD}/libtactus_sources.txt"
      --notices "${SOURCE}/packaging/debian/copyright" --version ${VERSION} --out "${folder}")
endfunction()
amalgamate("${WORK}/dist")
amalgamate("${WORK}/again")
sameFile("${WORK}/dist/tactus.cpp" "${WORK}/again/tactus.cpp" "the second run")
file(STRINGS "${WORK}/dist/tactus.cpp" left REGEX "^#include \"")
if(NOT left STREQUAL "#include \"tactus.h\"")
  message(FATAL_ERROR "includes more files: ${left}")
endif()
file(COPY "${WORK}/dist/tactus.h" DESTINATION "${WORK}/include/tactus")  # as programs include it that know the installed library
file(WRITE "${WORK}/verify.c" "#include <stdio.h>
#include \"tactus.h\"
int main(int argc, char** argv) {
  double error_n = 1;
  char message[256] = \"\";
  const int status = argc == 2 ? tactus_verify(argv[1], &error_n, message, sizeof message) : 1;
  printf(\"%d %g %s %s\\n\", status, error_n, tactus_version(), message);
  return 0;
}
")
bundle("${WORK}/bundle")
find_program(GXX g++)
find_program(CLANGXX NAMES clang++ clang++-14)
set(compiled 0)
foreach(compiler GXX CLANGXX)
  if(NOT ${compiler})
    message("SKIPPED: there is no ${compiler} here")
    continue()
  endif()
  math(EXPR compiled "${compiled} + 1")
  run(ignored "${${compiler}}" -std=c++20 -O2 -Wall -Werror -c "${WORK}/dist/tactus.cpp" -o "${WORK}/${compiler}.o")
  foreach(program "${SOURCE}/tests/consumer/outside/table.c" "${WORK}/verify.c")
    cmake_path(GET program STEM name)
    run(ignored "${C_COMPILER}" -std=c99 -I "${WORK}/include" -I "${WORK}/dist" -c "${program}" -o "${WORK}/${name}.o")
    run(ignored "${${compiler}}" "${WORK}/${name}.o" "${WORK}/${compiler}.o" -o "${WORK}/${compiler}_${name}")
  endforeach()
  consumerAgrees(${compiler} "${WORK}/${compiler}_table")
  run(said "${WORK}/${compiler}_verify" "${WORK}/bundle")
  if(NOT said STREQUAL "0 0 ${VERSION} \n")
    message(FATAL_ERROR "tactus_verify: ${said}")
  endif()
endforeach()
if(compiled EQUAL 0)
  message(FATAL_ERROR "found no compiler for the one file")
endif()
