#include "core/memory.h"
#include "core/number_text.h"
#include "image/files.h"
#include "image/stb_picture.h"

namespace vct {

void requirePixelMemory(int width, int height, std::size_t besides) {
    const std::size_t bytes =
        static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * sizeof(glm::vec3) + besides;
    if (bytes > availableMemory())
        throw PictureError("its " + std::to_string(width) + " x " + std::to_string(height) + " pixels take " +
                           megabytesText(bytes) + " of memory, and only " + megabytesText(availableMemory()) +
                           " are available");
}

}  // namespace vct
