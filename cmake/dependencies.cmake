# Third-party libraries, as the targets vct_headers (for the library), vct_dependencies (for everything else) and
# vct_imgui (for the app's panel). On a desktop they are packages of the system. For Android they are fetched, in the
# versions of Debian 12 unless newer ones repair faults.
if(ANDROID)
    include(cmake/dependencies_android.cmake)
    include(cmake/packings_android.cmake)
else()
    include(cmake/dependencies_host.cmake)
endif()
include(cmake/packings.cmake)
