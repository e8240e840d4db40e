# Scripts of reports (web/report): bundled into one file, which is embedded like the other assets. They need Node and npm
# at build time and nothing at run time. Without them a build makes the same reports, whose drawings do not move.
#
#   ARMCAL_REPORT_SCRIPT   path of the bundle; empty: this build has none
#   ARMCAL_WEB_DIR         copy of web/report with its node_modules: nothing is installed into the source tree

set(ARMCAL_REPORT_SCRIPTS AUTO CACHE STRING "Scripts in reports: AUTO (where Node is), ON, OFF")
set_property(CACHE ARMCAL_REPORT_SCRIPTS PROPERTY STRINGS AUTO ON OFF)
set(ARMCAL_WEB_DIR ${PROJECT_BINARY_DIR}/web)
set(ARMCAL_REPORT_SCRIPT "")

function(armcal_no_report_script why)
  if(ARMCAL_REPORT_SCRIPTS STREQUAL "ON")
    message(FATAL_ERROR "Scripts for reports: ${why}")
  endif()
  message(STATUS "Reports without scripts: ${why}")
endfunction()

# node_modules as the lock file says; again when that has changed.
function(armcal_install_web_packages problem)
  file(SHA256 ${ARMCAL_WEB_DIR}/package-lock.json wanted)
  set(wanted "${wanted} tests ${ARMCAL_TESTS}")
  set(stamp ${ARMCAL_WEB_DIR}/node_modules/.armcal)
  set(installed "")
  if(EXISTS ${stamp})
    file(READ ${stamp} installed)
  endif()
  if(installed STREQUAL wanted)
    return()
  endif()
  message(STATUS "Installing packages for the scripts of reports")
  set(without "")
  if(NOT ARMCAL_TESTS)
    set(without --omit=dev)
  endif()
  execute_process(
    COMMAND ${ARMCAL_NPM} ci ${without} --ignore-scripts --no-audit --no-fund --loglevel=error
            --fetch-retries=1 --fetch-timeout=30000
    WORKING_DIRECTORY ${ARMCAL_WEB_DIR} TIMEOUT 240 RESULT_VARIABLE failed OUTPUT_QUIET ERROR_VARIABLE errors)
  if(failed)
    string(REGEX MATCH "[^\n]*" first "${errors}")
    set(${problem} "npm ci failed (${failed}) ${first}" PARENT_SCOPE)
    return()
  endif()
  file(WRITE ${stamp} "${wanted}")
endfunction()

function(armcal_bundle_report_script)
  file(GLOB_RECURSE sources ${PROJECT_SOURCE_DIR}/web/report/*)
  list(FILTER sources EXCLUDE REGEX /node_modules/)
  set_property(DIRECTORY ${PROJECT_SOURCE_DIR} APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${sources})
  file(REMOVE_RECURSE ${ARMCAL_WEB_DIR}/src ${ARMCAL_WEB_DIR}/test)
  file(COPY ${PROJECT_SOURCE_DIR}/web/report/ DESTINATION ${ARMCAL_WEB_DIR} PATTERN node_modules EXCLUDE)
  find_program(ARMCAL_NODE NAMES node nodejs)
  find_program(ARMCAL_NPM npm)
  if(NOT ARMCAL_NODE OR NOT ARMCAL_NPM)
    armcal_no_report_script("they are made with node and npm, which are not here")
    return()
  endif()
  set(problem "")
  armcal_install_web_packages(problem)
  if(problem)
    armcal_no_report_script("${problem}")
    return()
  endif()
  execute_process(COMMAND ${ARMCAL_NODE} build.mjs ${ARMCAL_WEB_DIR}/report.js
    WORKING_DIRECTORY ${ARMCAL_WEB_DIR} TIMEOUT 120 RESULT_VARIABLE failed OUTPUT_QUIET ERROR_VARIABLE errors)
  if(failed)
    armcal_no_report_script("bundling failed: ${errors}")
    return()
  endif()
  set(ARMCAL_REPORT_SCRIPT ${ARMCAL_WEB_DIR}/report.js PARENT_SCOPE)
endfunction()

if(ARMCAL_REPORT_SCRIPTS)
  armcal_bundle_report_script()
endif()

# Reports in a real browser: web/report/test. Skipped where reports have no scripts, and where chromium or the packages
# are not.
if(ARMCAL_TESTS)
  set(test_with "${ARMCAL_NODE}")
  if(NOT ARMCAL_REPORT_SCRIPT)
    set(test_with sh -c "echo skipped: this build has no scripts for reports && exit 77")
  endif()
  add_test(NAME report_in_browser
           COMMAND ${test_with} ${ARMCAL_WEB_DIR}/test/run.mjs $<TARGET_FILE:armcal> ${PROJECT_SOURCE_DIR}/examples)
  set_tests_properties(report_in_browser PROPERTIES SKIP_RETURN_CODE 77 LABELS browser TIMEOUT 600 COST 1000)
endif()
