# Points of three models, and what `tactus eval` gives there: what all consumers are compared with. One expert; four experts
# and their average; a fifth input.
include("${CMAKE_CURRENT_LIST_DIR}/common.cmake")
run(ignored "${C_COMPILER}" -O1 -Wall -Werror "${CMAKE_CURRENT_LIST_DIR}/points.c" -o "${WORK}/points")

# points(NAME FILE COUNT UNIVERSES...): the model as NAME.tactus.json, its points NAME.csv, their forces NAME.wanted.csv.
function(points name file count)
  configure_file("${file}" "${WORK}/${name}.tactus.json" COPYONLY)
  execute_process(COMMAND "${WORK}/points" ${count} ${ARGN} OUTPUT_FILE "${WORK}/${name}.csv" COMMAND_ERROR_IS_FATAL ANY)
  run(ignored "${TACTUS}" eval "${WORK}/${name}.tactus.json" --in "${WORK}/${name}.csv" --out "${WORK}/${name}.wanted.csv")
endfunction()

set(ngt lubrication:0:1:0.1 neck_flexion:0:90:5 depth:0:600:5 speed:0:400:5)
points(ngt "${MODEL}" 100000 ${ngt})
points(averaged "${SOURCE}/tests/golden/models/averaged.tactus.json" 100000 ${ngt})
points(swallow "${PREFIX}/share/tactus/examples/simulator/swallow.tactus.json" 20000 lubrication:0:1:0.1 neck_flexion:0:90:5
       depth:0:500:5 speed:0:200:5 swallow:0:1:0.1)
