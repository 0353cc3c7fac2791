# nlohmann-json and tl::expected, which are headers alone.
if(NOT CMAKE_CROSSCOMPILING)
  find_package(nlohmann_json 3.11 REQUIRED)
  find_package(tl-expected REQUIRED)
  return()
endif()

# For another system the headers of this one serve too, but not the folder that they stand in: it also holds the headers of
# this system's C library.
find_path(TACTUS_HEADERS nlohmann/json.hpp PATHS /usr/include /usr/local/include NO_DEFAULT_PATH REQUIRED)
find_path(TACTUS_EXPECTED_HEADERS tl/expected.hpp PATHS /usr/include /usr/local/include NO_DEFAULT_PATH REQUIRED)
set(header_folder "${PROJECT_BINARY_DIR}/headers")
file(MAKE_DIRECTORY "${header_folder}")
file(CREATE_LINK "${TACTUS_HEADERS}/nlohmann" "${header_folder}/nlohmann" SYMBOLIC)
file(CREATE_LINK "${TACTUS_EXPECTED_HEADERS}/tl" "${header_folder}/tl" SYMBOLIC)
foreach(name nlohmann_json::nlohmann_json tl::expected)
  add_library(${name} INTERFACE IMPORTED GLOBAL)
  target_include_directories(${name} INTERFACE "${header_folder}")
endforeach()
