#include "engine/gpu_scene.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>
#include <numeric>
#include <tuple>

#include "engine/axis_sort.h"
#include "shared/layout.h"

namespace vct {

namespace {

// Computes in double precision until the last step, because a scene may lie 10^6 metres from the origin.
void place(shared::DrawUniforms& uniforms, const glm::dmat4& worldFromObject, const glm::dvec3& meshCentre,
           const glm::dmat4& volumeFromWorld) {
    const glm::dmat4 centred =
        worldFromObject * glm::dmat4(glm::dvec4(1, 0, 0, 0), glm::dvec4(0, 1, 0, 0), glm::dvec4(0, 0, 1, 0),
                                     glm::dvec4(meshCentre, 1.0));
    // The cofactors have the direction of the inverse transpose, and are finite for a scale of zero.
    const glm::dmat3 m(worldFromObject);
    glm::dmat3 cofactors(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
    const double sign = glm::determinant(m) < 0.0 ? -1.0 : 1.0;
    double largest = 0.0;
    for (int c = 0; c < 3; ++c)
        for (int r = 0; r < 3; ++r)
            largest = std::max(largest, std::abs(cofactors[c][r]));
    cofactors *= largest > 0.0 ? sign / largest : 0.0;
    uniforms.volumeFromObject = glm::mat4(volumeFromWorld * centred);
    uniforms.normalFromObject = glm::mat4(glm::dmat4(cofactors));
}

bool isMirrored(const glm::dmat4& worldFromObject) {
    return glm::determinant(glm::dmat3(worldFromObject)) < 0.0;
}

void upload(const gl::Buffer& buffer, std::size_t first, std::size_t size, const void* data) {
    buffer.bind(GL_COPY_WRITE_BUFFER);
    gl::BufferSubData(GL_COPY_WRITE_BUFFER, static_cast<GLintptr>(first), static_cast<GLsizeiptr>(size),
                      data);
}

void drawTriangles(std::size_t firstIndex, int indexCount) {
    gl::DrawElements(GL_TRIANGLES, indexCount, GL_UNSIGNED_INT,
                     reinterpret_cast<const void*>(firstIndex * sizeof(std::uint32_t)));
}

// Builds the index buffer: the triangles of each mesh, then the sorted orders of its instances.
class Indices {
  public:
    explicit Indices(const Scene& scene) {
        std::uint32_t firstVertex = 0;
        for (const Mesh& mesh : scene.meshes) {
            firstVertex_.push_back(firstVertex);
            orders_.push_back({all_.size()});
            append(mesh.indices, firstVertex);
            firstVertex += static_cast<std::uint32_t>(mesh.vertices.size());
        }
    }
    std::size_t firstOfMesh(int mesh) const { return orders_[mesh][0]; }
    std::uint32_t firstVertexOf(int mesh) const { return firstVertex_[mesh]; }
    // Returns the position of the mesh's triangles in this order, and adds them if no instance has it yet.
    std::size_t firstOf(int mesh, const std::vector<std::uint32_t>& order) {
        for (const std::size_t first : orders_[mesh]) {
            const auto same = [&](std::uint32_t index, std::uint32_t shared) {
                return index + firstVertex_[mesh] == shared;
            };
            if (all_.size() - first >= order.size() &&
                std::equal(order.begin(), order.end(), all_.begin() + static_cast<std::ptrdiff_t>(first),
                           same))
                return first;
        }
        orders_[mesh].push_back(all_.size());
        append(order, firstVertex_[mesh]);
        return orders_[mesh].back();
    }
    const std::vector<std::uint32_t>& all() const { return all_; }

  private:
    // ES 3.1 has no base vertex, so the mesh's first vertex is added to each index.
    void append(const std::vector<std::uint32_t>& indices, std::uint32_t firstVertex) {
        for (std::uint32_t index : indices)
            all_.push_back(firstVertex + index);
    }
    std::vector<std::uint32_t> all_, firstVertex_;
    std::vector<std::vector<std::size_t>> orders_;  // positions by mesh; the mesh's own order comes first
};

}  // namespace

GpuScene::GpuScene(const gl::ShaderLibrary& shaders, const Scene& scene,
                   const std::vector<bool>& emitterInstances, const Volume& volume, float radianceUnit,
                   int uniformAlignment, Voxelization voxelization)
    : features_(featuresOf(scene)),
      voxelization_(voxelization),
      volumeFromWorld_(volume.volumeFromWorld()),
      radianceUnit_(radianceUnit),
      instanceRoom_(scene.instanceRoom) {
    Indices indices(scene);

    const auto alignment = static_cast<std::size_t>(uniformAlignment);
    const std::size_t stride = (sizeof(shared::DrawUniforms) + alignment - 1) / alignment * alignment;
    uniformBytes_.resize(stride * (scene.instances.size() + instanceRoom_));
    for (std::size_t i = uniformBytes_.size() / stride; i-- > scene.instances.size();)
        freeUniforms_.push_back(stride * i);
    // Dynamic objects come last in each buffer, so that a pose uploads one range.
    std::size_t nextStatic = 0;
    auto nextMoving =
        static_cast<std::size_t>(std::count_if(scene.instances.begin(), scene.instances.end(),
                                               [](const Instance& instance) { return !instance.moves(); }));
    std::map<int, std::size_t> movingMeshes;
    // An added instance may have any mesh.
    for (std::size_t i = 0; instanceRoom_ > 0 && i < scene.meshes.size(); ++i) {
        const int mesh = static_cast<int>(i);
        movingMeshes.emplace(mesh, i);
        movingMeshes_.push_back({scene.meshes[i], cornersOf(scene.meshes[i]), indices.firstVertexOf(mesh),
                                 indices.firstOfMesh(mesh)});
    }
    std::map<int, std::vector<glm::dvec3>> corners;  // of the bounds of static meshes
    for (const Instance& instance : scene.instances) {
        const Mesh& mesh = scene.meshes[instance.mesh];
        const Material& material = scene.materials[mesh.material];
        Draw draw;
        draw.instance = static_cast<std::size_t>(&instance - scene.instances.data());
        draw.mirrored = isMirrored(instance.worldFromObject);
        draw.triangles = {indices.firstOfMesh(instance.mesh), static_cast<int>(mesh.indices.size())};
        draw.uniformOffset = stride * (instance.moves() ? nextMoving++ : nextStatic++);
        setMaterial(draw, material, materialFeatures(material) | sharedFeatures(scene));
        shared::DrawUniforms values;
        std::memcpy(&values, &uniformBytes_[draw.uniformOffset], sizeof values);
        values.surface.w = !emitterInstances.empty() && emitterInstances[draw.instance] ? 0.0F : 1.0F;
        vct::place(values, instance.worldFromObject, mesh.centre, volumeFromWorld_);
        if (instance.deforms) values.volumeFromObject = values.normalFromObject = glm::mat4(1.0F);
        std::memcpy(&uniformBytes_[draw.uniformOffset], &values, sizeof values);
        if (instance.deforms) {
            addDeforming(instance, mesh, draw);
            moving_.back().firstVertex = indices.firstVertexOf(instance.mesh);
            moving_.back().emission = glm::vec3(values.emissive);
        } else if (instance.moves()) {
            addMoving(instance, mesh, indices.firstVertexOf(instance.mesh), draw, movingMeshes);
            moving_.back().emission = glm::vec3(values.emissive);
        } else {
            std::vector<glm::dvec3>& around = corners[instance.mesh];
            if (around.empty()) around = cornersOf(mesh);
            draw.boundsWorld = boundsOf(around, instance.worldFromObject);
        }
        if (!instance.moves() && voxelization == Voxelization::sortedAxes) {
            const AxisSort sorted = sortByAxis(mesh, values.volumeFromObject);
            std::size_t first = indices.firstOf(instance.mesh, sorted.indices);
            for (std::size_t axis = 0; axis < 3; ++axis) {
                draw.trianglesByAxis[axis] = {first, sorted.indexCounts[axis]};
                first += static_cast<std::size_t>(sorted.indexCounts[axis]);
            }
        }
        draws_.push_back(draw);
    }
    firstMovingIndex_ = indices.all().size();
    for (Draw& draw : draws_)
        if (draw.moving >= 0 && moving_[static_cast<std::size_t>(draw.moving)].form == nullptr) place(draw);
    std::vector<std::uint32_t> allIndices = indices.all();
    allIndices.insert(allIndices.end(), movingIndices_.begin(), movingIndices_.end());
    if (!deforming_.empty()) makeDeformer(shaders, allIndices);
    sortDraws();

    uniforms_ = gl::Buffer("draw uniforms", GL_UNIFORM_BUFFER, uniformBytes_.size(), uniformBytes_.data(),
                           moves() ? GL_DYNAMIC_DRAW : GL_STATIC_DRAW);
    uploadGeometry(scene, allIndices);
    uploadTextures(scene);
    std::vector<std::size_t> all;
    for (std::size_t i = 0; i < moving_.size(); ++i)
        if (moving_[i].form != nullptr) all.push_back(i);
    deform(all);
}

void GpuScene::addMoving(const Instance& instance, const Mesh& mesh, std::uint32_t firstVertex, Draw& draw,
                         std::map<int, std::size_t>& meshes) {
    const auto [found, added] = meshes.try_emplace(instance.mesh, movingMeshes_.size());
    if (added) {
        movingMeshes_.push_back({mesh, cornersOf(mesh)});
    }
    draw.moving = static_cast<int>(moving_.size());
    moving_.push_back(
        {instance.node, instance.worldFromObject, found->second, firstVertex, movingIndices_.size(), {}});
    if (voxelization_ == Voxelization::sortedAxes)
        movingIndices_.resize(movingIndices_.size() + mesh.indices.size());
}

void GpuScene::addDeforming(const Instance& instance, const Mesh& mesh, Draw& draw) {
    Moving moving;
    moving.node = instance.node;
    moving.mesh = deforming_.size();
    deforming_.push_back({mesh.deformation, DeformationBoxes(*mesh.deformation)});
    setForm(moving, stateOf(*mesh.deformation, nullptr));
    draw.moving = static_cast<int>(moving_.size());
    moving_.push_back(std::move(moving));
}

// Reserves room for the sorted triangles at the end of `indices`, the whole index buffer.
void GpuScene::makeDeformer(const gl::ShaderLibrary& shaders, std::vector<std::uint32_t>& indices) {
    const bool sorts = voxelization_ == Voxelization::sortedAxes;
    std::vector<Deformer::Part> parts;
    for (Draw& draw : draws_) {
        const Moving* const moving =
            draw.moving < 0 ? nullptr : &moving_[static_cast<std::size_t>(draw.moving)];
        if (moving == nullptr || moving->form == nullptr) continue;
        const auto count = static_cast<std::size_t>(draw.triangles.count);
        parts.push_back({deforming_[moving->mesh].deformation,
                         count / 3,
                         {moving->firstVertex, draw.triangles.first, indices.size()}});
        if (!sorts) continue;
        for (IndexRange& range : draw.trianglesByAxis) {
            range = {indices.size(), draw.triangles.count};
            indices.resize(indices.size() + count, moving->firstVertex);
        }
    }
    deformer_.emplace(shaders, std::move(parts), sorts, volumeFromWorld_);
}

void GpuScene::setForm(Moving& moving, DeformationState state) {
    moving.boundsWorld = deforming_[moving.mesh].boxes.around(state, glm::dmat4(1.0));
    moving.form = std::make_shared<const DeformationState>(std::move(state));
}

// `changed`: indices into moving_ of the objects whose form has changed.
void GpuScene::deform(const std::vector<std::size_t>& changed) const {
    if (changed.empty()) return;
    Deformer::begin();
    for (const std::size_t i : changed)
        deformer_->deform(moving_[i].mesh, *moving_[i].form, vertices_, indices_, vertexFloats_);
    Deformer::end();
}

// Writes a rigid dynamic object's uniforms to uniformBytes_ and its sorted triangles to movingIndices_.
void GpuScene::place(Draw& draw) {
    Moving& moving = moving_[static_cast<std::size_t>(draw.moving)];
    const Mesh& mesh = movingMeshes_[moving.mesh].mesh;
    moving.boundsWorld = boundsOf(movingMeshes_[moving.mesh].corners, moving.worldFromObject);
    shared::DrawUniforms values;
    std::memcpy(&values, &uniformBytes_[draw.uniformOffset], sizeof values);
    vct::place(values, moving.worldFromObject, mesh.centre, volumeFromWorld_);
    std::memcpy(&uniformBytes_[draw.uniformOffset], &values, sizeof values);
    draw.mirrored = isMirrored(moving.worldFromObject);
    if (voxelization_ == Voxelization::geometryShader) return;

    AxisSort sorted = sortByAxis(mesh, values.volumeFromObject);
    for (std::uint32_t& index : sorted.indices)
        index += moving.firstVertex;
    std::size_t first = moving.firstIndex;
    if (moving.origin == Moving::Origin::added) {
        constexpr std::size_t size = sizeof sorted.indices[0];
        upload(indices_, first * size, sorted.indices.size() * size, sorted.indices.data());
    } else {
        std::copy(sorted.indices.begin(), sorted.indices.end(),
                  movingIndices_.begin() + static_cast<std::ptrdiff_t>(first));
        first += firstMovingIndex_;
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
        draw.trianglesByAxis[axis] = {first, sorted.indexCounts[axis]};
        first += static_cast<std::size_t>(sorted.indexCounts[axis]);
    }
}

std::vector<Placement> GpuScene::placements() const {
    std::vector<Placement> placements;
    for (const Moving& moving : moving_) {
        if (moving.origin == Moving::Origin::removed) {
            placements.emplace_back().isVisible = false;
            placements.back().changes = moving.changes;
            continue;
        }
        const Bounds box =
            moving.form != nullptr
                ? deforming_[moving.mesh].boxes.around(*moving.form, volumeFromWorld_)
                : boundsOf(movingMeshes_[moving.mesh].corners, volumeFromWorld_ * moving.worldFromObject);
        placements.push_back({moving.worldFromObject, box, moving.form, moving.isVisible,
                              moving.emissionScale, moving.changes});
    }
    return placements;
}

Bounds GpuScene::boundsWith(const Bounds& boundsWorld) const {
    Bounds bounds = boundsWorld;
    for (const Moving& moving : moving_)
        if (moving.isVisible) bounds = united(bounds, moving.boundsWorld);
    return bounds;
}

Bounds GpuScene::movingBounds() const {
    Bounds bounds = noBounds;
    for (const Moving& moving : moving_)
        if (moving.isVisible)
            bounds = united(bounds, boundsOf(cornersOf(moving.boundsWorld), volumeFromWorld_));
    return bounds;
}

std::vector<glm::vec4> GpuScene::movingSpheres(std::size_t largest) const {
    std::vector<std::vector<Bounds>> groups(1);
    for (const Moving& moving : moving_)
        if (moving.isVisible) groups[0].push_back(moving.boundsWorld);
    if (groups[0].empty()) return {};
    const auto around = [](const std::vector<Bounds>& boxes) {
        return std::accumulate(boxes.begin() + 1, boxes.end(), boxes[0], united);
    };
    // Halve the largest group until there are enough.
    while (groups.size() < largest) {
        const auto size = [&](const std::vector<Bounds>& boxes) {
            const Bounds box = around(boxes);
            return boxes.size() > 1 ? glm::length(box.max - box.min) : 0.0;
        };
        const auto widest = std::max_element(groups.begin(), groups.end(),
                                             [&](const auto& a, const auto& b) { return size(a) < size(b); });
        if (widest->size() < 2) break;
        std::vector<Bounds> boxes = std::move(*widest);
        const glm::dvec3 extent = around(boxes).max - around(boxes).min;
        const int axis = extent.x >= extent.y && extent.x >= extent.z ? 0 : extent.y >= extent.z ? 1 : 2;
        std::sort(boxes.begin(), boxes.end(), [&](const Bounds& a, const Bounds& b) {
            return a.min[axis] + a.max[axis] < b.min[axis] + b.max[axis];
        });
        const auto middle = boxes.begin() + static_cast<std::ptrdiff_t>(boxes.size() / 2);
        *widest = {boxes.begin(), middle};
        groups.emplace_back(middle, boxes.end());
    }
    std::vector<glm::vec4> spheres;
    const double scale = glm::length(glm::dvec3(volumeFromWorld_[0]));
    for (const std::vector<Bounds>& boxes : groups) {
        const Bounds box = around(boxes);
        const glm::dvec3 middle(volumeFromWorld_ * glm::dvec4(0.5 * (box.min + box.max), 1.0));
        spheres.emplace_back(glm::vec3(middle), 0.5 * scale * glm::length(box.max - box.min));
    }
    return spheres;
}

void GpuScene::sortDraws() {
    std::stable_sort(draws_.begin(), draws_.end(), [](const Draw& a, const Draw& b) {
        return std::tie(a.features, a.baseColorTexture, a.emissiveTexture) <
               std::tie(b.features, b.baseColorTexture, b.emissiveTexture);
    });
    visibleDraws_.resize(draws_.size());
    std::iota(visibleDraws_.begin(), visibleDraws_.end(), std::size_t{0});
    sortVisibleDraws();
}

void GpuScene::sortVisibleDraws() {
    std::stable_sort(visibleDraws_.begin(), visibleDraws_.end(), [&](std::size_t i, std::size_t j) {
        const Draw& a = draws_[i];
        const Draw& b = draws_[j];
        const auto key = [](const Draw& d) {
            return std::tie(d.features, d.baseColorTexture, d.emissiveTexture, d.triangles.first);
        };
        if (key(a) != key(b)) return key(a) < key(b);
        return std::memcmp(&uniformBytes_[a.uniformOffset], &uniformBytes_[b.uniformOffset],
                           sizeof(shared::DrawUniforms)) < 0;
    });
}

void GpuScene::setPose(const Pose& pose) {
    struct Range {
        std::size_t begin = std::numeric_limits<std::size_t>::max(), end = 0;
        void add(std::size_t first, std::size_t count) {
            begin = std::min(begin, first);
            end = std::max(end, first + count);
        }
    };
    Range bytes, indices;
    std::vector<std::size_t> deformed;
    for (Draw& draw : draws_) {
        if (draw.moving < 0) continue;
        Moving& moving = moving_[static_cast<std::size_t>(draw.moving)];
        if (moving.form != nullptr) {
            DeformationState state = stateOf(*deforming_[moving.mesh].deformation, &pose);
            state.changes = moving.form->changes;
            if (state == *moving.form) continue;
            setForm(moving, std::move(state));
            deformed.push_back(static_cast<std::size_t>(draw.moving));
            continue;
        }
        const glm::dmat4& worldFromObject = pose.worldFromNode.at(static_cast<std::size_t>(moving.node));
        if (worldFromObject == moving.worldFromObject) continue;
        moving.worldFromObject = worldFromObject;
        place(draw);
        bytes.add(draw.uniformOffset, sizeof(shared::DrawUniforms));
        if (moving.origin == Moving::Origin::described)
            indices.add(moving.firstIndex, static_cast<std::size_t>(draw.triangles.count));
    }
    deform(deformed);
    if (bytes.end == 0) return;
    sortVisibleDraws();
    upload(uniforms_, bytes.begin, bytes.end - bytes.begin, &uniformBytes_[bytes.begin]);
    if (movingIndices_.empty() || indices.end == 0) return;
    constexpr std::size_t size = sizeof movingIndices_[0];
    upload(indices_, (firstMovingIndex_ + indices.begin) * size, (indices.end - indices.begin) * size,
           &movingIndices_[indices.begin]);
}

void GpuScene::setVertices(int node, const ExternalVertices& vertices) {
    for (std::size_t i = 0; i < moving_.size(); ++i) {
        Moving& moving = moving_[i];
        if (moving.form == nullptr || moving.node != node) continue;
        deforming_[moving.mesh].boxes = DeformationBoxes(vertices.box);
        DeformationState state = *moving.form;
        ++state.changes;
        setForm(moving, std::move(state));
        Deformer::begin();
        deformer_->copyVertices(moving.mesh, vertices);
        deform({i});
    }
}

void GpuScene::setAppearance(int node, bool isVisible, float emissionScale) {
    for (const Draw& draw : draws_) {
        if (draw.moving < 0) continue;
        Moving& moving = moving_[static_cast<std::size_t>(draw.moving)];
        if (moving.node != node) continue;
        moving.isVisible = isVisible;
        if (moving.emissionScale == emissionScale) continue;
        moving.emissionScale = emissionScale;
        shared::DrawUniforms values;
        std::memcpy(&values, &uniformBytes_[draw.uniformOffset], sizeof values);
        values.emissive = glm::vec4(emissionScale * moving.emission, values.emissive.w);
        std::memcpy(&uniformBytes_[draw.uniformOffset], &values, sizeof values);
        upload(uniforms_, draw.uniformOffset, sizeof values, &values);
    }
}

void GpuScene::bindDraw(const Draw& draw, const gl::Program*& current,
                        const MaterialPrograms& programs) const {
    const MaterialPrograms::Variant& variant = programs(draw.features);
    if (&variant.program != current) variant.program.use();
    current = &variant.program;
    if (variant.readsBaseColorTexture) textures_[draw.baseColorTexture].bind(VCT_TEX_BASE_COLOR);
    if (variant.readsEmissiveTexture) textures_[draw.emissiveTexture].bind(VCT_TEX_EMISSIVE);
    if (variant.readsGlossTexture) dataTextures_[draw.glossTexture].bind(VCT_TEX_GLOSS);
    if (variant.readsNormalMap) dataTextures_[draw.normalTexture].bind(VCT_TEX_NORMAL_MAP);
    gl::FrontFace(draw.mirrored ? GL_CW : GL_CCW);
    gl::BindBufferRange(GL_UNIFORM_BUFFER, VCT_UBO_DRAW, uniforms_.name(),
                        static_cast<GLintptr>(draw.uniformOffset), sizeof(shared::DrawUniforms));
}

void GpuScene::bindGeometry() const {
    vertexArray_.bind();
    // A vertex array should keep this binding, but some Adreno and Mali drivers lose it (Filament,
    // OpenGLContext.h, vao_doesnt_store_element_array_buffer_binding).
    indices_.bind(GL_ELEMENT_ARRAY_BUFFER);
}

bool GpuScene::isDrawn(const Draw& draw, const DrawRegion& region) const {
    const Moving* const moving = draw.moving < 0 ? nullptr : &moving_[static_cast<std::size_t>(draw.moving)];
    if (moving != nullptr && !moving->isVisible) return false;
    const Bounds& world = moving != nullptr ? moving->boundsWorld : draw.boundsWorld;
    // The matrix only scales and translates.
    return region.meets({glm::dvec3(volumeFromWorld_ * glm::dvec4(world.min, 1.0)),
                         glm::dvec3(volumeFromWorld_ * glm::dvec4(world.max, 1.0))});
}

void GpuScene::draw(Culling culling, const MaterialPrograms& programs, const DrawRegion& region) const {
    bindGeometry();
    gl::CullFace(GL_BACK);
    const gl::Program* current = nullptr;
    for (std::size_t i = 0; i < draws_.size(); ++i) {
        const Draw& draw = draws_[culling == Culling::backFaces ? visibleDraws_[i] : i];
        if (!isDrawn(draw, region)) continue;
        bindDraw(draw, current, programs);
        (culling == Culling::backFaces && !draw.doubleSided ? gl::Enable : gl::Disable)(GL_CULL_FACE);
        drawTriangles(draw.triangles.first, draw.triangles.count);
    }
}

void GpuScene::drawForVoxels(const MaterialPrograms& programs, const DrawRegion& region,
                             ScenePart part) const {
    bindGeometry();
    gl::Disable(GL_CULL_FACE);
    const gl::Program* current = nullptr;
    for (const Draw& draw : draws_) {
        const bool isDynamic = draw.moving >= 0;
        if (part != ScenePart::all && isDynamic != (part == ScenePart::dynamicOnly)) continue;
        if (!isDrawn(draw, region)) continue;
        bindDraw(draw, current, programs);
        if (voxelization_ == Voxelization::geometryShader) {
            drawTriangles(draw.triangles.first, draw.triangles.count);
            continue;
        }
        for (GLuint axis = 0; axis < 3; ++axis) {
            const IndexRange& range = draw.trianglesByAxis[axis];
            if (range.count == 0) continue;
            gl::Uniform1ui(VCT_UNIFORM_AXIS, axis);
            drawTriangles(range.first, range.count);
        }
    }
}

Resources GpuScene::resources() const {
    Resources resources;
    for (const gl::Buffer* buffer : {&vertices_, &indices_, &uniforms_})
        add(resources, *buffer);
    if (deformer_) add(resources, deformer_->resources());
    std::size_t textureBytes = 0;
    for (const std::vector<gl::Texture>* textures : {&textures_, &dataTextures_})
        for (const gl::Texture& texture : *textures)
            textureBytes += texture.bytes();
    if (textureBytes > 0) resources.push_back({"scene textures", textureBytes});
    return resources;
}

}  // namespace vct
