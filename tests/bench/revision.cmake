# Writes the git revision as a header; run at every build, the file changes only with the revision.
# Variables: SOURCE, OUTPUT.
execute_process(COMMAND git -C ${SOURCE} describe --always --dirty --abbrev=12 --exclude=*
  OUTPUT_VARIABLE revision OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
if(NOT revision)
  set(revision unknown)
endif()
file(CONFIGURE OUTPUT ${OUTPUT} CONTENT [[// Made by tests/bench/revision.cmake.
#pragma once

namespace bench {
inline constexpr const char* kRevision = "@revision@";
}
]] @ONLY)
