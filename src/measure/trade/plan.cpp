#include "measure/trade/plan.h"

#include "base/error.h"
#include "base/hash.h"
#include "measure/trade/ladder.h"

namespace tarn {

namespace {

constexpr std::size_t mostGridPoints = 10000;

/// Names the files of a point's results, which later versions must still find.
std::string idOf(const Changes& changes)
{
    std::string text;
    for (const auto& [key, value] : changes) text += key + "=" + value + "\n";
    return fmt::format("{:012x}", fnv1a(text) & 0xffffffffffffu);
}

std::string labelOf(const Changes& changes)
{
    std::string label;
    for (const auto& [key, value] : changes) label += fmt::format("{}{}={}", label.empty() ? "" : ", ", key, value);
    return label.empty() ? "base" : label;
}

void planSweeps(TradePlan& plan, const std::vector<Sweep>& sweeps, const DescribeSettings& describe)
{
    for (const Sweep& sweep : sweeps) {
        TradePlan::SweptPoints swept{sweep, {}};
        for (const std::string& value : sweep.values)
            swept.points.push_back(addPoint(plan.points, makePoint(sweep.changes(value), "", "sweep", describe)));
        plan.sweeps.push_back(std::move(swept));
    }
}

void planGrid(TradePlan& plan, const std::vector<Sweep>& sweeps, const DescribeSettings& describe)
{
    std::size_t count = 1;
    for (const Sweep& sweep : sweeps) {
        count *= sweep.values.size();
        if (count > mostGridPoints)
            throw UsageError("--grid: more than {} combinations; sweep fewer values", mostGridPoints);
    }
    for (std::size_t i = 0; i < count; ++i) {
        Changes changes;
        std::size_t rest = i;
        for (const Sweep& sweep : sweeps) {
            for (const auto& [key, value] : sweep.changes(sweep.values[rest % sweep.values.size()]))
                changes[key] = value;
            rest /= sweep.values.size();
        }
        addPoint(plan.points, makePoint(changes, "", "grid", describe));
    }
}

} // namespace

TradePoint makePoint(const Changes& changes, std::string label, std::string origin, const DescribeSettings& describe)
{
    const std::vector<FieldRow> before = describe({}, origin);
    const std::vector<FieldRow> after = describe(changes, origin);
    TradePoint point;
    for (std::size_t i = 0; i < after.size(); ++i)
        if (after[i].value != before[i].value) point.changes[after[i].key] = after[i].value;
    point.id = idOf(point.changes);
    point.label = label.empty() ? labelOf(point.changes) : std::move(label);
    point.origin = std::move(origin);
    return point;
}

std::size_t addPoint(std::vector<TradePoint>& points, TradePoint point)
{
    for (std::size_t i = 0; i < points.size(); ++i)
        if (points[i].id == point.id) return i;
    points.push_back(std::move(point));
    return points.size() - 1;
}

std::vector<std::string> defaultSweeps()
{
    return {"refraction.steps=2,4,8",
            "refraction.target_size=128:1024:*2",
            "refraction.camera=main,snell,flat",
            "refraction.method=planar,iterative,raycast,combined",
            "reflection.target_size=128:1024:*2",
            "reflection.method=distance,iterative,raycast,combined",
            "heights.march=classic,pyramid@refraction.method=raycast",
            "heights.march=classic,pyramid@reflection.method=raycast",
            "reflection.facets=one,three,five",
            "water.fresnel=schlick,table,exact",
            "water.grid=uniform,focused",
            "water.grid_size=17,49,97",
            "water.surface_steps=0,1,3",
            "water.normals=vertex,pixel",
            "water.filter_waves=false,true",
            "caustics.method=points,fetch,mesh",
            "caustics.texture_size=128:1024:*2",
            "caustics.photons=128:512:*2",
            "caustics.filter=1,2",
            "sunlight.map_size=1024:4096:*2",
            "sunlight.taps=1,2",
            "sunlight.cascades=1,3",
            "frame.antialiasing=none,fxaa,msaa",
            "frame.scale=0.5,0.67,1,2",
            "frame.upscaler=bilinear,edge@frame.scale=0.67"};
}

TradePlan planTrade(const PlanRequest& request, const DescribeSettings& describe)
{
    const bool isDefault = request.sweeps.empty();
    std::vector<Sweep> sweeps;
    if (request.ladder)
        sweeps = cheaperSweeps(describe);
    else if (!request.presetsOnly)
        sweeps = parseSweeps(isDefault ? defaultSweeps() : request.sweeps, describe);
    if (request.grid && isDefault) throw UsageError("--grid needs at least one --sweep KEY=VALUES");
    if (request.presetsOnly && !isDefault) throw UsageError("--presets-only sweeps nothing; leave --sweep away");
    TradePlan plan;
    plan.points.push_back(makePoint({}, "base", "base", describe));
    if (request.grid) {
        planGrid(plan, sweeps, describe);
    } else {
        planSweeps(plan, sweeps, describe);
    }
    for (const Preset& preset : request.presets)
        plan.presets.emplace_back(preset.name,
                                  addPoint(plan.points, makePoint(preset.changes, preset.name, "preset", describe)));
    plan.isGreedy = isDefault && !request.presetsOnly;
    plan.ladder = request.ladder;
    return plan;
}

} // namespace tarn
