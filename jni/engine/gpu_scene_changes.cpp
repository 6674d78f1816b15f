// Changes of materials, meshes and instances after the scene was uploaded.
#include <algorithm>
#include <cstring>
#include <utility>

#include "core/error.h"
#include "engine/gpu_scene.h"
#include "shared/layout.h"

namespace vct {

namespace {

template <class Element>
void write(const gl::Buffer& buffer, std::size_t firstByte, const std::vector<Element>& elements) {
    buffer.bind(GL_COPY_WRITE_BUFFER);
    gl::BufferSubData(GL_COPY_WRITE_BUFFER, static_cast<GLintptr>(firstByte),
                      static_cast<GLsizeiptr>(elements.size() * sizeof elements[0]), elements.data());
}

}  // namespace

void GpuScene::setTexture(std::size_t texture, GLuint external) {
    for (std::vector<gl::Texture>* textures : {&textures_, &dataTextures_}) {
        textures->resize(std::max(textures->size(), texture + 1));
        (*textures)[texture] = gl::Texture::wrapExternal(external);
    }
}

std::size_t GpuScene::allocate(std::size_t count, std::size_t elementBytes, Ranges& ranges,
                               gl::Buffer& buffer) {
    if (const auto first = ranges.allocate(count)) return *first;
    const std::size_t capacity = ranges.capacity() + std::max(ranges.capacity() / 2, count);
    gl::Buffer larger(buffer.label(), GL_COPY_WRITE_BUFFER, capacity * elementBytes, nullptr,
                      GL_DYNAMIC_DRAW);
    buffer.bind(GL_COPY_READ_BUFFER);
    larger.bind(GL_COPY_WRITE_BUFFER);
    gl::CopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, 0, 0,
                          static_cast<GLsizeiptr>(ranges.capacity() * elementBytes));
    buffer = std::move(larger);
    ranges.grow(capacity);
    pointAttributes();
    return ranges.allocate(count).value();
}

void GpuScene::addMesh(std::size_t index, const Mesh& mesh) {
    const std::size_t vertexBytes = vertexFloats_ * sizeof(float);
    const std::size_t firstVertex = allocate(mesh.vertices.size(), vertexBytes, vertexRanges_, vertices_);
    std::vector<float> vertices;
    append(mesh, vertices);
    write(vertices_, firstVertex * vertexBytes, vertices);
    const std::size_t firstIndex =
        allocate(mesh.indices.size(), sizeof mesh.indices[0], indexRanges_, indices_);
    std::vector<std::uint32_t> indices = mesh.indices;
    for (std::uint32_t& i : indices)
        i += static_cast<std::uint32_t>(firstVertex);
    write(indices_, firstIndex * sizeof indices[0], indices);
    movingMeshes_.resize(std::max(movingMeshes_.size(), index + 1));
    movingMeshes_[index] = {mesh, cornersOf(mesh), static_cast<std::uint32_t>(firstVertex), firstIndex};
}

void GpuScene::removeMesh(std::size_t index) {
    const MovingMesh removed = std::exchange(movingMeshes_.at(index), {});
    vertexRanges_.release(removed.firstVertex, removed.mesh.vertices.size());
    indexRanges_.release(removed.firstIndex, removed.mesh.indices.size());
}

void GpuScene::addInstance(std::size_t index, const Instance& instance, const Material& material,
                           unsigned features) {
    const MovingMesh& mesh = movingMeshes_.at(static_cast<std::size_t>(instance.mesh));
    Draw draw;
    draw.instance = index;
    draw.triangles = {mesh.firstIndex, static_cast<int>(mesh.mesh.indices.size())};
    const auto free = std::find_if(moving_.begin(), moving_.end(), [](const Moving& moving) {
        return moving.origin == Moving::Origin::removed;
    });
    draw.moving = static_cast<int>(free - moving_.begin());
    if (free == moving_.end()) moving_.emplace_back();
    Moving& moving = moving_[static_cast<std::size_t>(draw.moving)];
    const std::uint64_t changes = moving.changes + 1;
    moving = {};
    moving.node = instance.node;
    moving.worldFromObject = instance.worldFromObject;
    moving.mesh = static_cast<std::size_t>(instance.mesh);
    moving.firstVertex = mesh.firstVertex;
    moving.changes = changes;
    moving.origin = Moving::Origin::added;
    if (voxelization_ == Voxelization::sortedAxes)
        moving.firstIndex = allocate(mesh.mesh.indices.size(), sizeof(std::uint32_t), indexRanges_, indices_);
    if (freeUniforms_.empty()) throw Error("there is no room for another instance");
    draw.uniformOffset = freeUniforms_.back();
    freeUniforms_.pop_back();
    shared::DrawUniforms values{};
    values.surface.w = 1.0F;  // its emission is in the voxels
    std::memcpy(&uniformBytes_[draw.uniformOffset], &values, sizeof values);
    setMaterial(draw, material, features);
    place(draw);
    uploadUniforms(draw);
    draws_.push_back(draw);
    sortDraws();
}

void GpuScene::removeInstance(std::size_t index) {
    const Draw removed = drawOf(index);
    Moving& moving = moving_[static_cast<std::size_t>(removed.moving)];
    if (voxelization_ == Voxelization::sortedAxes)
        indexRanges_.release(moving.firstIndex, static_cast<std::size_t>(removed.triangles.count));
    const std::uint64_t changes = moving.changes + 1;
    moving = {};
    moving.isVisible = false;
    moving.changes = changes;
    moving.origin = Moving::Origin::removed;
    freeUniforms_.push_back(removed.uniformOffset);
    std::erase_if(draws_, [&](const Draw& draw) { return draw.instance == index; });
    sortDraws();
}

bool GpuScene::setMaterial(std::size_t instance, const Material& material, unsigned features) {
    Draw& draw = drawOf(instance);
    const bool isDynamic = draw.moving >= 0;
    setMaterial(draw, material, features);
    uploadUniforms(draw);
    sortDraws();
    return isDynamic;
}

// Writes the material into uniformBytes_. The draws have to be sorted again.
void GpuScene::setMaterial(Draw& draw, const Material& material, unsigned features) {
    draw.features = features;
    draw.baseColorTexture = material.baseColorTexture;
    draw.emissiveTexture = material.emissiveTexture;
    draw.glossTexture = material.glossTexture;
    draw.normalTexture = material.normalTexture;
    draw.doubleSided = material.doubleSided;
    glm::vec3 emission = material.emissive / radianceUnit_;
    if (draw.moving >= 0) {
        Moving& moving = moving_[static_cast<std::size_t>(draw.moving)];
        moving.emission = emission;
        ++moving.changes;
        emission *= moving.emissionScale;
    }
    shared::DrawUniforms values;
    std::memcpy(&values, &uniformBytes_[draw.uniformOffset], sizeof values);
    values.baseColor = material.baseColor;
    values.emissive = glm::vec4(emission, material.normalScale);
    values.surface = glm::vec4(material.alphaCutoff, material.metallic, material.roughness, values.surface.w);
    std::memcpy(&uniformBytes_[draw.uniformOffset], &values, sizeof values);
}

void GpuScene::uploadUniforms(const Draw& draw) const {
    uniforms_.bind(GL_COPY_WRITE_BUFFER);
    gl::BufferSubData(GL_COPY_WRITE_BUFFER, static_cast<GLintptr>(draw.uniformOffset),
                      sizeof(shared::DrawUniforms), &uniformBytes_[draw.uniformOffset]);
}

GpuScene::Draw& GpuScene::drawOf(std::size_t instance) {
    return *std::find_if(draws_.begin(), draws_.end(),
                         [&](const Draw& draw) { return draw.instance == instance; });
}

}  // namespace vct
