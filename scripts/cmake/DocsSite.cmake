# Target `docs-site`: the manual (docs/) as a searchable site in BUILD/docs-site, made by MkDocs.
find_program(AIPS_MKDOCS mkdocs DOC "MkDocs, for the manual's site")
if(AIPS_MKDOCS)
  add_custom_target(docs-site
    COMMAND ${CMAKE_COMMAND} -E env PYTHONDONTWRITEBYTECODE=1
      ${AIPS_MKDOCS} build --strict --clean
      --config-file ${PROJECT_SOURCE_DIR}/scripts/manual/mkdocs.yml
      --site-dir ${PROJECT_BINARY_DIR}/docs-site
    COMMENT "The manual: ${PROJECT_BINARY_DIR}/docs-site/index.html"
    VERBATIM)
endif()
