# What `cmake --install` puts where: the library, its headers, the command, and how other builds find them.
include(CMakePackageConfigHelpers)
set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/pdmc)

install(TARGETS pdmc pdmc_cli EXPORT pdmcTargets)
install(TARGETS pdmc_gmsh LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}) # found beside the library
install(DIRECTORY include/pdmc TYPE INCLUDE FILES_MATCHING PATTERN "*.h")

# The headers need nothing but the C library, so that the targets are the whole package.
install(EXPORT pdmcTargets NAMESPACE pdmc:: FILE pdmcConfig.cmake DESTINATION ${package_dir})
write_basic_package_version_file(pdmcConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/pdmcConfigVersion.cmake DESTINATION ${package_dir})

# By the place of the file, so that `cmake --install --prefix` may choose another.
file(RELATIVE_PATH pc_to_prefix ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})
configure_file(cmake/pdmc.pc.in pdmc.pc @ONLY)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/pdmc.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)

# The man pages.
add_subdirectory(docs/man)
