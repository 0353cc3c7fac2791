# 100,000 points, and what `tactus eval` gives there: what all consumers are compared with.
include("${CMAKE_CURRENT_LIST_DIR}/common.cmake")
run(ignored "${C_COMPILER}" -O1 -Wall -Werror "${CMAKE_CURRENT_LIST_DIR}/points.c" -o "${WORK}/points")
execute_process(COMMAND "${WORK}/points" 100000 OUTPUT_FILE "${WORK}/points.csv" COMMAND_ERROR_IS_FATAL ANY)
run(ignored "${TACTUS}" eval "${MODEL}" --in "${WORK}/points.csv" --out "${WORK}/wanted.csv")
