# `cmake --install` and `find_package(armcal CONFIG)`.

include(CMakePackageConfigHelpers)

get_property(rooms GLOBAL PROPERTY ARMCAL_ROOMS)
add_library(armcal_armcal INTERFACE)
add_library(armcal::armcal ALIAS armcal_armcal)
set_target_properties(armcal_armcal PROPERTIES EXPORT_NAME armcal)
target_link_libraries(armcal_armcal INTERFACE ${rooms})

install(TARGETS ${rooms} armcal_armcal EXPORT armcalTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(TARGETS armcal RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(DIRECTORY src/armcal DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
        FILES_MATCHING PATTERN "*.h" PATTERN testing EXCLUDE PATTERN cli EXCLUDE)
install(DIRECTORY ${PROJECT_BINARY_DIR}/generated/armcal DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
        FILES_MATCHING PATTERN "*.h")
install(DIRECTORY examples DESTINATION ${CMAKE_INSTALL_DATADIR}/armcal)
install(FILES LICENSE README.md CHANGELOG.md DESTINATION ${CMAKE_INSTALL_DOCDIR})

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/armcal)
install(EXPORT armcalTargets NAMESPACE armcal:: DESTINATION ${package_dir})
configure_package_config_file(cmake/armcalConfig.cmake.in ${PROJECT_BINARY_DIR}/armcalConfig.cmake
                              INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/armcalConfigVersion.cmake
                                 COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/armcalConfig.cmake ${PROJECT_BINARY_DIR}/armcalConfigVersion.cmake
        DESTINATION ${package_dir})
