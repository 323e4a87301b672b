#include "app/viewer/comparison.h"

#include "base/error.h"
#include "measure/heat.h"

#include <imgui.h>

#include <cmath>
#include <cstdint>

namespace tarn {

namespace {

/// ImGui's OpenGL backend takes names of textures as pointers.
ImTextureID idOf(const gl::Texture& texture)
{
    return reinterpret_cast<ImTextureID>(static_cast<std::intptr_t>(texture.name()));
}

/// Three channels make a picture, four a map, whose pixels stay what they are: unknown ones have no colour to mix.
gl::Texture textureOf(const char* label, ivec2 size, const std::vector<std::uint8_t>& bytes, int channels)
{
    const gl::Filter filter = channels == 3 ? gl::Filter::linear : gl::Filter::nearest;
    gl::Texture texture({.format = gl::Format::rgba8, .size = size, .filter = filter}, label);
    texture.upload(bytes, channels);
    return texture;
}

/// The part of a texture that lies right of `from` in the window. Rows are as ImGui has them, from the top.
void drawRightOf(float from, const gl::Texture& texture)
{
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    const ScreenRect rect = overlaid(texture.size(), {window.x, window.y});
    const float left = std::max(rect.lower.x, from);
    if (left >= rect.upper.x) return;
    const float u = (left - rect.lower.x) / (rect.upper.x - rect.lower.x);
    ImGui::GetBackgroundDrawList()->AddImage(idOf(texture), {left, rect.lower.y}, {rect.upper.x, rect.upper.y},
                                             {u, 0.0f}, {1.0f, 1.0f});
}

/// The map's colours, with nothing where nothing is known, so that the live picture stays.
std::vector<std::uint8_t> transparentHeat(const Image& map, double scale)
{
    const Image heat = heatPicture(map, 0.0, scale);
    std::vector<std::uint8_t> bytes;
    bytes.reserve(4 * map.floats.size());
    for (std::size_t pixel = 0; pixel < map.floats.size(); ++pixel) {
        for (std::size_t c = 0; c < 3; ++c) bytes.push_back(heat.bytes[3 * pixel + c]);
        bytes.push_back(std::isnan(map.floats[pixel]) ? 0 : 255);
    }
    return bytes;
}

/// The figure that stands for a kind in a line.
std::string figureText(ErrorKind kind, const ErrorFigures& figures)
{
    const auto text = [](const char* name, double value, const char* unit) {
        return std::isnan(value) ? std::string() : fmt::format("{} {:.3g}{}{}", name, value, *unit ? " " : "", unit);
    };
    switch (kind) {
    case ErrorKind::refraction: return text("median", figures.refractionMedian, "m");
    case ErrorKind::reflection: return text("median", figures.reflectionMedian, "deg");
    case ErrorKind::fresnel: return text("mean", figures.fresnelMean, "");
    case ErrorKind::path: return text("median", figures.pathMedian, "m");
    case ErrorKind::caustics: break;
    }
    return "";
}

} // namespace

Comparison::Comparison(reference::Picture truth, const ReferenceView& view) : truth_(std::move(truth)), state_(view) {}

void Comparison::update(LivePicture& picture, const FrameRequest& request, const Settings& settings)
{
    switch (state_.shown()) {
    case ComparisonMode::off: return;
    case ComparisonMode::slider: return updateReference(settings.options.frame);
    case ComparisonMode::errorMap: return updateMap(picture, request, settings);
    }
}

void Comparison::updateReference(const FrameOptions& options)
{
    const std::string key = fmt::format("{} {}", options.exposure, static_cast<int>(options.toneCurve));
    if (key == referenceKey_) return;
    referenceKey_ = key;
    reference_ = textureOf("reference", truth_.size, displayPicture(truth_, options).bytes, 3);
}

void Comparison::updateMap(LivePicture& picture, const FrameRequest& request, const Settings& settings)
{
    takeMeasured();
    if (measuring_.valid()) return;
    if (const std::string key = settingsJson(settings); key != measuredKey_) {
        measuredKey_ = key;
        return measure(picture, request);
    }
    if (mapKind_ == state_.error()) return;
    mapKind_ = state_.error();
    map_ = textureOf("error map", truth_.size,
                     transparentHeat(errorMap(*mapKind_, used_, truth_), infoOf(*mapKind_).scale), 4);
}

void Comparison::measure(LivePicture& picture, const FrameRequest& request)
{
    auto promise = std::make_shared<std::promise<WaterQuantities>>();
    measuring_ = promise->get_future();
    picture.post([promise, request, view = state_.view(), size = truth_.size](FrameSource& source) {
        source.prepare(request);
        promise->set_value(readQuantities(*source.renderer(), view.camera, view.time, size));
    });
}

void Comparison::takeMeasured()
{
    if (!measuring_.valid() || measuring_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return;
    used_ = measuring_.get();
    figures_ = errorFigures(used_, truth_);
    mapKind_.reset();
}

void Comparison::drawOverlay(float scale)
{
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    switch (state_.shown()) {
    case ComparisonMode::off: return;
    case ComparisonMode::slider:
        if (reference_) drawRightOf(state_.slider() * window.x, reference_);
        return drawSlider(scale);
    case ComparisonMode::errorMap:
        if (map_) drawRightOf(0.0f, map_);
        return;
    }
}

void Comparison::drawSlider(float scale)
{
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    const float x = state_.slider() * window.x, reach = 8.0f * scale;
    ImGui::SetNextWindowPos({x - reach, 0.0f}, ImGuiCond_Always);
    ImGui::SetNextWindowSize({2.0f * reach, window.y}, ImGuiCond_Always);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0.0f, 0.0f});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1.0f, 1.0f});
    constexpr ImGuiWindowFlags flags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoBackground |
                                       ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                                       ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoFocusOnAppearing |
                                       ImGuiWindowFlags_NoBringToFrontOnFocus;
    bool grasped = false;
    if (ImGui::Begin("slider", nullptr, flags)) {
        ImGui::InvisibleButton("line", {2.0f * reach, window.y});
        grasped = ImGui::IsItemHovered() || ImGui::IsItemActive();
        if (ImGui::IsItemActive()) state_.setSlider(ImGui::GetIO().MousePos.x / window.x);
        if (grasped) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    }
    ImGui::End();
    ImGui::PopStyleVar(2);
    ImDrawList* list = ImGui::GetBackgroundDrawList();
    const ImU32 colour = grasped ? IM_COL32(255, 220, 120, 255) : IM_COL32(255, 255, 255, 220);
    list->AddLine({x, 0.0f}, {x, window.y}, IM_COL32(0, 0, 0, 160), 4.0f * scale);
    list->AddLine({x, 0.0f}, {x, window.y}, colour, 2.0f * scale);
    list->AddCircleFilled({x, 0.5f * window.y}, 6.0f * scale, colour);
}

void Comparison::drawChoice()
{
    int chosen = static_cast<int>(state_.error());
    const auto name = [](void*, int index, const char** text) {
        *text = errorKinds[static_cast<std::size_t>(index)].name;
        return true;
    };
    if (ImGui::Combo("error shown", &chosen, name, nullptr, static_cast<int>(errorKinds.size())))
        state_.chooseError(static_cast<ErrorKind>(chosen));
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", infoOf(state_.error()).doc);
}

std::string Comparison::note() const
{
    std::string text = state_.note();
    if (state_.shown() != ComparisonMode::errorMap) return text;
    const std::string figure = figureText(state_.error(), figures_);
    return figure.empty() ? text : figure + "   " + text;
}

} // namespace tarn
