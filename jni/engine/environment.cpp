#include "engine/environment.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/error.h"

namespace vct {

namespace {

constexpr double halfTurn = 3.14159265358979323846;  // radians
// At this size a texel is a sixth of a degree wide, two pixels of a picture with 400 pixels and a field of
// view of 40 degrees, and the cube takes 17 MB.
constexpr int largestSide = 512;
// Up to this size texels are a fourth of a pixel wide. The cube takes 1 MB.
constexpr int sideOfSmallPictures = 128;
constexpr int cubeFaces = 6;

// The coordinate of a texel's middle on a face, in [-1, 1].
double faceCoordinate(double texel, int side) {
    return 2.0 * (texel + 0.5) / side - 1.0;
}

// The direction of a point on a face (GL ES 3.1, table 8.25). Its length is sqrt(1 + s^2 + t^2).
glm::dvec3 directionOf(int face, double s, double t) {
    switch (face) {
        case 0:
            return {1.0, -t, -s};
        case 1:
            return {-1.0, -t, s};
        case 2:
            return {s, 1.0, t};
        case 3:
            return {s, -1.0, -t};
        case 4:
            return {s, -t, 1.0};
        default:
            return {-s, -t, -1.0};
    }
}

// The solid angle of the rectangle between a face's middle and a point on it. Differences of it are the solid
// angles of texels.
double cornerSolidAngle(double s, double t) {
    return std::atan2(s * t, std::sqrt(s * s + t * t + 1.0));
}

double texelSolidAngle(int x, int y, int side) {
    const double s0 = faceCoordinate(x - 0.5, side), s1 = faceCoordinate(x + 0.5, side);
    const double t0 = faceCoordinate(y - 0.5, side), t1 = faceCoordinate(y + 0.5, side);
    return cornerSolidAngle(s1, t1) - cornerSolidAngle(s0, t1) - cornerSolidAngle(s1, t0) +
           cornerSolidAngle(s0, t0);
}

// Calls visit(face, x, y) for all texels of a cube: face by face in GL's order, rows from t = 0 on.
template <class Visit>
void forEachTexel(int side, const Visit& visit) {
    for (int face = 0; face < cubeFaces; ++face)
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x)
                visit(face, x, y);
}

class WeightedMean {
  public:
    void add(double weight, const glm::vec3& value) {
        sum_ += weight * glm::dvec3(value);
        weights_ += weight;
    }
    glm::vec3 value() const { return sum_ / weights_; }

  private:
    glm::dvec3 sum_{0.0};
    double weights_ = 0.0;
};

// The picture at half its size; rows are weighted by the solid angle of their pixels.
Image halved(const Image& picture) {
    Image half(picture.width / 2, picture.height / 2);
    for (int y = 0; y < half.height; ++y) {
        const auto rowHeight = [&](int row) {
            return std::cos(halfTurn * row / picture.height) -
                   std::cos(halfTurn * (row + 1) / picture.height);
        };
        const double top = rowHeight(2 * y), bottom = rowHeight(2 * y + 1);
        const auto share = static_cast<float>(top / (top + bottom));
        for (int x = 0; x < half.width; ++x)
            half.at(x, y) =
                0.5F * (share * (picture.at(2 * x, 2 * y) + picture.at(2 * x + 1, 2 * y)) +
                        (1.0F - share) * (picture.at(2 * x, 2 * y + 1) + picture.at(2 * x + 1, 2 * y + 1)));
    }
    return half;
}

// Spreads each pixel along its row until it is as wide as it is high. Towards the poles pixels are narrower.
// Samples that are half a pixel's height apart would miss some there.
Image limitNarrowPixels(const Image& picture) {
    Image even = picture;
    for (int y = 0; y < picture.height; ++y) {
        const double sine = std::sin(halfTurn * (y + 0.5) / picture.height);
        const int aside = static_cast<int>(0.5 / sine);
        if (aside == 0) continue;
        const auto column = [&](int x) { return (x + picture.width) % picture.width; };
        glm::dvec3 sum(0.0);
        for (int x = -aside; x <= aside; ++x)
            sum += glm::dvec3(picture.at(column(x), y));
        for (int x = 0; x < picture.width; ++x) {
            even.at(x, y) = glm::vec3(glm::max(sum, 0.0) / (2.0 * aside + 1.0));
            sum += glm::dvec3(picture.at(column(x + aside + 1), y)) -
                   glm::dvec3(picture.at(column(x - aside), y));
        }
    }
    return even;
}

// Bilinear look-up in a direction. It wraps around at the sides of the picture, and ends at its poles.
glm::vec3 lookUp(const Image& picture, const glm::dvec3& direction) {
    const double length = glm::length(direction);
    const double u = 0.5 + std::atan2(direction.z, direction.x) / (2.0 * halfTurn);
    const double v = std::acos(std::clamp(direction.y / length, -1.0, 1.0)) / halfTurn;
    const double x = u * picture.width - 0.5, y = v * picture.height - 0.5;
    const int left = static_cast<int>(std::floor(x)), top = static_cast<int>(std::floor(y));
    const auto right = static_cast<float>(x - left), below = static_cast<float>(y - top);
    const auto pixel = [&](int column, int row) {
        return picture.at((column + picture.width) % picture.width, std::clamp(row, 0, picture.height - 1));
    };
    return glm::mix(glm::mix(pixel(left, top), pixel(left + 1, top), right),
                    glm::mix(pixel(left, top + 1), pixel(left + 1, top + 1), right), below);
}

// The finest level: means over the texels, of samples at most half a pixel of the picture apart.
std::vector<glm::vec3> finestLevel(const Image& picture, int side) {
    const int places = std::max(2, static_cast<int>(std::ceil(4.0 * picture.height / (halfTurn * side))));
    std::vector<glm::vec3> texels;
    texels.reserve(std::size_t{cubeFaces} * side * side);
    forEachTexel(side, [&](int face, int x, int y) {
        WeightedMean mean;
        for (int i = 0; i < places * places; ++i) {
            const double s = faceCoordinate(x - 0.5 + (i % places + 0.5) / places, side);
            const double t = faceCoordinate(y - 0.5 + (i / places + 0.5) / places, side);
            mean.add(std::pow(1.0 + s * s + t * t, -1.5), lookUp(picture, directionOf(face, s, t)));
        }
        texels.push_back(mean.value());
    });
    return texels;
}

std::vector<glm::vec3> coarser(const std::vector<glm::vec3>& fine, int fineSide) {
    const int side = fineSide / 2;
    std::vector<glm::vec3> texels;
    texels.reserve(std::size_t{cubeFaces} * side * side);
    forEachTexel(side, [&](int face, int x, int y) {
        WeightedMean mean;
        for (int i = 0; i < 4; ++i) {
            const int fineX = 2 * x + i % 2, fineY = 2 * y + i / 2;
            mean.add(texelSolidAngle(fineX, fineY, fineSide),
                     fine[(std::size_t(face) * fineSide + fineY) * fineSide + fineX]);
        }
        texels.push_back(mean.value());
    });
    return texels;
}

float largestComponent(const glm::vec3& color) {
    return std::max({color.r, color.g, color.b});
}

// Throws vct::Error if a picture cannot be a sky.
void requireSky(const Image& picture, const std::string& name) {
    const auto require = [&](bool ok, const std::string& cause) {
        if (!ok) throw Error("the sky " + name + " cannot be used: " + cause);
    };
    const std::string size = std::to_string(picture.width) + " x " + std::to_string(picture.height);
    require(picture.height > 0 && picture.width == 2 * picture.height,
            "it is " + size + " pixels; use an equirectangular picture, which is twice as wide as high");
    require(picture.width <= maxEnvironmentWidth, "it is " + size + " pixels; scale it down to at most " +
                                                      std::to_string(maxEnvironmentWidth) + " x " +
                                                      std::to_string(maxEnvironmentWidth / 2));
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
        const glm::vec3& pixel = picture.pixels[i];
        const auto isRadiance = [](float value) { return value >= 0.0F && value <= 1e30F; };
        require(isRadiance(pixel.r) && isRadiance(pixel.g) && isRadiance(pixel.b),
                "its pixel " + std::to_string(i % picture.width) + "," + std::to_string(i / picture.width) +
                    " is negative, infinite or not a number; give radiance from 0 on, and below 1e30");
    }
}

}  // namespace

Environment::Environment(const Image& picture, const std::string& name) {
    requireSky(picture, name);
    Image smaller = picture;
    while (smaller.height > 2 * largestSide && smaller.height % 2 == 0)
        smaller = halved(smaller);
    // Texels that are as wide as pixels blur the picture twice. That shows in a mirror if the pixels are
    // wide.
    const int wanted = std::max(smaller.height, std::min(4 * smaller.height, sideOfSmallPictures));
    int side = 1;
    while (side < std::min(wanted, largestSide))
        side *= 2;
    levels_.push_back(finestLevel(limitNarrowPixels(smaller), side));
    for (; side > 1; side /= 2)
        levels_.push_back(coarser(levels_.back(), side));
}

float Environment::largestIrradiance() const {
    glm::vec3 sum(0.0F);
    for (const glm::vec3& texel : levels_.back())
        sum += texel;
    return 4.0F * largestComponent(sum / static_cast<float>(cubeFaces));
}

float Environment::largestRadiance() const {
    float largest = 0.0F;
    for (const glm::vec3& texel : levels_.front())
        largest = std::max(largest, largestComponent(texel));
    return largest;
}

gl::Texture Environment::texture(float radianceUnit) const {
    gl::Texture texture = gl::Texture::makeCube("environment", GL_RGBA16F, side(), levels());
    texture.setFilter(GL_LINEAR_MIPMAP_LINEAR, GL_LINEAR);
    texture.bind(gl::scratchTextureUnit);
    gl::PixelStorei(GL_UNPACK_ALIGNMENT, 4);
    for (int level = 0; level < levels(); ++level) {
        const std::size_t texelsOfFace = std::size_t(side(level)) * side(level);
        for (int face = 0; face < cubeFaces; ++face) {
            std::vector<glm::vec4> rgba;
            for (std::size_t i = 0; i < texelsOfFace; ++i)
                rgba.emplace_back(levels_[level][face * texelsOfFace + i] / radianceUnit, 1.0F);
            gl::TexSubImage2D(GL_TEXTURE_CUBE_MAP_POSITIVE_X + static_cast<GLenum>(face), level, 0, 0,
                              side(level), side(level), GL_RGBA, GL_FLOAT, rgba.data());
        }
    }
    return texture;
}

}  // namespace vct
