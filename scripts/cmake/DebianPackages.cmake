# Debian packages, one for each component of AipsInstall.cmake: made by scripts/packages.
set(AIPS_MAINTAINER "aips-developers@lists.aips.invalid" CACHE STRING
  "Mail address of who makes the Debian packages")
mark_as_advanced(AIPS_MAINTAINER)
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_CONTACT "AIPS developers <${AIPS_MAINTAINER}>")
set(CPACK_PACKAGE_VENDOR AIPS)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_COMPONENTS_ALL)

# add_package(COMPONENT NAME SECTION SUMMARY DESCRIPTION): NAME.deb, with Debian's changelog and
# licence. What it depends on beside libraries is set by the caller.
macro(add_package component name section summary description)
  list(APPEND CPACK_COMPONENTS_ALL ${component})
  string(TOUPPER ${component} upper)
  set(CPACK_DEBIAN_${upper}_PACKAGE_NAME ${name})
  set(CPACK_DEBIAN_${upper}_PACKAGE_SECTION ${section})
  set(CPACK_COMPONENT_${upper}_DESCRIPTION "${summary}\n${description}")
  install(FILES ${PROJECT_BINARY_DIR}/debian/changelog.gz
    DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${name} COMPONENT ${component})
  install(FILES ${PROJECT_BINARY_DIR}/debian/copyright
    DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${name} COMPONENT ${component})
endmacro()

add_package(renderer lxsrender graphics
  "Renderer of LuxRender scenes with guided photons"
  "lxsrender renders scene files of LuxRender 1.x by photon mapping whose photons\nare guided to where the image still has error, after Liu and Zheng 2014, or by\npath tracing. lxsmerge merges renders of many machines.")
set(CPACK_DEBIAN_RENDERER_PACKAGE_RECOMMENDS "bash-completion, python3")

if(AIPS_MPI)
  add_package(mpi lxsrender-mpi graphics
    "Renderer of LuxRender scenes with guided photons - processes of one job"
    "The module of lxsrender --mpi, by which processes that mpirun has started\nrender one image together.")
  set(CPACK_DEBIAN_MPI_PACKAGE_DEPENDS "lxsrender (= ${PROJECT_VERSION})")
endif()

if(TARGET lxs_python)
  add_package(python python3-lxs python
    "Renderer of LuxRender scenes with guided photons - module of Python"
    "The module lxs, which renders scenes of LuxRender and pbrt within a program of\nPython and gives images, layers and statistics as numpy arrays and dicts.")
  # Modules are compiled for one version of Python.
  get_target_property(minor lxs_python LXS_PYTHON_MINOR)
  math(EXPR next "${minor} + 1")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS
    "lxsrender (= ${PROJECT_VERSION}), python3 (>= 3.${minor}), python3 (<< 3.${next}), python3-numpy")
  # They compile its sources, and take that away again.
  set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA
    ${CMAKE_CURRENT_LIST_DIR}/debian/postinst ${CMAKE_CURRENT_LIST_DIR}/debian/prerm)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_STRICT_PERMISSION ON)
endif()

add_package(dev libaips-dev libdevel
  "Engine of guided photons, and what plugins of lxsrender compile against"
  "Static libraries, headers, CMake and pkg-config files for renderers that link\nthe engine of adaptive importance photon shooting by its adapter, the SDK of\nlxsrender's plugins, and the manual.")
set(CPACK_DEBIAN_DEV_PACKAGE_DEPENDS "libboost-dev, libimath-dev, librandom123-dev, libtbb-dev")
set(CPACK_DEBIAN_DEV_PACKAGE_SHLIBDEPS OFF)

if(TARGET blender_addon)
  add_package(blender aips-blender graphics
    "Blender add-on that renders by lxsrender"
    "The file that Blender 3.4 and later installs as an add-on or an extension:\n/usr/share/aips/aips_blender.zip.")
  set(CPACK_DEBIAN_BLENDER_PACKAGE_ARCHITECTURE all)
  set(CPACK_DEBIAN_BLENDER_PACKAGE_SHLIBDEPS OFF)
  set(CPACK_DEBIAN_BLENDER_PACKAGE_RECOMMENDS "lxsrender, blender (>= 3.4)")
endif()

# What all of them have. Dated as the source says where that is known, else by the day.
string(TIMESTAMP AIPS_DATE "%a, %d %b %Y %H:%M:%S +0000" UTC)
configure_file(${CMAKE_CURRENT_LIST_DIR}/debian/changelog.in
  ${PROJECT_BINARY_DIR}/debian/changelog @ONLY)
configure_file(${CMAKE_CURRENT_LIST_DIR}/debian/copyright
  ${PROJECT_BINARY_DIR}/debian/copyright COPYONLY)
find_program(AIPS_GZIP gzip REQUIRED)
execute_process(COMMAND ${AIPS_GZIP} -9nkf ${PROJECT_BINARY_DIR}/debian/changelog
  COMMAND_ERROR_IS_FATAL ANY)

include(CPack)
