# armcal_room(NAME FILES a b c... [LINKS rooms and libraries] [PRIVATE_LINKS libraries used by sources only])
#
# One static library per room. FILES names ideas, not files: `circle` stands for circle.h, circle.cc and
# circle_test.cc, whichever of them exist; at least one must. Tests of a room make one test program.

add_custom_target(room_order ALL
  COMMAND ${CMAKE_COMMAND} -D SOURCE_DIR=${PROJECT_SOURCE_DIR}/src/armcal
          -P ${PROJECT_SOURCE_DIR}/cmake/check_room_order.cmake
  COMMENT "Checking the order of dependency between rooms" VERBATIM)

# Headers that nearly every source includes, parsed once. Each file still includes what it uses: the install test
# compiles the public headers without these.
add_library(armcal_common_headers OBJECT EXCLUDE_FROM_ALL ${PROJECT_SOURCE_DIR}/cmake/precompiled.cc)
target_precompile_headers(armcal_common_headers PRIVATE
  <Eigen/Core> <algorithm> <functional> <map> <nlohmann/json.hpp> <optional> <string> <vector>)
target_link_libraries(armcal_common_headers PRIVATE armcal_compiler armcal_watched Eigen3::Eigen)

function(armcal_room name)
  cmake_parse_arguments(ROOM "" "" "FILES;LINKS;PRIVATE_LINKS" ${ARGN})
  set(sources "")
  set(tests "")
  foreach(idea IN LISTS ROOM_FILES)
    set(found FALSE)
    foreach(suffix .h .cc _test.cc)
      set(path ${CMAKE_CURRENT_SOURCE_DIR}/${idea}${suffix})
      if(EXISTS ${path})
        set(found TRUE)
        if(suffix STREQUAL "_test.cc")
          list(APPEND tests ${path})
        else()
          list(APPEND sources ${path})
        endif()
      endif()
    endforeach()
    if(NOT found)
      message(FATAL_ERROR "room ${name}: no file for '${idea}'")
    endif()
  endforeach()

  add_library(armcal_${name} STATIC ${sources})
  add_library(armcal::${name} ALIAS armcal_${name})
  set_target_properties(armcal_${name} PROPERTIES EXPORT_NAME ${name} LINKER_LANGUAGE CXX)
  target_include_directories(armcal_${name} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/src>
    $<BUILD_INTERFACE:${PROJECT_BINARY_DIR}/generated>
    $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  target_compile_features(armcal_${name} PUBLIC cxx_std_20)
  target_link_libraries(armcal_${name}
    PUBLIC ${ROOM_LINKS}
    PRIVATE $<BUILD_INTERFACE:armcal_compiler> $<BUILD_INTERFACE:armcal_watched> ${ROOM_PRIVATE_LINKS})
  target_precompile_headers(armcal_${name} REUSE_FROM armcal_common_headers)
  add_dependencies(armcal_${name} room_order)
  set_property(GLOBAL APPEND PROPERTY ARMCAL_ROOMS armcal_${name})

  if(ARMCAL_TESTS AND tests)
    add_executable(armcal_${name}_test ${tests})
    target_precompile_headers(armcal_${name}_test REUSE_FROM armcal_test_headers)
    target_link_libraries(armcal_${name}_test PRIVATE
      armcal_${name} armcal_testing armcal_compiler rapidcheck rapidcheck_gtest GTest::gmock GTest::gtest_main)
    if(ARMCAL_SANITIZERS)
      # Of inline functions the linker keeps the copy that it meets first: that of the room, which is watched.
      target_link_options(armcal_${name}_test PRIVATE
        -Wl,--whole-archive $<TARGET_FILE:armcal_${name}> -Wl,--no-whole-archive)
    endif()
    add_test(NAME ${name} COMMAND armcal_${name}_test)
    # Rooms use those before them, so the tests of later ones take longer: ctest begins with these.
    get_property(rooms GLOBAL PROPERTY ARMCAL_ROOMS)
    list(LENGTH rooms rooms_so_far)
    set_tests_properties(${name} PROPERTIES TIMEOUT 900 COST ${rooms_so_far})
  endif()
endfunction()
