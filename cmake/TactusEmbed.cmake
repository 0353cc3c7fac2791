# tactus_embed(TARGET NAMESPACE FUNCTION FILE): the data file FILE becomes
#   std::string_view NAMESPACE::FUNCTION();
# in TARGET, so that the programs carry their data and need no installed folder.
# The declaration stands in the header of the code that uses it.
function(tactus_embed target namespace function file)
  get_filename_component(path "${file}" ABSOLUTE)
  set(out "${CMAKE_CURRENT_BINARY_DIR}/embedded_${function}.cpp")
  add_custom_command(
    OUTPUT "${out}"
    COMMAND ${CMAKE_COMMAND} -DIN=${path} -DOUT=${out} -DNAMESPACE=${namespace} -DFUNCTION=${function}
            -P "${PROJECT_SOURCE_DIR}/cmake/embed_file.cmake"
    DEPENDS "${path}" "${PROJECT_SOURCE_DIR}/cmake/embed_file.cmake"
    COMMENT "Embedding ${file}" VERBATIM)
  target_sources(${target} PRIVATE "${out}")
endfunction()
