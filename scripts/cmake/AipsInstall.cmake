# What `cmake --install` puts in place, by component:
# - renderer: lxsrender and lxsmerge with their modules, man pages and completion of bash, scenes;
# - mpi: the module of --mpi;
# - python: the package `lxs`, which finds the modules of the component renderer;
# - dev: libraries and headers for host adapters (CMake package `aips` and aips.pc), the plugin SDK
#   (lxs::sdk), the manual, and the example of a host that it walks through;
# - blender: the add-on, as Blender installs it.
include(CMakePackageConfigHelpers)

set(aips_cmake_dir ${CMAKE_INSTALL_LIBDIR}/cmake/aips)
set(aips_plugin_dir ${CMAKE_INSTALL_LIBDIR}/aips/plugins)

if(NOT AIPS_BUILD STREQUAL sdk)
  install(TARGETS aips_core aips_adapter aips_parts EXPORT aipsTargets COMPONENT dev)
  install(EXPORT aipsTargets NAMESPACE aips:: DESTINATION ${aips_cmake_dir} COMPONENT dev)
  install(DIRECTORY
    ${PROJECT_SOURCE_DIR}/core-adapter/core/include/
    ${PROJECT_SOURCE_DIR}/core-adapter/adapter/include/
    ${PROJECT_SOURCE_DIR}/core-adapter/parts/include/
    DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT dev FILES_MATCHING PATTERN "*.h")
  file(RELATIVE_PATH aips_prefix_from_pc
    /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
  configure_file(${CMAKE_CURRENT_LIST_DIR}/aips.pc.in ${PROJECT_BINARY_DIR}/aips.pc @ONLY)
  install(FILES ${PROJECT_BINARY_DIR}/aips.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig
    COMPONENT dev)
endif()

# The manual keeps its place beside README.md, which links to it.
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE ${PROJECT_SOURCE_DIR}/README.md
  ${PROJECT_SOURCE_DIR}/CITATION.cff DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT dev)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/docs DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT dev
  PATTERN notebook EXCLUDE)
install(FILES ${PROJECT_SOURCE_DIR}/scenes/README.md DESTINATION ${CMAKE_INSTALL_DOCDIR}/scenes
  COMPONENT dev)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/tests/install/consumer/
  DESTINATION ${CMAKE_INSTALL_DOCDIR}/example COMPONENT dev)

if(TARGET lxs_sdk)
  install(TARGETS lxs_sdk EXPORT lxsTargets COMPONENT dev)
  install(EXPORT lxsTargets NAMESPACE lxs:: DESTINATION ${aips_cmake_dir} COMPONENT dev)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/host/sdk/include/
    DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} COMPONENT dev)
endif()
if(AIPS_BUILD STREQUAL all)
  install(TARGETS lxs_path aips LIBRARY DESTINATION ${aips_plugin_dir} COMPONENT renderer)
  install(TARGETS lxs_images_module
    LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/aips/images COMPONENT renderer)
  if(AIPS_MPI)
    install(TARGETS lxs_mpi_module
      LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}/aips/mpi COMPONENT mpi)
  endif()
  install(TARGETS lxsrender lxsmerge COMPONENT renderer)
  if(TARGET lxs_python)
    install(TARGETS lxs_python LIBRARY DESTINATION ${LXS_PYTHON_DIR}/lxs COMPONENT python)
    install(DIRECTORY ${PROJECT_SOURCE_DIR}/host/python/lxs DESTINATION ${LXS_PYTHON_DIR}
      COMPONENT python PATTERN __pycache__ EXCLUDE)
  endif()
  install(PROGRAMS ${PROJECT_SOURCE_DIR}/scripts/render-frames
    DESTINATION ${CMAKE_INSTALL_BINDIR} COMPONENT renderer)
  install(DIRECTORY ${PROJECT_SOURCE_DIR}/scenes DESTINATION ${CMAKE_INSTALL_DATADIR}/aips
    COMPONENT renderer FILES_MATCHING PATTERN "*.lxs" PATTERN "meshes/*" PATTERN generate EXCLUDE)
  install(FILES ${PROJECT_SOURCE_DIR}/host/app/completion/lxsrender
    DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions COMPONENT renderer)
  install(FILES ${PROJECT_SOURCE_DIR}/host/app/completion/lxsrender RENAME lxsmerge
    DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions COMPONENT renderer)
  include(ManPages)
  find_program(AIPS_PYTHON_PROGRAM python3)
  if(AIPS_PYTHON_PROGRAM)
    set(addon ${PROJECT_BINARY_DIR}/aips_blender.zip)
    file(GLOB_RECURSE addon_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/host/blender/*)
    add_custom_command(OUTPUT ${addon}
      COMMAND ${AIPS_PYTHON_PROGRAM} -B ${PROJECT_SOURCE_DIR}/scripts/blender-addon -o ${addon}
      DEPENDS ${addon_sources} ${PROJECT_SOURCE_DIR}/scripts/blender-addon
      COMMENT "Add-on for Blender"
      VERBATIM)
    add_custom_target(blender_addon ALL DEPENDS ${addon})
    install(FILES ${addon} DESTINATION ${CMAKE_INSTALL_DATADIR}/aips COMPONENT blender)
  endif()
endif()

configure_package_config_file(
  ${CMAKE_CURRENT_LIST_DIR}/aipsConfig.cmake.in ${PROJECT_BINARY_DIR}/aipsConfig.cmake
  INSTALL_DESTINATION ${aips_cmake_dir}
  PATH_VARS aips_plugin_dir)
write_basic_package_version_file(
  ${PROJECT_BINARY_DIR}/aipsConfigVersion.cmake COMPATIBILITY SameMajorVersion)
install(FILES
  ${PROJECT_BINARY_DIR}/aipsConfig.cmake ${PROJECT_BINARY_DIR}/aipsConfigVersion.cmake
  DESTINATION ${aips_cmake_dir} COMPONENT dev)

if(AIPS_BUILD STREQUAL all)
  include(DebianPackages)
endif()
