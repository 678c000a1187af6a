# Finds OpenImageIO for the including folder.
find_package(OpenImageIO CONFIG REQUIRED)
# The packaged target names the headers of OpenCV, which need not be installed.
get_target_property(oiio_includes OpenImageIO::OpenImageIO INTERFACE_INCLUDE_DIRECTORIES)
list(REMOVE_ITEM oiio_includes /usr/include/opencv4)
set_target_properties(OpenImageIO::OpenImageIO PROPERTIES
  INTERFACE_INCLUDE_DIRECTORIES "${oiio_includes}" INTERFACE_SYSTEM_INCLUDE_DIRECTORIES "")
