# `cmake --install`: the library, its header, and what find_package(vct) reads. Nothing else has to be there to use it.
include(CMakePackageConfigHelpers)
set(package ${CMAKE_INSTALL_LIBDIR}/cmake/vct)
install(TARGETS vct_library EXPORT vctTargets ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(DIRECTORY include/vct DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
# It has no dependencies to find, so the targets are the whole of the package's configuration.
install(EXPORT vctTargets FILE vctConfig.cmake NAMESPACE vct:: DESTINATION ${package})
write_basic_package_version_file(${CMAKE_BINARY_DIR}/vctConfigVersion.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_BINARY_DIR}/vctConfigVersion.cmake DESTINATION ${package})
