# Proves that check_room_order.cmake fails on what it must: builds a small house with a wrong include.
#
#   cmake -D CHECK=cmake/check_room_order.cmake -D WORK_DIR=/some/folder -P cmake/check_room_order_test.cmake
cmake_minimum_required(VERSION 3.25)

function(expect description result message)
  execute_process(COMMAND ${CMAKE_COMMAND} -D SOURCE_DIR=${WORK_DIR} -P ${CHECK}
                  RESULT_VARIABLE code ERROR_VARIABLE text OUTPUT_VARIABLE ignored)
  # CMake wraps long messages: compare without line breaks.
  string(REGEX REPLACE "[ \n]+" " " text "${text}")
  if(result STREQUAL "passes" AND NOT code EQUAL 0)
    message(FATAL_ERROR "${description}: should pass, but: ${text}")
  elseif(result STREQUAL "fails" AND (code EQUAL 0 OR NOT text MATCHES "${message}"))
    message(FATAL_ERROR "${description}: should fail with \"${message}\", but gave ${code}: ${text}")
  endif()
endfunction()

file(REMOVE_RECURSE ${WORK_DIR})
file(WRITE ${WORK_DIR}/ROOMS "# a comment\ncore\narm\nio verification\n")
file(WRITE ${WORK_DIR}/core/units.h "#pragma once\n")
file(WRITE ${WORK_DIR}/arm/arm.cc "#include \"armcal/core/units.h\"\n#include <vector>\n")
expect("a house in order" passes "")

file(WRITE ${WORK_DIR}/core/bad.cc "#include \"armcal/arm/arm.h\"\n")
expect("an include upwards" fails "core/bad.cc: error: room 'core' may not include room 'arm'")

file(WRITE ${WORK_DIR}/core/bad.cc "")
file(WRITE ${WORK_DIR}/io/bad.h "  #  include <armcal/verification/x.h>\n")
expect("an include between neighbours" fails "io/bad.h: error: room 'io' may not include room 'verification'")

file(WRITE ${WORK_DIR}/io/bad.h "")
file(WRITE ${WORK_DIR}/core/units_test.cc "#include \"armcal/verification/x.h\"\n")
expect("tests may include anything" passes "")

file(WRITE ${WORK_DIR}/core/place.h "namespace armcal {\nstruct Place {\n};\nclass Far;\n}\n")
file(WRITE ${WORK_DIR}/arm/place.h "namespace armcal {\nclass Place final {\n};\nstruct Far {\n};\n}\n")
expect("two types of one name" fails "type 'Place' stands in src/armcal/")
file(WRITE ${WORK_DIR}/arm/place.h "namespace armcal::arms {\nclass Place final {\n};\n}\n")
expect("the same name in another namespace" passes "")

file(WRITE ${WORK_DIR}/attic/x.cc "")
expect("a room that nobody listed" fails "room 'attic' is not listed")
file(REMOVE_RECURSE ${WORK_DIR})
