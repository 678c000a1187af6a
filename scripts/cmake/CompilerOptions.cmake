# Options that every target of the project shares: standard, warnings, sanitizers, host tuning.
option(AIPS_WERROR "Treat warnings as errors (CI does)" OFF)
option(AIPS_FUZZ "Build for coverage-guided fuzzing, with the sanitizers (docs/build-on/testing.md; needs clang)" OFF)
option(AIPS_NATIVE "Tune for this machine's processor (-march=native)" OFF)
option(AIPS_UNITY "Compile files in batches (docs/build-on/building.md)" OFF)
option(AIPS_RECORD_WORK "Record parallel loops for scripts/scaling (docs/measured/scaling.md)" OFF)
set(CMAKE_UNITY_BUILD_BATCH_SIZE 16)
if(AIPS_UNITY)
  # Batches take more memory anyway: less of g++'s time for collecting it, and a faster linker.
  add_compile_options($<$<CXX_COMPILER_ID:GNU>:--param=ggc-min-heapsize=524288>)
  include(CheckLinkerFlag)
  check_linker_flag(CXX -fuse-ld=gold AIPS_HAS_GOLD)
  if(AIPS_HAS_GOLD)
    add_link_options(-fuse-ld=gold)
  endif()
endif()
set(AIPS_SANITIZE "" CACHE STRING "Sanitizers, e.g. address,undefined or thread")

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_CXX_VISIBILITY_PRESET hidden)
set(CMAKE_VISIBILITY_INLINES_HIDDEN ON)

if(AIPS_SANITIZE)
  # GCC's warning of uninitialised values is at fault in instrumented code (std::regex).
  add_compile_options(-fsanitize=${AIPS_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all
    $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
  add_link_options(-fsanitize=${AIPS_SANITIZE})
  if(AIPS_SANITIZE MATCHES thread)
    # A parallel_for that the sanitizer understands, before oneTBB's (docs/build-on/testing.md).
    include_directories(BEFORE ${CMAKE_CURRENT_SOURCE_DIR}/tests/thread_sanitizer)
  endif()
endif()
if(AIPS_FUZZ)
  if(NOT CMAKE_CXX_COMPILER_ID STREQUAL Clang)
    message(FATAL_ERROR "AIPS_FUZZ needs clang; other compilers build tests/fuzz as replayers")
  endif()
  # Guards of containers and assertions count as findings too.
  add_compile_options(-fsanitize=fuzzer-no-link,address,undefined -fno-omit-frame-pointer
    -fno-sanitize-recover=all -D_GLIBCXX_ASSERTIONS -UNDEBUG)
  add_link_options(-fsanitize=address,undefined)
endif()

# Hardening of release builds: what costs less than 1 % of a render's instructions
# (docs/build-on/building.md). A stack protector for all would cost 1.5 to 2.3 %: AIPS_STACK_PROTECTOR
# is for what reads files and what comes from a network.
set(AIPS_HARDENING "")
set(AIPS_STACK_PROTECTOR "")
if(NOT AIPS_SANITIZE AND NOT AIPS_FUZZ)
  add_link_options($<$<CONFIG:Release>:LINKER:-z,relro,-z,now>)
  set(AIPS_HARDENING $<$<CONFIG:Release>:-U_FORTIFY_SOURCE> $<$<CONFIG:Release>:-D_FORTIFY_SOURCE=2>)
  set(AIPS_STACK_PROTECTOR $<$<CONFIG:Release>:-fstack-protector-strong>)
  include(CheckCXXCompilerFlag)
  check_cxx_compiler_flag(-fcf-protection AIPS_HAS_CF_PROTECTION)  # of x86
  if(AIPS_HAS_CF_PROTECTION)
    list(APPEND AIPS_HARDENING $<$<CONFIG:Release>:-fcf-protection>)
  endif()
endif()

# From version 13 on g++ takes what an empty std::optional would hold for uninitialised.
set(false_warnings $<$<AND:$<CXX_COMPILER_ID:GNU>,$<VERSION_GREATER_EQUAL:$<CXX_COMPILER_VERSION>,13>>:-Wno-maybe-uninitialized>)

add_library(aips_compile_options INTERFACE)
target_compile_options(aips_compile_options INTERFACE -Wall -Wextra -Wpedantic -Wshadow
  -Wnon-virtual-dtor -Woverloaded-virtual -fno-math-errno -ffp-contract=off
  $<$<BOOL:${AIPS_WERROR}>:-Werror> ${false_warnings}
  $<$<BOOL:${AIPS_NATIVE}>:-march=native>)
