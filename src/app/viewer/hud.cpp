#include "app/viewer/hud.h"

#include "app/viewer/input_map.h"

#include <fmt/format.h>
#include <imgui.h>

namespace tarn {

namespace {

constexpr ImGuiWindowFlags overlayFlags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_AlwaysAutoResize |
                                          ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing |
                                          ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoMove;
constexpr ImGuiWindowFlags passiveFlags = overlayFlags | ImGuiWindowFlags_NoInputs;
const ImVec4 errorColour{1.0f, 0.45f, 0.4f, 1.0f};

void text(const std::string& line) { ImGui::TextUnformatted(line.c_str()); }

/// As wide as the figures are anyway.
void drawWrapped(const std::string& words)
{
    ImGui::PushTextWrapPos(ImGui::GetFontSize() * 22.0f);
    text(words);
    ImGui::PopTextWrapPos();
}

void drawFigures(const HudState& state)
{
    text(fmt::format("{:.1f} fps   {:.1f} ms", state.rate.framesPerSecond(), state.rate.frameMilliseconds()));
    if (!state.governor.empty()) drawWrapped(state.governor);
    for (const ShownTime& pass : state.rate.passes())
        text(fmt::format("  {:<12}{:7.2f} ms", pass.name, pass.milliseconds));
    text(fmt::format("{} triangles", state.triangles));
    const vec3 eye = state.camera.camera().eye;
    text(fmt::format("eye {:.1f}, {:.1f}, {:.1f}{}   {:.1f} m/s", eye.x, eye.y, eye.z,
                     state.underwater ? " (under water)" : "", state.camera.speed()));
    text(fmt::format("t = {:.2f} s{}", state.time, state.paused ? " (paused)" : ""));
    if (state.view != "final") text("view: " + state.view);
    if (!state.stereo.empty()) text(state.stereo);
    if (!state.comparison.empty()) text(state.comparison);
    if (!state.building.empty()) text(state.building);
    text("H: help");
}

/// A line of words near the lower edge, wrapped to the window.
void drawNote(const char* id, const std::string& words, float above, const ImVec4& colour)
{
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({0.5f * screen.x, screen.y - above}, ImGuiCond_Always, {0.5f, 1.0f});
    ImGui::SetNextWindowSizeConstraints({0.0f, 0.0f}, {0.9f * screen.x, screen.y});
    if (ImGui::Begin(id, nullptr, passiveFlags)) {
        ImGui::PushTextWrapPos(0.85f * screen.x);
        ImGui::PushStyleColor(ImGuiCol_Text, colour);
        text(words);
        ImGui::PopStyleColor();
        ImGui::PopTextWrapPos();
    }
    ImGui::End();
}

} // namespace

void drawHud(const HudState& state, float scale)
{
    ImGui::SetNextWindowPos({10.0f * scale, 10.0f * scale}, ImGuiCond_Always);
    ImGui::SetNextWindowBgAlpha(0.6f);
    if (ImGui::Begin("figures", nullptr, passiveFlags)) drawFigures(state);
    ImGui::End();
    if (!state.message.empty()) drawNote("message", state.message, 20.0f * scale, {1.0f, 1.0f, 1.0f, 1.0f});
    if (!state.shaderError.empty()) drawNote("shader", state.shaderError, 60.0f * scale, errorColour);
}

void drawHelp(float scale, bool& open)
{
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({0.5f * screen.x, 0.5f * screen.y}, ImGuiCond_Appearing, {0.5f, 0.5f});
    if (ImGui::Begin("Keys", &open, ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoCollapse)) {
        for (const HelpLine& line : helpLines()) {
            text(line.keys);
            ImGui::SameLine(110.0f * scale);
            text(line.what);
        }
    }
    ImGui::End();
}

void drawLoading(const SharedProgress::State& state, float scale)
{
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const float width = std::min(420.0f * scale, 0.9f * screen.x);
    ImGui::SetNextWindowPos({0.5f * screen.x, 0.5f * screen.y}, ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowSize({width, 0.0f}, ImGuiCond_Always);
    if (ImGui::Begin("loading", nullptr, passiveFlags & ~ImGuiWindowFlags_AlwaysAutoResize)) {
        ImGui::ProgressBar(static_cast<float>(state.fraction), {-1.0f, 0.0f});
        const std::string left = state.secondsLeft >= 0.0 ? fmt::format("{:.0f} s left  ", state.secondsLeft) : "";
        // Of a path only the name: folders would fill the line and hide it.
        text(left + state.what.substr(state.what.rfind('/') + 1));
    }
    ImGui::End();
}

std::string titleText(const HudState& state)
{
    std::string title = fmt::format("Tarn - {}{} - {:.0f} fps, {:.1f} ms", state.scene, state.draft ? " (draft)" : "",
                                    state.rate.framesPerSecond(), state.rate.frameMilliseconds());
    const char* separator = " - ";
    for (const ShownTime& pass : state.rate.passes()) {
        title += fmt::format("{}{} {:.1f}", separator, pass.name, pass.milliseconds);
        separator = ", ";
    }
    return title;
}

} // namespace tarn
