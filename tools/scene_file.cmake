# The scene file: TOML text -> Scene with diagnostics. toml++ is used as a header-only library, without exceptions.
find_path(ZERKALO_TOMLPLUSPLUS_INCLUDE_DIR toml++/toml.h REQUIRED)

add_library(zerkalo_scene_file STATIC
  scene_file/decimal_comma.cpp
  scene_file/diagnostic.cpp
  scene_file/file_bytes.cpp
  scene_file/locate.cpp
  scene_file/nesting.cpp
  scene_file/read_camera.cpp
  scene_file/read_image.cpp
  scene_file/read_light.cpp
  scene_file/read_mesh.cpp
  scene_file/read_mirror.cpp
  scene_file/read_scene.cpp
  scene_file/read_solid.cpp
  scene_file/report.cpp
  scene_file/scene_file.cpp
  scene_file/source_text.cpp
  scene_file/stl.cpp
  scene_file/stl_ascii.cpp
  scene_file/suggestion.cpp
  scene_file/syntax_error.cpp
  scene_file/table_reader.cpp
  scene_file/utf8.cpp)
zerkalo_batches(zerkalo_scene_file)
add_library(zerkalo::scene_file ALIAS zerkalo_scene_file)
target_include_directories(zerkalo_scene_file PUBLIC ${PROJECT_SOURCE_DIR})
target_include_directories(zerkalo_scene_file SYSTEM PRIVATE ${ZERKALO_TOMLPLUSPLUS_INCLUDE_DIR})
target_compile_definitions(zerkalo_scene_file PRIVATE TOML_HEADER_ONLY=1 TOML_EXCEPTIONS=0 TOML_ENABLE_FORMATTERS=0)
target_compile_options(zerkalo_scene_file PRIVATE -fno-exceptions)
target_link_libraries(zerkalo_scene_file PUBLIC zerkalo::core PRIVATE zerkalo_options)
# toml++ is parsed once, for those that read its tables.
target_precompile_headers(zerkalo_scene_file PRIVATE scene_file/toml_tree.hpp)
foreach(part decimal_comma diagnostic file_bytes nesting report source_text stl stl_ascii suggestion utf8)
  set_source_files_properties(scene_file/${part}.cpp PROPERTIES SKIP_PRECOMPILE_HEADERS ON)
endforeach()
# GCC 12 mistakes concatenations of std::string for overlapping copies (GCC bug 105651), and what it inlines from a
# precompiled header for the program's own text.
target_compile_options(zerkalo_scene_file PRIVATE
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict -Wno-array-bounds -Wno-stringop-overflow>)
