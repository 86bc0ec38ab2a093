# The stiff and extreme cases with their naive twins: shown by zerkalo stability, asserted by tests/stiff.
add_library(zerkalo_stability STATIC
  stability/all_cases.cpp
  stability/bounce_rows.cpp
  stability/contact_rows.cpp
  stability/far_camera_rows.cpp
  stability/lamp_rows.cpp
  stability/lobe_rows.cpp
  stability/polish_rows.cpp
  stability/solid_size_rows.cpp
  stability/stage.cpp
  stability/sun_rows.cpp
  stability/taper_rows.cpp)
target_include_directories(zerkalo_stability PUBLIC ${PROJECT_SOURCE_DIR})
target_link_libraries(zerkalo_stability PUBLIC zerkalo::core PRIVATE zerkalo::scene_file zerkalo_options)
