// Errors of the interface in include/vct/vct.h.
#include <functional>
#include <optional>

#include "api/described_scene.h"
#include "support/errors.h"

namespace vct::test {
namespace {

TEST_F(Embedded, ErrorsNameCauseAndRemedyWithoutOptionsOfTheProgram) {
    struct Asked {
        SceneDescription scene;
        Options options = optionsOf("mobile");
    };
    const auto expectError = [&](const char* part, const std::function<void(Asked&)>& spoil) {
        Asked wrong{described_.scene};
        spoil(wrong);
        const std::string error =
            errorOf([&] { GlobalIllumination(getProcAddress, wrong.scene, wrong.options); });
        expectMentions(error, {part});
        EXPECT_EQ(error.find("--"), std::string::npos) << error;
    };
    const std::vector<std::uint32_t> beyond{0, 1, 24};
    const std::vector<float> noNormals(72, 0.0F);
    expectError("thesis, mobile, quality", [](Asked& asked) { asked.options.preset = "best"; });
    expectError("64, 128, 256, 512", [](Asked& asked) { asked.options.grid = 100; });
    expectError("no picture", [](Asked& asked) {
        asked.options.radiance = asked.options.irradiance = asked.options.ambientVisibility =
            asked.options.sunVisibility = false;
    });
    expectError("cone angle", [](Asked& asked) { asked.scene.sun.diameterDegrees = 0; });
    expectError("no length", [](Asked& asked) { asked.scene.sun.directionToSun = {0, 0, 0}; });
    expectError("sun's colour", [](Asked& asked) { asked.scene.sun.color = {0.5F, 0.5F, 0.5F}; });
    expectError("sky", [](Asked& asked) { asked.scene.skyRadiance[1] = -1; });
    expectError("no instances", [](Asked& asked) { asked.scene.instances.clear(); });
    expectError("instance 0: there is no mesh 9", [](Asked& asked) { asked.scene.instances[0].mesh = 9; });
    expectError("not affine", [](Asked& asked) { asked.scene.instances[0].worldFromObject.columns[3] = 1; });
    expectError("mesh 1: there is no material 9", [](Asked& asked) { asked.scene.meshes[1].material = 9; });
    expectError("mesh 0: an index is 24", [&](Asked& asked) { asked.scene.meshes[0].indices = beyond; });
    expectError("normal of vertex", [&](Asked& asked) { asked.scene.meshes[0].normals = noNormals; });
    expectError("give as many", [](Asked& asked) { asked.scene.meshes[0].normals = {}; });
    expectError("material 0: give a base colour",
                [](Asked& asked) { asked.scene.materials[0].baseColor[0] = 1.5F; });
    Options nowhere = optionsOf("mobile");
    nowhere.shaderFolder = "/nowhere";
    GlobalIllumination withoutShaders(getProcAddress, described_.scene, nowhere);
    expectMentions(errorOf([&] { withoutShaders.render(described_.view()); }),
                   {"cannot read the shader /nowhere"});
    expectMentions(errorOf([&] { GlobalIllumination(nullptr, described_.scene); }), {"null"});

    GlobalIllumination light(getProcAddress, described_.scene, optionsOf("mobile"));
    expectMentions(errorOf([&] { light.setTransform(0, {}); }), {"not declared to move"});
    expectMentions(errorOf([&] { light.setTransform(9, {}); }), {"no instance 9"});
    View scaled = described_.view();
    scaled.cameraFromWorld.columns[0] *= 2;
    expectMentions(errorOf([&] { light.render(scaled); }), {"not a rotation"});
}

TEST_F(Embedded, OnlyProjectionsThatArePossibleAreTaken) {
    GlobalIllumination light(getProcAddress, described_.scene, optionsOf("mobile"));
    View view = described_.view();
    const auto errorWith = [&](const glm::dmat4& clipFromCamera) {
        view.clipFromCamera = Matrix::of(glm::value_ptr(clipFromCamera));
        return errorOf([&] { light.render(view); });
    };
    const glm::dmat4 perspective = glm::perspective(0.9, 4.0 / 3.0, 0.1, 20.0);
    const glm::dmat4 orthographic = glm::ortho(-2.0, 2.0, -1.5, 1.5, 0.1, 20.0);
    for (const glm::dmat4& projection : {perspective, orthographic}) {
        EXPECT_EQ(errorWith(projection), "");
        expectMentions(errorWith(glm::transpose(projection)), {"clipFromCamera", "column-major"});
        const glm::dmat4 reversed = glm::scale(glm::dmat4(1.0), {1, 1, -1}) * projection;
        expectMentions(errorWith(reversed), {"reverses depth", "set View::reversedDepth"});
        view.reversedDepth = true;
        EXPECT_EQ(errorWith(reversed), "");
        expectMentions(errorWith(projection), {"View::reversedDepth is set", "from 1 (near) to 0 (far)"});
        view.reversedDepth = false;
        const glm::dmat4 jittered = glm::translate(glm::dmat4(1.0), {0.001, 0.002, 0}) * projection;
        EXPECT_EQ(errorWith(jittered), "");
    }
    expectMentions(errorWith(glm::dmat4(0.0)), {"no inverse"});
}

TEST_F(Embedded, WithoutAContextTheErrorSaysSo) {
    const EGLDisplay display = eglGetCurrentDisplay();
    ASSERT_EQ(eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT), EGL_TRUE);
    const std::string error = errorOf([&] { GlobalIllumination(getProcAddress, described_.scene); });
    expectMentions(error, {"no GL context is current", "make one"});
}

// The message of each function of the library, in some order.
std::vector<std::string> errorsOfAllFunctions(GlobalIllumination& light, const View& view) {
    const GBufferTextures textures{};
    const std::vector<std::function<void()>> calls{[&] { light.setTransform(0, {}); },
                                                   [&] { light.setVertices(0, {}, {}); },
                                                   [&] { light.setVisible(0, true); },
                                                   [&] { light.setEmission(0, 1.0F); },
                                                   [&] { light.setSun({0, 1, 0}); },
                                                   [&] { light.setSunlight({1, 1, 1}, 1.0F); },
                                                   [&] { light.setSky(std::array<float, 3>{0, 0, 0}); },
                                                   [&] { light.setSky(SkyPicture{}); },
                                                   [&] { light.addLight({}); },
                                                   [&] { light.setLight(0, {}); },
                                                   [&] { light.removeLight(0); },
                                                   [&] { light.resize(8, 8); },
                                                   [&] { light.bakeLight(); },
                                                   [&] { light.useBakedLight({}); },
                                                   [&] { light.render(view); },
                                                   [&] { light.render(view, textures); },
                                                   [&] { light.lookUpGlsl(); },
                                                   [&] { light.bindLookUp(); },
                                                   [&] { light.radianceUnit(); },
                                                   [&] { light.voxelBounds(); }};
    std::vector<std::string> errors;
    for (const std::function<void()>& call : calls)
        errors.push_back(errorOf(call));
    return errors;
}

TEST_F(Embedded, CallsWithoutTheirContextAndDestructionAreSafe) {
    std::optional<GlobalIllumination> light(std::in_place, getProcAddress, described_.scene,
                                            optionsOf("mobile"));
    const EGLDisplay display = eglGetCurrentDisplay();
    const EGLContext own = eglGetCurrentContext();
    ASSERT_EQ(eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT), EGL_TRUE);
    for (const std::string& error : errorsOfAllFunctions(*light, described_.view()))
        expectMentions(error, {"no GL context is current in this thread", "make the one current"});
    {
        const Context other = openContext(Backend::egl);
        for (const std::string& error : errorsOfAllFunctions(*light, described_.view()))
            expectMentions(error, {"another GL context is current in this thread", "make the one current"});
        GLuint buffer = 0;  // has the name of one of the object's
        gl::GenBuffers(1, &buffer);
        gl::BindBuffer(GL_UNIFORM_BUFFER, buffer);
        light.reset();
        EXPECT_EQ(gl::IsBuffer(buffer), GL_TRUE) << "an object of another context was deleted";
    }
    ASSERT_EQ(eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, own), EGL_TRUE);
}

TEST_F(Embedded, AnObjectThatWasMovedFromThrows) {
    GlobalIllumination first(getProcAddress, described_.scene, optionsOf("mobile"));
    GlobalIllumination second = std::move(first);
    for (const std::string& error : errorsOfAllFunctions(first, described_.view()))
        expectMentions(error, {"was moved from", "call the one that it was moved to"});
    first = std::move(second);
    EXPECT_NO_THROW(first.setSun({0, 1, 0}));
    EXPECT_NO_THROW(first.render(described_.view()));
}

}  // namespace
}  // namespace vct::test
