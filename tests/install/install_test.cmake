# Script of the test install.consumer; the variables are given on the command line.
cmake_minimum_required(VERSION 3.25)
set(prefix ${work_dir}/prefix)
set(flags)
if(sanitize)
  set(flags -fsanitize=${sanitize})
endif()
set(host OFF)
if(built STREQUAL all)
  set(host ON)
endif()

# run(COMMAND...): the test fails if the command does; its output is left in `output`.
function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE out ERROR_VARIABLE err)
  if(NOT result EQUAL 0)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "'${command}' failed (${result}):\n${out}${err}")
  endif()
  set(output "${out}" PARENT_SCOPE)
endfunction()

# The example renders its image, in which something is to be seen.
function(run_example program)
  file(REMOVE ${work_dir}/caustic.ppm)
  execute_process(COMMAND ${program} WORKING_DIRECTORY ${work_dir}
    RESULT_VARIABLE result OUTPUT_VARIABLE out ERROR_VARIABLE err)
  # Warnings and findings of validate_host() go to the error stream.
  if(NOT result EQUAL 0 OR NOT err STREQUAL "")
    message(FATAL_ERROR "${program} failed (${result}):\n${out}${err}")
  endif()
  file(SIZE ${work_dir}/caustic.ppm size)
  file(READ ${work_dir}/caustic.ppm pixels OFFSET 15 HEX)
  if(NOT size EQUAL 57615 OR NOT pixels MATCHES "ff" OR pixels MATCHES "^f*$")
    message(FATAL_ERROR "${program}: caustic.ppm (${size} bytes) is no picture of 160 x 120")
  endif()
endfunction()

file(REMOVE_RECURSE ${work_dir})
run(${CMAKE_COMMAND} --install ${build_dir} --prefix ${prefix})
# Moved after installation: nothing in it may name the place where it was installed first.
file(RENAME ${prefix} ${work_dir}/moved)
set(prefix ${work_dir}/moved)

foreach(file LICENSE README.md docs/build-on/host-adapter.md docs/images/glass-ball.png
    example/consumer.cpp example/plugin.cpp scenes/README.md)
  if(NOT EXISTS ${prefix}/${docdir}/${file})
    message(FATAL_ERROR "${file} is not installed in ${docdir}")
  endif()
endforeach()

# build_consumer(PREFIX FOLDER OPTIONS...): builds the example, as it is installed, in the folder.
set(consumer_dir ${prefix}/${docdir}/example)
function(build_consumer package folder)
  run(${CMAKE_COMMAND} -S ${consumer_dir} -B ${folder} -G Ninja -DCMAKE_BUILD_TYPE=Release
    -DCMAKE_CXX_COMPILER=${compiler} -DCMAKE_CXX_FLAGS=${flags} -DCMAKE_PREFIX_PATH=${package}
    ${ARGN})
  run(${CMAKE_COMMAND} --build ${folder})
endfunction()
build_consumer(${prefix} ${work_dir}/build -DWITH_SDK=${host})
run_example(${work_dir}/build/consumer)

find_program(pkg_config NAMES pkg-config pkgconf REQUIRED)
set(ENV{PKG_CONFIG_PATH} ${prefix}/${libdir}/pkgconfig)
run(${pkg_config} --cflags --libs aips)
separate_arguments(package_flags UNIX_COMMAND "${output}")
run(${compiler} ${flags} ${consumer_dir}/consumer.cpp -o ${work_dir}/pkg_config_consumer
  ${package_flags})
run_example(${work_dir}/pkg_config_consumer)

if(NOT host)
  return()
endif()
# The installed renderer finds the installed plugins, also after the move, and a module that was
# built against the installed SDK: where that is told, and where its project installs it.
function(expect_plugins)
  run(${prefix}/${bindir}/lxsrender --list-plugins ${ARGN})
  foreach(name aips path consumer)
    if(NOT output MATCHES "(^|\n)${name} ")
      message(FATAL_ERROR "lxsrender --list-plugins ${ARGN} does not list '${name}':\n${output}")
    endif()
  endforeach()
endfunction()
expect_plugins(--plugin-path ${work_dir}/build/plugins)
run(${CMAKE_COMMAND} --install ${work_dir}/build)
expect_plugins()
file(GLOB installed ${prefix}/${libdir}/aips/plugins/*consumer*)
file(REMOVE ${installed})

# The SDK alone, built where nothing of the engine and of the renderer is.
set(absent)
foreach(package TBB embree OpenEXR fmt spdlog CLI11 pegtl nlohmann_json GTest)
  list(APPEND absent -DCMAKE_DISABLE_FIND_PACKAGE_${package}=ON)
endforeach()
run(${CMAKE_COMMAND} -S ${source_dir} -B ${work_dir}/sdk_build -G Ninja -DAIPS_BUILD=sdk
  -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_COMPILER=${compiler} -DCMAKE_CXX_FLAGS=${flags} ${absent}
  -DCMAKE_INSTALL_LIBDIR=${libdir})
run(${CMAKE_COMMAND} --build ${work_dir}/sdk_build)
run(${CMAKE_COMMAND} --install ${work_dir}/sdk_build --prefix ${work_dir}/sdk)
build_consumer(${work_dir}/sdk ${work_dir}/sdk_consumer -DWITH_ENGINE=OFF -DWITH_SDK=ON)
expect_plugins(--plugin-path ${work_dir}/sdk_consumer/plugins)
