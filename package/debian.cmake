# Packages for Debian: cpack -G DEB, or scripts/package.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_VENDOR "Cosurge")
set(CPACK_PACKAGE_CONTACT "Cosurge maintainers")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "wave impacts on elastic structures")
set(CPACK_PACKAGING_INSTALL_PREFIX ${CMAKE_INSTALL_PREFIX})
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR})
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL cosurge cosurge-dev)
set(CPACK_COMPONENT_COSURGE_DESCRIPTION
    "Free-surface water by the particle method MPS, elastic structures, and the coupler that runs them together.")
set(CPACK_COMPONENT_COSURGE-DEV_DESCRIPTION "Headers of libcosurge, its CMake package and its pkg-config file.")
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_COSURGE_PACKAGE_NAME cosurge)
set(CPACK_DEBIAN_COSURGE_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_COSURGE_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS ${CMAKE_LIBRARY_OUTPUT_DIRECTORY})
set(CPACK_DEBIAN_COSURGE_PACKAGE_DEPENDS "fonts-dejavu-core")  # letters of pictures
# Videos; cases/foreign_solid.
set(CPACK_DEBIAN_COSURGE_PACKAGE_RECOMMENDS "ffmpeg, python3, python3-zmq, python3-protobuf")
set(CPACK_DEBIAN_COSURGE-DEV_PACKAGE_NAME libcosurge-dev)
set(CPACK_DEBIAN_COSURGE-DEV_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_COSURGE-DEV_PACKAGE_DEPENDS "cosurge (= ${PROJECT_VERSION}), libeigen3-dev")
set(CPACK_DEBIAN_COSURGE-DEV_PACKAGE_SUGGESTS "libprotobuf-dev")  # cosurge/case.pb.h
include(CPack)
