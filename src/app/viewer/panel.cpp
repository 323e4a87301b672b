#include "app/viewer/panel.h"

#include <fmt/format.h>
#include <imgui.h>

#include <cmath>
#include <cstring>

namespace tarn {

namespace {

/// One widget a field. A slider where both ends are known, else a number to drag.
class PanelVisitor : public FieldVisitor {
public:
    bool changed = false;

    void enter(const char* group, const char* doc) override
    {
        // Two groups may share a name (how water is drawn, what water it is): the text tells them apart.
        const std::string title = fmt::format("{}: {}###{}{}", group, doc, group, doc);
        shown_ = ImGui::CollapsingHeader(title.c_str(), ImGuiTreeNodeFlags_DefaultOpen);
        ImGui::PushID(title.c_str());
    }
    void leave() override
    {
        ImGui::PopID();
        shown_ = true;
    }

    void field(const FieldInfo& info, bool& value) override
    {
        if (shown_) finish(info, ImGui::Checkbox(info.name, &value));
    }

    void field(const FieldInfo& info, int& value) override
    {
        if (!shown_) return;
        if (!bounded(info)) return finish(info, ImGui::DragInt(info.name, &value));
        const auto lower = static_cast<int>(info.lower), upper = static_cast<int>(info.upper);
        finish(info, ImGui::SliderInt(info.name, &value, lower, upper, "%d", sliderFlags(info)));
    }

    void field(const FieldInfo& info, float& value) override
    {
        if (shown_) floats(info, &value, 1);
    }
    void field(const FieldInfo& info, vec2& value) override
    {
        if (shown_) floats(info, &value.x, 2);
    }
    void field(const FieldInfo& info, vec3& value) override
    {
        if (!shown_) return;
        if (std::strcmp(info.name, "colour") != 0) return floats(info, &value.x, 3);
        const vec3 before = value;
        const bool edited = ImGui::ColorEdit3(info.name, &value.x, ImGuiColorEditFlags_Float);
        if (edited && !usable(info, &value.x, 3)) value = before;
        finish(info, edited);
    }

    void choiceIndex(const FieldInfo& info, int& value, std::span<const char* const> names) override
    {
        if (shown_) finish(info, ImGui::Combo(info.name, &value, names.data(), static_cast<int>(names.size())));
    }

private:
    static bool bounded(const FieldInfo& info)
    {
        // A slider over a kilometre has no use: its pixels are metres.
        return std::isfinite(info.lower) && std::isfinite(info.upper) && info.upper - info.lower <= 1e4;
    }

    static ImGuiSliderFlags sliderFlags(const FieldInfo& info)
    {
        const bool wide = info.lower >= 0.0 && info.upper > 50.0 * std::max(info.lower, 0.01);
        return ImGuiSliderFlags_AlwaysClamp | (wide ? ImGuiSliderFlags_Logarithmic : 0);
    }

    static bool usable(const FieldInfo& info, const float* values, int count)
    {
        for (int i = 0; i < count; ++i)
            if (!(std::isfinite(values[i]) && values[i] >= info.lower && values[i] <= info.upper)) return false;
        return true;
    }

    void floats(const FieldInfo& info, float* values, int count)
    {
        float before[3] = {};
        std::copy(values, values + count, before);
        const auto lower = static_cast<float>(info.lower), upper = static_cast<float>(info.upper);
        const bool edited = bounded(info) ? ImGui::SliderScalarN(info.name, ImGuiDataType_Float, values, count, &lower,
                                                                 &upper, "%.4g", sliderFlags(info))
                                          : ImGui::DragScalarN(info.name, ImGuiDataType_Float, values, count, 0.05f,
                                                               nullptr, nullptr, "%.4g");
        // A person can type "nan", and anything beyond the ends.
        if (edited && !usable(info, values, count)) std::copy(before, before + count, values);
        finish(info, edited);
    }

    void finish(const FieldInfo& info, bool edited)
    {
        changed = changed || edited;
        if (!ImGui::IsItemHovered()) return;
        std::string tip = info.doc;
        if (*info.unit) tip += fmt::format(" [{}]", info.unit);
        if (std::isfinite(info.lower) && std::isfinite(info.upper))
            tip += fmt::format(" ({} to {})", info.lower, info.upper);
        ImGui::BeginTooltip();
        ImGui::PushTextWrapPos(ImGui::GetFontSize() * 28.0f);
        ImGui::TextUnformatted(tip.c_str());
        ImGui::PopTextWrapPos();
        ImGui::EndTooltip();
    }

    bool shown_ = true;
};

} // namespace

PanelResult drawPanel(const FieldTree& tree, float scale, bool& open, const std::function<void()>& above)
{
    PanelResult result;
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const float width = std::min(420.0f * scale, 0.9f * screen.x);
    ImGui::SetNextWindowPos({screen.x - width - 10.0f * scale, 10.0f * scale}, ImGuiCond_Appearing);
    ImGui::SetNextWindowSize({width, screen.y - 20.0f * scale}, ImGuiCond_Appearing);
    if (ImGui::Begin("Options", &open)) {
        result.reset = ImGui::Button("As at the start");
        ImGui::SameLine();
        ImGui::TextDisabled("Ctrl+click a slider to type");
        ImGui::PushItemWidth(0.5f * ImGui::GetContentRegionAvail().x);
        if (above) above();
        PanelVisitor visitor;
        tree(visitor);
        ImGui::PopItemWidth();
        result.changed = visitor.changed;
    }
    ImGui::End();
    return result;
}

void drawPlan(const std::string& table)
{
    if (!ImGui::CollapsingHeader("This frame")) return;
    ImGui::PushTextWrapPos(0.0f);
    ImGui::TextUnformatted(table.c_str());
    ImGui::PopTextWrapPos();
}

} // namespace tarn
