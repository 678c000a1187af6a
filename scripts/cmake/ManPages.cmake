# Man pages of the programs, made by help2man of what `--help` prints; left out without it.
find_program(AIPS_HELP2MAN help2man)
find_program(AIPS_GZIP gzip)
if(NOT AIPS_HELP2MAN OR NOT AIPS_GZIP)
  return()
endif()

# add_man_page(PROGRAM FILE SUMMARY): PROGRAM.1 of what FILE prints, built with everything and
# installed.
function(add_man_page program file summary)
  set(page ${PROJECT_BINARY_DIR}/man/${program}.1)
  add_custom_command(OUTPUT ${page}.gz
    COMMAND ${AIPS_HELP2MAN} --no-info --version-string=${PROJECT_VERSION} --name=${summary}
      --output=${page} ${file}
    COMMAND ${AIPS_GZIP} -9nf ${page}
    DEPENDS ${file}
    COMMENT "Man page of ${program}"
    VERBATIM)
  add_custom_target(man_${program} ALL DEPENDS ${page}.gz)
  install(FILES ${page}.gz DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT renderer)
endfunction()

file(MAKE_DIRECTORY ${PROJECT_BINARY_DIR}/man)
add_man_page(lxsrender $<TARGET_FILE:lxsrender>
  "render a LuxRender scene by guided photons or path tracing")
add_man_page(lxsmerge $<TARGET_FILE:lxsmerge> "merge renders of one scene into one image")
add_man_page(render-frames ${PROJECT_SOURCE_DIR}/scripts/render-frames
  "render the frames of an animation with lxsrender")
