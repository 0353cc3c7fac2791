# Toolchain file: 64-bit Windows from Debian (g++-mingw-w64-x86-64-posix). Only libtactus is built for Windows: preset mingw.
set(CMAKE_SYSTEM_NAME Windows)
set(CMAKE_SYSTEM_PROCESSOR x86_64)
find_program(TACTUS_MINGW_C NAMES x86_64-w64-mingw32-gcc-posix x86_64-w64-mingw32-gcc)
find_program(TACTUS_MINGW_CXX NAMES x86_64-w64-mingw32-g++-posix x86_64-w64-mingw32-g++)
set(CMAKE_C_COMPILER "${TACTUS_MINGW_C}")
set(CMAKE_CXX_COMPILER "${TACTUS_MINGW_CXX}")
find_program(CMAKE_RC_COMPILER x86_64-w64-mingw32-windres)
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)

# Windows aligns the stack to 16 bytes, and g++ does not align it further for 32-byte vectors (GCC bug 54412): the
# assembler takes the instructions that need no alignment.
set(CMAKE_CXX_FLAGS_INIT "-Wa,-muse-unaligned-vector-move")
# One file to hand on: the C++ runtime is inside.
# The linker strips it, because strip would write the time into it: the same bytes on each day.
set(CMAKE_SHARED_LINKER_FLAGS_INIT "-static -s -Wl,--no-insert-timestamp")
set(CMAKE_EXE_LINKER_FLAGS_INIT "-static")
