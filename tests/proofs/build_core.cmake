# Configures and builds tests/proofs/pictures, and with it the core, in a directory of its own.
# cmake -D SOURCE= -D BUILD= -D COMPILER= -D FLAGS= -D LEVEL= -D TOOLCHAIN= -D PREFIX= -D GENERATOR=
#   -D FEW_KERNELS= -D INTEGERS= -P build_core.cmake
set(toolchain "")
if(TOOLCHAIN)
  set(toolchain -DCMAKE_TOOLCHAIN_FILE=${TOOLCHAIN})
endif()

# Release is -O3, by the core's own word; any other level is its own, nameless configuration.
if(LEVEL STREQUAL -O3)
  set(type Release)
else()
  set(type None)
  set(FLAGS "${LEVEL} -DNDEBUG ${FLAGS}")
endif()

# A compiler cache does not keep call graphs.
set(launcher "")
if(FLAGS MATCHES "-fcallgraph-info")
  set(launcher -DCMAKE_CXX_COMPILER_LAUNCHER=)
endif()

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE code OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT code EQUAL 0)
    string(JOIN " " command ${ARGN})
    message(FATAL_ERROR "${command}\n${output}")
  endif()
endfunction()

run(${CMAKE_COMMAND} -S ${SOURCE} -B ${BUILD} -G ${GENERATOR} ${toolchain}
  -DCMAKE_CXX_COMPILER=${COMPILER} -DCMAKE_BUILD_TYPE=${type} "-DCMAKE_CXX_FLAGS=${FLAGS}"
  "-DCMAKE_PREFIX_PATH=${PREFIX}" -DZERKALO_FEW_KERNELS=${FEW_KERNELS} -DINTEGERS=${INTEGERS} ${launcher})
run(${CMAKE_COMMAND} --build ${BUILD} --parallel 2)
