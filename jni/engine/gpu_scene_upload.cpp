// Uploads the scene's vertices, indices and textures. Vertices have only the attributes that the scene needs.
#include <cstddef>
#include <cstring>

#include "engine/gpu_scene.h"
#include "engine/material_texture.h"

namespace vct {

struct GpuScene::Attribute {
    GLuint location;
    int components;
    std::size_t offset;  // in Vertex or VertexExtras
    bool extra = false;  // true: `offset` is in VertexExtras
};

std::vector<GpuScene::Attribute> GpuScene::attributes() const {
    std::vector<Attribute> attributes{{VCT_ATTRIBUTE_POSITION, 3, offsetof(Vertex, position)},
                                      {VCT_ATTRIBUTE_NORMAL, 3, offsetof(Vertex, normal)}};
    if (features_.has(featureBaseColorTexture))
        attributes.push_back({VCT_ATTRIBUTE_UV, 2, offsetof(Vertex, uv)});
    if (features_.has(featureEmissiveTexture))
        attributes.push_back({VCT_ATTRIBUTE_EMISSIVE_UV, 2, offsetof(Vertex, emissiveUv)});
    if (features_.has(featureVertexColors))
        attributes.push_back({VCT_ATTRIBUTE_COLOR, 4, offsetof(VertexExtras, color), true});
    if (features_.has(featureGlossTexture))
        attributes.push_back({VCT_ATTRIBUTE_GLOSS_UV, 2, offsetof(VertexExtras, glossUv), true});
    if (features_.has(featureNormalMap))
        attributes.push_back({VCT_ATTRIBUTE_NORMAL_UV, 2, offsetof(VertexExtras, normalUv), true});
    return attributes;
}

// Appends the mesh's vertices to those of the vertex buffer.
void GpuScene::append(const Mesh& mesh, std::vector<float>& vertices) const {
    const std::vector<Attribute> all = attributes();
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        const VertexExtras extras = mesh.extras.empty() ? VertexExtras() : mesh.extras[i];
        for (const Attribute& attribute : all) {
            const void* from = &mesh.vertices[i];
            if (attribute.extra) from = &extras;
            float values[4];
            std::memcpy(values, static_cast<const char*>(from) + attribute.offset,
                        static_cast<std::size_t>(attribute.components) * sizeof(float));
            vertices.insert(vertices.end(), values, values + attribute.components);
        }
    }
}

void GpuScene::pointAttributes() const {
    vertexArray_.bind();
    indices_.bind(GL_ELEMENT_ARRAY_BUFFER);
    vertices_.bind(GL_ARRAY_BUFFER);
    std::size_t offset = 0;  // bytes
    for (const Attribute& attribute : attributes()) {
        gl::EnableVertexAttribArray(attribute.location);
        gl::VertexAttribPointer(attribute.location, attribute.components, GL_FLOAT, GL_FALSE,
                                static_cast<GLsizei>(vertexFloats_ * sizeof(float)),
                                reinterpret_cast<const void*>(offset));
        offset += static_cast<std::size_t>(attribute.components) * sizeof(float);
    }
}

void GpuScene::uploadGeometry(const Scene& scene, const std::vector<std::uint32_t>& indices) {
    std::vector<float> vertices;
    for (const Mesh& mesh : scene.meshes)
        append(mesh, vertices);
    vertexFloats_ = 0;
    for (const Attribute& attribute : attributes())
        vertexFloats_ += static_cast<std::size_t>(attribute.components);
    vertexArray_.bind();
    indices_ = gl::Buffer("indices", GL_ELEMENT_ARRAY_BUFFER, indices.size() * sizeof indices[0],
                          indices.data(), movingIndices_.empty() ? GL_STATIC_DRAW : GL_DYNAMIC_DRAW);
    vertices_ = gl::Buffer("vertices", GL_ARRAY_BUFFER, vertices.size() * sizeof vertices[0], vertices.data(),
                           GL_STATIC_DRAW);
    indexRanges_ = Ranges(indices.size());
    vertexRanges_ = Ranges(vertices.size() / vertexFloats_);
    pointAttributes();
}

void GpuScene::uploadTextures(const Scene& scene) {
    const auto upload = [&](const std::vector<bool>& read, TextureOf of,
                            const std::vector<std::optional<float>>& holesBelow) {
        std::vector<gl::Texture> textures;
        for (std::size_t i = 0; i < scene.textures.size(); ++i) {
            const Texture& texture = scene.textures[i];
            if (texture.external != 0)
                textures.push_back(gl::Texture::wrapExternal(texture.external));
            else
                textures.push_back(read[i] ? materialTexture(texture, of, holesBelow[i]) : gl::Texture());
        }
        return textures;
    };
    textures_ = upload(features_.textures, TextureOf::colors, features_.holesBelow);
    const std::vector<std::optional<float>> noHoles(scene.textures.size());
    dataTextures_ = upload(features_.dataTextures, TextureOf::numbers, noHoles);
}

}  // namespace vct
