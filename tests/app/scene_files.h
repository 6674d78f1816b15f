// An APK's scenes, of which there is one that costs nothing.
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
