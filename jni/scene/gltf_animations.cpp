#include "scene/gltf_animations.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "core/number_text.h"
#include "scene/gltf_accessors.h"

namespace vct {

namespace {

using nlohmann::json;
using Interpolation = AnimationChannel::Interpolation;
using Path = AnimationChannel::Path;

std::string text(const json& object, const char* key) {
    const auto found = object.find(key);
    return found != object.end() && found->is_string() ? found->get<std::string>() : std::string();
}

// -1 where it is missing; what is not an index is one that no array has.
int index(const json& object, const char* key) {
    const auto found = object.find(key);
    if (found == object.end()) return -1;
    const bool small = found->is_number_unsigned() && found->get<std::uint64_t>() <= 0x7FFFFFFF;
    return small ? found->get<int>() : 0x7FFFFFFF;
}

std::vector<json> objects(const GltfFile& file, const json& animation, const char* key,
                          const std::string& name) {
    const auto found = animation.find(key);
    if (found == animation.end()) return {};
    const auto isObject = [](const json& element) { return element.is_object(); };
    if (!found->is_array() || !std::all_of(found->begin(), found->end(), isObject))
        file.fail(name + " has " + key + " that are not a list of objects");
    return {found->begin(), found->end()};
}

std::string named(const std::vector<tinygltf::Animation>& all, std::size_t i) {
    return indexAndName(i, all[i].name);
}

std::size_t choose(const GltfFile& file, const std::string& nameOrIndex) {
    const std::vector<tinygltf::Animation>& all = file.model.animations;
    if (nameOrIndex.empty()) return 0;
    std::string names;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (all[i].name == nameOrIndex) return i;
        names += (i == 0 ? "" : ", ") + named(all, i);
    }
    const bool isNumber = nameOrIndex.size() <= 9 && std::all_of(nameOrIndex.begin(), nameOrIndex.end(),
                                                                 [](char c) { return c >= '0' && c <= '9'; });
    const std::size_t i = isNumber ? std::stoul(nameOrIndex) : all.size();
    if (i < all.size()) return i;
    if (all.empty())
        file.fail("it has no animation, and \"" + oneLine(nameOrIndex) + "\" was asked for",
                  "leave out --animation");
    file.fail("it has no animation \"" + oneLine(nameOrIndex) + "\"", "choose one of " + names);
}

// One channel of one animation, whose every error says which it is.
class ChannelLoader {
  public:
    ChannelLoader(GltfFile& file, const tinygltf::Animation& animation, std::size_t channel,
                  const std::string& name)
        : file_(file), animation_(animation), source_(animation.channels[channel]), name_(name) {}

    // Nothing where the channel moves no node. AnimationChannel::node is the file's.
    std::optional<AnimationChannel> load() {
        AnimationChannel channel;
        if (source_.target_path == "weights") {
            file_.warn("morph targets are ignored: animated weights change nothing");
            return std::nullopt;
        }
        if (!setPath(channel)) return std::nullopt;
        if (source_.target_node == -1) {  // section 3.11: for extensions
            file_.warn("animation channels without a node are ignored");
            return std::nullopt;
        }
        require(static_cast<std::size_t>(source_.target_node) < file_.model.nodes.size(),
                "moves node " + std::to_string(source_.target_node) + " of " +
                    std::to_string(file_.model.nodes.size()));
        require(
            source_.sampler >= 0 && static_cast<std::size_t>(source_.sampler) < animation_.samplers.size(),
            source_.sampler < 0 ? std::string("has no sampler")
                                : "refers to sampler " + std::to_string(source_.sampler) + " of " +
                                      std::to_string(animation_.samplers.size()));
        require(file_.model.nodes[static_cast<std::size_t>(source_.target_node)].matrix.empty(),
                "moves a node that has a matrix; only translation, rotation and scale can be animated");
        channel.node = source_.target_node;
        const tinygltf::AnimationSampler& sampler =
            animation_.samplers[static_cast<std::size_t>(source_.sampler)];
        setInterpolation(sampler, channel);
        setTimes(sampler, channel);
        setValues(sampler, channel);
        return channel;
    }

  private:
    void require(bool ok, const std::string& cause, const std::string& remedy = reexportRemedy) const {
        if (!ok) file_.fail(name_ + " " + cause, remedy);
    }

    bool setPath(AnimationChannel& channel) {
        const std::string& path = source_.target_path;
        if (path == "translation")
            channel.path = Path::translation;
        else if (path == "rotation")
            channel.path = Path::rotation;
        else if (path == "scale")
            channel.path = Path::scale;
        else {
            file_.warn("animation channels of the path \"" + oneLine(path) + "\" are ignored");
            return false;
        }
        return true;
    }

    void setInterpolation(const tinygltf::AnimationSampler& sampler, AnimationChannel& channel) const {
        const std::string& name = sampler.interpolation;
        require(name == "STEP" || name == "LINEAR" || name == "CUBICSPLINE",
                "has the unknown interpolation \"" + oneLine(name) + "\"");
        channel.interpolation = name == "STEP"     ? Interpolation::step
                                : name == "LINEAR" ? Interpolation::linear
                                                   : Interpolation::cubicSpline;
    }

    int accessor(int i, const char* what) const {
        const std::size_t count = file_.model.accessors.size();
        require(i >= 0 && static_cast<std::size_t>(i) < count,
                i < 0 ? std::string("has a sampler without ") + what
                      : std::string("has a sampler whose ") + what + " is accessor " + std::to_string(i) +
                            " of " + std::to_string(count));
        return i;
    }

    void setTimes(const tinygltf::AnimationSampler& sampler, AnimationChannel& channel) const {
        channel.times = readFloats(file_, accessor(sampler.input, "input"), 1, Components::floatOnly,
                                   name_ + ", key times");
        const std::vector<float>& times = channel.times;
        require(!times.empty(), "has no keys");
        for (std::size_t key = 0; key < times.size(); ++key) {
            const std::string which = "key " + std::to_string(key);
            require(std::isfinite(times[key]) && times[key] >= 0.0F,
                    "has the time " + numberText(times[key]) + " for " + which +
                        ", which is negative or not a number");
            require(key == 0 || times[key] > times[key - 1],
                    "has unsorted keys: " + which + " at " + numberText(times[key]) +
                        " s does not come after " + numberText(times[key == 0 ? 0 : key - 1]) + " s",
                    "sort its keys by time, each time once");
        }
    }

    void setValues(const tinygltf::AnimationSampler& sampler, AnimationChannel& channel) const {
        const bool rotation = channel.path == Path::rotation;
        const int width = rotation ? 4 : 3;
        const std::vector<float> values =
            readFloats(file_, accessor(sampler.output, "output"), width,
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
            // A spline's tangents are of the values as they stand; its result is made a unit quaternion.
            if (!cubic) channel.values[i] /= length;
        }
    }

    GltfFile& file_;
    const tinygltf::Animation& animation_;
    const tinygltf::AnimationChannel& source_;
    std::string name_;
};

void warnOfOthers(GltfFile& file, std::size_t played) {
    const std::vector<tinygltf::Animation>& all = file.model.animations;
    std::string others;
    for (std::size_t i = 0; i < all.size(); ++i)
        if (i != played) others += (others.empty() ? "" : ", ") + named(all, i);
    if (!others.empty())
        file.warn("animation " + named(all, played) + " is played; not played (--animation): " + others);
}

}  // namespace

void readAnimations(GltfFile& file, const json& animations) {
    for (const json& source : animations) {
        const std::string name = "animation " + std::to_string(file.model.animations.size());
        tinygltf::Animation animation;
        animation.name = text(source, "name");
        for (const json& element : objects(file, source, "samplers", name)) {
            tinygltf::AnimationSampler sampler;
            sampler.input = index(element, "input");
            sampler.output = index(element, "output");
            sampler.interpolation =
                element.contains("interpolation") ? text(element, "interpolation") : "LINEAR";
            animation.samplers.push_back(std::move(sampler));
        }
        for (const json& element : objects(file, source, "channels", name)) {
            tinygltf::AnimationChannel channel;
            channel.sampler = index(element, "sampler");
            const auto target = element.find("target");
            if (target == element.end() || !target->is_object())
                file.fail(name + ", channel " + std::to_string(animation.channels.size()) + " has no target");
            channel.target_node = index(*target, "node");
            channel.target_path = text(*target, "path");
            animation.channels.push_back(std::move(channel));
        }
        file.model.animations.push_back(std::move(animation));
    }
}

Animation loadAnimation(GltfFile& file, const std::string& nameOrIndex, std::vector<PlacedNode>& placed) {
    const std::size_t chosen = choose(file, nameOrIndex);
    Animation animation;
    if (file.model.animations.empty()) return animation;
    warnOfOthers(file, chosen);
    const tinygltf::Animation& source = file.model.animations[chosen];
    animation.name = source.name;

    std::set<std::pair<int, Path>> targets;
    std::vector<bool> isMoved(file.model.nodes.size());
    std::vector<AnimationChannel> channels;
    for (std::size_t i = 0; i < source.channels.size(); ++i) {
        const std::string name =
            "animation " + named(file.model.animations, chosen) + ", channel " + std::to_string(i);
        std::optional<AnimationChannel> channel = ChannelLoader(file, source, i, name).load();
        if (!channel) continue;
        if (!targets.insert({channel->node, channel->path}).second)
            file.fail(name + " moves the " + source.channels[i].target_path + " of node " +
                      std::to_string(channel->node) + ", which another channel moves already");
        isMoved[static_cast<std::size_t>(channel->node)] = true;
        channels.push_back(std::move(*channel));
    }

    std::vector<int> movingOf(file.model.nodes.size(), -1);  // stays -1 outside the scene
    for (PlacedNode& node : placed) {
        const auto inFile = static_cast<std::size_t>(node.node - file.model.nodes.data());
        const PlacedNode* const parent =
            node.parent < 0 ? nullptr : &placed[static_cast<std::size_t>(node.parent)];
        const int movingParent = parent == nullptr ? -1 : parent->moving;
        if (!isMoved[inFile] && movingParent < 0) continue;
        node.moving = movingOf[inFile] = static_cast<int>(animation.nodes.size());
        animation.nodes.push_back(
            {movingParent, parent == nullptr ? glm::dmat4(1.0) : parent->worldFromNode, node.transform});
    }
    for (AnimationChannel& channel : channels) {
        channel.node = movingOf[static_cast<std::size_t>(channel.node)];
        if (channel.node < 0) continue;
        animation.durationS = std::max(animation.durationS, static_cast<double>(channel.times.back()));
        animation.channels.push_back(std::move(channel));
    }
    return animation;
}

}  // namespace vct
