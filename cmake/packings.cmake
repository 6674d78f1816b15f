# The libraries of what scenes may be packed with. A build without one of them refuses what needs it, and says so: where
# it is not installed, and where its option is OFF.
function(vct_packing name library header)
    option(VCT_${name} "Read what needs the library ${library}, where that is installed" ON)
    if(NOT VCT_${name})
        return()
    endif()
    find_path(${name}_INCLUDE_DIR ${header})
    find_library(${name}_LIBRARY ${library})
    mark_as_advanced(${name}_INCLUDE_DIR ${name}_LIBRARY)
    if(${name}_INCLUDE_DIR AND ${name}_LIBRARY)
        target_include_directories(vct_dependencies SYSTEM INTERFACE ${${name}_INCLUDE_DIR})
        target_link_libraries(vct_dependencies INTERFACE ${${name}_LIBRARY})
        target_compile_definitions(vct_dependencies INTERFACE VCT_HAS_${name})
    endif()
endfunction()

# None is pinned for Android, and those of the machine that builds are not for it.
if(ANDROID)
    return()
endif()
vct_packing(DRACO draco draco/compression/decode.h)
vct_packing(MESHOPT meshoptimizer meshoptimizer.h)
vct_packing(WEBP webp webp/decode.h)
# No package of Debian: whoever installs it has it.
vct_packing(KTX ktx ktx.h)
