# The stiff and extreme cases with their naive twins: shown by zerkalo stability, asserted by tests/stiff.
find_package(Threads REQUIRED)
include(${PROJECT_SOURCE_DIR}/core/xsimd.cmake)
add_library(zerkalo_stability STATIC
  stability/aimed_ray_rows.cpp
  stability/all_cases.cpp
  stability/bad_number_rows.cpp
  stability/bounce_rows.cpp
  stability/camera_frame_rows.cpp
  stability/camera_place_rows.cpp
  stability/contact_rows.cpp
  stability/edge_rows.cpp
  stability/far_camera_rows.cpp
  stability/format_rows.cpp
  stability/glass_rows.cpp
  stability/hemisphere_rows.cpp
  stability/lamp_rows.cpp
  stability/light_rows.cpp
  stability/lobe_rows.cpp
  stability/machine_rows.cpp
  stability/mirror_curvature_rows.cpp
  stability/parallel_ray_rows.cpp
  stability/picture_rows.cpp
  stability/polish_rows.cpp
  stability/refusal_rows.cpp
  stability/scaling_rows.cpp
  stability/solid_size_rows.cpp
  stability/sphere_rows.cpp
  stability/stage.cpp
  stability/sun_rows.cpp
  stability/symmetry_rows.cpp
  stability/taper_rows.cpp)
target_include_directories(zerkalo_stability PUBLIC ${PROJECT_SOURCE_DIR})
target_link_libraries(zerkalo_stability PUBLIC zerkalo_staging zerkalo::core PRIVATE zerkalo_options Threads::Threads)
target_precompile_headers(zerkalo_stability PRIVATE stability/stiff_case.hpp)
# Fixed point without a picture is asked where it stands: in the headers of the core.
target_include_directories(zerkalo_stability SYSTEM PRIVATE $<TARGET_PROPERTY:xsimd,INTERFACE_INCLUDE_DIRECTORIES>)
