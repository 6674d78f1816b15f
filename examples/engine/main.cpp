// A small forward renderer that gets its light from the library: a room with textures, a figure with a skin,
// a lamp that is switched, and a pane of frosted glass that the look-up lights.
//
// engine MODEL.glb                                   opens a window; the lamp is switched every two seconds
// engine MODEL.glb --headless FRAMES --out FILE.png  draws so many frames and writes the last one
//     --time SECONDS   shows this moment of the animation, and the light when it has converged
//     --no-lamp        switches the lamp off
//     --no-pane        leaves the pane out
#include <GLES3/gl31.h>
#include <stb_image_write.h>
#include <vct/vct.h>

#include <cmath>
#include <cstdlib>
#include <exception>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <iostream>
#include <optional>
#include <stdexcept>

#include "../embed/window.h"
#include "model.h"
#include "shaders.h"

namespace {

struct Arguments {
    std::string model, out;
    int frames = 0;
    std::optional<float> time;
    bool hasLamp = true, hasPane = true;
};

void require(bool ok, const std::string& message) {
    if (!ok) throw std::runtime_error(message);
}

GLuint program(const std::string& vertex, const std::string& fragment) {
    const GLuint program = glCreateProgram();
    const auto attach = [&](GLenum stage, const std::string& text) {
        const std::string whole = "#version 310 es\nprecision highp float;\nprecision highp int;\n" + text;
        const char* source = whole.c_str();
        const GLuint shader = glCreateShader(stage);
        glShaderSource(shader, 1, &source, nullptr);
        glCompileShader(shader);
        glAttachShader(program, shader);
        glDeleteShader(shader);
    };
    attach(GL_VERTEX_SHADER, vertex);
    attach(GL_FRAGMENT_SHADER, fragment);
    glLinkProgram(program);
    GLint linked = 0;
    glGetProgramiv(program, GL_LINK_STATUS, &linked);
    require(linked == GL_TRUE, "a shader of the example does not compile");
    return program;
}

// A texture with mip levels. sRGB: sampling gives linear colours, as the library needs them.
GLuint textureOf(const Picture& picture) {
    GLuint name = 0;
    glGenTextures(1, &name);
    glBindTexture(GL_TEXTURE_2D, name);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_SRGB8_ALPHA8, picture.width, picture.height, 0, GL_RGBA,
                 GL_UNSIGNED_BYTE, picture.rgba.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glGenerateMipmap(GL_TEXTURE_2D);
    return name;
}

// The linear picture that the program draws to, and the displayed one. They follow the window's size.
struct Targets {
    int width, height;
    GLuint framebuffer = 0, buffers[2] = {};
    Targets(int w, int h) : width(w), height(h) {
        glGenFramebuffers(1, &framebuffer);
        glGenRenderbuffers(2, buffers);
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
        const GLenum formats[] = {GL_SRGB8_ALPHA8, GL_DEPTH_COMPONENT24},
                     places[] = {GL_COLOR_ATTACHMENT0, GL_DEPTH_ATTACHMENT};
        for (int i = 0; i < 2; ++i) {
            glBindRenderbuffer(GL_RENDERBUFFER, buffers[i]);
            glRenderbufferStorage(GL_RENDERBUFFER, formats[i], width, height);
            glFramebufferRenderbuffer(GL_FRAMEBUFFER, places[i], GL_RENDERBUFFER, buffers[i]);
        }
    }
    ~Targets() {
        glDeleteFramebuffers(1, &framebuffer);
        glDeleteRenderbuffers(2, buffers);
    }
};

// A part of the model in GL buffers: positions, normals, texture coordinates, indices.
struct Drawable {
    GLuint vertexArray = 0, buffers[4] = {};
    GLsizei count;

    explicit Drawable(const Part& part) : count(static_cast<GLsizei>(part.indices.size())) {
        glGenVertexArrays(1, &vertexArray);
        glGenBuffers(4, buffers);
        glBindVertexArray(vertexArray);
        upload(0, part.positions);
        upload(1, part.normals);
        upload(2, part.coordinates);
        for (GLuint i = 0; i < 3; ++i) {
            if (i == 2 && part.coordinates.empty()) continue;
            glBindBuffer(GL_ARRAY_BUFFER, buffers[i]);
            glEnableVertexAttribArray(i);
            glVertexAttribPointer(i, i == 2 ? 2 : 3, GL_FLOAT, GL_FALSE, 0, nullptr);
        }
        glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[3]);
        glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(part.indices.size() * sizeof(GLuint)),
                     part.indices.data(), GL_STATIC_DRAW);
    }
    template <class Vector>
    void upload(int buffer, const std::vector<Vector>& values) const {
        glBindBuffer(GL_ARRAY_BUFFER, buffers[buffer]);
        glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(values.size() * sizeof(Vector)), values.data(),
                     GL_DYNAMIC_DRAW);
    }
};

template <class Vector>
std::span<const float> numbers(const std::vector<Vector>& vectors) {
    return {reinterpret_cast<const float*>(vectors.data()), vectors.size() * sizeof(Vector) / sizeof(float)};
}

// The library's description of the model. Its spans refer to the model, and `textures` are GL's names.
vct::SceneDescription describe(const Model& model, const std::vector<GLuint>& textures) {
    vct::SceneDescription scene;
    const auto color = [](glm::vec3 c) { return std::array<float, 3>{c.r, c.g, c.b}; };
    for (const Surface& surface : model.surfaces) {
        vct::MaterialDescription& material = scene.materials.emplace_back();
        material.baseColor = color(surface.baseColor);
        material.emission = color(surface.emission);
        if (surface.picture >= 0)
            material.baseColorTexture = textures[static_cast<std::size_t>(surface.picture)];
    }
    for (const Part& part : model.parts) {
        vct::MeshDescription mesh{numbers(part.positions), numbers(part.normals), part.indices, part.surface};
        mesh.textureCoordinates = numbers(part.coordinates);
        mesh.deforms = part.hasSkin;
        vct::InstanceDescription instance;
        instance.mesh = scene.meshes.size();
        // A skin places its vertices in the world.
        if (!part.hasSkin)
            instance.worldFromObject = vct::Matrix::of(glm::value_ptr(model.worldFromNode(part.node)));
        instance.moves = part.hasSkin || part.name == "lamp";
        scene.meshes.push_back(mesh);
        scene.instances.push_back(instance);
    }
    scene.sun.directionToSun = {model.directionToSun.x, model.directionToSun.y, model.directionToSun.z};
    scene.sun.color = color(model.sunColor);
    scene.sun.illuminance = model.sunIlluminance;
    return scene;
}

// A rectangle in the room, in front of the figure.
Part pane() {
    Part part;
    for (const glm::vec2 corner : {glm::vec2(0, 0), glm::vec2(1, 0), glm::vec2(1, 1), glm::vec2(0, 1)}) {
        part.positions.emplace_back(-0.75F + 0.9F * corner.x, 0.45F + 1.1F * corner.y,
                                    0.8F - 0.3F * corner.x);
        part.normals.push_back(glm::normalize(glm::vec3(0.3F, 0, 0.9F)));
    }
    part.indices = {0, 1, 2, 0, 2, 3};
    return part;
}

class Engine {
  public:
    Engine(const Arguments& arguments, int width, int height)
        : arguments_(arguments),
          model_(arguments.model),
          pane_(pane()),
          opaque_(program(vertexShader, opaqueShader)) {
        for (const Picture& picture : model_.pictures)
            textures_.push_back(textureOf(picture));
        white_ = textureOf({1, 1, {255, 255, 255, 255}});
        for (const Part& part : model_.parts)
            drawables_.emplace_back(part);
        vct::Options options;
        options.width = width;
        options.height = height;
        options.radiance = false;
        options.irradiance = options.sunVisibility = true;
        light_.emplace(Window::getProcAddress, describe(model_, textures_), options);
        targets_.emplace(width, height);
        glass_ = program(vertexShader, light_->lookUpGlsl(lookUp_) + glassShader);
    }

    void resize(int width, int height) {
        if (width == targets_->width && height == targets_->height) return;
        light_->resize(width, height);
        targets_.emplace(width, height);
    }

    void draw(float seconds, bool lampIsOn, vct::GlobalIllumination::Light steps) {
        move(seconds, lampIsOn);
        const float aspect = static_cast<float>(targets_->width) / static_cast<float>(targets_->height);
        const glm::mat4 cameraFromWorld = glm::inverse(model_.worldFromCamera),
                        clipFromCamera = glm::perspective(model_.verticalFovRad, aspect, 0.1F, 20.0F);
        const vct::Pictures pictures = light_->render({vct::Matrix::of(glm::value_ptr(cameraFromWorld)),
                                                       vct::Matrix::of(glm::value_ptr(clipFromCamera))},
                                                      steps);

        glBindFramebuffer(GL_FRAMEBUFFER, targets_->framebuffer);
        glViewport(0, 0, targets_->width, targets_->height);
        glClearColor(0, 0, 0, 1);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        glEnable(GL_DEPTH_TEST);
        glEnable(GL_CULL_FACE);
        drawModel(clipFromCamera * cameraFromWorld, pictures, lampIsOn);
        if (arguments_.hasPane) drawPane(clipFromCamera * cameraFromWorld);
    }

    const Targets& targets() const { return *targets_; }

  private:
    // Takes the figure and the lamp to their present state, and tells the library.
    void move(float seconds, bool lampIsOn) {
        model_.animate(seconds);
        std::vector<glm::vec3> positions, normals;
        for (std::size_t i = 0; i < drawables_.size(); ++i) {
            if (model_.parts[i].name == "lamp") light_->setEmission(i, lampIsOn ? 1.0F : 0.0F);
            if (!model_.parts[i].hasSkin) continue;
            model_.deform(model_.parts[i], positions, normals);
            drawables_[i].upload(0, positions);
            drawables_[i].upload(1, normals);
            glm::dvec3 low(positions[0]), high(low);
            for (const glm::vec3& position : positions) {
                low = glm::min(low, glm::dvec3(position));
                high = glm::max(high, glm::dvec3(position));
            }
            light_->setVertices(i, {drawables_[i].buffers[0], drawables_[i].buffers[1]},
                                {{low.x, low.y, low.z}, {high.x, high.y, high.z}});
        }
    }

    void drawModel(const glm::mat4& clipFromWorld, const vct::Pictures& pictures, bool lampIsOn) {
        glUseProgram(opaque_);
        glUniformMatrix4fv(0, 1, GL_FALSE, glm::value_ptr(clipFromWorld));
        const auto unit = static_cast<float>(light_->radianceUnit());
        const glm::vec3 sun = model_.sunColor * model_.sunIlluminance / (3.14159265F * unit);
        glUniform3fv(4, 1, glm::value_ptr(model_.directionToSun));
        glUniform3fv(5, 1, glm::value_ptr(sun));
        glUniform1f(6, unit);
        bind(1, pictures.irradiance);
        bind(2, pictures.sunVisibility);
        for (std::size_t i = 0; i < drawables_.size(); ++i) {
            const Part& part = model_.parts[i];
            const Surface& surface = model_.surfaces[part.surface];
            const glm::mat4 place = part.hasSkin ? glm::mat4(1.0F) : model_.worldFromNode(part.node);
            const glm::vec3 emission = surface.emission * (lampIsOn ? 1.0F : 0.0F);
            glUniformMatrix4fv(1, 1, GL_FALSE, glm::value_ptr(place));
            glUniform3fv(2, 1, glm::value_ptr(surface.baseColor));
            glUniform3fv(3, 1, glm::value_ptr(emission));
            bind(0, surface.picture >= 0 ? textures_[static_cast<std::size_t>(surface.picture)] : white_);
            glBindVertexArray(drawables_[i].vertexArray);
            glDrawElements(GL_TRIANGLES, drawables_[i].count, GL_UNSIGNED_INT, nullptr);
        }
    }

    void drawPane(const glm::mat4& clipFromWorld) {
        const glm::vec3 tint(0.8F, 0.9F, 0.85F);
        glUseProgram(glass_);
        glUniformMatrix4fv(0, 1, GL_FALSE, glm::value_ptr(clipFromWorld));
        glUniformMatrix4fv(1, 1, GL_FALSE, glm::value_ptr(glm::mat4(1.0F)));
        glUniform3fv(2, 1, glm::value_ptr(tint));
        glUniform1f(6, static_cast<float>(light_->radianceUnit()));
        light_->bindLookUp(lookUp_);
        glDisable(GL_CULL_FACE);
        glEnable(GL_BLEND);
        glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
        glBindVertexArray(pane_.vertexArray);
        glDrawElements(GL_TRIANGLES, pane_.count, GL_UNSIGNED_INT, nullptr);
        glDisable(GL_BLEND);
    }

    static void bind(GLuint unit, GLuint texture) {
        glActiveTexture(GL_TEXTURE0 + unit);
        glBindTexture(GL_TEXTURE_2D, texture);
    }

    static constexpr vct::LookUpBindings lookUp_{3, 0};  // after the textures of drawModel()
    Arguments arguments_;
    Model model_;
    Drawable pane_;
    GLuint opaque_, glass_ = 0, white_ = 0;
    std::vector<GLuint> textures_;
    std::vector<Drawable> drawables_;
    std::optional<vct::GlobalIllumination> light_;
    std::optional<Targets> targets_;
};

void writePng(const std::string& path, const Targets& targets) {
    const int stride = 4 * targets.width;
    std::vector<unsigned char> rgba(static_cast<std::size_t>(stride * targets.height));
    glBindFramebuffer(GL_FRAMEBUFFER, targets.framebuffer);
    glReadPixels(0, 0, targets.width, targets.height, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
    stbi_flip_vertically_on_write(1);
    require(stbi_write_png(path.c_str(), targets.width, targets.height, 4, rgba.data(), stride) != 0,
            "cannot write " + path);
}

Arguments argumentsOf(int count, char** words) {
    Arguments arguments;
    for (int i = 1; i < count; ++i) {
        const std::string word = words[i];
        const auto value = [&] {
            require(i + 1 < count, word + " needs a value");
            return words[++i];
        };
        if (word == "--headless")
            arguments.frames = std::atoi(value());
        else if (word == "--out")
            arguments.out = value();
        else if (word == "--time")
            arguments.time = std::strtof(value(), nullptr);
        else if (word == "--no-lamp")
            arguments.hasLamp = false;
        else if (word == "--no-pane")
            arguments.hasPane = false;
        else
            arguments.model = word;
    }
    require(!arguments.model.empty(), "name a .glb file, for example assets/studio.glb");
    return arguments;
}

void run(const Arguments& arguments) {
    Window window(arguments.frames);
    Engine engine(arguments, window.width(), window.height());
    for (float seconds = 0; window.next(); seconds += 1.0F / 60) {
        engine.resize(window.width(), window.height());
        const bool isSwitchedOn = arguments.frames > 0 || std::fmod(seconds, 4.0F) < 2.0F;
        engine.draw(arguments.time.value_or(seconds), arguments.hasLamp && isSwitchedOn,
                    arguments.time ? vct::GlobalIllumination::Light::converged
                                   : vct::GlobalIllumination::Light::oneStep);
        if (arguments.frames > 0) continue;
        const Targets& targets = engine.targets();
        glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
        glBlitFramebuffer(0, 0, targets.width, targets.height, 0, 0, targets.width, targets.height,
                          GL_COLOR_BUFFER_BIT, GL_NEAREST);
    }
    if (!arguments.out.empty()) writePng(arguments.out, engine.targets());
}

}  // namespace

int main(int count, char** words) {
    try {
        run(argumentsOf(count, words));
        return 0;
    } catch (const std::exception& error) {
        std::cerr << "error: " << error.what() << "\n";
        return 1;
    }
}
