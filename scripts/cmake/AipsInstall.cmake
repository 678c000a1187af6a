# What `cmake --install` puts in place: libraries and headers for host adapters (CMake package
# `aips` and aips.pc), the plugin SDK (lxs::sdk), the plugin modules and lxsrender; the manual, the
# licence, and the example of a host that the manual walks through.
include(CMakePackageConfigHelpers)

set(aips_cmake_dir ${CMAKE_INSTALL_LIBDIR}/cmake/aips)
set(aips_plugin_dir ${CMAKE_INSTALL_LIBDIR}/aips/plugins)

if(NOT AIPS_BUILD STREQUAL sdk)
  install(TARGETS aips_core aips_adapter aips_parts EXPORT aipsTargets)
  install(EXPORT aipsTargets NAMESPACE aips:: DESTINATION ${aips_cmake_dir})
  install(DIRECTORY
    ${PROJECT_SOURCE_DIR}/core-adapter/core/include/
    ${PROJECT_SOURCE_DIR}/core-adapter/adapter/include/
    ${PROJECT_SOURCE_DIR}/core-adapter/parts/include/
    DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.h")
  file(RELATIVE_PATH aips_prefix_from_pc
    /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
  configure_file(${CMAKE_CURRENT_LIST_DIR}/aips.pc.in ${PROJECT_BINARY_DIR}/aips.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/aips.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
endif()

# The manual keeps its place beside README.md, which links to it.
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE ${PROJECT_SOURCE_DIR}/README.md
  DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/docs DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(FILES ${PROJECT_SOURCE_DIR}/scenes/README.md DESTINATION ${CMAKE_INSTALL_DOCDIR}/scenes)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/tests/install/consumer/
  DESTINATION ${CMAKE_INSTALL_DOCDIR}/example)

if(TARGET lxs_sdk)
  install(TARGETS lxs_sdk EXPORT lxsTargets)
  install(EXPORT lxsTargets NAMESPACE lxs:: DESTINATION ${aips_cmake_dir})
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/host/sdk/include/
    DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
endif()
if(AIPS_BUILD STREQUAL all)
  install(TARGETS lxs_path aips LIBRARY DESTINATION ${aips_plugin_dir})
  install(TARGETS lxs_images_module LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/aips/images)
  if(AIPS_MPI)
    install(TARGETS lxs_mpi_module LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/aips/mpi)
  endif()
  install(TARGETS lxsrender lxsmerge)
  install(PROGRAMS ${PROJECT_SOURCE_DIR}/scripts/render-frames
    DESTINATION ${CMAKE_INSTALL_BINDIR})
endif()

configure_package_config_file(
  ${CMAKE_CURRENT_LIST_DIR}/aipsConfig.cmake.in ${PROJECT_BINARY_DIR}/aipsConfig.cmake
  INSTALL_DESTINATION ${aips_cmake_dir}
  PATH_VARS aips_plugin_dir)
write_basic_package_version_file(
  ${PROJECT_BINARY_DIR}/aipsConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES
  ${PROJECT_BINARY_DIR}/aipsConfig.cmake ${PROJECT_BINARY_DIR}/aipsConfigVersion.cmake
  DESTINATION ${aips_cmake_dir})
