# The library once more for each level of x86-64 in COSURGE_LEVELS, where the system's loader finds it by itself on
# processors that have that level: lib/glibc-hwcaps/LEVEL/libcosurge.so.
include(ExternalProject)
foreach(level ${COSURGE_LEVELS})
  set(binary ${PROJECT_BINARY_DIR}/${level})
  ExternalProject_Add(cosurge_${level}
    SOURCE_DIR ${PROJECT_SOURCE_DIR}
    BINARY_DIR ${binary}
    CMAKE_ARGS -DCMAKE_BUILD_TYPE=${CMAKE_BUILD_TYPE} -DCMAKE_CXX_FLAGS=-march=${level} -DCOSURGE_NATIVE=OFF
      -DCOSURGE_LEVELS= -DCOSURGE_TESTS=OFF -DCOSURGE_BENCHMARKS=OFF -DCOSURGE_MAN=OFF
      -DCMAKE_CXX_COMPILER=${CMAKE_CXX_COMPILER} -DCMAKE_CXX_COMPILER_LAUNCHER=${CMAKE_CXX_COMPILER_LAUNCHER}
      -DCMAKE_INSTALL_PREFIX=${CMAKE_INSTALL_PREFIX}
    BUILD_COMMAND ${CMAKE_COMMAND} --build <BINARY_DIR> --target libcosurge
    INSTALL_COMMAND ""
    BUILD_ALWAYS ON
    USES_TERMINAL_BUILD ON)
  # Under the name that programs ask for; links are of no use there.
  set(soname libcosurge.so.${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR})
  install(PROGRAMS ${binary}/lib/libcosurge.so.${PROJECT_VERSION} RENAME ${soname} COMPONENT cosurge
          DESTINATION ${CMAKE_INSTALL_LIBDIR}/glibc-hwcaps/${level})
endforeach()
