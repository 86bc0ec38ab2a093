# Toolchain file: cross-compiles for 32-bit ARM (hard float) with Debian's g++-arm-linux-gnueabihf, for qemu-arm.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR arm)
set(CMAKE_C_COMPILER arm-linux-gnueabihf-gcc)
set(CMAKE_CXX_COMPILER arm-linux-gnueabihf-g++)
set(CMAKE_EXE_LINKER_FLAGS_INIT -static)

# xsimd is headers only, but Debian keeps its CMake files in the folder of the host's architecture, where a cross build
# does not look.
file(GLOB zerkalo_xsimd_folder /usr/lib/*/cmake/xsimd)
if(zerkalo_xsimd_folder AND NOT xsimd_DIR)
  list(GET zerkalo_xsimd_folder 0 xsimd_DIR)
endif()
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
