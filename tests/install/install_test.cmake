# Script of the test install.consumer; the variables are given on the command line.
cmake_minimum_required(VERSION 3.25)
set(prefix ${work_dir}/prefix)
set(flags)
if(sanitize)
  set(flags -fsanitize=${sanitize})
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
  # Warnings and findings of check_host() go to the error stream.
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

# What is built is the example as it is installed.
set(consumer_dir ${prefix}/${docdir}/example)
run(${CMAKE_COMMAND} -S ${consumer_dir} -B ${work_dir}/build -G Ninja -DCMAKE_BUILD_TYPE=Release
  -DCMAKE_CXX_COMPILER=${compiler} -DCMAKE_CXX_FLAGS=${flags} -DCMAKE_PREFIX_PATH=${prefix}
  -DWITH_SDK=${host})
run(${CMAKE_COMMAND} --build ${work_dir}/build)
run_example(${work_dir}/build/consumer)

find_program(pkg_config NAMES pkg-config pkgconf REQUIRED)
set(ENV{PKG_CONFIG_PATH} ${prefix}/${libdir}/pkgconfig)
run(${pkg_config} --cflags --libs aips)
separate_arguments(package_flags UNIX_COMMAND "${output}")
run(${compiler} ${flags} ${consumer_dir}/consumer.cpp -o ${work_dir}/pkg_config_consumer
  ${package_flags})
run_example(${work_dir}/pkg_config_consumer)

if(host)
  # The installed renderer finds the installed plugins, also after the move, and a module that was
  # built against the installed SDK.
  run(${prefix}/${bindir}/lxsrender --list-plugins --plugin-path ${work_dir}/build/plugins)
  foreach(name aips path consumer)
    if(NOT output MATCHES "(^|\n)${name} ")
      message(FATAL_ERROR "lxsrender --list-plugins does not list '${name}':\n${output}")
    endif()
  endforeach()
endif()
