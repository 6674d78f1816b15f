// The shortest program that embeds the library: a red triangle on a grey floor, written to a file.
//
// triangle FILE.ppm
#include <EGL/egl.h>
#include <GLES3/gl31.h>
#include <vct/vct.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <fstream>
#include <iostream>

#include "shapes.h"
#include "window.h"

namespace {

// Writes a picture of the library to a file. The picture is linear with row 0 at the bottom; the file is
// gamma-encoded with row 0 at the top.
void writePpm(const std::string& path, unsigned picture, int width, int height) {
    GLuint framebuffer = 0;
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, picture, 0);
    std::vector<float> rgba(static_cast<std::size_t>(4) * width * height);
    glReadPixels(0, 0, width, height, GL_RGBA, GL_FLOAT, rgba.data());
    std::ofstream file(path, std::ios::binary);
    file << "P6\n" << width << " " << height << "\n255\n";
    for (int y = height - 1; y >= 0; --y)
        for (int x = 0; x < width; ++x)
            for (int channel = 0; channel < 3; ++channel) {
                const float linear = rgba[static_cast<std::size_t>(4) * (y * width + x) + channel];
                const float shown = std::pow(std::clamp(linear, 0.0F, 1.0F), 1.0F / 2.2F);
                file.put(static_cast<char>(std::lround(255.0F * shown)));
            }
    if (!file.flush()) throw std::runtime_error("cannot write " + path);
}

void run(const std::string& out) {
    const Window window(1);  // an OpenGL ES 3.1 context without a window

    // Front faces are counter-clockwise.
    const std::vector<float> floorPositions{-2, 0, -2, -2, 0, 2, 2, 0, 2, 2, 0, -2};
    const std::vector<float> floorNormals{0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0};
    const std::vector<std::uint32_t> floorIndices{0, 1, 2, 0, 2, 3};
    const std::vector<float> redPositions{-0.7F, 0, 0, 0.7F, 0, 0, 0, 1.2F, 0};
    const std::vector<float> redNormals{0, 0, 1, 0, 0, 1, 0, 0, 1};
    const std::vector<std::uint32_t> redIndices{0, 1, 2};

    vct::SceneDescription scene;
    scene.materials.resize(2);
    scene.materials[0].baseColor = {0.8F, 0.8F, 0.8F};
    scene.materials[1].baseColor = {0.8F, 0.05F, 0.05F};
    scene.materials[1].doubleSided = true;  // makes the triangle visible from behind
    scene.meshes = {{floorPositions, floorNormals, floorIndices, 0},
                    {redPositions, redNormals, redIndices, 1}};
    scene.instances.resize(2);
    scene.instances[1].mesh = 1;
    scene.sun.directionToSun = {-0.8, 0.8, 0.7};
    scene.skyRadiance = {0.2F, 0.25F, 0.3F};

    vct::LightDescription spot;
    spot.type = vct::LightDescription::Type::spot;
    spot.position = {-1.6, 1.5, 1};
    spot.direction = {0.4, -1, -0.6};
    spot.color = {1, 0.8F, 0.6F};
    spot.intensity = 2;   // candela, if the sun's illuminance is in lux
    spot.radius = 0.05F;  // metres; makes its shadows soft
    scene.lights.push_back(spot);

    vct::Options options;
    options.width = 640;
    options.height = 480;
    vct::GlobalIllumination renderer(
        [](const char* name) { return reinterpret_cast<void*>(eglGetProcAddress(name)); }, scene, options);

    // The camera is at (0, 2.2, 4) and looks along -Z, 25 degrees downwards.
    const Matrix4 cameraFromWorld = product(rotationAboutX(25), translation({0, -2.2F, -4}));
    const Matrix4 clipFromCamera = perspective(45, 640.0F / 480.0F, 0.1F, 20);
    const vct::View view{vct::Matrix::of(cameraFromWorld.data()), vct::Matrix::of(clipFromCamera.data())};
    const vct::Pictures pictures = renderer.render(view, vct::GlobalIllumination::Light::converged);

    writePpm(out, pictures.radiance, options.width, options.height);
}

}  // namespace

int main(int count, char** arguments) {
    try {
        if (count != 2) throw std::runtime_error("give the name of the picture to write: triangle FILE.ppm");
        run(arguments[1]);
        return 0;
    } catch (const std::exception& error) {
        std::cerr << "error: " << error.what() << "\n";
        return 1;
    }
}
