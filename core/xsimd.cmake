# The lane library, headers alone. Any major version from Debian 12's 8.1 on: find_package() alone would take one only.
find_package(xsimd REQUIRED)
if(xsimd_VERSION VERSION_LESS 8.1)
  message(FATAL_ERROR "xsimd ${xsimd_VERSION} is too old: ${xsimd_DIR}; 8.1 or newer is needed")
endif()
