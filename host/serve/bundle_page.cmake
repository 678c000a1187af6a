# Run by the build: bundles the page of --serve into PAGE, or puts a stand-in there where npm cannot
# fetch its packages: who builds without a network gets everything but the page.
#     cmake -DNPM=... -DSOURCE=... -DPACKAGES=... -DPAGE=... -P bundle_page.cmake
set(installed ${PACKAGES}/node_modules/.package-lock.json)
set(failed 0)
if(${SOURCE}/package-lock.json IS_NEWER_THAN ${installed})
  file(COPY ${SOURCE}/package.json ${SOURCE}/package-lock.json ${SOURCE}/.npmrc
    DESTINATION ${PACKAGES})
  execute_process(
    COMMAND ${NPM} ci --prefer-offline --ignore-scripts --no-audit --no-fund --loglevel=error
    WORKING_DIRECTORY ${PACKAGES}
    RESULT_VARIABLE failed)
endif()
if(failed)
  message(WARNING "npm could not fetch the packages of the page: lxsrender is built without --serve."
    " Remove ${PAGE} to try again.")
  configure_file(${SOURCE}/src/no_page.cpp ${PAGE} COPYONLY)
  return()
endif()
execute_process(COMMAND ${NPM} run --silent build -- ${PACKAGES} ${PAGE}
  WORKING_DIRECTORY ${SOURCE}
  COMMAND_ERROR_IS_FATAL ANY)
