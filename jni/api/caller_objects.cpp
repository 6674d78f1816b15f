#include "api/caller_objects.h"

#include <algorithm>
#include <utility>

#include "core/error.h"
#include "gl/objects.h"

namespace vct {

namespace {

struct TextureParameters {
    GLint width = 0, height = 0, format = 0;
};

// `member`: the member of the interface that has this name. Throws vct::Error if it is not a texture.
TextureParameters requireTexture(unsigned name, const std::string& member) {
    gl::Texture::wrapExternal(name).bind(gl::scratchTextureUnit);
    TextureParameters found;
    if (name != 0) {
        gl::GetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, &found.width);
        gl::GetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_HEIGHT, &found.height);
        gl::GetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_INTERNAL_FORMAT, &found.format);
    }
    if (gl::GetError() != GL_NO_ERROR || found.width < 1)
        throw Error(member + " is " + std::to_string(name) +
                    ", which is not a 2D texture with storage; give the name of one");
    return found;
}

}  // namespace

void requireTarget(unsigned name, const char* what, glm::ivec2 size, std::initializer_list<GLint> formats) {
    const std::string member = std::string("GBufferTextures::") + what;
    const TextureParameters found = requireTexture(name, member);
    if (found.width != size.x || found.height != size.y)
        throw Error(member + " has " + std::to_string(found.width) + "x" + std::to_string(found.height) +
                    " texels, but the pictures have " + std::to_string(size.x) + "x" +
                    std::to_string(size.y) + "; give it that size, or call resize()");
    if (std::find(formats.begin(), formats.end(), found.format) == formats.end())
        throw Error(member + " has the internal format " + std::to_string(found.format) +
                    "; use one of the formats that vct.h lists");
}

ExternalVertices::Attribute attributeOf(unsigned buffer, std::size_t offset, std::size_t stride,
                                        std::size_t vertices, const char* member) {
    const std::string name = std::string("VertexBuffers::") + member;
    if (offset % 4 != 0 || stride % 4 != 0 || stride < 12)
        throw Error(name + ": give offset and stride in bytes, multiples of 4, and a stride of 12 or more");
    GLint bytes = 0;
    if (gl::IsBuffer(buffer) != GL_FALSE) {
        gl::BindBuffer(GL_COPY_READ_BUFFER, buffer);
        gl::GetBufferParameteriv(GL_COPY_READ_BUFFER, GL_BUFFER_SIZE, &bytes);
    }
    const std::size_t needed = offset + stride * (vertices - 1) + 12;
    if (static_cast<std::size_t>(bytes) < needed)
        throw Error(name + " is " + std::to_string(buffer) + ", a buffer of " + std::to_string(bytes) +
                    " bytes (0: there is none), and " + std::to_string(vertices) + " vertices need " +
                    std::to_string(needed));
    return {buffer, offset / 4, stride / 4};
}

void requireTextures(const MaterialDescription& material, const std::string& name) {
    for (const auto& [texture, member] : {std::pair{material.baseColorTexture, ": baseColorTexture"},
                                          {material.emissionTexture, ": emissionTexture"},
                                          {material.glossTexture, ": glossTexture"},
                                          {material.normalTexture, ": normalTexture"}})
        if (texture != 0) requireTexture(texture, name + member);
}

}  // namespace vct
