#include "scene/gltf_foreign.h"

#include <algorithm>
#include <cstring>
#include <filesystem>

namespace vct {
namespace {

constexpr const char* byBlender = "import it in Blender and export glTF 2.0 (File > Export)";
constexpr const char* inBlender = "open it in Blender and export glTF 2.0 (File > Export)";
constexpr const char* byFreeCad = "open it in FreeCAD and export glTF (File > Export)";
constexpr const char* byItsProgram = "export glTF 2.0, or FBX for Blender, from the program that wrote it";

struct Format {
    const char* ending;
    const char* signature;  // the first bytes of such files, or ""
    const char* name;       // with its article
    const char* remedy;
};

const Format formats[] = {
    {".fbx", "Kaydara FBX", "an FBX file", byBlender},
    {".blend", "BLENDER", "a file of Blender", inBlender},
    {".usdc", "PXR-USDC", "a USD file", byBlender},
    {".usda", "#usda", "a USD file", byBlender},
    {".usd", "", "a USD file", byBlender},
    {".usdz", "", "a USD file", byBlender},
    {".obj", "", "a Wavefront OBJ file", byBlender},
    {".stl", "", "an STL file", byBlender},
    {".ply", "ply\n", "a PLY file", byBlender},
    {".dae", "", "a COLLADA file", byBlender},
    {".abc", "Ogawa", "an Alembic file", byBlender},
    {".x3d", "", "an X3D file", byBlender},
    {".3ds", "", "a 3DS file", byBlender},
    {".step", "ISO-10303-21", "a STEP or IFC file", byFreeCad},
    {".stp", "", "a STEP file", byFreeCad},
    {".ifc", "", "an IFC file", byFreeCad},
    {".iges", "", "an IGES file", byFreeCad},
    {".max", "", "a file of 3ds Max", byItsProgram},
    {".ma", "", "a file of Maya", byItsProgram},
    {".mb", "", "a file of Maya", byItsProgram},
    {".c4d", "", "a file of Cinema 4D", byItsProgram},
    {".skp", "", "a file of SketchUp", byItsProgram},
    {".3dm", "", "a file of Rhino", byItsProgram},
};

bool beginsWith(const std::vector<unsigned char>& bytes, const char* signature) {
    const std::size_t length = std::strlen(signature);
    return length > 0 && bytes.size() >= length && std::memcmp(bytes.data(), signature, length) == 0;
}

}  // namespace

ForeignFile foreignFile(const std::string& path, const std::vector<unsigned char>& bytes) {
    std::string ending = std::filesystem::path(path).extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    for (const Format& format : formats)
        if (beginsWith(bytes, format.signature) || ending == format.ending)
            return {std::string("it is ") + format.name + ", and only glTF is read (.gltf, .glb)",
                    format.remedy};
    return {};
}

}  // namespace vct
