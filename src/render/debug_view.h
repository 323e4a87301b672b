// The intermediate pictures of a frame that can be shown in place of the final one: shaders/shared/debug_views.glsl as
// C++.
#pragma once

#include <array>
#include <optional>
#include <string_view>

namespace tarn {

/// What each shows stands in the table.
enum class DebugView {
#define DEBUG_VIEW_ROW(view, code, name, writer, display, unit, doc) view = code,
#include "shared/debug_views.glsl"
#undef DEBUG_VIEW_ROW
};

/// The passes that write a view's values.
enum class DebugWriter { all, scene, water, sceneAndWater, refraction, reflection, caustics };

struct DebugViewInfo {
    DebugView view;
    const char* name; ///< as on the command line
    DebugWriter writer;
    int display; ///< DISPLAY of present.frag
    const char* unit;
    const char* doc;
};

/// In the order of the enumeration.
inline constexpr std::array debugViews{
#define DEBUG_VIEW_ROW(view, code, name, writer, display, unit, doc)                                                   \
    DebugViewInfo{DebugView::view, #name, DebugWriter::writer, display, #unit, #doc},
#include "shared/debug_views.glsl"
#undef DEBUG_VIEW_ROW
};
inline constexpr int debugViewCount = static_cast<int>(debugViews.size());

constexpr const DebugViewInfo& infoOf(DebugView view) { return debugViews[static_cast<std::size_t>(view)]; }

static_assert(
    [] {
        for (std::size_t i = 0; i < debugViews.size(); ++i)
            if (debugViews[i].view != static_cast<DebugView>(i)) return false;
        return true;
    }(),
    "the rows of debug_views.glsl are not in the order of their codes");

/// "final", "scene-depth", …, in the order of the enumeration.
inline constexpr auto debugViewNames = [] {
    std::array<const char*, debugViews.size()> names{};
    for (std::size_t i = 0; i < names.size(); ++i) names[i] = debugViews[i].name;
    return names;
}();

inline std::optional<DebugView> debugViewFromName(std::string_view name)
{
    for (const DebugViewInfo& info : debugViews)
        if (info.name == name) return info.view;
    return std::nullopt;
}

/// The scene around the water stays empty in these.
constexpr bool isWaterView(DebugView view) { return infoOf(view).writer == DebugWriter::water; }

/// What the water's program is to write: the picture, where another pass writes the view.
constexpr DebugView writtenByWater(DebugView view)
{
    const DebugWriter writer = infoOf(view).writer;
    return writer == DebugWriter::water || writer == DebugWriter::sceneAndWater ? view : DebugView::final;
}

/// "scene, water": the names of the passes, as profiler and `tarn explain` have them.
constexpr const char* passesOf(DebugWriter writer)
{
    switch (writer) {
    case DebugWriter::all: return "all";
    case DebugWriter::scene: return "scene";
    case DebugWriter::water: return "water";
    case DebugWriter::sceneAndWater: return "scene, water";
    case DebugWriter::refraction: return "refraction";
    case DebugWriter::reflection: return "reflection";
    case DebugWriter::caustics: return "caustics";
    }
    return "";
}

} // namespace tarn
