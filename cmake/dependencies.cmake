# Third-party libraries, behind the targets vct_headers (all that the library needs), vct_dependencies and vct_imgui. A
# desktop has packages of them; Android has none, so there they are fetched, in the versions that Debian 12 packages
# unless newer ones repair faults.
if(ANDROID)
    include(cmake/dependencies_android.cmake)
    include(cmake/packings_android.cmake)
else()
    include(cmake/dependencies_host.cmake)
endif()
include(cmake/packings.cmake)
