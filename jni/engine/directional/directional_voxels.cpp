#include "engine/directional/directional_voxels.h"

#include <algorithm>

#include "core/error.h"
#include "engine/frame_uniforms.h"
#include "engine/lamp_light.h"
#include "engine/programs.h"
#include "gl/debug.h"

namespace vct {

namespace {

double areaWorld(const Mesh& mesh, const Instance& instance) {
    const glm::dmat3 linear(instance.worldFromObject);
    double area = 0.0;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        const glm::dvec3 a = mesh.vertices[mesh.indices[i]].position;
        const glm::dvec3 ab = glm::dvec3(mesh.vertices[mesh.indices[i + 1]].position) - a;
        const glm::dvec3 ac = glm::dvec3(mesh.vertices[mesh.indices[i + 2]].position) - a;
        area += 0.5 * glm::length(glm::cross(linear * ab, linear * ac));
    }
    return area;
}

}  // namespace

gl::ProgramDescription directionalClearProgram() {
    return {"directional/clear", {"directional/clear.comp"}, {}};
}

gl::ProgramDescription directionalClearBaseProgram() {
    return {"directional/clear_base", {"directional/clear_base.comp"}, {}};
}

float faceSumUnits(std::size_t triangles) {
    const std::size_t room = 0xFFFFFFFFU / std::max<std::size_t>(triangles, 1);
    return static_cast<float>(std::clamp<std::size_t>(room, 1, 4096));
}

float faceRadianceRange(const Scene& scene, const DirectionalLight& light, const glm::vec3& skyRadiance,
                        int grid) {
    const Volume volume = volumeAround(scene.boundsWorld, grid);
    const std::vector<EmitterPart> emitters = emitterParts(scene, volume);
    const std::vector<bool> isLamp = lampsAmong(scene, emitters);
    const LampLight lamps = lampLight(scene, emitters, volume.voxelSize());
    // What all emitters send, and what all surfaces absorb of it.
    double sent = lamps.fluxOverPi, absorbed = 0.0;
    auto brightest = static_cast<float>(lamps.brightest);
    for (const Instance& instance : scene.instances) {
        const Mesh& mesh = scene.meshes[instance.mesh];
        const Material& material = scene.materials[mesh.material];
        const float emission = std::max({material.emissive.r, material.emissive.g, material.emissive.b});
        const float albedo = std::max({material.baseColor.r, material.baseColor.g, material.baseColor.b});
        const double area = areaWorld(mesh, instance);
        if (!isLamp[static_cast<std::size_t>(&instance - scene.instances.data())]) {
            brightest = std::max(brightest, emission);
            sent += area * emission;
        }
        absorbed += area * (1.0 - std::min(albedo, 0.95F));
    }
    const float sky = std::max({skyRadiance.r, skyRadiance.g, skyRadiance.b});
    const float circulating = absorbed > 0.0 ? static_cast<float>(sent / absorbed) : 0.0F;
    const float range =
        std::max(light.intensity > 0.0F && light.color != glm::vec3(0.0F) ? 2.0F : 0.0F,
                 (brightest + std::min(circulating, 20.0F * brightest) + sky) / radianceUnit(light));
    return range > 0.0F ? range : 1.0F;
}

DirectionalVoxels::DirectionalVoxels(const gl::ShaderLibrary& shaders, int grid, std::uint32_t listCapacity)
    : index_(shaders, grid, listCapacity),
      faces_(texture("voxel faces", grid, index_.levels())),
      clearBase_(shaders, directionalClearBaseProgram()),
      clear_(shaders, directionalClearProgram()) {
    faces_.setFilter(GL_LINEAR_MIPMAP_NEAREST, GL_LINEAR);
    gl::zeroTexture3d(faces_, grid);
}

gl::Texture DirectionalVoxels::texture(const std::string& label, int grid, int levels) {
    return gl::Texture::make3d(label, GL_RGBA8, blocksX * grid, blocksY * grid, grid, levels);
}

std::size_t DirectionalVoxels::bytesFor(int grid, std::uint32_t listCapacity) {
    return VoxelPyramid::bytesFor(grid, listCapacity) +
           gl::textureBytes(GL_RGBA8, blocksX * grid, blocksY * grid, grid, 1) * 8 / 7;
}

std::uint32_t withHeadRoom(std::uint32_t count) {
    return count + count / 4;
}

Resources DirectionalVoxels::resources() const {
    Resources resources = index_.resources();
    add(resources, faces_);
    add(resources, sums_);
    return resources;
}

void DirectionalVoxels::clear() {
    const gl::DebugGroup group("clear faces");
    gl::MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_COMMAND_BARRIER_BIT |
                      GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
    // Until there is room for the sums, no face is written.
    if (sums_.bytes() == 0) {
        index_.clear();
        return;
    }
    bindLists();
    index_.texture().bind(VCT_TEX_VOXELS);
    clearBase_.use();
    bindLevel(VCT_IMAGE_FACES, 0);
    index_.bindLevel(VCT_IMAGE_VOXELS, 0, GL_WRITE_ONLY);
    index_.dispatchOverLevel(0);
    clear_.use();
    for (int level = 1; level < levels(); ++level) {
        bindLevel(VCT_IMAGE_FACES, level);
        index_.bindLevel(VCT_IMAGE_VOXELS, level, GL_WRITE_ONLY);
        index_.dispatchOverFaces(level);
    }
    index_.emptyLists();
}

void DirectionalVoxels::makeRoom(std::uint32_t voxels) {
    // Where there is no memory for the new ones, there is no room.
    sums_ = {};
    places_ = 0;
    const std::uint32_t places = std::max(voxels, 1U);
    const std::size_t words = index_.placeFaceLists(std::size_t{places} * VCT_SLOT_WORDS, places);
    const std::vector<std::uint32_t> zeros(words);
    sums_ = gl::Buffer("voxel face sums", GL_SHADER_STORAGE_BUFFER, words * sizeof zeros[0], zeros.data(),
                       GL_DYNAMIC_COPY);
    places_ = places;
}

std::vector<std::uint32_t> DirectionalVoxels::readFaceList(int level) const {
    const shared::LevelCommands commands = index_.readCommands()[static_cast<std::size_t>(level)];
    std::vector<std::uint32_t> faces(std::min(commands.faceCount, commands.faceCapacity));
    sums_.read(faces.data(), faces.size() * sizeof faces[0], commands.firstFace * sizeof faces[0]);
    return faces;
}

void DirectionalVoxels::bindLists() const {
    index_.bindLists();
    sums_.bindBase(GL_SHADER_STORAGE_BUFFER, VCT_SSBO_FACE_SUMS);
}

void DirectionalVoxels::bindLevel(int unit, int level) const {
    faces_.bindImage(unit, level, GL_WRITE_ONLY);
}

}  // namespace vct
