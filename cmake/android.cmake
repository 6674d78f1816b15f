# Builds the app's library libvct.so. Gradle (app/build.gradle) or the target `apk` (cmake/apk.cmake) packs it.

# This code belongs to the NDK, so it is built without the project's warnings.
set(glue ${ANDROID_NDK}/sources/android/native_app_glue)
add_library(vct_native_app_glue OBJECT ${glue}/android_native_app_glue.c)
target_include_directories(vct_native_app_glue SYSTEM PUBLIC ${glue})

file(GLOB VCT_APP_SOURCES CONFIGURE_DEPENDS jni/app/*.cpp jni/app/android/*.cpp)
add_library(vct SHARED ${VCT_APP_SOURCES})
target_link_libraries(vct PRIVATE vct_core vct_imgui vct_native_app_glue android log EGL)
target_link_options(vct PRIVATE
    -Wl,--no-undefined -Wl,--gc-sections
    # The only exported function is ANativeActivity_onCreate, which Android calls.
    -Wl,--version-script=${CMAKE_SOURCE_DIR}/cmake/exports.map
    # Phones with pages of 16 KiB require this alignment; NDKs before r28 align to 4 KiB.
    -Wl,-z,max-page-size=16384)
# Removes the folders of the build machine from the messages of assert().
foreach(target vct vct_library vct_core vct_single_headers vct_imgui vct_draco vct_meshoptimizer vct_webp)
    target_compile_options(${target} PRIVATE -ffunction-sections -fdata-sections
        -ffile-prefix-map=${CMAKE_BINARY_DIR}/= -ffile-prefix-map=${CMAKE_SOURCE_DIR}/=)
endforeach()

set_target_properties(vct PROPERTIES LINK_DEPENDS ${CMAKE_SOURCE_DIR}/cmake/exports.map)

include(cmake/apk.cmake)
include(cmake/stand_ins.cmake)
