# tactus.py from the installed prefix: the same table, with and without numpy.
include("${CMAKE_CURRENT_LIST_DIR}/common.cmake")
if(NOT PYTHON)
  message("SKIPPED: there is no python3 here, so tactus.py is not tested")
  return()
endif()
unset(ENV{LD_LIBRARY_PATH})  # it finds the library of its prefix by itself
bundle("${WORK}/bundle")
set(outside "${SOURCE}/tests/consumer/outside")
consumerAgrees(python "${PYTHON}" "${outside}/table.py" "${PREFIX}/share/tactus/languages")
run(said "${PYTHON}" "${outside}/uses.py" "${PREFIX}/share/tactus/languages" "${MODEL}" "${WORK}/bundle")
message("${said}")
run(force "${PYTHON}" "${PREFIX}/share/tactus/examples/force.py" "${MODEL}" 1 45 30 30)
if(NOT force MATCHES "^0\\.12666666666666[0-9]* N\n$")
  message(FATAL_ERROR "force.py: ${force}")
endif()
execute_process(COMMAND "${PYTHON}" "${PREFIX}/share/tactus/examples/force.py" "${MODEL}" 0,5 45 30 30 ERROR_VARIABLE said
                RESULT_VARIABLE status)
if(NOT status EQUAL 1 OR NOT said STREQUAL "found 0,5 45 30 30, wanted numbers with a decimal point\n")
  message(FATAL_ERROR "force.py with a comma: ${status} ${said}")
endif()

# The cells of the notebook in their order. The package of the library lets `import tactus` find the module; here it is told.
set(ENV{PYTHONPATH} "${PREFIX}/share/tactus/languages")
run(cells "${PYTHON}" -B "${PREFIX}/share/tactus/examples/notebook.py" "${MODEL}")
if(NOT cells MATCHES "NGT by S4\n.*depth: 0 to 600 mm\n.*in the middle: 0\\.[0-9]+ N\n.* 600 mm .* 1000 ms +5[0-9]\\.[0-9]+ mm")
  message(FATAL_ERROR "notebook.py: ${cells}")
endif()
