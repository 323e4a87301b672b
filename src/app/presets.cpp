#include "app/presets.h"

#include "base/error.h"
#include "base/files.h"

#include <algorithm>

namespace tarn {

namespace fs = std::filesystem;

std::vector<std::string> presetNames()
{
    const std::vector<std::string> order{"fast", "low", "medium", "high", "best"};
    std::vector<std::string> names;
    std::error_code ignored; // no folder: no presets
    for (const fs::directory_entry& entry : fs::directory_iterator(projectRoot() / "assets" / "presets", ignored))
        if (entry.path().extension() == ".toml" && entry.path().stem() != "ladder")
            names.push_back(entry.path().stem().string());
    std::sort(names.begin(), names.end());
    const auto rank = [&](const std::string& name) { return std::find(order.begin(), order.end(), name); };
    std::stable_sort(names.begin(), names.end(),
                     [&](const std::string& a, const std::string& b) { return rank(a) < rank(b); });
    return names;
}

fs::path presetFile(const std::string& name)
{
    const std::vector<std::string> names = presetNames();
    if (std::find(names.begin(), names.end(), name) == names.end()) {
        const std::string near = nearestName(name, names);
        throw UsageError("--preset {}: no such preset{}; there are auto, {}", name,
                         near.empty() ? "" : fmt::format(", did you mean {}?", near), fmt::join(names, ", "));
    }
    return projectRoot() / "assets" / "presets" / (name + ".toml");
}

MachinePreset presetForMachine(const std::string& renderer, bool isSoftware)
{
    if (isSoftware) return {"fast", fmt::format("{} draws on the processor, so the preset is fast", renderer)};
    return {"high",
            fmt::format("{} is a graphics card, so the preset is high, the same as for software: none was measured "
                        "on a card",
                        renderer)};
}

} // namespace tarn
