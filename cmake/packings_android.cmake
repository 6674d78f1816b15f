# Builds, from sources, the decoders of the libraries that cmake/packings.cmake links. libwebp and draco are
# newer than in Debian 12, whose packages have the fixes of newer versions.
vct_fetch(draco https://github.com/google/draco.git 8786740086a9f4d83f44aa83badfbea4dce7a1b5)                 # 1.5.7
vct_fetch(meshoptimizer https://github.com/zeux/meshoptimizer.git e62c41e47cfdaf014c1e2a98dfeb571dd60c271f)   # 0.18
vct_fetch(webp https://github.com/webmproject/libwebp.git ca332209cb5567c9b249c86788cb2dbf8847e760)           # 1.3.2

# EXCLUDE_FROM_ALL avoids building a library whose option is OFF.
function(vct_unpacker name include)
    set(CMAKE_UNITY_BUILD OFF)
    add_library(vct_${name} STATIC EXCLUDE_FROM_ALL ${ARGN})
    target_include_directories(vct_${name} SYSTEM PUBLIC ${include})
    target_compile_options(vct_${name} PRIVATE -w)
endfunction()

set(draco ${draco_SOURCE_DIR}/src/draco)
file(GLOB_RECURSE sources ${draco}/attributes/*.cc ${draco}/compression/*.cc ${draco}/core/*.cc ${draco}/mesh/*.cc
    ${draco}/metadata/*.cc ${draco}/point_cloud/*.cc)
# The filter matches only file names, because a folder above the sources may have any name.
list(FILTER sources EXCLUDE REGEX "/[^/]*(_test|test_|encod|scene|texture|material|features)[^/]*\\.cc$")
vct_unpacker(draco ${draco_SOURCE_DIR}/src ${sources})
# Draco's own CMake build would choose the same features.
file(WRITE ${CMAKE_BINARY_DIR}/draco/draco/draco_features.h "
#define DRACO_MESH_COMPRESSION_SUPPORTED
#define DRACO_NORMAL_ENCODING_SUPPORTED
#define DRACO_POINT_CLOUD_COMPRESSION_SUPPORTED
#define DRACO_STANDARD_EDGEBREAKER_SUPPORTED
#define DRACO_PREDICTIVE_EDGEBREAKER_SUPPORTED
#define DRACO_BACKWARDS_COMPATIBILITY_SUPPORTED
")
target_include_directories(vct_draco SYSTEM PUBLIC ${CMAKE_BINARY_DIR}/draco)

set(meshoptimizer ${meshoptimizer_SOURCE_DIR}/src)
vct_unpacker(meshoptimizer ${meshoptimizer} ${meshoptimizer}/allocator.cpp ${meshoptimizer}/indexcodec.cpp
    ${meshoptimizer}/vertexcodec.cpp ${meshoptimizer}/vertexfilter.cpp)

set(webp ${webp_SOURCE_DIR}/src)
file(GLOB sources ${webp}/dec/*.c ${webp}/dsp/*.c ${webp}/utils/*.c)
list(FILTER sources EXCLUDE REGEX "/(enc|lossless_enc|cost|ssim)[^/]*\\.c$|_encode[^/]*\\.c$|/quant_levels_utils\\.c$")
vct_unpacker(webp ${webp} ${sources})
target_include_directories(vct_webp SYSTEM PRIVATE ${webp_SOURCE_DIR})
