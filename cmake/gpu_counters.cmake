# The APK's optional library libvct_counters.so (jni/app/counters), with Arm's libGPUCounters.
vct_fetch(gpu_counters https://github.com/ARM-software/libGPUCounters.git 7e3ea4d852355103aa2a5e883adb06fc2957b6fe)   # 2.4.0

set(device ${gpu_counters_SOURCE_DIR}/backend/device)
set(hwcpipe ${gpu_counters_SOURCE_DIR}/hwcpipe)
file(GLOB_RECURSE sources ${device}/src/*.cpp ${hwcpipe}/src/*.cpp)
add_library(vct_gpu_counters STATIC ${sources})
target_include_directories(vct_gpu_counters SYSTEM PUBLIC ${device}/include ${hwcpipe}/include
    PRIVATE ${device}/src ${hwcpipe}/src)
# One file is a table of all counters of all GPUs, which takes minutes with optimization.
target_compile_options(vct_gpu_counters PRIVATE -w -O0)
target_compile_definitions(vct_gpu_counters PRIVATE HWCPIPE_DEVICE_BUILDING=1)

add_library(vct_counters SHARED ${CMAKE_SOURCE_DIR}/jni/app/counters/library.cpp)
target_include_directories(vct_counters PRIVATE ${CMAKE_SOURCE_DIR}/jni)
target_link_libraries(vct_counters PRIVATE vct_gpu_counters)
target_compile_options(vct_counters PRIVATE ${VCT_WARNINGS})
target_link_options(vct_counters PRIVATE -Wl,--no-undefined -Wl,--exclude-libs,ALL -Wl,-z,max-page-size=16384)
set_target_properties(vct_counters PROPERTIES CXX_VISIBILITY_PRESET default)
