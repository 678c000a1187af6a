# Script of the test install.consumer; the variables are given on the command line.
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

file(REMOVE_RECURSE ${work_dir})
run(${CMAKE_COMMAND} --install ${build_dir} --prefix ${prefix})
# Moved after installation: nothing in it may name the place where it was installed first.
file(RENAME ${prefix} ${work_dir}/moved)
set(prefix ${work_dir}/moved)

run(${CMAKE_COMMAND} -S ${consumer_dir} -B ${work_dir}/build -G Ninja -DCMAKE_BUILD_TYPE=Release
  -DCMAKE_CXX_COMPILER=${compiler} -DCMAKE_CXX_FLAGS=${flags} -DCMAKE_PREFIX_PATH=${prefix}
  -DWITH_SDK=${host})
run(${CMAKE_COMMAND} --build ${work_dir}/build)
run(${work_dir}/build/consumer)

find_program(pkg_config NAMES pkg-config pkgconf REQUIRED)
set(ENV{PKG_CONFIG_PATH} ${prefix}/${libdir}/pkgconfig)
run(${pkg_config} --cflags --libs aips)
separate_arguments(package_flags UNIX_COMMAND "${output}")
run(${compiler} ${flags} ${consumer_dir}/consumer.cpp -o ${work_dir}/pkg_config_consumer
  ${package_flags})
run(${work_dir}/pkg_config_consumer)

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
