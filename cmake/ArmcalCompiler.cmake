# One interface target carries everything that each room and test is compiled with.

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/bin)

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Build type" FORCE)
endif()

find_program(ARMCAL_CCACHE ccache)
if(ARMCAL_CCACHE)
  # Wherever the clone lies, and with precompiled headers, which ccache leaves alone unless told.
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_BASEDIR=${PROJECT_SOURCE_DIR} CCACHE_NOHASHDIR=1
    CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime ${ARMCAL_CCACHE})
endif()

add_library(armcal_compiler INTERFACE)
target_compile_options(armcal_compiler INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wsign-conversion -Wnon-virtual-dtor -Wold-style-cast
  # Members left out of a designated initialiser have their defaults: that is what it is for.
  -Wno-missing-field-initializers
  # GCC 12 sees impossible copies inside std::string where it inlines much (GCC bugs 105329 and 105651), and members
  # that nobody set in the unused half of a std::variant or std::optional.
  "$<$<CXX_COMPILER_ID:GNU>:-Wno-stringop-overflow;-Wno-restrict;-Wno-maybe-uninitialized>"
  # What ccache needs to see through a precompiled header.
  $<$<AND:$<CXX_COMPILER_ID:GNU>,$<BOOL:${ARMCAL_CCACHE}>>:-fpch-preprocess>
  # The same readings must give the same digits on every build: no fused multiply-add behind our back.
  -ffp-contract=off)
if(ARMCAL_WERROR)
  target_compile_options(armcal_compiler INTERFACE -Werror)
endif()
# Sanitizers watch what is released, not the tests: instrumented, they take twice as long to compile.
add_library(armcal_watched INTERFACE)
if(ARMCAL_SANITIZERS)
  # Left out: checks that AddressSanitizer makes as well, or that x86 does not need; they double the
  # compile time of every file that uses Eigen.
  target_compile_options(armcal_watched INTERFACE
    -fsanitize=address,undefined -fno-sanitize=null,alignment,object-size,vptr
    -fno-sanitize-recover=all -fno-omit-frame-pointer
    # Marks the scope of every temporary of every expression of Eigen: a sixth of the compile time.
    -fno-sanitize-address-use-after-scope)
  target_link_options(armcal_compiler INTERFACE -fsanitize=address,undefined)
  # Where Eigen sees AddressSanitizer it shifts what it allocates; libraries that were compiled without (Ceres) do
  # not, and free what we allocate. Memory is aligned as it comes.
  target_compile_definitions(armcal_compiler INTERFACE EIGEN_MALLOC_ALREADY_ALIGNED=1)
endif()
if(ARMCAL_FUZZERS)
  # The fuzzer steers by the branches that an input takes.
  target_compile_options(armcal_compiler INTERFACE -fsanitize=fuzzer-no-link)
endif()
