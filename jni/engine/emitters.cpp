#include "engine/emitters.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "image/image.h"

namespace vct {

namespace {

// Largest radius of a part, in voxels; a larger part is divided.
constexpr double maxRadius = 5.0;
// The coarsest grid of the presets.
constexpr int coarsestGrid = 64;
// An instance with more parts than this is no compact emitter.
constexpr std::size_t maxPartsPerEmitter = 16;
// Triangles are cut into pieces, about this many per instance, before the pieces are grouped into parts.
constexpr double piecesPerInstance = 256.0;

// One side of a piece of a triangle.
struct Piece {
    glm::dvec3 centre, facing, radiance;  // as in EmitterPart
};

glm::dvec3 linear(const std::uint8_t* rgba) {
    return {srgbDecode(rgba[0] / 255.0F), srgbDecode(rgba[1] / 255.0F), srgbDecode(rgba[2] / 255.0F)};
}

// The nearest texel. No filter is needed, because the radiance of all pieces is averaged.
const std::uint8_t* texelAt(const Texture& texture, const glm::dvec2& uv) {
    const auto index = [](double coordinate, int size, Texture::Wrap wrap) {
        double at = wrap == Texture::Wrap::clampToEdge ? std::clamp(coordinate, 0.0, 1.0)
                                                       : coordinate - std::floor(coordinate);
        if (wrap == Texture::Wrap::mirroredRepeat && std::fmod(std::abs(std::floor(coordinate)), 2.0) == 1.0)
            at = 1.0 - at;
        return std::clamp(static_cast<int>(at * size), 0, size - 1);
    };
    const auto x = static_cast<std::size_t>(index(uv.x, texture.width, texture.wrapS));
    const auto y = static_cast<std::size_t>(index(uv.y, texture.height, texture.wrapT));
    return &texture.rgba[4 * (y * static_cast<std::size_t>(texture.width) + x)];
}

// Cuts the emitting surface of an instance into pieces.
class Pieces {
  public:
    Pieces(const Scene& scene, const Instance& instance)
        : scene_(scene),
          instance_(instance),
          mesh_(scene.meshes[static_cast<std::size_t>(instance.mesh)]),
          material_(scene.materials[static_cast<std::size_t>(mesh_.material)]) {
        double area = 0.0;
        for (std::size_t i = 0; i + 2 < mesh_.indices.size(); i += 3)
            area += 0.5 * glm::length(doubleArea(i));
        for (std::size_t i = 0; i + 2 < mesh_.indices.size() && area > 0.0; i += 3)
            cut(i, area);
    }
    std::vector<Piece> take() { return std::move(pieces_); }

  private:
    const Vertex& vertex(std::size_t corner) const { return mesh_.vertices[mesh_.indices[corner]]; }
    const VertexExtras& extrasOf(std::size_t corner) const { return mesh_.extras[mesh_.indices[corner]]; }
    glm::dvec3 world(std::size_t corner) const {
        const glm::dvec3 position = mesh_.centre + glm::dvec3(vertex(corner).position);
        return glm::dvec3(instance_.worldFromObject * glm::dvec4(position, 1.0));
    }
    glm::dvec3 doubleArea(std::size_t first) const {
        const glm::dvec3 a = world(first);
        const glm::dvec3 normal = glm::cross(world(first + 1) - a, world(first + 2) - a);
        return glm::determinant(glm::dmat3(instance_.worldFromObject)) < 0.0 ? -normal : normal;
    }
    // Cuts a triangle into n^2 triangles of the same size.
    void cut(std::size_t first, double areaOfAll) {
        const glm::dvec3 facing = 0.5 * doubleArea(first);
        const double n =
            std::clamp(std::ceil(std::sqrt(glm::length(facing) / areaOfAll * piecesPerInstance)), 1.0, 16.0);
        for (double row = 0.0; row < n; ++row) {
            for (double column = 0.0; column < 2.0 * (n - row) - 1.0; ++column) {
                // Every second piece is upside down.
                const double tip = std::fmod(column, 2.0), third = (1.0 + tip) / 3.0;
                const double u = (std::floor(column / 2.0) + third) / n, v = (row + third) / n;
                add(first, {1.0 - u - v, u, v}, facing / (n * n));
            }
        }
    }
    void add(std::size_t first, const glm::dvec3& weights, const glm::dvec3& facing) {
        glm::dvec3 centre(0.0);
        glm::dvec2 uv(0.0), emissiveUv(0.0);
        double vertexAlpha = material_.vertexColors ? 0.0 : 1.0;
        for (int i = 0; i < 3; ++i) {
            const Vertex& corner = vertex(first + static_cast<std::size_t>(i));
            centre += weights[i] * world(first + static_cast<std::size_t>(i));
            uv += weights[i] * glm::dvec2(corner.uv);
            emissiveUv += weights[i] * glm::dvec2(corner.emissiveUv);
            if (material_.vertexColors)
                vertexAlpha += weights[i] * double{extrasOf(first + static_cast<std::size_t>(i)).color.a};
        }
        const auto texture = [&](int index) -> const Texture& {
            return scene_.textures[static_cast<std::size_t>(index)];
        };
        if (material_.alphaMode == Material::AlphaMode::mask) {
            const double alpha = material_.baseColorTexture < 0
                                     ? 1.0
                                     : texelAt(texture(material_.baseColorTexture), uv)[3] / 255.0;
            if (alpha * vertexAlpha * material_.baseColor.a < material_.alphaCutoff) return;
        }
        glm::dvec3 radiance(material_.emissive);
        if (material_.emissiveTexture >= 0)
            radiance *= linear(texelAt(texture(material_.emissiveTexture), emissiveUv));
        pieces_.push_back({centre, facing, radiance});
        if (material_.doubleSided) pieces_.push_back({centre, -facing, radiance});
    }

    const Scene& scene_;
    const Instance& instance_;
    const Mesh& mesh_;
    const Material& material_;
    std::vector<Piece> pieces_;
};

// Half a side of the rectangle with the part's area and ratio of second moments.
glm::dvec3 sideOf(const EmitterPart& part, const std::vector<Piece>& pieces) {
    const glm::dvec3 normal = glm::normalize(part.facing);
    // A square has no longer side, so its axes follow the world's.
    const glm::dvec3 helper = std::abs(normal.x) < 0.7 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 0, 1);
    const glm::dvec3 u = glm::normalize(helper - glm::dot(helper, normal) * normal),
                     v = glm::cross(normal, u);
    double uu = 0.0, uv = 0.0, vv = 0.0;
    for (const Piece& piece : pieces) {
        const double area = glm::length(piece.facing);
        const double x = glm::dot(piece.centre - part.centre, u), y = glm::dot(piece.centre - part.centre, v);
        uu += area * x * x;
        uv += area * x * y;
        vv += area * y * y;
    }
    const bool oblong = std::hypot(uu - vv, 2.0 * uv) > 0.02 * (uu + vv);
    const double turn = oblong ? 0.5 * std::atan2(2.0 * uv, uu - vv) : 0.0;
    const double c = std::cos(turn), s = std::sin(turn);
    const double first = std::sqrt(std::max(c * c * uu + 2.0 * c * s * uv + s * s * vv, 0.0));
    const double second = std::sqrt(std::max(s * s * uu - 2.0 * c * s * uv + c * c * vv, 0.0));
    // A single piece has no moments and is treated as a square.
    const double shape = first > 0.0 && second > 0.0 ? std::clamp(first / second, 0.01, 100.0) : 1.0;
    return (c * u + s * v) * std::sqrt(0.25 * glm::length(part.facing) * shape);
}

EmitterPart aggregate(std::size_t instance, const std::vector<Piece>& pieces) {
    EmitterPart part{instance, glm::dvec3(0.0), glm::dvec3(0.0), 0.0, glm::dvec3(0.0), 0.0,
                     0.0,      glm::dvec3(0.0)};
    for (const Piece& piece : pieces) {
        const double area = glm::length(piece.facing);
        part.area += area;
        part.facing += piece.facing;
        part.centre += area * piece.centre;
        part.radiance += area * piece.radiance;
    }
    part.centre /= part.area;
    part.radiance /= part.area;
    const glm::dvec3 normal = part.isRound() ? glm::dvec3(0.0) : glm::normalize(part.facing);
    for (const Piece& piece : pieces) {
        const glm::dvec3 aside = piece.centre - part.centre;
        part.radius = std::max(part.radius, glm::length(aside));
        part.halfDepth = std::max(part.halfDepth, std::abs(glm::dot(aside, normal)));
    }
    if (part.isRound())
        part.halfDepth = part.radius;
    else
        part.side = sideOf(part, pieces);
    return part;
}

// True if the pieces show about the same area to every side: no axis has much more than a third of the
// squared normals' sum.
bool isIsotropic(const std::vector<Piece>& pieces) {
    glm::dvec3 squares(0.0);
    for (const Piece& piece : pieces)
        squares += piece.facing * piece.facing / std::max(glm::length(piece.facing), 1e-300);
    const double sum = squares.x + squares.y + squares.z;
    return std::max({squares.x, squares.y, squares.z}) < 0.45 * sum;
}

// Groups the pieces by the axis direction that they face most; at most six groups, none empty.
std::vector<std::vector<Piece>> splitByFacing(const std::vector<Piece>& pieces) {
    std::vector<std::vector<Piece>> sides(6);
    for (const Piece& piece : pieces) {
        const glm::dvec3 size = glm::abs(piece.facing);
        const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
        sides[static_cast<std::size_t>(2 * axis + (piece.facing[axis] > 0.0 ? 0 : 1))].push_back(piece);
    }
    sides.erase(std::remove_if(sides.begin(), sides.end(), [](const auto& side) { return side.empty(); }),
                sides.end());
    return sides;
}

// Splits the pieces at the middle of their longest axis.
std::vector<std::vector<Piece>> splitAtMedian(std::vector<Piece> pieces) {
    glm::dvec3 low(pieces[0].centre), high(low);
    for (const Piece& piece : pieces) {
        low = glm::min(low, piece.centre);
        high = glm::max(high, piece.centre);
    }
    const glm::dvec3 size = high - low;
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const double middle = 0.5 * (low[axis] + high[axis]);
    const auto second = std::partition(pieces.begin(), pieces.end(),
                                       [&](const Piece& piece) { return piece.centre[axis] <= middle; });
    return {{pieces.begin(), second}, {second, pieces.end()}};
}

// Divides an instance's pieces into parts. Returns none if there would be more than maxPartsPerEmitter.
std::vector<EmitterPart> partsOf(std::size_t instance, std::vector<Piece> pieces, double largest) {
    std::vector<EmitterPart> done;
    std::vector<std::vector<Piece>> left{std::move(pieces)};
    while (!left.empty()) {
        if (done.size() + left.size() > maxPartsPerEmitter) return {};
        const std::vector<Piece> group = std::move(left.back());
        left.pop_back();
        const EmitterPart part = aggregate(instance, group);
        std::vector<std::vector<Piece>> divided;
        if (part.radius > largest)
            divided = splitAtMedian(group);
        else if (glm::length(part.facing) < 0.8 * part.area && !isIsotropic(group))
            divided = splitByFacing(group);
        if (divided.size() < 2)
            done.push_back(part);
        else
            for (std::vector<Piece>& some : divided)
                left.push_back(std::move(some));
    }
    return done;
}

double fluxOf(const std::vector<EmitterPart>& parts) {
    double flux = 0.0;
    for (const EmitterPart& part : parts)
        flux += part.flux();
    return flux;
}

struct Emitter {
    std::size_t instance;
    std::vector<Piece> pieces;
};

struct CompactEmitters {
    std::size_t count = 0;
    std::vector<EmitterPart> parts;
};

// The parts of the emitters that are compact with parts of this radius at most, the brightest first.
CompactEmitters divided(const std::vector<Emitter>& emitters, double largest) {
    std::vector<std::vector<EmitterPart>> compact;
    for (const Emitter& emitter : emitters) {
        std::vector<EmitterPart> parts = partsOf(emitter.instance, emitter.pieces, largest);
        if (!parts.empty()) compact.push_back(std::move(parts));
    }
    std::stable_sort(compact.begin(), compact.end(),
                     [](const auto& a, const auto& b) { return fluxOf(a) > fluxOf(b); });
    CompactEmitters found;
    for (const std::vector<EmitterPart>& parts : compact) {
        if (found.parts.size() + parts.size() > VCT_MAX_EMITTER_PARTS) continue;
        found.parts.insert(found.parts.end(), parts.begin(), parts.end());
        ++found.count;
    }
    return found;
}

}  // namespace

double EmitterPart::flux() const {
    return area * std::max({radiance.r, radiance.g, radiance.b});
}

bool EmitterPart::isRound() const {
    return glm::length(facing) < 0.5 * area;
}

// The texels of textures of the embedding program are on the GPU only.
static bool dependsOnExternalTexture(const Scene& scene, const Material& material) {
    const auto isExternal = [&](int index) {
        return index >= 0 && scene.textures[static_cast<std::size_t>(index)].external != 0;
    };
    return isExternal(material.emissiveTexture) ||
           (material.alphaMode == Material::AlphaMode::mask && isExternal(material.baseColorTexture));
}

std::vector<EmitterPart> emitterParts(const Scene& scene, const Volume& volume) {
    std::vector<Emitter> emitters;
    for (std::size_t i = 0; i < scene.instances.size(); ++i) {
        const Instance& instance = scene.instances[i];
        const Mesh& mesh = scene.meshes[static_cast<std::size_t>(instance.mesh)];
        const Material& material = scene.materials[static_cast<std::size_t>(mesh.material)];
        if (material.emissive == glm::vec3(0.0F)) continue;
        if (dependsOnExternalTexture(scene, material)) continue;
        if (instance.deforms) continue;  // parts are rigid, so its emission stays in the voxels
        if (glm::determinant(glm::dmat3(instance.worldFromObject)) == 0.0) continue;
        std::vector<Piece> pieces = Pieces(scene, instance).take();
        if (!pieces.empty()) emitters.push_back({i, std::move(pieces)});
    }
    const double smallest = maxRadius * volume.voxelSize();
    double largest =
        std::max(smallest, maxRadius * volumeAround(scene.boundsWorld, coarsestGrid).voxelSize());
    CompactEmitters chosen = divided(emitters, largest);
    while (largest > smallest) {
        largest = std::max(0.5 * largest, smallest);
        CompactEmitters finer = divided(emitters, largest);
        if (finer.count < chosen.count) break;
        chosen = std::move(finer);
    }
    return chosen.parts;
}

std::vector<bool> emittingInstances(const Scene& scene, const std::vector<EmitterPart>& parts) {
    std::vector<bool> emitting(scene.instances.size());
    for (const EmitterPart& part : parts)
        emitting[part.instance] = true;
    return emitting;
}

Emitters::Emitters(const Scene& scene, const std::vector<EmitterPart>& parts, const Volume& volume,
                   float radianceUnit)
    : instances_(emittingInstances(scene, parts)),
      volume_(volume),
      radianceUnit_(radianceUnit),
      uniforms_("emitters", GL_UNIFORM_BUFFER, sizeof(shared::EmitterBlock), nullptr, GL_DYNAMIC_DRAW) {
    for (const EmitterPart& part : parts) {
        const Instance& instance = scene.instances[part.instance];
        parts_.push_back({part, instance.node, glm::inverse(instance.worldFromObject)});
    }
    upload();
}

void Emitters::setPose(const Pose& pose) {
    pose_ = pose;
    upload();
}

void Emitters::setScale(int node, float scale) {
    for (Placed& part : parts_)
        if (part.node == node) part.scale = scale;
    upload();
}

void Emitters::setRadiance(std::size_t instance, const glm::vec3& radiance) {
    for (Placed& part : parts_)
        if (part.part.instance == instance) part.part.radiance = radiance;
    upload();
}

void Emitters::upload() const {
    shared::EmitterBlock block{};
    for (const Placed& placed : parts_) {
        if (placed.scale == 0.0F) continue;
        const EmitterPart& part = placed.part;
        glm::dmat4 moved(1.0);
        if (pose_ && placed.node >= 0)
            moved = pose_->worldFromNode.at(static_cast<std::size_t>(placed.node)) * placed.objectFromWorld;
        const glm::dmat3 m(moved);
        const glm::dmat3 cofactors(glm::cross(m[1], m[2]), glm::cross(m[2], m[0]), glm::cross(m[0], m[1]));
        const double larger = std::cbrt(std::abs(glm::determinant(m)));
        const glm::dvec3 facing = cofactors * part.facing / (volume_.side * volume_.side);
        const double area = part.area * larger * larger / (volume_.side * volume_.side);
        const double halfDepth = part.halfDepth * larger / volume_.side;
        if (placed.node >= 0) block.count.y |= 1 << block.count.x;
        shared::EmitterPartUniforms& to = block.part[block.count.x++];
        to.position = glm::vec4(glm::dvec3(volume_.volumeFromWorld() * moved * glm::dvec4(part.centre, 1.0)),
                                part.radius * larger / volume_.side);
        to.facing = glm::vec4(facing, std::max(area - glm::length(facing), 0.0) / 4.0);
        to.side = glm::vec4(m * part.side / volume_.side, 0.0);
        to.radiance = glm::vec4(placed.scale * glm::vec3(part.radiance / double{radianceUnit_}), halfDepth);
    }
    uniforms_.bind(GL_UNIFORM_BUFFER);
    gl::BufferSubData(GL_UNIFORM_BUFFER, 0, sizeof block, &block);
}

}  // namespace vct
