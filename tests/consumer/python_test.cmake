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
run(said "${PYTHON}" "${outside}/owned.py" "${PREFIX}/share/tactus/languages" "${MODEL}")
if(NOT said STREQUAL "all of it\n")
  message(FATAL_ERROR "owned.py: ${said}")
endif()
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

# What the engines' examples have in common, and the class for many environments.
set(engines "${PREFIX}/share/tactus/examples/engines")
set(felt "${WORK}/felt")  # a bundle with a hole, so that the last force is held there
run(ignored "${TACTUS}" bundle "${MODEL}" --table-error 0.5 --accept-hole "depth 460 to 600 mm" --out "${felt}")
run(said "${PYTHON}" -B "${engines}/traces.py" "${felt}")
if(NOT said MATCHES "steps of checks_tube.csv: at most 0\\.0 N off")
  message(FATAL_ERROR "traces.py: ${said}")
endif()
set(ENV{PYTHONPATH} "${PREFIX}/share/tactus/languages:${engines}")
run(said "${PYTHON}" -B -c "
import sys, isaac_lab_tube
tubes = isaac_lab_tube.Tubes(sys.argv[1], {'lubrication': 1.0, 'neck_flexion': 45.0}, 2, 0.005)
for i in range(200): forces = tubes.step([i * 0.0003, 0.0], [True, True])
print(forces[0] > 0.05, forces[1])" "${MODEL}")
if(NOT said STREQUAL "True 0.0\n")
  message(FATAL_ERROR "isaac_lab_tube.py: ${said}")
endif()
execute_process(COMMAND "${PYTHON}" -c "import mujoco" RESULT_VARIABLE missing OUTPUT_QUIET ERROR_QUIET)
if(missing)
  message("SKIPPED: mujoco for Python is not installed, so mujoco_tube.py was not run")
else()
  run(said "${PYTHON}" -B "${engines}/mujoco_tube.py" "${felt}")
endif()

# MuJoCo for Node: in the folder that NODE_MODULES_HOST names, or here.
find_program(node node)
set(host "$ENV{NODE_MODULES_HOST}")
if(NOT host)
  set(host "${WORK}")
endif()
execute_process(COMMAND "${node}" -e "require.resolve('mujoco-js')" WORKING_DIRECTORY "${host}" RESULT_VARIABLE missing
                OUTPUT_QUIET ERROR_QUIET)
if(NOT node OR missing)
  message("SKIPPED: node with mujoco-js is not installed, so mujoco.mjs was not run")
else()
  execute_process(COMMAND "${node}" "${engines}/mujoco.mjs" "${felt}" WORKING_DIRECTORY "${host}"
                  RESULT_VARIABLE status OUTPUT_VARIABLE said ERROR_VARIABLE wrong)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "mujoco.mjs: ${said}${wrong}")
  endif()
endif()

# Godot without a screen.
find_program(godot NAMES godot3-server godot3)
if(NOT godot)
  message("SKIPPED: Godot 3 (godot3-server) is not installed, so the tube in GDScript was not run")
else()
  set(ENV{XDG_DATA_HOME} "${WORK}/godot")
  run(said "${godot}" --path "${engines}/godot" -s prove.gd "${felt}")
  message("${said}")
endif()

# The plugin of SOFA, where its headers are.
execute_process(COMMAND ${CMAKE_COMMAND} -S "${engines}/sofa" -B "${WORK}/sofa" "-DCMAKE_PREFIX_PATH=${PREFIX}"
                RESULT_VARIABLE missing OUTPUT_QUIET ERROR_QUIET)
if(missing)
  message("SKIPPED: SOFA is not installed, so its plugin was not compiled")
else()
  run(said ${CMAKE_COMMAND} --build "${WORK}/sofa")
endif()
