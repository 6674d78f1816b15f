#include "engine/directional/irradiance.h"

#include <algorithm>
#include <cmath>

#include "engine/programs.h"
#include "gl/debug.h"

namespace vct {

float largestBounceShare(const Scene& scene) {
    float largest = 0.0F;
    for (const Instance& instance : scene.instances) {
        // A texture only makes it smaller.
        const glm::vec4& color = scene.materials[scene.meshes[instance.mesh].material].baseColor;
        largest = std::max({largest, color.r, color.g, color.b});
    }
    return std::min(largest, 0.95F);
}

namespace {

// Once light or surfaces have changed, what was received before is wrong but near. So many steps of it are
// kept: fewer would be noise, more would lag behind (docs/levers.md).
constexpr float memoryInChange = 15.0F;
// When the changes have ended there are more cones in each step, and what lagged behind is forgotten sooner.
constexpr float memoryAfterChange = 9.0F;
// A face that has received nothing yet looks into at least so many directions in its first step.
constexpr std::uint32_t conesOfNew = 8;
// Of light that stands still, in steps: what a few cones add to it then is hardly seen.
constexpr float longestMemory = 192.0F;
// The 16 faces of a block look into 16 directions in a row (shaders/directional/irradiance.comp): in the next
// step these are others. Odd, so that each face comes to all of them.
constexpr std::uint32_t directionsOfBlock = 17;
// Once the changes have ended, so much less of a face's light is its block's in each step.
constexpr float smoothingLess = 0.25F;

// Of a texture with a texel for each face of a block.
glm::ivec3 blocksSize(int grid) {
    return grid / VCT_BRICK_SIDE * glm::ivec3(DirectionalVoxels::blocksX, DirectionalVoxels::blocksY, 1);
}

// In each step a quarter of the faces look at the lamps anew (shaders/directional/emitters.comp).
constexpr int stepsOfEmitters = 4;

// In groups of 4^3.
void dispatchOver(const glm::ivec3& texels) {
    const glm::uvec3 groups = (texels + 3) / 4;
    gl::DispatchCompute(groups.x, groups.y, groups.z);
}

}  // namespace

gl::ProgramDescription lightProgram(const std::string& name, const LightFeatures& sources) {
    return {name, {"directional/" + name + ".comp"}, lightDefines(sources)};
}

LightFeatures featuresFor(GatherOf of, const LightFeatures& sources) {
    return of == GatherOf::light ? sources : LightFeatures();
}

gl::ProgramDescription emittersProgram(const GatherSettings& settings) {
    std::vector<std::string> defines = gatherDefines(settings);
    defines.emplace_back("VCT_EMITTERS");
    return {"emitters", {"directional/emitters.comp"}, defines};
}

gl::ProgramDescription irradianceProgram(const GatherSettings& settings, GatherOf of,
                                         const LightFeatures& sources) {
    std::vector<std::string> defines = gatherDefines(settings);
    defines.push_back("VCT_FORGETTING " + number(irradianceForgetting));
    defines.emplace_back(of == GatherOf::occlusion ? "VCT_GATHER_OCCLUSION true"
                                                   : "VCT_GATHER_OCCLUSION false");
    for (const std::string& define : lightDefines(sources))
        defines.push_back(define);
    return {of == GatherOf::occlusion ? "irradiance, occlusion" : "irradiance",
            {"directional/irradiance.comp"},
            defines};
}

Irradiance::Irradiance(const gl::ShaderLibrary& shaders, const GatherSettings& settings, GatherOf of,
                       int lightFrames, bool voxelsChange, const LightFeatures& sources)
    : settings_(settings),
      lightFrames_(lightFrames),
      voxelsChange_(voxelsChange),
      inherit_(shaders, lightProgram("light_inherit", sources)),
      clear_(shaders, lightProgram("light_clear", sources)),
      placeBricks_(shaders, lightProgram("light_bricks", sources)),
      gather_(shaders, irradianceProgram(settings, of, sources)),
      gatherBlocks_(shaders, lightProgram("light_blocks", sources)),
      uniforms_("light step", GL_UNIFORM_BUFFER, sizeof(shared::LightStep), nullptr, GL_DYNAMIC_DRAW) {
    if (of == GatherOf::light) shine_.emplace(shaders, lightProgram("light_shine", sources));
    if (sources.emitters) emitters_.emplace(shaders, emittersProgram(settings));
    forget();
}

void Irradiance::note(const Change& change) {
    if (change.keptFaces) {
        firstNew_ = std::min(*change.keptFaces, firstNew_.value_or(*change.keptFaces));
        emitterSteps_ = stepsOfEmitters;
    }
    changed_ = true;
    if (!change.light) return;
    age_ = std::min(age_, memoryInChange);
    stepsLeft_ = lightFrames_;
}

void Irradiance::forget() {
    firstNew_ = 0U;
    emitterSteps_ = stepsOfEmitters;
    age_ = 0.0F;
    stepsLeft_ = lightFrames_;
    lastShare_ = 0.0F;
}

void Irradiance::step(DirectionalVoxels& voxels, DirectionalMipmapper& mipmapper, bool allBounces) {
    const gl::DebugGroup group("irradiance");
    const bool listsChanged = firstNew_.has_value();
    if (!changed_ && !settling_) age_ = std::min(age_, memoryAfterChange);
    // Faces that are all new begin with what pixels looked up before: that would be smoothed again and again.
    const bool allNew = firstNew_ == 0U && age_ > 0.0F;
    smoothing_ = changed_ && !allNew ? 1.0F : std::max(smoothing_ - smoothingLess, 0.0F);
    settling_ = !changed_;
    if (listsChanged && (voxelsChange_ || !irradiance_)) counts_ = voxels.index().readCommands();
    // The last frame fetched what is written here, and all before wrote what is fetched.
    gl::MemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT |
                      GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
    if (listsChanged) {
        makeRoomForFaces(counts_[0].faceCount, counts_[VCT_BRICK_LEVEL].faceCount);
        if (irradiance_) {
            uploadUniforms(allBounces);
            bind(voxels);
            inherit_.use();
            voxels.index().dispatchOverFaces(0);
            gl::MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
        }
        makeRoomForBricks(voxels.grid(), counts_[VCT_BRICK_LEVEL].faceCount);
    }
    uploadUniforms(allBounces);
    bind(voxels);
    if (listsChanged) placeBricks(voxels);
    // Four faces for each invocation: what they add up is added to the sums of all once.
    const GLuint groups = counts_[0].faceCount / (4 * VCT_LIST_GROUP) + 1;
    if (emitters_ && emitterSteps_ > 0) {
        --emitterSteps_;
        emitters_->use();
        gl::Uniform1ui(VCT_UNIFORM_LEVEL, 0);
        gl::DispatchCompute(groups, 1, 1);
        gl::MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    }
    if (shine_) {
        shine_->use();
        voxels.bindLevel(VCT_IMAGE_FACES, 0);
        gl::Uniform1ui(VCT_UNIFORM_LEVEL, 0);
        gl::DispatchCompute(groups, 1, 1);
        gl::MemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT);
        mipmapper.update(voxels, frame_);
    }
    gather_.use();
    irradiance_->bindImage(VCT_IMAGE_IRRADIANCE, 0, GL_WRITE_ONLY);
    gl::Uniform1ui(VCT_UNIFORM_LEVEL, 0);
    gl::DispatchCompute(groups, 1, 1);
    gl::MemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_STORAGE_BARRIER_BIT);
    gatherBlocks_.use();
    blockLight_->bindImage(VCT_IMAGE_BLOCK_LIGHT, 0, GL_WRITE_ONLY);
    dispatchOver(blocksSize(voxels.grid()));

    lastShare_ = shareOfStep();
    age_ = age_ == 0.0F ? float{VCT_STEPS_OF_NEW} : std::min(age_ + 1.0F, longestMemory);
    direction_ += changed_ ? directionsOfBlock : static_cast<std::uint32_t>(cones());
    ++frame_;
    stepsLeft_ = std::max(stepsLeft_ - 1, 0);
    // Where the light stands still, what a few cones find in voxels that are made anew changes it little.
    if (stepsLeft_ == 0) age_ = longestMemory;
    firstNew_.reset();
    changed_ = false;
}

// The last steps until the light stands still are whole rounds; those before them, at least as many as a
// round has, are not. Where lists are made anew in the same light, rounds go on.
int Irradiance::stepOfRound() const {
    if (changed_) return -1;
    const int rounds = std::max(lightFrames_ / round() - 1, 0);
    if (stepsLeft_ > rounds * round()) return -1;
    return (round() - stepsLeft_ % round()) % round();
}

float Irradiance::shareOfStep() const {
    if (stepOfRound() >= 0) return 1.0F / static_cast<float>(round());
    return irradianceForgetting / (age_ + irradianceForgetting);
}

void Irradiance::makeRoomForFaces(std::uint32_t faces, std::uint32_t blocks) {
    if (facePlaces_ > 0 && faces <= facePlaces_ && blocks <= blockPlaces_) return;
    const auto places = [this](std::uint32_t count, std::uint32_t before) {
        return count <= before ? before : std::max(voxelsChange_ ? withHeadRoom(count) : count, 1U);
    };
    const bool first = facePlaces_ == 0;
    facePlaces_ = places(faces, facePlaces_);
    blockPlaces_ = places(blocks, blockPlaces_);
    const std::vector<std::uint32_t> zeros(VCT_LIGHT_HEADER + wordsOfFace() * std::size_t{facePlaces_} +
                                           4 * std::size_t{blockPlaces_});
    gl::Buffer larger("received light", GL_SHADER_STORAGE_BUFFER, zeros.size() * sizeof zeros[0],
                      zeros.data(), GL_DYNAMIC_COPY);
    if (!first) {
        // Nothing before reads the new buffer, so it does no harm where a copy comes too early
        // (VoxelPyramid::setCommands()).
        gl::MemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
        received_.bind(GL_COPY_READ_BUFFER);
        larger.bind(GL_COPY_WRITE_BUFFER);
        gl::CopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, 0, 0,
                              static_cast<GLsizeiptr>(received_.bytes()));
    }
    received_ = std::move(larger);
}

// As near to a cube as they come: no side is longer than the least that ES 3.1 has room for, up to 256^3.
void Irradiance::makeRoomForBricks(int grid, std::uint32_t count) {
    if (irradiance_ && count <= brickPlaces_) return;
    const std::uint32_t wanted = std::max(voxelsChange_ ? withHeadRoom(count) : count, 1U);
    bricksAlong_ = static_cast<std::uint32_t>(std::ceil(std::cbrt(wanted)));
    const std::uint32_t layer = bricksAlong_ * bricksAlong_;
    const std::uint32_t layers = (wanted + layer - 1) / layer;
    brickPlaces_ = layers * layer;
    irradianceSize_ = VCT_BRICK_TEXELS * glm::ivec3(bricksAlong_, bricksAlong_, layers);
    irradiance_ = gl::Texture::make3d("irradiance", GL_RGBA16F, irradianceSize_.x, irradianceSize_.y,
                                      irradianceSize_.z, 1);
    irradiance_->setFilter(GL_LINEAR, GL_LINEAR);
    if (bricks_) return;
    const glm::ivec3 size = blocksSize(grid);
    bricks_ = gl::Texture::make3d("places of irradiance", GL_R32UI, size.x, size.y, size.z, 1);
    blockLight_ = gl::Texture::make3d("received light of blocks", GL_RGBA16F, size.x, size.y, size.z, 1);
    blockLight_->setFilter(GL_LINEAR, GL_LINEAR);
}

void Irradiance::uploadUniforms(bool allBounces) const {
    shared::LightStep values{};
    values.frame = frame_;
    values.direction = direction_;
    values.cones = static_cast<std::uint32_t>(cones());
    values.conesOfNew = std::max(conesOfNew, values.cones);
    values.firstNew = firstNew_.value_or(VCT_NO_ENTRY);
    values.beginsRound = stepOfRound() == 0 ? 1 : 0;
    values.shareInRound = stepOfRound() >= 0 ? shareOfStep() : 0.0F;
    values.bricksAlong = bricksAlong_;
    // Each face's mean is shortened to what the light's age allows.
    values.memory = std::max(age_, 1.0F);
    values.inherited = age_;
    values.reflected = allBounces ? settings_.bounceGain : 0.0F;
    values.amplitude = lastShare_;
    values.towardsBalance = stepOfRound() >= 0 ? lastShare_ : std::max(lastShare_, 0.5F);
    values.blockSums = VCT_LIGHT_HEADER + wordsOfFace() * facePlaces_;
    values.smoothing = smoothing_;
    values.sumUnits = std::min(65536.0F, 2147483648.0F / static_cast<float>(facePlaces_));
    uniforms_.bind(GL_UNIFORM_BUFFER);
    gl::BufferSubData(GL_UNIFORM_BUFFER, 0, sizeof values, &values);
}

void Irradiance::bind(const DirectionalVoxels& voxels) const {
    voxels.bindLists();
    received_.bindBase(GL_SHADER_STORAGE_BUFFER, VCT_SSBO_RECEIVED);
    uniforms_.bindBase(GL_UNIFORM_BUFFER, VCT_UBO_LIGHT);
    voxels.faces().bind(VCT_TEX_FACES);
    voxels.index().texture().bind(VCT_TEX_VOXELS);
    if (bricks_) bricks_->bind(VCT_TEX_BRICKS);
    if (irradiance_) irradiance_->bind(VCT_TEX_IRRADIANCE);
    if (blockLight_) blockLight_->bind(VCT_TEX_BLOCK_LIGHT);
}

void Irradiance::placeBricks(const DirectionalVoxels& voxels) const {
    clear_.use();
    irradiance_->bindImage(VCT_IMAGE_IRRADIANCE, 0, GL_WRITE_ONLY);
    bricks_->bindImage(VCT_IMAGE_BRICKS, 0, GL_WRITE_ONLY);
    const glm::uvec3 groups = (glm::max(irradianceSize_, blocksSize(voxels.grid())) + 7) / 8;
    gl::DispatchCompute(groups.x, groups.y, 1);
    gl::MemoryBarrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
    placeBricks_.use();
    voxels.index().dispatchOverFaces(VCT_BRICK_LEVEL);
    gl::MemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT |
                      GL_SHADER_STORAGE_BARRIER_BIT);
}

std::vector<const gl::Texture*> Irradiance::textures() const {
    if (!irradiance_) return {};
    return {&*irradiance_, &*bricks_, &*blockLight_};
}

}  // namespace vct
