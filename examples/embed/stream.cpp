// Streams 200 meshes in and out of a scene while it draws, one in each frame and 40 at a time, without a
// window. Prints the times of the frames and the memory that the process takes.
#include <GLES3/gl31.h>
#include <vct/vct.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <deque>
#include <exception>
#include <fstream>
#include <iostream>

#include "shapes.h"
#include "window.h"

namespace {

constexpr int frames = 60;
constexpr std::size_t shown = 24;

// The place of the object of a frame, on a ring, a little farther than the one before.
Matrix4 placeOf(int frame) {
    const float angle = 6.2831853F * static_cast<float>(frame) / 40.0F;
    const float radius = 1.2F + 0.3F * static_cast<float>(frame % 3);
    return translation({radius * std::cos(angle), 0.15F, radius * std::sin(angle)});
}

double residentMegabytes() {
    std::size_t pages = 0, resident = 0;
    std::ifstream("/proc/self/statm") >> pages >> resident;
    return static_cast<double>(resident) * 4096.0 / 1e6;
}

void run() {
    const Window window(1);
    const Shape ground = box({2, 0.1F, 2}, false);

    // The scene is described with the kinds of all materials, and with the room in which objects appear.
    vct::SceneDescription scene;
    scene.materials.resize(1);
    scene.meshes = {{ground.positions, ground.normals, ground.indices}};
    scene.instances.resize(1);
    scene.instances[0].worldFromObject = vct::Matrix::of(translation({0, -0.1F, 0}).data());
    scene.maxInstances = scene.instances.size() + shown;
    scene.bounds = vct::Box{{-2, -0.2, -2}, {2, 1, 2}};
    scene.sun.directionToSun = {-0.8, 0.8, 0.7};
    scene.skyRadiance = {0.2F, 0.25F, 0.3F};

    vct::Options options;
    options.width = 320;
    options.height = 240;
    vct::GlobalIllumination renderer(Window::getProcAddress, scene, options);
    const Matrix4 cameraFromWorld = product(rotationAboutX(25), translation({0, -2.2F, -4}));
    const Matrix4 clipFromCamera = perspective(45, 320.0F / 240.0F, 0.1F, 20);
    const vct::View view{vct::Matrix::of(cameraFromWorld.data()), vct::Matrix::of(clipFromCamera.data())};

    struct Object {
        std::size_t material, mesh, instance;
    };
    std::deque<Object> objects;
    std::vector<double> milliseconds;
    double half = 0.0;
    for (int frame = 0; frame < frames; ++frame) {
        const auto start = std::chrono::steady_clock::now();
        // The oldest object goes, and another one comes.
        if (objects.size() == shown) {
            const Object& oldest = objects.front();
            renderer.removeInstance(oldest.instance);
            renderer.removeMesh(oldest.mesh);
            renderer.removeMaterial(oldest.material);
            objects.pop_front();
        }
        const Shape shape = frame % 2 == 0 ? box({0.1F, 0.15F, 0.1F}, false) : ball(0.15F);
        vct::MaterialDescription material;
        material.baseColor = {0.5F + 0.1F * static_cast<float>(frame % 5), 0.5F, 0.3F};
        Object object{};
        object.material = renderer.addMaterial(material);
        object.mesh = renderer.addMesh({shape.positions, shape.normals, shape.indices, object.material});
        object.instance = renderer.addInstance({object.mesh, vct::Matrix::of(placeOf(frame).data())});
        objects.push_back(object);
        renderer.render(view);
        glFinish();
        const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - start;
        milliseconds.push_back(time.count());
        if (frame == frames / 2) half = residentMegabytes();
    }
    const double end = residentMegabytes();
    // The first frame compiles the shaders.
    std::sort(milliseconds.begin() + 1, milliseconds.end());
    std::cout << "first frame " << milliseconds[0] << " ms, median " << milliseconds[frames / 2]
              << " ms, longest " << milliseconds.back() << " ms; memory " << half << " MB at half time, "
              << end << " MB at the end\n";
}

}  // namespace

int main() {
    try {
        run();
        return 0;
    } catch (const std::exception& error) {
        std::cerr << "error: " << error.what() << "\n";
        return 1;
    }
}
