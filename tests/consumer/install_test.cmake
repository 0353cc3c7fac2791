# Installs the library into an empty prefix, and looks at what is there.
file(REMOVE_RECURSE "${PREFIX}")
foreach(component libtactus1 libtactus-dev)
  execute_process(COMMAND ${CMAKE_COMMAND} --install "${BUILD}" --component ${component} --prefix "${PREFIX}"
                  OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
endforeach()
file(GLOB_RECURSE files RELATIVE "${PREFIX}" "${PREFIX}/*")
foreach(wanted include/tactus/tactus.h include/tactus/tactus.hpp "lib.*/libtactus.so.1" "lib.*/libtactus.so" "lib.*/libtactus.a"
        "lib.*/cmake/tactus/tactusConfig.cmake" "lib.*/pkgconfig/tactus.pc" share/tactus/languages/tactus.py
        share/tactus/tactus-force-model.schema.json
        share/tactus/languages/Tactus.cs share/tactus/examples/force.c share/tactus/examples/insertion.cpp
        share/tactus/examples/force.py share/tactus/examples/Force.cs)
  set(found "${files}")
  list(FILTER found INCLUDE REGEX "^${wanted}$")
  if(NOT found)
    message(FATAL_ERROR "not installed: ${wanted}; there is: ${files}")
  endif()
endforeach()
