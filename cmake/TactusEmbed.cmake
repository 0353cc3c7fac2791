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

# tactus_embed_folder(TARGET NAMESPACE FUNCTION FOLDER): the files below FOLDER become
#   std::vector<std::pair<std::string_view, std::string_view>> NAMESPACE::FUNCTION();
# in TARGET: the path of each below FOLDER, and its bytes.
function(tactus_embed_folder target namespace function folder)
  get_filename_component(path "${folder}" ABSOLUTE)
  file(GLOB_RECURSE files CONFIGURE_DEPENDS RELATIVE "${path}" "${path}/*")
  list(SORT files)
  set(declared "")
  set(listed "")
  foreach(file IN LISTS files)
    string(MAKE_C_IDENTIFIER "${function}_${file}" name)
    tactus_embed(${target} ${namespace} ${name} "${path}/${file}")
    string(APPEND declared "std::string_view ${name}();\n")
    string(APPEND listed "      {\"${file}\", ${name}()},\n")
  endforeach()
  set(out "${CMAKE_CURRENT_BINARY_DIR}/embedded_${function}.cpp")
  file(CONFIGURE OUTPUT "${out}" @ONLY CONTENT [[#include <string_view>
#include <utility>
#include <vector>

namespace @namespace@ {
@declared@std::vector<std::pair<std::string_view, std::string_view>> @function@();
std::vector<std::pair<std::string_view, std::string_view>> @function@() {
  return {
@listed@  };
}
}  // namespace @namespace@
]])
  target_sources(${target} PRIVATE "${out}")
endfunction()
