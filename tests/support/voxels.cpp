#include "support/voxels.h"

namespace vct::test {

void writeLevel(const gl::Texture& voxels, int level, const Words& words) {
    const int side = voxels.width() >> level;
    voxels.bind(VCT_TEX_VOXELS);
    gl::PixelStorei(GL_UNPACK_ALIGNMENT, 4);
    gl::TexSubImage3D(GL_TEXTURE_3D, level, 0, 0, 0, side, side, side, GL_RED_INTEGER, GL_UNSIGNED_INT,
                      words.data());
}

void writePyramid(const gl::Texture& voxels, Words base) {
    for (int level = 0; level < voxels.levels(); ++level) {
        writeLevel(voxels, level, base);
        if (level + 1 < voxels.levels()) base = mipOnCpu(base, voxels.width() >> level);
    }
}

}  // namespace vct::test
