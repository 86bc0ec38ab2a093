# Parts of small scenes, shared by the stiff cases and the tests.
add_library(zerkalo_staging STATIC staging.cpp)
target_include_directories(zerkalo_staging PUBLIC ${PROJECT_SOURCE_DIR})
target_link_libraries(zerkalo_staging PRIVATE zerkalo_options)
