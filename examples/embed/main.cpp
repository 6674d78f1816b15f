// A room with a box and a floating ball under a moving sun. The program draws its own G-buffer, the library
// computes irradiance and the sun's soft shadow, and the program shades with both.
//
// embed                                     opens a window
// embed --headless FRAMES --out FILE.ppm    draws so many frames without a window and writes the last one
#include <GLES3/gl31.h>
#include <vct/vct.h>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <fstream>
#include <iostream>

#include "shapes.h"
#include "window.h"

namespace {

const char* gBufferVertex = R"(#version 310 es
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 0) uniform mat4 clipFromWorld;
layout(location = 1) uniform mat4 worldFromObject;
out vec3 worldPosition;
out vec3 worldNormal;
void main() {
    worldPosition = (worldFromObject * vec4(position, 1.0)).xyz;
    worldNormal = mat3(worldFromObject) * normal;
    gl_Position = clipFromWorld * vec4(worldPosition, 1.0);
})";

// The fragment shader of the G-buffer, without its beginning: normalEncodingGlsl() comes before it.
const char* gBufferFragment = R"(
in vec3 worldPosition;
in vec3 worldNormal;
layout(location = 2) uniform vec3 baseColor;
layout(location = 0) out vec4 albedo;
layout(location = 1) out uvec2 normalCode;
void main() {
    vec3 normal = normalize(gl_FrontFacing ? worldNormal : -worldNormal);
    uvec3 codes = encodeNormals(normal, faceNormal(worldPosition, normal));
    albedo = vec4(sqrt(baseColor), float(codes.z) / 255.0);
    normalCode = codes.xy;
})";

const char* fullScreenVertex = R"(#version 310 es
void main() {
    gl_Position = vec4(float(gl_VertexID & 1) * 4.0 - 1.0, float(gl_VertexID & 2) * 2.0 - 1.0, 0.0, 1.0);
})";

const char* shadeFragment = R"(
layout(binding = 0) uniform sampler2D albedoTarget;
layout(binding = 1) uniform highp usampler2D normalTarget;
layout(binding = 2) uniform sampler2D irradiance;
layout(binding = 3) uniform sampler2D sunVisibility;
layout(location = 0) uniform vec3 directionToSun;
layout(location = 0) out vec4 color;
void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec3 root = texelFetch(albedoTarget, pixel, 0).rgb;
    vec3 normal = decodeNormal(texelFetch(normalTarget, pixel, 0).rg);
    float sun = max(dot(normal, directionToSun), 0.0) * texelFetch(sunVisibility, pixel, 0).r;
    vec3 radiance = root * root * (sun + texelFetch(irradiance, pixel, 0).rgb);
    color = vec4(pow(min(radiance, vec3(1.0)), vec3(1.0 / 2.2)), 1.0);
})";

void require(bool ok, const std::string& message) {
    if (!ok) throw std::runtime_error(message);
}

GLuint program(const std::string& vertex, const std::string& fragment) {
    const GLuint program = glCreateProgram();
    const auto attach = [&](GLenum stage, const std::string& text) {
        const char* source = text.c_str();
        const GLuint shader = glCreateShader(stage);
        glShaderSource(shader, 1, &source, nullptr);
        glCompileShader(shader);
        glAttachShader(program, shader);
        glDeleteShader(shader);
    };
    attach(GL_VERTEX_SHADER, vertex);
    attach(GL_FRAGMENT_SHADER, "#version 310 es\nprecision highp float;\nprecision highp int;\n" +
                                   vct::normalEncodingGlsl() + fragment);
    glLinkProgram(program);
    GLint linked = 0;
    glGetProgramiv(program, GL_LINK_STATUS, &linked);
    require(linked == GL_TRUE, "a shader of the example does not compile");
    return program;
}

GLuint texture(GLenum format, int width, int height) {
    GLuint name = 0;
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_2D, name);
    glTexStorage2D(GL_TEXTURE_2D, 1, format, width, height);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    return name;
}

// The textures that the program draws to. They are recreated when the window's size changes.
struct Targets {
    GLuint albedo, normal, depth, picture, gBuffer = 0, shaded = 0;
    Targets(int width, int height)
        : albedo(texture(GL_RGBA8, width, height)),
          normal(texture(GL_RG16UI, width, height)),
          depth(texture(GL_DEPTH_COMPONENT32F, width, height)),
          picture(texture(GL_RGBA8, width, height)) {
        const GLenum both[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
        glGenFramebuffers(1, &gBuffer);
        glBindFramebuffer(GL_FRAMEBUFFER, gBuffer);
        glFramebufferTexture2D(GL_FRAMEBUFFER, both[0], GL_TEXTURE_2D, albedo, 0);
        glFramebufferTexture2D(GL_FRAMEBUFFER, both[1], GL_TEXTURE_2D, normal, 0);
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth, 0);
        glDrawBuffers(2, both);
        glGenFramebuffers(1, &shaded);
        glBindFramebuffer(GL_FRAMEBUFFER, shaded);
        glFramebufferTexture2D(GL_FRAMEBUFFER, both[0], GL_TEXTURE_2D, picture, 0);
    }
    ~Targets() {
        for (const GLuint name : {albedo, normal, depth, picture})
            glDeleteTextures(1, &name);
        for (const GLuint name : {gBuffer, shaded})
            glDeleteFramebuffers(1, &name);
    }
};

// A shape in the program's own GL buffers.
struct Drawable {
    GLuint vertexArray = 0;
    GLsizei count = 0;
    Vector color;
    Matrix4 worldFromObject;
    Drawable(const Shape& shape, Vector c, const Matrix4& m)
        : count(static_cast<GLsizei>(shape.indices.size())), color(c), worldFromObject(m) {
        GLuint buffers[3];
        glGenVertexArrays(1, &vertexArray);
        glBindVertexArray(vertexArray);
        glGenBuffers(3, buffers);
        for (GLuint i = 0; i < 2; ++i) {
            const std::vector<float>& values = i == 0 ? shape.positions : shape.normals;
            glBindBuffer(GL_ARRAY_BUFFER, buffers[i]);
            glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(values.size() * sizeof(float)),
                         values.data(), GL_STATIC_DRAW);
            glEnableVertexAttribArray(i);
            glVertexAttribPointer(i, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
        }
        glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[2]);
        glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(shape.indices.size() * sizeof(GLuint)),
                     shape.indices.data(), GL_STATIC_DRAW);
    }
};

void drawGBuffer(const Targets& targets, GLuint program, const std::vector<Drawable>& drawables,
                 const Matrix4& clipFromWorld) {
    const GLfloat black[4] = {0, 0, 0, 0}, far = 1;
    const GLuint none[4] = {0, 0, 0, 0};
    glBindFramebuffer(GL_FRAMEBUFFER, targets.gBuffer);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE);
    glClearBufferfv(GL_COLOR, 0, black);
    glClearBufferuiv(GL_COLOR, 1, none);
    glClearBufferfv(GL_DEPTH, 0, &far);
    glUseProgram(program);
    glUniformMatrix4fv(0, 1, GL_FALSE, clipFromWorld.data());
    for (const Drawable& drawable : drawables) {
        glUniformMatrix4fv(1, 1, GL_FALSE, drawable.worldFromObject.data());
        glUniform3fv(2, 1, drawable.color.data());
        glBindVertexArray(drawable.vertexArray);
        glDrawElements(GL_TRIANGLES, drawable.count, GL_UNSIGNED_INT, nullptr);
    }
}

void shade(const Targets& targets, GLuint program, const vct::Pictures& pictures, Vector directionToSun) {
    glBindFramebuffer(GL_FRAMEBUFFER, targets.shaded);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    const GLuint inputs[] = {targets.albedo, targets.normal, pictures.irradiance, pictures.sunVisibility};
    for (GLuint unit = 0; unit < 4; ++unit) {
        glActiveTexture(GL_TEXTURE0 + unit);
        glBindTexture(GL_TEXTURE_2D, inputs[unit]);
    }
    glUseProgram(program);
    glUniform3fv(0, 1, directionToSun.data());
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

void writePpm(const std::string& path, int width, int height) {
    std::vector<unsigned char> rgba(static_cast<std::size_t>(4) * width * height);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
    std::ofstream file(path, std::ios::binary);
    file << "P6\n" << width << " " << height << "\n255\n";
    for (int y = height - 1; y >= 0; --y)
        for (int x = 0; x < width; ++x)
            file.write(reinterpret_cast<const char*>(&rgba[static_cast<std::size_t>(4) * (y * width + x)]),
                       3);
    require(file.flush().good(), "cannot write " + path);
}

void run(int framesWithoutWindow, const std::string& out) {
    Window window(framesWithoutWindow);
    const Shape roomShape = box({2, 1.5F, 2}, true), boxShape = box({0.5F, 0.7F, 0.5F}, false);
    const Shape ballShape = ball(0.4F);
    const Matrix4 boxPlace = translation({-0.8F, -0.8F, -0.6F});

    // The constructor of GlobalIllumination reads the scene once.
    vct::SceneDescription scene;
    scene.materials.resize(2);
    scene.materials[0].baseColor = {0.8F, 0.8F, 0.8F};
    scene.materials[1].baseColor = {0.9F, 0.3F, 0.1F};
    const std::size_t material[] = {0, 1, 0};
    const Shape* const shapes[] = {&roomShape, &boxShape, &ballShape};
    for (int i = 0; i < 3; ++i)
        scene.meshes.push_back({shapes[i]->positions, shapes[i]->normals, shapes[i]->indices, material[i]});
    scene.instances.resize(3);
    for (std::size_t i = 0; i < 3; ++i)
        scene.instances[i].mesh = i;
    scene.instances[1].worldFromObject = vct::Matrix::of(boxPlace.data());
    scene.instances[2].moves = true;
    scene.skyRadiance = {0.2F, 0.25F, 0.3F};

    vct::Options options;
    options.width = window.width();
    options.height = window.height();
    options.radiance = false;
    options.irradiance = options.sunVisibility = true;
    vct::GlobalIllumination renderer(Window::getProcAddress, scene, options);

    std::vector<Drawable> drawables{{roomShape, scene.materials[0].baseColor, translation({})},
                                    {boxShape, scene.materials[1].baseColor, boxPlace},
                                    {ballShape, scene.materials[0].baseColor, translation({})}};
    const GLuint gBufferProgram = program(gBufferVertex, gBufferFragment);
    const GLuint shadeProgram = program(fullScreenVertex, shadeFragment);
    std::optional<Targets> targets(std::in_place, options.width, options.height);
    for (float seconds = 0; window.next(); seconds += 0.05F) {
        if (window.width() != options.width || window.height() != options.height) {
            targets.emplace(options.width = window.width(), options.height = window.height());
            renderer.resize(options.width, options.height);
        }
        const float aspect = static_cast<float>(options.width) / static_cast<float>(options.height);
        const Matrix4 cameraFromWorld = translation({0, 0, -5.5F});
        const Matrix4 clipFromCamera = perspective(40, aspect, 0.1F, 20);
        const float angle = 0.8F * std::sin(seconds);
        const Vector directionToSun{std::sin(angle) * 0.8F, 0.6F, std::cos(angle) * 0.8F};
        drawables[2].worldFromObject = translation({0.8F, 0.3F * std::sin(2 * seconds), 0.2F});
        glViewport(0, 0, options.width, options.height);
        drawGBuffer(*targets, gBufferProgram, drawables, product(clipFromCamera, cameraFromWorld));

        // Each frame passes the movements to the library and gets its pictures.
        renderer.setSun({directionToSun[0], directionToSun[1], directionToSun[2]});
        renderer.setTransform(2, vct::Matrix::of(drawables[2].worldFromObject.data()));
        const vct::View view{vct::Matrix::of(cameraFromWorld.data()), vct::Matrix::of(clipFromCamera.data())};
        const vct::Pictures pictures =
            renderer.render(view, {targets->albedo, targets->normal, targets->depth});

        shade(*targets, shadeProgram, pictures, directionToSun);
        if (framesWithoutWindow > 0) continue;
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
        glBlitFramebuffer(0, 0, options.width, options.height, 0, 0, options.width, options.height,
                          GL_COLOR_BUFFER_BIT, GL_NEAREST);
    }
    if (!out.empty()) writePpm(out, options.width, options.height);
}

}  // namespace

int main(int count, char** arguments) {
    int frames = 0;
    std::string out;
    for (int i = 1; i + 1 < count; i += 2) {
        if (std::strcmp(arguments[i], "--headless") == 0) frames = std::atoi(arguments[i + 1]);
        if (std::strcmp(arguments[i], "--out") == 0) out = arguments[i + 1];
    }
    try {
        run(frames, out);
        return 0;
    } catch (const std::exception& error) {
        std::cerr << "error: " << error.what() << "\n";
        return 1;
    }
}
