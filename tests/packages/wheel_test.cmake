# The wheel: its names and sums, and a force where nothing but Python and the wheel is there.
file(REMOVE_RECURSE "${WORK}")
file(MAKE_DIRECTORY "${WORK}")
if(NOT PYTHON)
  message("SKIPPED: there is no Python here (python3), so no wheel is made")
  return()
endif()
# What a preset with TACTUS_STATIC_RUNTIME links.
set(library "${WORK}/libtactus.so.1")
execute_process(COMMAND ${CXX_COMPILER} -shared -static-libstdc++ -static-libgcc -o "${library}" -Wl,-soname,libtactus.so.1
                "-Wl,--version-script=${SOURCE}/core/runtime/exports.map" -Wl,--gc-sections -Wl,--whole-archive "${ARCHIVE}"
                -Wl,--no-whole-archive COMMAND_ERROR_IS_FATAL ANY)
# wheel(STATUS SAID LIBRARY FOLDER): the wheel of a library.
function(wheel status said library folder)
  execute_process(COMMAND ${PYTHON} -B "${SOURCE}/packaging/release/wheel.py" --library "${library}" --version ${VERSION} --out "${folder}"
                  --module "${SOURCE}/core/runtime/languages/tactus.py" --license "${SOURCE}/LICENSE"
                  --notices "${SOURCE}/packaging/debian/copyright"
                  OUTPUT_VARIABLE text ERROR_VARIABLE errors RESULT_VARIABLE result OUTPUT_STRIP_TRAILING_WHITESPACE)
  set(${status} ${result} PARENT_SCOPE)
  set(${said} "${text}${errors}" PARENT_SCOPE)
endfunction()
wheel(status wheel "${library}" "${WORK}/one")
if(NOT status EQUAL 0 OR NOT wheel MATCHES "/tactus-${VERSION}-py3-none-manylinux_2_[0-9]+_[a-z0-9_]+\\.whl$")
  message(FATAL_ERROR "wheel.py: ${status} ${wheel}")
endif()
wheel(status again "${library}" "${WORK}/two")
file(SHA256 "${wheel}" first)
file(SHA256 "${again}" second)
if(NOT first STREQUAL second)
  message(FATAL_ERROR "two wheels of the same files differ")
endif()
# The tag promises nothing about the C++ runtime of another system.
wheel(status said "${SHARED}" "${WORK}/refused")
if(NOT status EQUAL 1 OR NOT said MATCHES "^--library: found that it needs lib(stdc|gcc)")
  message(FATAL_ERROR "a library that needs the C++ runtime: ${status} ${said}")
endif()

execute_process(COMMAND ${PYTHON} -B "${SOURCE}/tests/packages/wheel_record.py" "${wheel}" COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${PYTHON} -m pip --version OUTPUT_QUIET ERROR_QUIET RESULT_VARIABLE no_pip)
if(no_pip)
  execute_process(COMMAND ${PYTHON} -m zipfile -e "${wheel}" "${WORK}/target" COMMAND_ERROR_IS_FATAL ANY)
else()
  execute_process(COMMAND ${PYTHON} -m pip install --quiet --no-index --no-deps --no-compile --disable-pip-version-check
                  --root-user-action=ignore --target "${WORK}/target" "${wheel}" COMMAND_ERROR_IS_FATAL ANY)
endif()
execute_process(COMMAND ${CMAKE_COMMAND} -E env --unset=LD_LIBRARY_PATH --unset=TACTUS_LIBRARY "PYTHONPATH=${WORK}/target" ${PYTHON} -B -c
                "import sys, tactus; print(tactus.version(), tactus.Model.open(sys.argv[1]).force([1, 45, 30, 30]))"
                "${SOURCE}/tests/golden/models/ngt.tactus.json" WORKING_DIRECTORY "${WORK}" OUTPUT_VARIABLE said COMMAND_ERROR_IS_FATAL ANY)
# The exact force of S4's rules at this point is .12666666666666668 N.
if(NOT said MATCHES "^${VERSION} 0\\.12666666666666[0-9]*\n$")
  message(FATAL_ERROR "a force by the wheel: ${said}")
endif()
