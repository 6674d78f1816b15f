# Third-party libraries for Android. They are fetched at configure time, each pinned by the hash of a commit, by which
# git verifies every byte.
include(FetchContent)
enable_language(C)
find_package(Git REQUIRED)

# Fetches one commit without its history, a tenth of the size of FetchContent's own clone.
macro(vct_fetch name repository commit)
    FetchContent_Declare(${name}
        DOWNLOAD_COMMAND ${GIT_EXECUTABLE} init --quiet <SOURCE_DIR>
        COMMAND ${GIT_EXECUTABLE} -C <SOURCE_DIR> fetch --quiet --depth 1 ${repository} ${commit}
        COMMAND ${GIT_EXECUTABLE} -C <SOURCE_DIR> -c advice.detachedHead=false checkout --quiet --force ${commit}
        # Only the sources are used; the targets are defined below.
        SOURCE_SUBDIR none)
    FetchContent_MakeAvailable(${name})
endmacro()

vct_fetch(glm https://github.com/g-truc/glm.git bf71a834948186f4097caa076cd2663c69a10e1e)             # 0.9.9.8
vct_fetch(tinygltf https://github.com/syoyo/tinygltf.git 584f1dfbe4f11c1e8209e5bf8b44858bafadf812)    # 2.7.0
vct_fetch(stb https://github.com/nothings/stb.git 8b5f1f37b5b75829fc72d38e7b5d4bcbf8a26d55)           # 2022-09-08
vct_fetch(nlohmann_json https://github.com/nlohmann/json.git bc889afb4c5bf1c0d8ee29ef35eaaf4c8bef8a5d) # 3.11.2
vct_fetch(imgui https://github.com/ocornut/imgui.git 512c54bbc062c41c74f8a8bd8ff1fd6bebd1e6d0)        # 1.86

# Header-only libraries, whose code is compiled once in this target.
add_library(vct_single_headers STATIC cmake/single_headers.cpp)
target_compile_definitions(vct_single_headers PRIVATE TINYGLTF_NO_INCLUDE_JSON TINYGLTF_NO_INCLUDE_STB_IMAGE
    TINYGLTF_NO_INCLUDE_STB_IMAGE_WRITE)
# Copies the one header that is needed, because tinygltf's folder has other versions of stb and json.
file(COPY ${tinygltf_SOURCE_DIR}/tiny_gltf.h DESTINATION ${CMAKE_BINARY_DIR}/tinygltf)
target_include_directories(vct_single_headers SYSTEM PUBLIC
    ${CMAKE_BINARY_DIR}/tinygltf ${stb_SOURCE_DIR} ${nlohmann_json_SOURCE_DIR}/single_include)

add_library(vct_headers INTERFACE)
target_include_directories(vct_headers SYSTEM INTERFACE ${glm_SOURCE_DIR})
add_library(vct_dependencies INTERFACE)
target_link_libraries(vct_dependencies INTERFACE vct_headers vct_single_headers EGL z)

add_library(vct_imgui STATIC ${imgui_SOURCE_DIR}/imgui.cpp ${imgui_SOURCE_DIR}/imgui_draw.cpp
    ${imgui_SOURCE_DIR}/imgui_tables.cpp ${imgui_SOURCE_DIR}/imgui_widgets.cpp)
target_include_directories(vct_imgui SYSTEM PUBLIC ${imgui_SOURCE_DIR})
