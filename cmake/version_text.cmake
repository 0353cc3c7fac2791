# cmake -DVERSION=0.2.0 -DSOURCE=… -DHEADER=… [-DGIT=git] -P version_text.cmake: writes HEADER if its text is another one.
# Without git, or where SOURCE is no checkout (an archive of the sources), the text is VERSION alone.
set(text "${VERSION}")
# git(OUT ARGUMENTS...): what git prints, empty where it fails.
function(git out)
  execute_process(COMMAND "${GIT}" -C "${SOURCE}" ${ARGN} OUTPUT_VARIABLE said OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET
                  RESULT_VARIABLE status)
  if(NOT status EQUAL 0)
    set(said "")
  endif()
  set(${out} "${said}" PARENT_SCOPE)
endfunction()

# The archive of a release may be unpacked inside a checkout of something else.
if(GIT AND EXISTS "${SOURCE}/.git")
  git(released describe --tags --exact-match --dirty --match "v${VERSION}")
  git(commit describe --always --dirty --abbrev=8 --exclude *)
  if(commit AND NOT released STREQUAL "v${VERSION}")
    string(REPLACE "-dirty" ".dirty" commit "${commit}")
    string(APPEND text "+g${commit}")
  endif()
endif()

set(wanted "#define TACTUS_VERSION_TEXT \"${text}\"\n")
set(present "")
if(EXISTS "${HEADER}")
  file(READ "${HEADER}" present)
endif()
if(NOT present STREQUAL wanted)
  file(WRITE "${HEADER}" "${wanted}")
endif()
