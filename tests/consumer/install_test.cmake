# Installs the library into an empty prefix, and looks at what is there.
file(REMOVE_RECURSE "${PREFIX}" "${PREFIX}-program")
foreach(component libtactus1 libtactus-dev)
  execute_process(COMMAND ${CMAKE_COMMAND} --install "${BUILD}" --component ${component} --prefix "${PREFIX}"
                  OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
endforeach()
file(GLOB_RECURSE files RELATIVE "${PREFIX}" "${PREFIX}/*")
foreach(wanted include/tactus/tactus.h include/tactus/tactus.hpp "lib.*/libtactus.so.1" "lib.*/libtactus.so" "lib.*/libtactus.a"
        "lib.*/cmake/tactus/tactusConfig.cmake" "lib.*/pkgconfig/tactus.pc" share/tactus/languages/tactus.py
        share/tactus/tactus-force-model.schema.json
        share/tactus/languages/Tactus.cs share/tactus/languages/TactusLink.cs share/tactus/examples/force.c share/tactus/examples/insertion.cpp
        share/tactus/examples/force.py share/tactus/examples/Force.cs share/tactus/examples/live_link.py
        share/tactus/examples/simulator/simulator.cpp share/tactus/examples/simulator/swallow.tactus.json)
  set(found "${files}")
  list(FILTER found INCLUDE REGEX "^${wanted}$")
  if(NOT found)
    message(FATAL_ERROR "not installed: ${wanted}; there is: ${files}")
  endif()
endforeach()

# The program goes elsewhere, with what a desktop and udev want of it.
execute_process(COMMAND ${CMAKE_COMMAND} --install "${BUILD}" --component tactus --prefix "${PREFIX}-program"
                OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
foreach(wanted bin/tactus lib/udev/rules.d/60-tactus.rules share/mime/packages/tactus.xml)
  if(NOT EXISTS "${PREFIX}-program/${wanted}")
    message(FATAL_ERROR "not installed: ${wanted}")
  endif()
endforeach()
if(EXISTS "${BUILD}/tactus-workbench")
  execute_process(COMMAND ${CMAKE_COMMAND} --install "${BUILD}" --component tactus-workbench --prefix "${PREFIX}-program"
                  OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
  foreach(wanted bin/tactus-workbench share/applications/tactus-workbench.desktop)
    if(NOT EXISTS "${PREFIX}-program/${wanted}")
      message(FATAL_ERROR "not installed: ${wanted}")
    endif()
  endforeach()
endif()
