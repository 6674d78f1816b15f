# Third-party libraries on a desktop, all from packages of the system (scripts/setup.sh installs them).
find_package(glm REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(CLI11 REQUIRED)
find_package(OpenEXR REQUIRED)
find_package(ZLIB REQUIRED)
find_package(Threads REQUIRED)

find_path(TINYGLTF_INCLUDE_DIR tiny_gltf.h REQUIRED)
find_library(TINYGLTF_LIBRARY tinygltf REQUIRED)
find_path(STB_INCLUDE_DIR stb_image.h PATH_SUFFIXES stb REQUIRED)
find_library(STB_LIBRARY stb REQUIRED)
find_path(IMGUI_INCLUDE_DIR imgui.h PATH_SUFFIXES imgui REQUIRED)
find_library(IMGUI_LIBRARY imgui REQUIRED)
find_path(EGL_INCLUDE_DIR EGL/egl.h REQUIRED)
find_path(GLES_INCLUDE_DIR GLES3/gl32.h REQUIRED)

add_library(vct_headers INTERFACE)
target_include_directories(vct_headers SYSTEM INTERFACE ${GLES_INCLUDE_DIR})
add_library(vct_dependencies INTERFACE)
target_include_directories(vct_dependencies SYSTEM INTERFACE
    ${TINYGLTF_INCLUDE_DIR} ${STB_INCLUDE_DIR} ${EGL_INCLUDE_DIR})
target_link_libraries(vct_dependencies INTERFACE vct_headers
    ${TINYGLTF_LIBRARY} ${STB_LIBRARY} OpenEXR::OpenEXR ZLIB::ZLIB nlohmann_json::nlohmann_json Threads::Threads
    ${CMAKE_DL_LIBS})
find_library(EGL_LIBRARY EGL REQUIRED)
target_link_libraries(vct_dependencies INTERFACE ${EGL_LIBRARY})

# Dear ImGui for the app's panel, without its own back ends: Debian's OpenGL back end is built for desktop GL.
add_library(vct_imgui INTERFACE)
target_include_directories(vct_imgui SYSTEM INTERFACE ${IMGUI_INCLUDE_DIR})
target_link_libraries(vct_imgui INTERFACE ${IMGUI_LIBRARY} ${STB_LIBRARY})
