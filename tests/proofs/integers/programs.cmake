# The fixed-point kernel without an instruction for floats: its plan is prepared by one program and compiled into
# another, and both must render the same bytes. With the preset aarch64 this is a processor without a float unit.
# GCC's: clang 14 cannot read the standard headers without float registers.
set(folder ${CMAKE_CURRENT_LIST_DIR})
get_filename_component(repository ${folder}/../../.. ABSOLUTE)
add_executable(bake_fixed_plan ${folder}/bake.cpp)
target_compile_features(bake_fixed_plan PRIVATE cxx_std_20)
target_link_libraries(bake_fixed_plan PRIVATE zerkalo_options zerkalo::core)
set(baked_plan ${CMAKE_CURRENT_BINARY_DIR}/fixed_plan.bin)
add_custom_command(OUTPUT ${baked_plan} COMMAND bake_fixed_plan ${baked_plan} DEPENDS bake_fixed_plan)
set_source_files_properties(${folder}/integers_main.cpp PROPERTIES OBJECT_DEPENDS ${baked_plan})
add_executable(pictures_integers ${folder}/integers_main.cpp ${folder}/../pictures/freestanding_main.cpp
  ${repository}/core/render/kernel_fixed.cpp)
target_compile_features(pictures_integers PRIVATE cxx_std_20)
target_include_directories(pictures_integers PRIVATE ${repository})
target_compile_definitions(pictures_integers PRIVATE ZERKALO_INTEGERS_ONLY ZERKALO_ISA=isa_integers ZERKALO_WIDTH=1
  ZERKALO_TABLE=kFixedKernel_scalar ZERKALO_PLAN="${baked_plan}")
# A program without a standard error stream has nothing to say about lost digits.
target_compile_options(pictures_integers PRIVATE -UZERKALO_CHECKED_FIXED -mgeneral-regs-only -O2 -fno-exceptions
  -fno-rtti -fno-stack-protector -fno-builtin -fno-sanitize=all -fno-tree-loop-distribute-patterns)
target_link_options(pictures_integers PRIVATE -nostdlib -nostartfiles -static -no-pie -fno-sanitize=all)
