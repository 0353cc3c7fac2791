# tactus_version_text(HEADER): HEADER defines TACTUS_VERSION_TEXT, the version that the programs print and write into files. With
# TACTUS_REVISION it names the commit, and each build looks whether that is still the one; the target tactus_version_text does.
function(tactus_version_text header)
  set(write ${CMAKE_COMMAND} -DVERSION=${PROJECT_VERSION} "-DSOURCE=${PROJECT_SOURCE_DIR}" "-DHEADER=${header}")
  if(TACTUS_REVISION)
    find_package(Git QUIET)
    add_custom_target(tactus_version_text COMMAND ${write} "-DGIT=${GIT_EXECUTABLE}" -P "${PROJECT_SOURCE_DIR}/cmake/version_text.cmake"
                      BYPRODUCTS "${header}" COMMENT "The commit" VERBATIM)
  else()
    execute_process(COMMAND ${write} -P "${PROJECT_SOURCE_DIR}/cmake/version_text.cmake" COMMAND_ERROR_IS_FATAL ANY)
    add_custom_target(tactus_version_text)
  endif()
endfunction()
