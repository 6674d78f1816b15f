# The target `stand_ins`, in the folder stand_ins: Android's NativeActivity and the libraries that the app calls, for
# scripts/android-userland.sh.
set(folder ${CMAKE_BINARY_DIR}/stand_ins)
set(sources ${CMAKE_SOURCE_DIR}/tools/android)
file(WRITE ${folder}/empty.cpp "")
file(COPY ${CMAKE_SYSROOT}/usr/lib/${CMAKE_LIBRARY_ARCHITECTURE}/libc++_shared.so DESTINATION ${folder})

add_custom_target(stand_ins)
function(vct_stand_in name)
    target_compile_options(${name} PRIVATE ${VCT_WARNINGS})
    set_target_properties(${name} PROPERTIES CXX_VISIBILITY_PRESET default EXCLUDE_FROM_ALL ON
        RUNTIME_OUTPUT_DIRECTORY ${folder} LIBRARY_OUTPUT_DIRECTORY ${folder})
    add_dependencies(stand_ins ${name})
endfunction()
function(vct_stand_in_library name)
    add_library(stand_in_${name} SHARED ${ARGN})
    set_target_properties(stand_in_${name} PROPERTIES OUTPUT_NAME ${name})
    vct_stand_in(stand_in_${name})
endfunction()

vct_stand_in_library(log ${sources}/log.cpp)
vct_stand_in_library(android ${sources}/looper.cpp ${sources}/device.cpp)
vct_stand_in_library(EGL ${sources}/egl.cpp)
target_link_libraries(stand_in_android PRIVATE z)
target_link_libraries(stand_in_EGL PRIVATE stand_in_android)
# An app must not see a library that Android does not list as public.
vct_stand_in_library(not_public ${folder}/empty.cpp)
# A userland may lack libz.so. The NDK has it as a static library.
vct_stand_in_library(z ${folder}/empty.cpp)
target_link_options(stand_in_z PRIVATE -Wl,--whole-archive
    ${CMAKE_SYSROOT}/usr/lib/${CMAKE_LIBRARY_ARCHITECTURE}/libz.a -Wl,--no-whole-archive)

add_executable(activity ${sources}/activity.cpp ${sources}/app_library.cpp ${sources}/java.cpp)
target_link_libraries(activity PRIVATE stand_in_android stand_in_log dl)
vct_stand_in(activity)
