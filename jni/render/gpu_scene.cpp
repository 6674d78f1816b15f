#include "render/gpu_scene.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <set>
#include <tuple>

#include "render/programs.h"
#include "shared/layout.h"

namespace vct {

namespace {

GLenum glWrap(Texture::Wrap wrap) {
    switch (wrap) {
        case Texture::Wrap::clampToEdge:
            return GL_CLAMP_TO_EDGE;
        case Texture::Wrap::mirroredRepeat:
            return GL_MIRRORED_REPEAT;
        case Texture::Wrap::repeat:
            break;
    }
    return GL_REPEAT;
}

gl::Texture uploadTexture(const Texture& source) {
    const int levels = static_cast<int>(std::log2(std::max(source.width, source.height))) + 1;
    gl::Texture texture =
        gl::Texture::make2d("texture " + source.name, GL_SRGB8_ALPHA8, source.width, source.height, levels);
    gl::PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    gl::TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, source.width, source.height, GL_RGBA, GL_UNSIGNED_BYTE,
                      source.rgba.data());
    gl::GenerateMipmap(GL_TEXTURE_2D);
    texture.setFilter(GL_LINEAR_MIPMAP_LINEAR, source.linearFilter ? GL_LINEAR : GL_NEAREST);
    texture.setParameter(GL_TEXTURE_WRAP_S, glWrap(source.wrapS));
    texture.setParameter(GL_TEXTURE_WRAP_T, glWrap(source.wrapT));
    return texture;
}

// All in double until the last step: a scene may lie 10^6 units from the origin.
shared::DrawUniforms drawUniforms(const Instance& instance, const Mesh& mesh, const Material& material,
                                  const glm::dmat4& volumeFromWorld, float radianceUnit) {
    const glm::dmat4 centred =
        instance.worldFromObject * glm::dmat4(glm::dvec4(1, 0, 0, 0), glm::dvec4(0, 1, 0, 0),
                                              glm::dvec4(0, 0, 1, 0), glm::dvec4(mesh.centre, 1.0));
    // Cofactors instead of the inverse transpose: the same direction, and finite for a scale of zero.
    const glm::dmat3 m(instance.worldFromObject);
    glm::dmat3 cofactors(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
    const double sign = glm::determinant(m) < 0.0 ? -1.0 : 1.0;
    double largest = 0.0;
    for (int c = 0; c < 3; ++c)
        for (int r = 0; r < 3; ++r)
            largest = std::max(largest, std::abs(cofactors[c][r]));
    cofactors *= largest > 0.0 ? sign / largest : 0.0;

    shared::DrawUniforms uniforms{};
    uniforms.volumeFromObject = glm::mat4(volumeFromWorld * centred);
    uniforms.normalFromObject = glm::mat4(glm::dmat4(cofactors));
    uniforms.baseColor = material.baseColor;
    uniforms.emissive = glm::vec4(material.emissive / radianceUnit, 0.0F);
    uniforms.surface = glm::vec4(material.alphaCutoff, material.doubleSided ? 1.0F : 0.0F, 0.0F, 0.0F);
    return uniforms;
}

}  // namespace

GpuScene::GpuScene(const Scene& scene, const Volume& volume, float radianceUnit, int uniformAlignment) {
    std::vector<std::size_t> firstIndex;
    std::size_t indexCount = 0;
    for (const Mesh& mesh : scene.meshes) {
        firstIndex.push_back(indexCount);
        indexCount += mesh.indices.size();
    }

    const auto alignment = static_cast<std::size_t>(uniformAlignment);
    const std::size_t stride = (sizeof(shared::DrawUniforms) + alignment - 1) / alignment * alignment;
    std::vector<unsigned char> uniforms(stride * scene.instances.size());
    for (const Instance& instance : scene.instances) {
        const Mesh& mesh = scene.meshes[instance.mesh];
        const Material& material = scene.materials[mesh.material];
        Draw draw;
        draw.features = materialFeatures(material);
        draw.baseColorTexture = material.baseColorTexture;
        draw.emissiveTexture = material.emissiveTexture;
        draw.doubleSided = material.doubleSided;
        draw.mirrored = glm::determinant(glm::dmat3(instance.worldFromObject)) < 0.0;
        draw.firstIndex = firstIndex[instance.mesh];
        draw.indexCount = static_cast<int>(mesh.indices.size());
        draw.uniformOffset = stride * draws_.size();
        const shared::DrawUniforms values =
            drawUniforms(instance, mesh, material, volume.volumeFromWorld(), radianceUnit);
        std::memcpy(&uniforms[draw.uniformOffset], &values, sizeof values);
        draws_.push_back(draw);
    }
    std::stable_sort(draws_.begin(), draws_.end(), [](const Draw& a, const Draw& b) {
        return std::tie(a.features, a.baseColorTexture, a.emissiveTexture) <
               std::tie(b.features, b.baseColorTexture, b.emissiveTexture);
    });
    visibleDraws_ = draws_;
    std::stable_sort(visibleDraws_.begin(), visibleDraws_.end(), [&](const Draw& a, const Draw& b) {
        const auto key = [](const Draw& d) {
            return std::tie(d.features, d.baseColorTexture, d.emissiveTexture, d.firstIndex);
        };
        if (key(a) != key(b)) return key(a) < key(b);
        return std::memcmp(&uniforms[a.uniformOffset], &uniforms[b.uniformOffset],
                           sizeof(shared::DrawUniforms)) < 0;
    });
    uniforms_ =
        gl::Buffer("draw uniforms", GL_UNIFORM_BUFFER, uniforms.size(), uniforms.data(), GL_STATIC_DRAW);
    uploadGeometry(scene);
    uploadTextures(scene);
}

void GpuScene::uploadGeometry(const Scene& scene) {
    std::vector<Vertex> vertices;
    std::vector<std::uint32_t> indices;
    for (const Mesh& mesh : scene.meshes) {
        // ES 3.1 has no base vertex: it goes into the indices.
        const auto base = static_cast<std::uint32_t>(vertices.size());
        vertices.insert(vertices.end(), mesh.vertices.begin(), mesh.vertices.end());
        for (std::uint32_t index : mesh.indices)
            indices.push_back(base + index);
    }
    vertexArray_.bind();
    indices_ = gl::Buffer("indices", GL_ELEMENT_ARRAY_BUFFER, indices.size() * sizeof indices[0],
                          indices.data(), GL_STATIC_DRAW);
    vertices_ = gl::Buffer("vertices", GL_ARRAY_BUFFER, vertices.size() * sizeof vertices[0], vertices.data(),
                           GL_STATIC_DRAW);
    const auto attribute = [](GLuint location, int components, std::size_t offset) {
        gl::EnableVertexAttribArray(location);
        gl::VertexAttribPointer(location, components, GL_FLOAT, GL_FALSE, sizeof(Vertex),
                                reinterpret_cast<const void*>(offset));
    };
    attribute(VCT_ATTRIBUTE_POSITION, 3, offsetof(Vertex, position));
    attribute(VCT_ATTRIBUTE_NORMAL, 3, offsetof(Vertex, normal));
    attribute(VCT_ATTRIBUTE_UV, 2, offsetof(Vertex, uv));
    attribute(VCT_ATTRIBUTE_EMISSIVE_UV, 2, offsetof(Vertex, emissiveUv));
}

void GpuScene::uploadTextures(const Scene& scene) {
    for (const Texture& texture : scene.textures)
        textures_.push_back(uploadTexture(texture));
}

void GpuScene::draw(Culling culling, const MaterialPrograms& programs) const {
    vertexArray_.bind();
    gl::CullFace(GL_BACK);
    const gl::Program* current = nullptr;
    for (const Draw& draw : culling == Culling::backFaces ? visibleDraws_ : draws_) {
        const gl::Program& program = programs(draw.features);
        if (&program != current) program.use();
        current = &program;
        if (draw.features & featureBaseColorTexture)
            textures_[draw.baseColorTexture].bind(VCT_TEX_BASE_COLOR);
        if (draw.features & featureEmissiveTexture) textures_[draw.emissiveTexture].bind(VCT_TEX_EMISSIVE);
        (culling == Culling::backFaces && !draw.doubleSided ? gl::Enable : gl::Disable)(GL_CULL_FACE);
        gl::FrontFace(draw.mirrored ? GL_CW : GL_CCW);
        gl::BindBufferRange(GL_UNIFORM_BUFFER, VCT_UBO_DRAW, uniforms_.name(),
                            static_cast<GLintptr>(draw.uniformOffset), sizeof(shared::DrawUniforms));
        gl::DrawElements(GL_TRIANGLES, draw.indexCount, GL_UNSIGNED_INT,
                         reinterpret_cast<const void*>(draw.firstIndex * sizeof(std::uint32_t)));
    }
}

std::vector<unsigned> GpuScene::featuresThatOccur() const {
    std::set<unsigned> features;
    for (const Draw& draw : draws_)
        features.insert(draw.features);
    return {features.begin(), features.end()};
}

bool GpuScene::hasEmission() const {
    return std::any_of(draws_.begin(), draws_.end(),
                       [](const Draw& draw) { return (draw.features & featureEmissive) != 0; });
}

std::vector<const gl::Texture*> GpuScene::textures() const {
    std::vector<const gl::Texture*> result;
    for (const gl::Texture& texture : textures_)
        result.push_back(&texture);
    return result;
}

MaterialPrograms::MaterialPrograms(const gl::ShaderLibrary& shaders, const GpuScene& scene,
                                   const std::function<gl::ProgramDescription(unsigned features)>& describe) {
    for (unsigned features : scene.featuresThatOccur())
        programs_.emplace(features, gl::Program(shaders, describe(features)));
}

}  // namespace vct
