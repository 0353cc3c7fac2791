# What lupdate reads, and what the program carries of it. See "Translations" in CONTRIBUTING.md.

# tactus_translations(TARGET FOLDER): TARGET carries all *.ts files of FOLDER as `:/i18n/*.qm`. Only the
# target update_translations writes to them, from all sources in the current folder and below it. English is the language
# of the sources: its file holds the plural forms alone.
# TACTUS_LUPDATE_LIST is the file that names these sources, for the test that compares.
function(tactus_translations target folder)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/*.cpp" "${CMAKE_CURRENT_SOURCE_DIR}/*.h")
  set(list "${CMAKE_CURRENT_BINARY_DIR}/lupdate_sources.txt")
  list(JOIN sources "\n" lines)
  file(CONFIGURE OUTPUT "${list}" CONTENT "-I${PROJECT_SOURCE_DIR}\n${lines}\n" @ONLY)
  set(TACTUS_LUPDATE_LIST "${list}" CACHE INTERNAL "The sources of the translations, one a line")

  file(GLOB english CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/${folder}/*_en.ts")
  file(GLOB languages CONFIGURE_DEPENDS "${CMAKE_CURRENT_SOURCE_DIR}/${folder}/*.ts")
  set(update COMMAND Qt6::lupdate "@${list}" -no-obsolete -locations none -pluralonly -ts ${english})
  set(others ${languages})
  list(REMOVE_ITEM others ${english})
  if(others)
    list(APPEND update COMMAND Qt6::lupdate "@${list}" -no-obsolete -locations none -ts ${others})
  endif()
  add_custom_target(update_translations ${update} VERBATIM)

  qt_add_translation(compiled ${languages} OPTIONS -silent)
  qt_add_resources(${target} translations PREFIX /i18n BASE "${CMAKE_CURRENT_BINARY_DIR}" FILES ${compiled})
endfunction()
