# libtactus for 64-bit ARM: where a cross compiler and qemu are, a program in C gives the bits that it gives here.
include("${CMAKE_CURRENT_LIST_DIR}/common.cmake")
find_program(CROSS aarch64-linux-gnu-g++)
find_program(QEMU NAMES qemu-aarch64-static qemu-aarch64)
if(NOT CROSS)
  message("SKIPPED: there is no compiler for ARM here (g++-aarch64-linux-gnu), so libtactus is not built for it")
  return()
endif()
set(for_arm -G "${GENERATOR}" "-DCMAKE_TOOLCHAIN_FILE=${SOURCE}/cmake/aarch64.cmake" -DCMAKE_BUILD_TYPE=Release)
run(ignored ${CMAKE_COMMAND} -S "${SOURCE}" -B "${WORK}/library" ${for_arm} "-DCMAKE_INSTALL_PREFIX=${WORK}/prefix" -DTACTUS_PROGRAM=OFF
    -DTACTUS_WORKBENCH=OFF -DTACTUS_TESTS=OFF -DCMAKE_CXX_FLAGS_RELEASE=-O1)  # compiles fast, and must give the same bits
run(ignored ${CMAKE_COMMAND} --build "${WORK}/library" -j 2)
run(ignored ${CMAKE_COMMAND} --install "${WORK}/library")
run(ignored ${CMAKE_COMMAND} -S "${SOURCE}/tests/consumer/outside" -B "${WORK}/outside" ${for_arm} "-DCMAKE_PREFIX_PATH=${WORK}/prefix"
    "-DWANTED_VERSION=${VERSION}")
run(ignored ${CMAKE_COMMAND} --build "${WORK}/outside")
if(NOT QEMU)
  message("SKIPPED: there is no qemu here (qemu-user-static), so programs for ARM are built and not run")
  return()
endif()
consumerAgrees(static_c "${QEMU}" -L /usr/aarch64-linux-gnu "${WORK}/outside/static_c")
