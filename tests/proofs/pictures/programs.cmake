# The programs that print the hashes of pictures: with a C library, and without.
add_executable(pictures ${CMAKE_CURRENT_LIST_DIR}/pictures.cpp ${CMAKE_CURRENT_LIST_DIR}/hosted_main.cpp)
target_compile_features(pictures PRIVATE cxx_std_20)
target_link_libraries(pictures PRIVATE zerkalo::core)

# No library at all: whatever the core needs beyond memcpy, memmove, memset and memcmp is a link error.
add_executable(pictures_freestanding
  ${CMAKE_CURRENT_LIST_DIR}/pictures.cpp ${CMAKE_CURRENT_LIST_DIR}/freestanding_main.cpp)
target_compile_features(pictures_freestanding PRIVATE cxx_std_20)
target_compile_options(pictures_freestanding PRIVATE -fno-exceptions -fno-rtti -fno-stack-protector -fno-builtin
  $<$<CXX_COMPILER_ID:GNU>:-fno-tree-loop-distribute-patterns>)
target_link_options(pictures_freestanding PRIVATE -nostdlib -nostartfiles -static -no-pie)
target_link_libraries(pictures_freestanding PRIVATE zerkalo::core)
