#include "engine/deformer.h"

#include <algorithm>
#include <cstring>

#include "gl/debug.h"

namespace vct {

namespace {

// Binds `bytes` bytes of `buffer` from byte `first` on. The binding has to begin at a multiple of the
// driver's alignment, so it may include bytes before `first`; their number is returned.
std::size_t bindPart(GLuint index, const gl::Buffer& buffer, std::size_t first, std::size_t bytes) {
    GLint alignment = 1;
    gl::GetIntegerv(GL_SHADER_STORAGE_BUFFER_OFFSET_ALIGNMENT, &alignment);
    const std::size_t before = first % static_cast<std::size_t>(std::max(alignment, 4));
    gl::BindBufferRange(GL_SHADER_STORAGE_BUFFER, index, buffer.name(), static_cast<GLintptr>(first - before),
                        static_cast<GLsizeiptr>(before + bytes));
    return before;
}

void setRange(int which, std::size_t value) {
    gl::Uniform1ui(VCT_UNIFORM_DEFORM + which, static_cast<GLuint>(value));
}

void dispatchOver(std::size_t count) {
    const std::size_t groups = (count + VCT_LIST_GROUP - 1) / VCT_LIST_GROUP;
    gl::DispatchCompute(static_cast<GLuint>(std::min<std::size_t>(groups, VCT_MAX_GROUPS)), 1, 1);
}

std::vector<shared::DeformSource> sourcesOf(const Deformation& deformation) {
    std::vector<shared::DeformSource> sources(deformation.positions.size());
    for (std::size_t i = 0; i < sources.size(); ++i) {
        const Influences influences =
            deformation.influences.empty() ? Influences() : deformation.influences[i];
        const auto joints = [&](std::size_t low) {
            return std::uint32_t{influences.joints[low]} | std::uint32_t{influences.joints[low + 1]} << 16;
        };
        sources[i].position = deformation.positions[i];
        sources[i].joints01 = joints(0);
        sources[i].normal = deformation.normals[i];
        sources[i].joints23 = joints(2);
        for (int w = 0; w < 4; ++w)
            sources[i].weights[w] = influences.weights[static_cast<std::size_t>(w)];
    }
    return sources;
}

std::vector<glm::vec3> displacementsOf(const Deformation& deformation) {
    std::vector<glm::vec3> displacements;
    for (const MorphTarget& target : deformation.targets)
        for (std::size_t i = 0; i < target.positions.size(); ++i) {
            displacements.push_back(target.positions[i]);
            displacements.push_back(target.normals.empty() ? glm::vec3(0.0F) : target.normals[i]);
        }
    return displacements;
}

template <class T>
gl::Buffer storage(const std::string& label, std::vector<T> values) {
    if (values.empty()) values.resize(1);  // a buffer of no bytes cannot be bound
    return {label, GL_SHADER_STORAGE_BUFFER, values.size() * sizeof(T), values.data(), GL_STATIC_DRAW};
}

}  // namespace

gl::ProgramDescription deformProgram() {
    return {"deform", {"passes/deform.comp"}, {}};
}

gl::ProgramDescription sortAxesProgram() {
    return {"sort_axes", {"passes/sort_axes.comp"}, {}};
}

gl::ProgramDescription copyVerticesProgram() {
    return {"copy_vertices", {"passes/copy_vertices.comp"}, {}};
}

Deformer::Deformer(const gl::ShaderLibrary& shaders, std::vector<Part> parts, bool sorts,
                   const glm::dmat4& volumeFromWorld)
    : deform_(shaders, deformProgram()),
      shaders_(shaders),
      volumeFromWorld_(volumeFromWorld),
      parts_(std::move(parts)) {
    if (sorts) sort_.emplace(shaders, sortAxesProgram());
    std::vector<shared::DeformSource> sources;
    std::vector<glm::vec3> displacements;
    std::size_t states = 0;
    for (const Part& part : parts_) {
        const Deformation& deformation = *part.deformation;
        first_.push_back({sources.size(), 3 * displacements.size(), states});
        const std::vector<shared::DeformSource> partSources = sourcesOf(deformation);
        sources.insert(sources.end(), partSources.begin(), partSources.end());
        const std::vector<glm::vec3> targetDisplacements = displacementsOf(deformation);
        displacements.insert(displacements.end(), targetDisplacements.begin(), targetDisplacements.end());
        states += 3 * deformation.joints.size() + deformation.targets.size();
    }
    sources_ = storage("deform sources", std::move(sources));
    displacements_ = storage("morph targets", std::move(displacements));
    state_ = storage("joints and weights", std::vector<glm::vec4>(states));
}

void Deformer::begin() {
    // Earlier draws must have read the vertices before they are overwritten.
    gl::MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

void Deformer::end() {
    gl::MemoryBarrier(GL_VERTEX_ATTRIB_ARRAY_BARRIER_BIT | GL_ELEMENT_ARRAY_BARRIER_BIT);
}

void Deformer::copyVertices(std::size_t index, const ExternalVertices& vertices) {
    const gl::DebugGroup group("copy vertices");
    const Deformation& deformation = *parts_[index].deformation;
    if (!copy_) copy_.emplace(shaders_, copyVerticesProgram());
    copy_->use();
    sources_.bindBase(GL_SHADER_STORAGE_BUFFER, VCT_SSBO_DEFORM_SOURCES);
    gl::BindBufferBase(GL_SHADER_STORAGE_BUFFER, VCT_SSBO_COPY_POSITIONS, vertices.positions.buffer);
    gl::BindBufferBase(GL_SHADER_STORAGE_BUFFER, VCT_SSBO_COPY_NORMALS, vertices.normals.buffer);
    setRange(VCT_DEFORM_COUNT, deformation.positions.size());
    setRange(VCT_COPY_FIRST_POSITION, vertices.positions.firstFloat);
    setRange(VCT_COPY_POSITION_STRIDE, vertices.positions.strideFloats);
    setRange(VCT_DEFORM_FIRST_SOURCE, first_[index].source);
    setRange(VCT_COPY_FIRST_NORMAL, vertices.normals.firstFloat);
    setRange(VCT_COPY_NORMAL_STRIDE, vertices.normals.strideFloats);
    const glm::vec3 centre(deformation.centre);
    gl::Uniform4f(VCT_UNIFORM_COPY_CENTRE, centre.x, centre.y, centre.z, 0.0F);
    dispatchOver(deformation.positions.size());
    gl::MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

void Deformer::deform(std::size_t index, const DeformationState& state, const gl::Buffer& vertices,
                      const gl::Buffer& indices, std::size_t vertexFloats) const {
    const gl::DebugGroup group("deform");
    const Part& part = parts_[index];
    const First& first = first_[index];
    const Deformation& deformation = *part.deformation;
    std::vector<glm::vec4> values;
    const glm::dmat4 centred(glm::dvec4(1, 0, 0, 0), glm::dvec4(0, 1, 0, 0), glm::dvec4(0, 0, 1, 0),
                             glm::dvec4(deformation.centre, 1.0));
    for (const glm::dmat4& worldFromObject : state.worldFromObject) {
        const glm::dmat4 rows = glm::transpose(volumeFromWorld_ * worldFromObject * centred);
        for (int row = 0; row < 3; ++row)
            values.emplace_back(rows[row]);
    }
    for (std::size_t target = 0; target < deformation.targets.size(); ++target)
        values.emplace_back(state.weights[target], 0.0F, 0.0F, 0.0F);
    state_.bind(GL_COPY_WRITE_BUFFER);
    gl::BufferSubData(GL_COPY_WRITE_BUFFER, static_cast<GLintptr>(first.state * sizeof values[0]),
                      static_cast<GLsizeiptr>(values.size() * sizeof values[0]), values.data());

    const std::size_t count = deformation.positions.size();
    const std::size_t vertexBytes = vertexFloats * sizeof(float);
    deform_.use();
    const std::size_t before = bindPart(VCT_SSBO_DEFORM_VERTICES, vertices,
                                        part.place.firstVertex * vertexBytes, count * vertexBytes);
    sources_.bindBase(GL_SHADER_STORAGE_BUFFER, VCT_SSBO_DEFORM_SOURCES);
    displacements_.bindBase(GL_SHADER_STORAGE_BUFFER, VCT_SSBO_DEFORM_DISPLACEMENTS);
    state_.bindBase(GL_SHADER_STORAGE_BUFFER, VCT_SSBO_DEFORM_STATE);
    setRange(VCT_DEFORM_COUNT, count);
    setRange(VCT_DEFORM_FIRST_FLOAT, before / sizeof(float));
    setRange(VCT_DEFORM_VERTEX_FLOATS, vertexFloats);
    setRange(VCT_DEFORM_FIRST_SOURCE, first.source);
    setRange(VCT_DEFORM_FIRST_DISPLACEMENT, first.displacement);
    setRange(VCT_DEFORM_TARGETS, deformation.targets.size());
    setRange(VCT_DEFORM_FIRST_STATE, first.state);
    setRange(VCT_DEFORM_FIRST_WEIGHT, first.state + 3 * deformation.joints.size());
    dispatchOver(count);
    if (sort_) sort(part, vertices, indices, vertexFloats);
}

void Deformer::sort(const Part& part, const gl::Buffer& vertices, const gl::Buffer& indices,
                    std::size_t vertexFloats) const {
    gl::MemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
    const std::size_t vertexBytes = vertexFloats * sizeof(float);
    const std::size_t cornerBytes = 3 * part.triangles * sizeof(std::uint32_t);
    sort_->use();
    const std::size_t beforeVertices =
        bindPart(VCT_SSBO_DEFORM_VERTICES, vertices, part.place.firstVertex * vertexBytes,
                 part.deformation->positions.size() * vertexBytes);
    const std::size_t beforeCorners =
        bindPart(VCT_SSBO_SORT_CORNERS, indices, part.place.firstIndex * sizeof(std::uint32_t), cornerBytes);
    const std::size_t beforeSorted = bindPart(
        VCT_SSBO_SORT_SORTED, indices, part.place.firstSorted * sizeof(std::uint32_t), 3 * cornerBytes);
    setRange(VCT_DEFORM_COUNT, part.triangles);
    setRange(VCT_DEFORM_FIRST_FLOAT, beforeVertices / sizeof(float));
    setRange(VCT_DEFORM_VERTEX_FLOATS, vertexFloats);
    setRange(VCT_SORT_FIRST_VERTEX, part.place.firstVertex);
    setRange(VCT_SORT_FIRST_CORNER, beforeCorners / sizeof(std::uint32_t));
    setRange(VCT_SORT_FIRST_SORTED, beforeSorted / sizeof(std::uint32_t));
    dispatchOver(part.triangles);
}

Resources Deformer::resources() const {
    Resources resources;
    for (const gl::Buffer* buffer : {&sources_, &displacements_, &state_})
        add(resources, *buffer);
    return resources;
}

}  // namespace vct
