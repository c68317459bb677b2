# The library once more for each level of x86-64 in COSURGE_LEVELS, where the system's loader finds it by itself on
# processors that have that level: lib/glibc-hwcaps/LEVEL/libcosurge.so. Its solvers are compiled for the level; the rest,
# which takes little of a run's time, is that of the library for all.
foreach(level ${COSURGE_LEVELS})
  set(flags -march=${level})
  if(level STREQUAL "x86-64-v3")
    list(APPEND flags ${COSURGE_MOVES_OF_AVX2})
  endif()
  set(objects)
  foreach(part ${COSURGE_PARTS})
    if(NOT part MATCHES "fluid|solid")
      list(APPEND objects $<TARGET_OBJECTS:${part}>)
      continue()
    endif()
    get_target_property(sources ${part} SOURCES)
    get_target_property(folder ${part} SOURCE_DIR)
    get_target_property(options ${part} COMPILE_OPTIONS)
    list(TRANSFORM sources PREPEND ${folder}/)
    add_library(${part}_${level} OBJECT ${sources})
    set_target_properties(${part}_${level} PROPERTIES POSITION_INDEPENDENT_CODE ON)
    target_compile_options(${part}_${level} PRIVATE ${flags} $<$<BOOL:${options}>:${options}>)
    target_link_libraries(${part}_${level} PRIVATE cosurge_common Spectra::Spectra)
    get_target_property(headers cosurge_common PRECOMPILE_HEADERS)
    target_precompile_headers(${part}_${level} PRIVATE ${headers})
    list(APPEND objects $<TARGET_OBJECTS:${part}_${level}>)
  endforeach()
  add_library(libcosurge_${level} SHARED ${objects})
  set_target_properties(libcosurge_${level} PROPERTIES OUTPUT_NAME cosurge LINKER_LANGUAGE CXX
    VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR}.${PROJECT_VERSION_MINOR}
    LIBRARY_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/${level})  # where no program of the build finds it
  target_link_libraries(libcosurge_${level} PRIVATE cosurge_coupler)
  target_link_options(libcosurge_${level} PRIVATE -Wl,-Bsymbolic-functions)
  install(TARGETS libcosurge_${level}
          LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/glibc-hwcaps/${level} COMPONENT cosurge NAMELINK_SKIP)
endforeach()
