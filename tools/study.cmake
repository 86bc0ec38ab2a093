# Error against run time: what `zerkalo study` does. Compiled once for both programs and for its tests.
add_library(zerkalo_study OBJECT
  study/crops.cpp
  study/diagrams.cpp
  study/error_figures.cpp
  study/gnuplot_script.cpp
  study/goals.cpp
  study/join.cpp
  study/journal.cpp
  study/light_picture.cpp
  study/plan.cpp
  study/references.cpp
  study/regions.cpp
  study/report.cpp
  study/results.cpp
  study/row_runner.cpp
  study/row_text.cpp
  study/series.cpp
  study/statistics.cpp
  study/study.cpp)
zerkalo_batches(zerkalo_study)
target_include_directories(zerkalo_study PUBLIC ${PROJECT_SOURCE_DIR})
target_link_libraries(zerkalo_study PUBLIC zerkalo_options zerkalo::core)
# GCC 12 mistakes concatenations of std::string for overlapping copies (GCC bug 105651).
target_compile_options(zerkalo_study PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>)
