# Toolchain file: cross-compiles for 64-bit ARM with Debian's g++-aarch64-linux-gnu; programs run under qemu-user.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_C_COMPILER aarch64-linux-gnu-gcc)
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++)

# Static programs need nothing of the target's file system, neither here nor on a bare board.
set(CMAKE_EXE_LINKER_FLAGS_INIT -static)
find_program(ZERKALO_QEMU qemu-aarch64)
if(ZERKALO_QEMU)
  set(CMAKE_CROSSCOMPILING_EMULATOR ${ZERKALO_QEMU} -L /usr/aarch64-linux-gnu)
endif()

# xsimd is headers only, but Debian keeps its CMake files in the folder of the host's architecture, where a cross build
# does not look.
file(GLOB zerkalo_xsimd_folder /usr/lib/*/cmake/xsimd)
if(zerkalo_xsimd_folder AND NOT xsimd_DIR)
  list(GET zerkalo_xsimd_folder 0 xsimd_DIR)
endif()

# No library of the host can serve; programs of the host (python3) can.
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
