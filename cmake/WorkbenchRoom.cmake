# tactus_room(NAME LOGIC ... VIEWS ... ROOMS ... LINK ...): one folder of the workbench as two libraries.
#   tactus_workbench_NAME_logic: controllers and item models, with Qt6::Core alone: a widget in them does not compile;
#   tactus_workbench_NAME: that, with widgets and plots.
# ROOMS are the other rooms that it includes, LINK the libraries below the window.

# Headers that take seconds are compiled once for all rooms (TACTUS_PCH).
function(tactus_room_headers name)
  cmake_parse_arguments(ARG "" "" "LINK;HEADERS" ${ARGN})
  file(WRITE "${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp" "// Carries the precompiled headers.\n")
  add_library(${name} STATIC "${CMAKE_CURRENT_BINARY_DIR}/${name}.cpp")
  set_target_properties(${name} PROPERTIES POSITION_INDEPENDENT_CODE ON)
  target_link_libraries(${name} PRIVATE tactus_common ${ARG_LINK})
  target_compile_options(${name} PRIVATE ${TACTUS_QUICK_OPTIONS})
  target_precompile_headers(${name} PRIVATE ${ARG_HEADERS})
endfunction()

set(TACTUS_ROOM_TOOLKIT Qt6::Widgets Qt6::PrintSupport Qt6::Svg QCustomPlotQt6::QCustomPlotQt6)
if(TACTUS_PCH)
  tactus_room_headers(tactus_workbench_core_headers LINK Qt6::Core
    HEADERS <QObject> <QString> <QTimer> <functional> <memory> <optional> <string> <vector>)
  tactus_room_headers(tactus_workbench_widget_headers LINK ${TACTUS_ROOM_TOOLKIT}
    HEADERS <qcustomplot.h> <QAction> <QApplication> <QBoxLayout> <QComboBox> <QGridLayout> <QLabel> <QMenu> <QPainter>
            <QPushButton> <QStyledItemDelegate> <QTimer> <QToolButton> <QWidget> <functional> <memory> <optional>
            <string> <vector>)
endif()

# The code that moc writes for a library is compiled together with its sources instead of by itself (TACTUS_UNITY).
function(tactus_moc_with_sources name)
  if(TACTUS_UNITY)
    set(written "${CMAKE_CURRENT_BINARY_DIR}/${name}_autogen/mocs_compilation.cpp")
    set(carrier "${CMAKE_CURRENT_BINARY_DIR}/${name}_mocs.cpp")
    file(CONFIGURE OUTPUT "${carrier}" CONTENT "#include \"${written}\"\n")
    set_source_files_properties("${carrier}" PROPERTIES SKIP_AUTOMOC ON)
    set_source_files_properties("${written}" PROPERTIES HEADER_FILE_ONLY ON)
    target_sources(${name} PRIVATE "${carrier}")
  endif()
endfunction()

function(tactus_room room)
  cmake_parse_arguments(ARG "" "" "LOGIC;VIEWS;ROOMS;LINK" ${ARGN})
  set(name tactus_workbench_${room})
  set(rooms ${ARG_ROOMS})
  list(TRANSFORM rooms PREPEND tactus_workbench_)
  set(logic_of_rooms ${rooms})
  list(TRANSFORM logic_of_rooms APPEND _logic)

  if(ARG_LOGIC)
    add_library(${name}_logic STATIC ${ARG_LOGIC})
    set_target_properties(${name}_logic PROPERTIES AUTOMOC ON AUTORCC ON POSITION_INDEPENDENT_CODE ON)
    target_link_libraries(${name}_logic PUBLIC tactus_common ${ARG_LINK} ${logic_of_rooms} Qt6::Core)
    target_compile_options(${name}_logic PRIVATE ${TACTUS_QUICK_OPTIONS})
    if(TACTUS_PCH)
      target_precompile_headers(${name}_logic REUSE_FROM tactus_workbench_core_headers)
    endif()
    tactus_moc_with_sources(${name}_logic)
    tactus_unity(${name}_logic)
  else()
    add_library(${name}_logic INTERFACE)
    target_link_libraries(${name}_logic INTERFACE tactus_common ${ARG_LINK} ${logic_of_rooms} Qt6::Core)
  endif()

  if(ARG_VIEWS)
    add_library(${name} STATIC ${ARG_VIEWS})
    set_target_properties(${name} PROPERTIES AUTOMOC ON POSITION_INDEPENDENT_CODE ON)
    target_link_libraries(${name} PUBLIC ${name}_logic ${rooms} Qt6::Widgets PRIVATE ${TACTUS_ROOM_TOOLKIT})
    target_compile_options(${name} PRIVATE ${TACTUS_QUICK_OPTIONS})
    if(TACTUS_PCH)
      target_precompile_headers(${name} REUSE_FROM tactus_workbench_widget_headers)
    endif()
    tactus_moc_with_sources(${name})
    tactus_unity(${name})
  else()
    add_library(${name} INTERFACE)
    target_link_libraries(${name} INTERFACE ${name}_logic ${rooms})
  endif()
endfunction()
