#include "support/voxels.h"

namespace vct::test {

void writePyramid(const gl::Texture& voxels, Words base) {
    voxels.bind(VCT_TEX_VOXELS);
    gl::PixelStorei(GL_UNPACK_ALIGNMENT, 4);
    for (int level = 0; level < voxels.levels(); ++level) {
        const int side = voxels.width() >> level;
        gl::TexSubImage3D(GL_TEXTURE_3D, level, 0, 0, 0, side, side, side, GL_RED_INTEGER, GL_UNSIGNED_INT,
                          base.data());
        if (level + 1 < voxels.levels()) base = mipOnCpu(base, side);
    }
}

}  // namespace vct::test
