# libtactus for Windows by mingw-w64: what the DLL exports, and programs in C and C++ against it; where Wine is, they run and
# give the bits that the library gives here.
include("${CMAKE_CURRENT_LIST_DIR}/common.cmake")
find_program(MINGW NAMES x86_64-w64-mingw32-g++-posix x86_64-w64-mingw32-g++)
find_program(OBJDUMP x86_64-w64-mingw32-objdump)
if(NOT MINGW OR NOT OBJDUMP)
  message("SKIPPED: there is no mingw-w64 here (g++-mingw-w64-x86-64-posix), so libtactus is not built for Windows")
  return()
endif()
set(for_windows -G "${GENERATOR}" "-DCMAKE_TOOLCHAIN_FILE=${SOURCE}/cmake/mingw.cmake" -DCMAKE_BUILD_TYPE=Release
    "-DCMAKE_INSTALL_PREFIX=${WORK}/prefix")
run(ignored ${CMAKE_COMMAND} -S "${SOURCE}" -B "${WORK}/library" ${for_windows} -DTACTUS_PROGRAM=OFF -DTACTUS_WORKBENCH=OFF
    -DTACTUS_TESTS=OFF -DTACTUS_WERROR=ON
    -DCMAKE_CXX_FLAGS_RELEASE=-O1)  # compiles fast, and must give the same bits
run(ignored ${CMAKE_COMMAND} --build "${WORK}/library" -j 2)
run(ignored ${CMAKE_COMMAND} --install "${WORK}/library")

# The names of tactus.h and no other; no library but the system's.
run(said ${OBJDUMP} -p "${WORK}/prefix/bin/tactus.dll")
string(REGEX MATCHALL "DLL Name: [^\n]+" needed "${said}")
if(NOT needed STREQUAL "DLL Name: KERNEL32.dll;DLL Name: msvcrt.dll")
  message(FATAL_ERROR "needed: ${needed}")
endif()
string(REPLACE "[" "<" said "${said}")  # a list of CMake keeps what stands in brackets together
string(REPLACE "]" ">" said "${said}")
string(REGEX REPLACE "^.*<Ordinal/Name Pointer> Table" "" said "${said}")
string(REGEX REPLACE "\n\n.*$" "\n" said "${said}")
# The last word of a line, after a number or a bracket; newer binutils have more columns and a line of their names.
string(REGEX MATCHALL "[0-9a-f>] [A-Za-z_][A-Za-z_0-9]*\n" exported "${said}")
list(TRANSFORM exported REPLACE "^. ([A-Za-z_0-9]+)\n$" "\\1")
file(STRINGS "${WORK}/prefix/include/tactus/tactus.h" declared REGEX "^TACTUS_API")
list(TRANSFORM declared REPLACE "^.*[ *](tactus_[a-z0-9_]+)\\(.*$" "\\1")
list(SORT exported)
list(SORT declared)
if(NOT exported STREQUAL declared)
  message(FATAL_ERROR "exported: ${exported}\ndeclared: ${declared}")
endif()
foreach(project outside windows)
  run(ignored ${CMAKE_COMMAND} -S "${SOURCE}/tests/consumer/${project}" -B "${WORK}/${project}" ${for_windows}
      "-DCMAKE_PREFIX_PATH=${WORK}/prefix" "-DWANTED_VERSION=${VERSION}")
  run(ignored ${CMAKE_COMMAND} --build "${WORK}/${project}")
endforeach()
# The example that follows the live link, with the sockets of Windows.
run(ignored ${CMAKE_COMMAND} -S "${WORK}/prefix/share/tactus/examples" -B "${WORK}/examples" ${for_windows}
    "-DCMAKE_PREFIX_PATH=${WORK}/prefix")
run(ignored ${CMAKE_COMMAND} --build "${WORK}/examples" --target simulator)

find_program(WINE NAMES wine64 wine PATHS /usr/lib/wine)
if(NOT WINE)
  message("SKIPPED: there is no Wine here (wine64), so programs with tactus.dll are built and not run")
  return()
endif()
set(ENV{WINEPREFIX} "${WORK}/wine")
set(ENV{WINEDEBUG} "-all")
set(ENV{WINEPATH} "${WORK}/prefix/bin")
# Digits of numbers are Microsoft's there in C, so the doubles are compared; in C++ the table too.
foreach(name IN LISTS MODELS)
  foreach(program shared_c static_c shared_cpp)
    set(found "${WORK}/${program}-${name}")
    run(ignored ${WINE} "${WORK}/outside/${program}.exe" "${POINTS}/${name}.tactus.json" "${POINTS}/${name}.csv" "${found}.csv"
        "${found}.all")
    sameFile("${found}.all" "${WORK}/../consumer_program/shared_c-${name}.all" "the program in C here")
  endforeach()
  sameAsProgram(${name} "${WORK}/shared_cpp-${name}.csv")
endforeach()
execute_process(COMMAND ${WINE} "${WORK}/windows/named.exe" "${MODEL}" WORKING_DIRECTORY "${WORK}/windows" OUTPUT_VARIABLE said
                RESULT_VARIABLE status)
if(NOT status EQUAL 0 OR NOT said MATCHES "4 inputs")
  message(FATAL_ERROR "a name in UTF-8: ${said}")
endif()
