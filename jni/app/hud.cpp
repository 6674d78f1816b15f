#include "app/hud.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>

#include "app/resolution_scale.h"

namespace vct::app {

namespace {

constexpr float fontPixels = 13.0F;  // height of the built-in font, which is sharp at whole multiples of it
constexpr float panelCharacters = 48.0F, buttonCharacters = 12.0F;

ImVec4 warningColor() {
    return {1.0F, 0.75F, 0.3F, 1.0F};
}

std::string titleOf(const FileChoice& scene) {
    return scene.bundled ? scene.name : scene.name + " (files)";
}

// Draws a list to choose from. Returns the chosen item, or null if the current one was kept.
template <typename Items, typename NameOf>
auto choose(const char* label, const Items& items, const std::string& current, const NameOf& nameOf)
    -> decltype(std::data(items)) {
    decltype(std::data(items)) chosen = nullptr;
    if (!ImGui::BeginCombo(label, current.c_str(), ImGuiComboFlags_HeightLargest)) return chosen;
    for (const auto& item : items) {
        const std::string name = nameOf(item);
        if (ImGui::Selectable(name.c_str(), name == current) && name != current) chosen = &item;
    }
    ImGui::EndCombo();
    return chosen;
}

}  // namespace

Hud::Hud(float pixelsPerDp) : context_(ImGui::CreateContext()) {
    ImGui::SetCurrentContext(context_);
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;  // on a phone the working folder is not writable
    io.ConfigWindowsMoveFromTitleBarOnly = true;
    setScale(pixelsPerDp);
}

void Hud::setPixelsPerDp(float pixelsPerDp) {
    ImGui::SetCurrentContext(context_);
    cancelTouch();
    setScale(pixelsPerDp);
}

void Hud::setScale(float pixelsPerDp) {
    slop_ = 8.0F * pixelsPerDp;
    scale_ = std::max(1.0F, std::round(1.1F * pixelsPerDp));
    ImFontConfig font;
    font.SizePixels = fontPixels * scale_;
    font.OversampleH = 1;
    ImGuiIO& io = ImGui::GetIO();
    io.Fonts->Clear();
    io.Fonts->AddFontDefault(&font);
    io.Fonts->Build();
    ImGuiStyle& style = ImGui::GetStyle();
    style = ImGuiStyle();
    ImGui::StyleColorsDark();
    // A finger is about 40 dp wide.
    style.FramePadding = ImVec2(6.0F, 7.0F);
    style.ItemSpacing = ImVec2(6.0F, 6.0F);
    style.ScrollbarSize = 22.0F;
    style.GrabMinSize = 26.0F;
    style.WindowRounding = 0.0F;
    style.Colors[ImGuiCol_WindowBg].w = 0.72F;
    style.ScaleAllSizes(scale_);
}

Hud::~Hud() {
    ImGui::DestroyContext(context_);
}

namespace {

// The topmost window at a position in the last frame; null: none.
ImGuiWindow* windowAt(const ImGuiContext& context, const glm::vec2& position) {
    const ImVector<ImGuiWindow*>& windows = context.Windows;
    for (int i = windows.Size - 1; i >= 0; --i)
        if (windows[i]->WasActive && !windows[i]->Hidden && !windows[i]->IsFallbackWindow &&
            windows[i]->Rect().Contains(ImVec2(position.x, position.y)))
            return windows[i];
    return nullptr;
}

}  // namespace

bool Hud::covers(const glm::vec2& position) const {
    return windowAt(*context_, position) != nullptr;
}

// Returns the window that a finger at this position would scroll, or null. Its scroll bar is a widget.
ImGuiWindow* Hud::scrollableAt(const glm::vec2& position) const {
    for (ImGuiWindow* window = windowAt(*context_, position); window != nullptr;
         window = window->ParentWindow)
        if (window->ScrollMax.y > 0.0F) return position.x < window->InnerRect.Max.x ? window : nullptr;
    return nullptr;
}

void Hud::touch(const glm::vec2& position, bool down) {
    const glm::vec2 way = glm::abs(position - fingerStart_);
    if (down && finger_ == Finger::up) {
        finger_ = Finger::undecided;
        fingerStart_ = position;
        scrolled_ = scrollableAt(position);
        if (scrolled_ != nullptr) scrollStart_ = scrolled_->Scroll.y;
    } else if (finger_ == Finger::undecided && (!down || std::max(way.x, way.y) >= slop_)) {
        finger_ = down && scrolled_ != nullptr && way.y > way.x ? Finger::scrolls : Finger::presses;
        if (finger_ == Finger::presses) touches_.push_back({fingerStart_, true});
    }
    if (finger_ == Finger::scrolls)
        ImGui::SetScrollY(
            scrolled_, glm::clamp(scrollStart_ + fingerStart_.y - position.y, 0.0F, scrolled_->ScrollMax.y));
    if (finger_ == Finger::presses) touches_.push_back({position, down});
    if (!down) finger_ = Finger::up;
}

void Hud::cancelTouch() {
    // No widget is there, so none is clicked.
    if (finger_ == Finger::presses) touches_.push_back({glm::vec2(-1.0F), false});
    finger_ = Finger::up;
}

void Hud::scroll(const glm::vec2& position, float clicks) {
    wheelAt_ = position;
    wheelClicks_ += clicks;
}

void Hud::beginFrame(glm::ivec2 window, const glm::ivec4& free, double secondsPassed) {
    ImGui::SetCurrentContext(context_);
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = ImVec2(static_cast<float>(window.x), static_cast<float>(window.y));
    io.DeltaTime = static_cast<float>(std::max(secondsPassed, 1e-4));
    // This version of Dear ImGui reads the finger's state once per frame. A tap that began and ended since
    // the last frame is therefore passed on over two frames.
    while (!touches_.empty()) {
        const TouchEvent event = touches_.front();
        touches_.pop_front();
        io.MousePos = ImVec2(event.position.x, event.position.y);
        const bool changed = event.down != touchDown_;
        touchDown_ = event.down;
        if (changed) break;
    }
    io.MouseDown[0] = touchDown_;
    // The wheel scrolls the widget under the cursor, so the cursor's position is set for this frame.
    if (wheelClicks_ != 0.0F && !touchDown_) {
        io.MousePos = ImVec2(wheelAt_.x, wheelAt_.y);
        io.MouseWheel = wheelClicks_;
    }
    wheelClicks_ = 0.0F;
    // Lists that open keep this distance from the window's sides. It is the same for opposite sides.
    const glm::ivec2 covered = glm::max(glm::ivec2(free), window - glm::ivec2(free.z, free.w));
    ImGui::GetStyle().DisplaySafeAreaPadding =
        ImVec2(static_cast<float>(covered.x), static_cast<float>(covered.y));
    ImGui::NewFrame();
}

void Hud::endFrame() {
    ImGui::Render();
    // After the finger is lifted there is no position, otherwise the widget that it touched last would stay
    // highlighted.
    if (!touchDown_ && touches_.empty()) ImGui::GetIO().MousePos = ImVec2(-FLT_MAX, -FLT_MAX);
}

const ImDrawData& Hud::drawData() const {
    ImGui::SetCurrentContext(context_);
    return *ImGui::GetDrawData();
}

// Begins a panel in the upper left corner, as high as its contents but no higher than the screen.
void Hud::beginPanel(const char* name, const glm::ivec4& free, float widest) {
    const ImVec2 room(static_cast<float>(free.z - free.x), static_cast<float>(free.w - free.y));
    const float width = std::min(widest, room.x);
    ImGui::SetNextWindowPos(ImVec2(static_cast<float>(free.x), static_cast<float>(free.y)));
    ImGui::SetNextWindowSizeConstraints(ImVec2(width, 0.0F), ImVec2(width, room.y));
    ImGui::Begin(name, nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoSavedSettings);
}

HudActions Hud::build(const HudContent& content, glm::ivec2 window, const glm::ivec4& free,
                      double secondsPassed) {
    beginFrame(window, free, secondsPassed);
    HudActions actions;
    if (off_) {
        endFrame();
        return actions;
    }
    const float characterWidth = 0.54F * ImGui::GetFontSize();
    const float width = panelCharacters * characterWidth;
    isFolded_ = folded_.value_or(width > 0.25F * static_cast<float>(window.x));
    const bool isButton = isFolded_ && content.status.empty() && content.message.empty();
    beginPanel(isButton ? "button" : "panel", free, isButton ? buttonCharacters * characterWidth : width);
    if (ImGui::Button(isFolded_ ? "Show" : "Hide")) toggle();
    if (!isFolded_) {
        ImGui::SameLine();
        ImGui::AlignTextToFramePadding();
        ImGui::Text("%.1f ms, %.1f frames/s", content.frameMs,
                    content.frameMs > 0.0 ? 1000.0 / content.frameMs : 0.0);
    }
    if (!content.status.empty()) ImGui::TextWrapped("%s", content.status.c_str());
    if (!content.message.empty()) {
        ImGui::PushStyleColor(ImGuiCol_Text, warningColor());
        ImGui::TextWrapped("%s", content.message.c_str());
        ImGui::PopStyleColor();
        actions.dismiss = ImGui::Button("Dismiss");
    }
    if (!isFolded_) {
        buildTimes(content);
        if (!content.measuring) buildChoices(content, actions);
        if (ImGui::Button(content.measuring ? "Stop measuring" : "Measure")) actions.measure = true;
    }
    ImGui::End();
    endFrame();
    return actions;
}

void Hud::buildMessage(const std::string& title, const std::string& text, glm::ivec2 window,
                       const glm::ivec4& free) {
    beginFrame(window, free, 0.1);
    beginPanel("message", free, static_cast<float>(free.z - free.x));
    ImGui::PushStyleColor(ImGuiCol_Text, warningColor());
    ImGui::TextWrapped("%s", title.c_str());
    ImGui::PopStyleColor();
    ImGui::Spacing();
    ImGui::TextWrapped("%s", text.c_str());
    ImGui::End();
    endFrame();
}

void Hud::buildTimes(const HudContent& content) const {
    ImGui::Text("%d x %d pixels", content.renderSize.x, content.renderSize.y);
    if (content.divisor)
        ImGui::TextWrapped(
            "Automatic: 1/%g of the window's sides, for at most %g ms a frame%s (lowest: 1/%g)",
            *content.divisor, ResolutionScale::maxMs, content.isLimitedByHeat ? " and a cooler device" : "",
            ResolutionScale::maxDivisor);
    if (content.stepMs == nullptr) return;
    double total = content.presentMs;
    if (!ImGui::BeginTable("times", 3)) return;
    const auto cell = [](const char* title, double ms) {
        ImGui::TableNextColumn();
        ImGui::TextDisabled("%s", title);
        ImGui::Text("%.2f ms", ms);
    };
    for (int i = 0; i < stepCount; ++i) {
        std::string title = stepName(static_cast<Step>(i));
        std::replace(title.begin(), title.end(), '_', ' ');
        cell(title.c_str(), (*content.stepMs)[i]);
        total += (*content.stepMs)[i];
    }
    cell("present", content.presentMs);
    cell("total", total);
    ImGui::EndTable();
}

void Hud::buildChoices(const HudContent& content, HudActions& actions) const {
    Choices& choices = *content.choices;
    const std::vector<FileChoice>& scenes = *content.scenes;
    ImGui::PushItemWidth(-11.0F * 0.54F * ImGui::GetFontSize());
    const std::string scene = *content.scene >= 0 ? titleOf(scenes[*content.scene]) : "none";
    if (const FileChoice* chosen = choose("scene", scenes, scene, titleOf))
        *content.scene = static_cast<int>(chosen - scenes.data());
    if (ImGui::IsItemClicked()) actions.rescan = true;
    if (content.opensFiles && ImGui::Button("Open a file")) actions.openFile = true;
    if (content.cameras.size() > 1) buildCameras(content, actions);
    if (const std::string* chosen =
            choose("preset", presetNames(), choices.preset, [](const std::string& name) { return name; }))
        choosePreset(choices, *chosen);
    if (const Output* chosen = choose("mode", allModes(), outputName(choices.mode), outputName))
        choices.mode = *chosen;
    buildGrid(content);
    buildCascades(content);
    const std::vector<Resolution>& all = resolutions();
    if (const Resolution* chosen = choose("pixels", all, all[choices.resolution].name,
                                          [](const Resolution& resolution) { return resolution.name; }))
        choices.resolution = static_cast<int>(chosen - all.data());
    ImGui::SliderFloat("sun size", &choices.coneAngleDeg, 1.0F, 30.0F, "%.1f degrees",
                       ImGuiSliderFlags_AlwaysClamp);
    buildLight(content);
    if (!content.lights.empty()) buildLights(content);
    buildSky(content, actions);
    ImGui::PopItemWidth();
    ImGui::Checkbox("time each step", &choices.timeSteps);
    if (content.animated) {
        ImGui::SameLine();
        ImGui::Checkbox("play", &choices.play);
    }
    if (ImGui::Button("Reset view and sun")) {
        actions.resetView = true;
        choices.lightAnglesDeg.reset();
    }
    ImGui::SameLine();
}

// The possible grids depend on the free memory, so they are queried only while the list is open.
void Hud::buildGrid(const HudContent& content) const {
    const auto name = [](int grid) { return std::to_string(grid) + "^3"; };
    int& chosen = content.choices->grid;
    if (!ImGui::BeginCombo("grid", name(chosen).c_str(), ImGuiComboFlags_HeightLargest)) return;
    for (const int grid : content.possibleGrids())
        if (ImGui::Selectable(name(grid).c_str(), grid == chosen)) chosen = grid;
    ImGui::EndCombo();
}

// Only directional voxels have cascades.
void Hud::buildCascades(const HudContent& content) const {
    Choices& choices = *content.choices;
    if (presetSettings(choices.preset).voxels != Voxels::directional) return;
    if (choices.cascades > maxCascadesFor(choices.grid)) choices.cascades.reset();  // another grid was chosen
    const std::string automatic = "automatic: " + std::to_string(content.cascades);
    std::vector<std::optional<int>> all{std::nullopt};
    for (int count = 1; count <= maxCascadesFor(choices.grid); ++count)
        all.emplace_back(count);
    const auto name = [&](const std::optional<int>& count) {
        return count ? std::to_string(*count) : choices.cascades ? "automatic" : automatic;
    };
    if (const std::optional<int>* chosen = choose("cascades", all, name(choices.cascades), name))
        choices.cascades = *chosen;
}

void Hud::buildLight(const HudContent& content) const {
    glm::vec2 angles = content.choices->lightAnglesDeg.value_or(content.sceneLightDeg);
    bool changed = ImGui::SliderFloat("sun from", &angles.x, -180.0F, 180.0F, "%.0f degrees",
                                      ImGuiSliderFlags_AlwaysClamp);
    changed |= ImGui::SliderFloat("sun height", &angles.y, -90.0F, 90.0F, "%.0f degrees",
                                  ImGuiSliderFlags_AlwaysClamp);
    if (changed) content.choices->lightAnglesDeg = angles;
}

void Hud::buildCameras(const HudContent& content, HudActions& actions) const {
    std::vector<int> cameras(content.cameras.size());
    std::iota(cameras.begin(), cameras.end(), 0);
    // The number makes labels unique.
    const auto name = [&](int camera) {
        return std::to_string(camera + 1) + " " + content.cameras[static_cast<std::size_t>(camera)];
    };
    if (const int* chosen = choose("camera", cameras, name(content.camera), name)) actions.camera = *chosen;
}

void Hud::buildSky(const HudContent& content, HudActions& actions) const {
    struct Item {
        Sky sky;
        const FileChoice* picture;
    };
    std::vector<Item> items;
    for (const Sky sky : skies())
        items.push_back({sky, nullptr});
    Choices& choices = *content.choices;
    std::string current = skyName(choices.sky);
    if (content.skies != nullptr)
        for (const FileChoice& picture : *content.skies) {
            items.push_back({Sky::picture, &picture});
            if (choices.sky == Sky::picture && choices.skyPicture == picture.path) current = picture.name;
        }
    const auto name = [](const Item& item) {
        return item.picture != nullptr ? item.picture->name : std::string(skyName(item.sky));
    };
    if (const Item* chosen = choose("sky", items, current, name)) {
        choices.sky = chosen->sky;
        if (chosen->picture != nullptr) choices.skyPicture = chosen->picture->path;
    }
    if (ImGui::IsItemClicked()) actions.rescan = true;
}

void Hud::buildLights(const HudContent& content) const {
    auto& off = content.choices->lightsOff;
    const std::size_t count = std::min(content.lights.size(), off.size());
    std::size_t shining = 0;
    for (std::size_t i = 0; i < count; ++i)
        shining += off.test(i) ? 0 : 1;
    const std::string on = std::to_string(shining) + " of " + std::to_string(count) + " on";
    if (!ImGui::BeginCombo("lights", on.c_str(), ImGuiComboFlags_HeightLargest)) return;
    for (std::size_t i = 0; i < count; ++i) {
        bool isOn = !off.test(i);
        // The number makes labels unique. ImGui would treat two widgets with the same label as one.
        const std::string label = std::to_string(i + 1) + " " + content.lights[i];
        if (ImGui::Checkbox(label.c_str(), &isOn)) off.set(i, !isOn);
    }
    ImGui::EndCombo();
}

}  // namespace vct::app
