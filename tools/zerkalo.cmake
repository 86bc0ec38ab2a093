# The program: every command; and the same linked statically, without bench (Debian's Google Benchmark is shared only).
find_package(CLI11 REQUIRED)
find_package(benchmark REQUIRED)
find_package(Threads REQUIRED)

# All but main.cpp, which knows whether there is a bench: compiled once for both programs.
add_library(zerkalo_commands OBJECT
  zerkalo/options.cpp
  zerkalo/messages.cpp
  zerkalo/json.cpp
  zerkalo/progress.cpp
  zerkalo/stop_signals.cpp
  zerkalo/scene_input.cpp
  zerkalo/picture_file.cpp
  zerkalo/picture_difference.cpp
  zerkalo/difference_map.cpp
  zerkalo/edge_rays.cpp
  zerkalo/frame.cpp
  zerkalo/refine.cpp
  zerkalo/render_command.cpp
  zerkalo/compare_command.cpp
  zerkalo/show_command.cpp
  zerkalo/doctor_command.cpp
  zerkalo/stability_command.cpp
  zerkalo/strip_command.cpp
  zerkalo/study_command.cpp)
zerkalo_batches(zerkalo_commands)
target_include_directories(zerkalo_commands PUBLIC ${PROJECT_SOURCE_DIR})
target_compile_definitions(zerkalo_commands PUBLIC ZERKALO_VERSION="${PROJECT_VERSION}")
target_link_libraries(zerkalo_commands PUBLIC zerkalo_options zerkalo_scene_file zerkalo_stability zerkalo::core
  zerkalo_command_line Threads::Threads)
# CLI11 is headers: parsed once, and not optimised anew for each command at a level that only the core deserves. What
# GCC 12 inlines from a precompiled header it mistakes for the program's own text.
add_library(zerkalo_command_line INTERFACE)
target_compile_options(zerkalo_command_line INTERFACE $<$<CONFIG:Release>:-O1>
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict -Wno-array-bounds -Wno-stringop-overflow>)
target_link_libraries(zerkalo_command_line INTERFACE CLI11::CLI11)
target_precompile_headers(zerkalo_commands PRIVATE <CLI/CLI.hpp>)
foreach(part messages json progress stop_signals scene_input picture_file picture_difference difference_map frame refine
    bench_scenes)
  set_source_files_properties(zerkalo/${part}.cpp PROPERTIES SKIP_PRECOMPILE_HEADERS ON)
endforeach()
# The headers alone: what stands for the library is the program's choice.
target_include_directories(zerkalo_commands PRIVATE $<TARGET_PROPERTY:zerkalo_platform,INTERFACE_INCLUDE_DIRECTORIES>)

# zerkalo_program(NAME PLATFORM...): the program, with what stands for the platform library.
function(zerkalo_program name)
  add_executable(${name} zerkalo/main.cpp $<TARGET_OBJECTS:zerkalo_commands> $<TARGET_OBJECTS:zerkalo_study>)
  target_include_directories(${name} PRIVATE ${PROJECT_SOURCE_DIR})
  target_compile_definitions(${name} PRIVATE ZERKALO_VERSION="${PROJECT_VERSION}")
  target_link_libraries(${name} PRIVATE zerkalo_options zerkalo_scene_file zerkalo_stability ${ARGN} zerkalo::core
    zerkalo_command_line Threads::Threads)
  target_precompile_headers(${name} REUSE_FROM zerkalo_commands)
endfunction()

zerkalo_program(zerkalo zerkalo::platform)
target_sources(zerkalo PRIVATE zerkalo/bench_command.cpp zerkalo/bench_scenes.cpp)
target_compile_definitions(zerkalo PRIVATE ZERKALO_BENCH)
target_link_libraries(zerkalo PRIVATE benchmark::benchmark)

# The platform library brings the shared libpng with it: take its objects alone, and the static libraries by name.
find_library(ZERKALO_STATIC_PNG libpng.a)
find_library(ZERKALO_STATIC_ZLIB libz.a)
if(ZERKALO_STATIC_PNG AND ZERKALO_STATIC_ZLIB)
  zerkalo_program(zerkalo_static $<TARGET_OBJECTS:zerkalo_platform> ${ZERKALO_STATIC_PNG} ${ZERKALO_STATIC_ZLIB} m)
  set_target_properties(zerkalo_static PROPERTIES EXCLUDE_FROM_ALL ON)
  target_link_options(zerkalo_static PRIVATE -static)
endif()
