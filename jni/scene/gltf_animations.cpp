// Loads the animations of a glTF file: nodes and weights of morph targets (declared in gltf_nodes.h).
#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>

#include "core/error.h"
#include "core/list_text.h"
#include "core/number_text.h"
#include "scene/gltf_accessors.h"
#include "scene/gltf_nodes.h"

namespace vct {

namespace {

using nlohmann::json;
using Interpolation = AnimationChannel::Interpolation;
using Path = AnimationChannel::Path;

constexpr std::pair<const char*, Path> paths[] = {{"translation", Path::translation},
                                                  {"rotation", Path::rotation},
                                                  {"scale", Path::scale},
                                                  {"weights", Path::morphWeight}};
constexpr std::pair<const char*, Interpolation> interpolations[] = {
    {"STEP", Interpolation::step},
    {"LINEAR", Interpolation::linear},
    {"CUBICSPLINE", Interpolation::cubicSpline}};

// Names of the animations in messages: "3 (walk)".
std::vector<std::string> namesOf(const json& animations) {
    std::vector<std::string> names;
    for (const json& animation : animations)
        names.push_back(indexAndName(names.size(), textAt(animation, "name")));
    return names;
}

// Text of a list without the name with index `left`, which may be out of range.
std::string listed(std::vector<std::string> names, std::size_t left) {
    if (left < names.size()) names.erase(names.begin() + static_cast<std::ptrdiff_t>(left));
    return listText(names);
}

std::size_t choose(const GltfFile& file, const std::string& nameOrIndex) {
    if (nameOrIndex.empty()) return 0;
    const std::size_t count = file.animations.size();
    for (std::size_t i = 0; i < count; ++i)
        if (textAt(file.animations[i], "name") == nameOrIndex) return i;
    const bool isNumber = nameOrIndex.size() <= 9 && std::all_of(nameOrIndex.begin(), nameOrIndex.end(),
                                                                 [](char c) { return c >= '0' && c <= '9'; });
    const std::size_t i = isNumber ? std::stoul(nameOrIndex) : count;
    if (i < count) return i;
    if (count == 0)
        file.fail("it has no animation, and \"" + oneLine(nameOrIndex) + "\" was asked for",
                  "do not ask for an animation");
    file.fail("it has no animation \"" + oneLine(nameOrIndex) + "\"",
              "choose one of " + listed(namesOf(file.animations), count));
}

// Looks up a word of the file in a table. Returns nothing if the table lacks it.
template <class Value, std::size_t count>
std::optional<Value> find(const std::pair<const char*, Value> (&table)[count], const std::string& word) {
    for (const auto& [name, value] : table)
        if (word == name) return value;
    return std::nullopt;
}

// Loads one channel of an animation. Its errors name the animation and the channel.
class ChannelLoader {
  public:
    ChannelLoader(GltfFile& file, const json& samplers, const json& source, const std::string& name)
        : file_(file), samplers_(samplers), source_(source), name_(name) {}

    // Returns the channel, with AnimationChannel::node as an index of the file. A channel of weights becomes
    // one channel per morph target of the node's mesh; targetsOf(node) is their number. Returns nothing if
    // the channel moves no node.
    std::vector<AnimationChannel> load(const std::function<std::size_t(int node)>& targetsOf) {
        const auto target = source_.find("target");
        require(target != source_.end() && target->is_object(), "has no target");
        const std::string pathName = textAt(*target, "path");
        const auto path = find(paths, pathName);
        const auto node = index(*target, "node", "node", file_.model.nodes.size());
        if (!path)
            file_.warn("animation channels of the path \"" + oneLine(pathName) + "\" are ignored");
        else if (!node)  // section 3.11 reserves it for extensions
            file_.warn("animation channels without a node are ignored");
        if (!path || !node) return {};
        const bool weights = *path == Path::morphWeight;
        require(weights || file_.model.nodes[*node].matrix.empty(),
                "moves a node that has a matrix; only translation, rotation and scale can be animated");
        const auto sampler = index(source_, "sampler", "sampler", samplers_.size());
        require(sampler.has_value(), "has no sampler");
        AnimationChannel channel;
        channel.node = static_cast<int>(*node);
        channel.path = *path;
        setInterpolation(samplers_[*sampler], channel);
        setTimes(samplers_[*sampler], channel);
        if (weights) return weightChannels(samplers_[*sampler], channel, targetsOf(channel.node));
        setValues(samplers_[*sampler], channel);
        return {channel};
    }

  private:
    void require(bool ok, const std::string& cause, const std::string& remedy = reexportRemedy) const {
        if (!ok) file_.fail(name_ + " " + cause, remedy);
    }

    // Returns the index at `key` of an object, which must be below `count`. Returns nothing if the key is
    // missing.
    std::optional<std::size_t> index(const json& object, const char* key, const char* kind,
                                     std::size_t count) const {
        const auto found = object.find(key);
        if (found == object.end()) return std::nullopt;
        require(
            found->is_number_unsigned() && found->get<std::uint64_t>() < count,
            std::string("refers to ") + kind + " " + oneLine(found->dump()) + " of " + std::to_string(count));
        return found->get<std::size_t>();
    }

    void setInterpolation(const json& sampler, AnimationChannel& channel) const {
        std::string name = sampler.contains("interpolation") ? textAt(sampler, "interpolation") : "LINEAR";
        if (sampler.contains("interpolation") && sampler["interpolation"] == "") {
            file_.warn("animations with an empty interpolation are played as LINEAR");
            name = "LINEAR";
        }
        const auto found = find(interpolations, name);
        require(found.has_value(), "has the unknown interpolation \"" + oneLine(name) + "\"");
        channel.interpolation = *found;
    }

    int accessor(const json& sampler, const char* key) const {
        const auto i = index(sampler, key, "accessor", file_.model.accessors.size());
        require(i.has_value(), std::string("has a sampler without ") + key);
        return static_cast<int>(*i);
    }

    void setTimes(const json& sampler, AnimationChannel& channel) const {
        channel.times =
            readFloats(file_, accessor(sampler, "input"), 1, Components::floatOnly, name_ + ", key times");
        const std::vector<float>& times = channel.times;
        require(!times.empty(), "has no keys");
        for (std::size_t key = 0; key < times.size(); ++key) {
            const std::string which = "key " + std::to_string(key);
            require(std::isfinite(times[key]) && times[key] >= 0.0F,
                    "has the time " + numberText(times[key]) + " for " + which +
                        ", which is negative or not a number");
            if (key == 0) continue;
            require(times[key] >= times[key - 1],
                    "has unsorted keys: " + which + " at " + numberText(times[key]) +
                        " s does not come after " + numberText(times[key - 1]) + " s",
                    "sort its keys by time, each time once");
            // Exporters write jumps in this way: the animation approaches the first key and continues from
            // the last.
            if (times[key] == times[key - 1])
                file_.warn("animations with two keys at one time jump there from the first to the last");
        }
    }

    void setValues(const json& sampler, AnimationChannel& channel) const {
        const bool rotation = channel.path == Path::rotation;
        const int width = rotation ? 4 : 3;
        const std::vector<float> values =
            readFloats(file_, accessor(sampler, "output"), width,
                       rotation ? Components::floatOrNormalized : Components::floatOnly, name_ + ", values");
        const bool cubic = channel.interpolation == Interpolation::cubicSpline;
        const std::size_t count = values.size() / static_cast<std::size_t>(width);
        const std::size_t expected = channel.times.size() * (cubic ? 3 : 1);
        require(count == expected, "has " + std::to_string(count) + " values for " +
                                       std::to_string(channel.times.size()) + " keys, where " +
                                       std::to_string(expected) + " are needed");
        file_.reserveGeometry(count, sizeof(glm::dvec4));
        channel.values.assign(count, glm::dvec4(0.0));
        for (std::size_t i = 0; i < values.size(); ++i) {
            require(std::abs(values[i]) <= 1e30F, "has a value that is not a usable number");
            channel.values[i / static_cast<std::size_t>(width)][static_cast<int>(i) % width] = values[i];
        }
        if (!rotation) return;
        for (std::size_t i = cubic ? 1 : 0; i < count; i += cubic ? 3 : 1) {
            const double length = glm::length(channel.values[i]);
            require(length > 1e-6,
                    "has a rotation of zero length for key " + std::to_string(cubic ? i / 3 : i));
            // A spline's tangents refer to the stored values, so these are not normalized; the result is.
            if (!cubic) channel.values[i] /= length;
        }
    }

    // Splits the values of a weights channel into one channel per target. The file has one value per target
    // for each key and each tangent.
    std::vector<AnimationChannel> weightChannels(const json& sampler, const AnimationChannel& timed,
                                                 std::size_t targets) const {
        if (targets == 0) {
            file_.warn("animated weights of a mesh without morph targets are ignored");
            return {};
        }
        const std::vector<float> values = readFloats(file_, accessor(sampler, "output"), 1,
                                                     Components::floatOrNormalized, name_ + ", values");
        const std::size_t steps =
            timed.times.size() * (timed.interpolation == Interpolation::cubicSpline ? 3 : 1);
        require(values.size() == steps * targets, "has " + std::to_string(values.size()) + " values for " +
                                                      std::to_string(timed.times.size()) + " keys of " +
                                                      std::to_string(targets) + " weights, where " +
                                                      std::to_string(steps * targets) + " are needed");
        file_.reserveGeometry(targets * timed.times.size(), sizeof(float));
        file_.reserveGeometry(values.size(), sizeof(glm::dvec4));
        std::vector<AnimationChannel> channels;
        for (std::size_t target = 0; target < targets; ++target) {
            AnimationChannel channel = timed;
            channel.target = static_cast<int>(target);
            for (std::size_t step = 0; step < steps; ++step) {
                const float value = values[step * targets + target];
                require(std::abs(value) <= 1e9F, "has a value that is not a usable number");
                channel.values.emplace_back(value, 0.0, 0.0, 0.0);
            }
            channels.push_back(std::move(channel));
        }
        return channels;
    }

    GltfFile& file_;
    const json& samplers_;
    const json& source_;
    std::string name_;
};

Animation load(GltfFile& file, std::size_t chosen, const std::vector<std::string>& names,
               std::vector<PlacedNode>& placed) {
    Animation animation;
    if (names.size() > 1)
        file.warn("animation " + names[chosen] +
                  " is played; not played (--animation): " + listed(names, chosen));
    json source = file.animations[chosen];
    animation.name = textAt(source, "name");
    const std::string name = "animation " + names[chosen];
    const json samplers = takeObjects(file, source, "samplers", name + ": its");

    // Number of morph targets of a node's mesh; 0 if the node is not in the scene.
    std::map<int, PlacedNode*> placedOf;
    for (PlacedNode& node : placed)
        placedOf[static_cast<int>(node.node - file.model.nodes.data())] = &node;
    const auto targetsOf = [&](int node) {
        const auto found = placedOf.find(node);
        return found == placedOf.end() ? 0 : morphWeightsAtRest(file, *found->second->node).size();
    };
    std::set<std::pair<int, Path>> targets;
    std::vector<bool> isMoved(file.model.nodes.size());
    std::vector<AnimationChannel> channels, weightChannels;
    std::size_t count = 0;
    for (const json& element : takeObjects(file, source, "channels", name + ": its")) {
        const std::string which = name + ", channel " + std::to_string(count++);
        for (AnimationChannel& channel : ChannelLoader(file, samplers, element, which).load(targetsOf)) {
            if (channel.target == 0 && !targets.insert({channel.node, channel.path}).second)
                file.fail(which + " moves the " + textAt(element["target"], "path") + " of node " +
                          std::to_string(channel.node) + ", which another channel moves already");
            const bool weights = channel.path == Path::morphWeight;
            if (!weights) isMoved[channel.node] = true;
            (weights ? weightChannels : channels).push_back(std::move(channel));
        }
    }

    std::vector<int> movingOf(file.model.nodes.size(),
                              -1);  // -1: the node does not move or is not in the scene
    for (PlacedNode& node : placed) {
        const auto inFile = static_cast<std::size_t>(node.node - file.model.nodes.data());
        const PlacedNode* const parent = node.parent < 0 ? nullptr : &placed[node.parent];
        const int movingParent = parent == nullptr ? -1 : parent->moving;
        if (!isMoved[inFile] && movingParent < 0) continue;
        node.moving = movingOf[inFile] = static_cast<int>(animation.nodes.size());
        animation.nodes.push_back(
            {movingParent, parent == nullptr ? glm::dmat4(1.0) : parent->worldFromNode, node.transform});
    }
    for (AnimationChannel& channel : channels) {
        channel.node = movingOf[channel.node];
        if (channel.node < 0) continue;
        animation.durationS = std::max(animation.durationS, static_cast<double>(channel.times.back()));
        animation.channels.push_back(std::move(channel));
    }
    for (AnimationChannel& channel : weightChannels) {
        PlacedNode& node = *placedOf.at(channel.node);
        if (node.morph < 0) {
            node.morph = static_cast<int>(animation.morphWeights.size());
            animation.morphWeights.push_back(morphWeightsAtRest(file, *node.node));
        }
        channel.node = node.morph;
        animation.durationS = std::max(animation.durationS, static_cast<double>(channel.times.back()));
        animation.channels.push_back(std::move(channel));
    }
    return animation;
}

}  // namespace

std::vector<float> morphWeightsAtRest(const GltfFile& file, const tinygltf::Node& node) {
    if (node.mesh < 0) return {};
    const tinygltf::Mesh& mesh = file.at(file.model.meshes, node.mesh, "mesh");
    std::size_t targets = 0;
    for (const tinygltf::Primitive& primitive : mesh.primitives)
        targets = std::max(targets, primitive.targets.size());
    const std::vector<double>& given = node.weights.empty() ? mesh.weights : node.weights;
    std::vector<float> weights(targets);
    for (std::size_t i = 0; i < std::min(targets, given.size()); ++i)
        if (std::abs(given[i]) <= 1e9) weights[i] = static_cast<float>(given[i]);
    return weights;
}

Animation loadAnimation(GltfFile& file, const std::string& nameOrIndex, std::vector<PlacedNode>& placed) {
    const std::size_t chosen = choose(file, nameOrIndex);
    if (file.animations.empty()) return {};
    const std::vector<std::string> names = namesOf(file.animations);
    if (!nameOrIndex.empty()) return load(file, chosen, names, placed);
    try {
        return load(file, chosen, names, placed);
    } catch (const Error& error) {
        file.warn("the animation cannot be played, so nothing moves: " + asClause(error.what()));
        return {};
    }
}

}  // namespace vct
