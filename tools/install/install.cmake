# What `cmake --install` puts where, so that find_package(zerkalo) works.
# Headers go to include/zerkalo and are named as in the repository: #include "core/render/render.hpp".
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(zerkalo_headers include/zerkalo)
set(zerkalo_package ${CMAKE_INSTALL_LIBDIR}/cmake/zerkalo)

# zerkalo_install_library(NAME): the target zerkalo_<NAME> as zerkalo::<NAME>, with the headers of the folder <NAME>.
function(zerkalo_install_library name)
  set_target_properties(zerkalo_${name} PROPERTIES EXPORT_NAME ${name})
  target_compile_features(zerkalo_${name} PUBLIC cxx_std_20)
  install(TARGETS zerkalo_${name} EXPORT zerkalo_${name} ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
  install(EXPORT zerkalo_${name} NAMESPACE zerkalo:: FILE zerkalo_${name}.cmake DESTINATION ${zerkalo_package})
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/${name} DESTINATION ${zerkalo_headers} FILES_MATCHING PATTERN "*.hpp")
endfunction()

zerkalo_install_library(core)
if(TARGET zerkalo_platform)
  zerkalo_install_library(platform)
endif()
if(TARGET zerkalo)
  install(TARGETS zerkalo RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/firmware/scenes DESTINATION ${CMAKE_INSTALL_DATADIR}/zerkalo)
endif()
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})

configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/zerkaloConfig.cmake.in ${PROJECT_BINARY_DIR}/zerkaloConfig.cmake
  INSTALL_DESTINATION ${zerkalo_package})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/zerkaloConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/zerkaloConfig.cmake ${PROJECT_BINARY_DIR}/zerkaloConfigVersion.cmake
  DESTINATION ${zerkalo_package})
