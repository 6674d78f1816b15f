// A folder of scenes, as in the APK, with one tiny scene.
#pragma once

#include <filesystem>
#include <string>

#include "support/gltf_builder.h"
#include "support/temporary_folder.h"

namespace vct::test {

class TinyScene {
  public:
    TinyScene() {
        GltfBuilder builder;
        builder.triangle();
        writeBytes(folder_.file("tiny.glb"), builder.glb());
    }
    std::string folder() const { return folder_.path(); }

  private:
    TemporaryFolder folder_;
};

}  // namespace vct::test
