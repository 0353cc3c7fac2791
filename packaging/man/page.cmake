# cmake -DIN=tactus.1 -DPROGRAM=tactus -DOUT=tactus.1 [-DGZIP=gzip] -P page.cmake: the page IN with the commands of the program in
# the place of @COMMANDS@; OUT.gz where gzip is there.
execute_process(COMMAND "${PROGRAM}" help --man OUTPUT_VARIABLE commands COMMAND_ERROR_IS_FATAL ANY)
file(READ "${IN}" page)
string(REPLACE "@COMMANDS@\n" "${commands}" page "${page}")
file(WRITE "${OUT}" "${page}")
if(GZIP)
  execute_process(COMMAND "${GZIP}" -9 -n -c "${OUT}" OUTPUT_FILE "${OUT}.gz" COMMAND_ERROR_IS_FATAL ANY)
endif()
