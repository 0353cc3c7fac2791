# What every target of the project has in common: language level, floating point, warnings, sanitizers.
find_program(TACTUS_CCACHE ccache)
if(TACTUS_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER "${TACTUS_CCACHE}")
endif()

set(CMAKE_CXX_EXTENSIONS OFF)
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release)
endif()

add_library(tactus_common INTERFACE)
target_compile_features(tactus_common INTERFACE cxx_std_20)
target_include_directories(tactus_common INTERFACE "${PROJECT_SOURCE_DIR}")
# No contraction and no fast-math: the same entry point gives the same bits on every x86-64 machine.
target_compile_options(tactus_common INTERFACE -ffp-contract=off -Wall -Wextra -Wpedantic -Wshadow -Wnon-virtual-dtor)
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU)
  target_compile_options(tactus_common INTERFACE -Wno-restrict)  # false alarms on std::string in g++ 12 (GCC bug 105651)
endif()
if(TACTUS_UNITY AND CMAKE_CXX_COMPILER_ID STREQUAL GNU)
  # Several files at once fill the memory that the compiler takes at first; looking for what it could reuse takes a tenth of its time.
  target_compile_options(tactus_common INTERFACE "SHELL:--param ggc-min-expand=300" "SHELL:--param ggc-min-heapsize=600000")
endif()
# Each compiler warns of something else. The code is kept free of the warnings of this one.
set(TACTUS_WERROR_COMPILER "GNU 12")
if(TACTUS_WERROR)
  if("${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}" MATCHES "^${TACTUS_WERROR_COMPILER}\\.")
    target_compile_options(tactus_common INTERFACE -Werror)
  else()
    message(STATUS "Warnings are no errors: the compiler is not ${TACTUS_WERROR_COMPILER}")
  endif()
endif()
if(TACTUS_SANITIZE)
  target_compile_options(tactus_common INTERFACE -fsanitize=${TACTUS_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
  target_link_options(tactus_common INTERFACE -fsanitize=${TACTUS_SANITIZE})
endif()

# Several files at once (TACTUS_UNITY): about 0.6 of the time of a build from nothing, because headers and templates are
# compiled once for all of them. What is local to one of them must not have the name of what is local to another.
# `tactus_unity(TARGET PRECOMPILED)`: half as many at once, where that costs next to nothing and a change is compiled sooner.
function(tactus_unity target)
  if(TACTUS_UNITY)
    set(files ${TACTUS_UNITY_FILES})
    if(TACTUS_PCH AND "PRECOMPILED" IN_LIST ARGN)
      math(EXPR files "(${files} + 1) / 2")
    endif()
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${files})
    # A class of a .cpp file may hold what is local to it; here the compiler takes that file for a header.
    target_compile_options(${target} PRIVATE -Wno-subobject-linkage)
  endif()
endfunction()

# tactus_library(NAME [RUNTIME] [SEPARATE] [QUICK] SOURCES ... LINK ...): a static library whose LINK list is its place in the
# layering.
# RUNTIME: a part of libtactus (core/runtime), which exports none of it and leaves out what it does not use.
# SEPARATE: its sources are always compiled one by one, so that what the optimizer makes of a loop depends on its file alone.
# QUICK: runs once for a command or a click, so it is compiled as fast as tests and views are (TACTUS_QUICK_OPTIONS).
function(tactus_library name)
  cmake_parse_arguments(ARG "RUNTIME;SEPARATE;QUICK" "" "SOURCES;LINK;PRIVATE_LINK" ${ARGN})
  add_library(${name} STATIC ${ARG_SOURCES})
  set_target_properties(${name} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  if(ARG_RUNTIME)
    set_target_properties(${name} PROPERTIES CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
    target_compile_options(${name} PRIVATE -ffunction-sections -fdata-sections)
  endif()
  if(ARG_QUICK)
    target_compile_options(${name} PRIVATE ${TACTUS_QUICK_OPTIONS})
  endif()
  target_link_libraries(${name} PUBLIC tactus_common ${ARG_LINK} PRIVATE ${ARG_PRIVATE_LINK})
  if(NOT ARG_SEPARATE)
    tactus_unity(${name})
  endif()
endfunction()
