# `cmake --install` installs the library, its header and the files for find_package(vct) and pkg-config. The library needs
# nothing else.
include(CMakePackageConfigHelpers)
set(package ${CMAKE_INSTALL_LIBDIR}/cmake/vct)
install(TARGETS vct_library EXPORT vctTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
# Debug information would be most of the library's size.
install(CODE "file(GLOB library \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_LIBDIR}/libvct.a\")
execute_process(COMMAND \"${CMAKE_STRIP}\" --strip-debug \${library} COMMAND_ERROR_IS_FATAL ANY)")
install(DIRECTORY include/vct ${CMAKE_BINARY_DIR}/include/vct DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
# The library has no dependencies to find, so the file of its targets is the whole package configuration.
install(EXPORT vctTargets FILE vctConfig.cmake NAMESPACE vct:: DESTINATION ${package})
write_basic_package_version_file(${CMAKE_BINARY_DIR}/vctConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/vctConfigVersion.cmake DESTINATION ${package})

file(RELATIVE_PATH VCT_PREFIX_FROM_PC /prefix/${CMAKE_INSTALL_LIBDIR}/pkgconfig /prefix)
configure_file(cmake/vct.pc.in vct.pc @ONLY)
install(FILES ${CMAKE_BINARY_DIR}/vct.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
