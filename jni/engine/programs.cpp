#include "engine/programs.h"

#include <cstdio>

namespace vct {

std::string booleanDefine(const char* name, bool value) {
    return std::string(name) + (value ? " true" : " false");
}

std::vector<std::string> featureDefines(unsigned features, unsigned used, std::vector<std::string> defines) {
    features &= used;
    defines.push_back(booleanDefine("VCT_ALPHA_MASK", features & featureAlphaMask));
    defines.push_back(booleanDefine("VCT_EMISSIVE", features & featureEmissive));
    defines.push_back(booleanDefine("VCT_DOUBLE_SIDED", features & featureDoubleSided));
    if (features & featurePunctualLights) defines.emplace_back("VCT_PUNCTUAL_LIGHTS");
    if (features & featureBaseColorTexture) defines.emplace_back("VCT_BASE_COLOR_TEXTURE");
    if (features & featureEmissiveTexture) defines.emplace_back("VCT_EMISSIVE_TEXTURE");
    if (features & featureVertexColors) defines.emplace_back("VCT_VERTEX_COLORS");
    if (features & featureUnlit) defines.emplace_back("VCT_UNLIT");
    if (features & featureGlossTexture) defines.emplace_back("VCT_GLOSS_TEXTURE");
    if (features & featureNormalMap) defines.emplace_back("VCT_NORMAL_MAP");
    return defines;
}

std::string number(float value) {
    char text[32];
    std::snprintf(text, sizeof text, "%#.9g", value);
    return text;
}

std::vector<std::string> gatherDefines(const GatherSettings& settings) {
    return {"VCT_GATHER_DIRECTIONS " + std::to_string(settings.directionSet()),
            "VCT_DIRECTIONS " + std::to_string(settings.directions),
            "VCT_HIT_BITS " + std::to_string(settings.hitBits)};
}

std::vector<std::string> lightDefines(const LightFeatures& sources) {
    std::vector<std::string> defines;
    if (sources.environment) defines.emplace_back("VCT_ENVIRONMENT");
    if (sources.emitters > 0) defines.push_back("VCT_EMITTERS " + std::to_string(sources.emitters));
    return defines;
}

std::vector<std::string> emissionDefines(bool emission) {
    if (emission) return {"VCT_EMISSION"};
    return {};
}

gl::ProgramDescription voxelizing(const std::string& name, std::vector<std::string> defines,
                                  Voxelization voxelization) {
    if (voxelization == Voxelization::geometryShader)
        return {name, {"shared/voxelizer.vert", "shared/voxelizer.geom", name + ".frag"}, std::move(defines)};
    defines.emplace_back("VCT_SORTED_AXES");
    return {name, {"shared/voxelizer.vert", name + ".frag"}, std::move(defines)};
}

gl::ShaderLibrary shaderLibrary(const Settings& settings, const gl::Capabilities& capabilities,
                                gl::ReadShader read, std::shared_ptr<gl::ProgramCache> cache) {
    std::vector<std::string> defines;
    if (settings.cascades > 1) defines.push_back("VCT_CASCADES " + std::to_string(settings.cascades));
    defines.push_back("VCT_PIXEL_SAMPLES " + std::to_string(pixelSamplesFor(capabilities)));
    // llvmpipe emulates the rounding of mediump, which makes the last pass up to twice as slow.
    if (capabilities.softwareDriver) defines.emplace_back("mediump highp");
    return {std::move(read), capabilities.language(), std::move(defines), std::move(cache)};
}

}  // namespace vct
