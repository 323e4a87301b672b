#include "plan/ladder.h"

#include "base/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace tarn {

namespace {

/// Whole numbers that no program is made for; numbers with fractions never are.
constexpr std::array sizes{"caustics.interval",      "caustics.photons",    "caustics.texture_size",
                           "glow.divisor",           "heights.map_size",    "reflection.interval",
                           "reflection.target_size", "refraction.interval", "refraction.target_size",
                           "sunlight.map_size",      "water.grid_size"};

/// Every option as a number: names of a choice count from 0 in their order. Vectors have none.
class Ranks : public FieldVisitor {
public:
    std::map<std::string, double> of;

    void enter(const char* group, const char* /*doc*/) override { prefix_ += std::string(group) + "."; }
    void leave() override
    {
        prefix_.pop_back();
        const std::size_t dot = prefix_.rfind('.');
        prefix_.resize(dot == std::string::npos ? 0 : dot + 1);
    }
    void field(const FieldInfo& info, bool& value) override { note(info, value ? 1.0 : 0.0); }
    void field(const FieldInfo& info, int& value) override { note(info, value); }
    void field(const FieldInfo& info, float& value) override { note(info, static_cast<double>(value)); }
    void field(const FieldInfo& /*info*/, vec2& /*value*/) override {}
    void field(const FieldInfo& /*info*/, vec3& /*value*/) override {}
    void choiceIndex(const FieldInfo& info, int& value, std::span<const char* const> /*names*/) override
    {
        note(info, value);
    }

private:
    void note(const FieldInfo& info, double value) { of[prefix_ + info.name] = value; }

    std::string prefix_;
};

FieldTree treeOf(Options& options)
{
    return [&options](FieldVisitor& visitor) { visit(visitor, options); };
}

std::map<std::string, double> ranksOf(Options options)
{
    Ranks ranks;
    visit(ranks, options);
    return ranks.of;
}

std::string faultOfRung(const Ladder& ladder, std::size_t i)
{
    const Rung& rung = ladder.rungs[i];
    if (!(rung.cost > 0.0) || !std::isfinite(rung.cost)) return fmt::format("cost {} is no positive number", rung.cost);
    if (!(rung.milliseconds > 0.0) || !std::isfinite(rung.milliseconds))
        return fmt::format("milliseconds {} is no positive number", rung.milliseconds);
    for (const auto& [what, error] : {std::pair{"flip", rung.flip}, std::pair{"wrong_hits", rung.wrongHits}})
        if (!(error >= 0.0 && error <= 1.0)) return fmt::format("{} {} is not between 0 and 1", what, error);
    try {
        for (const auto& [key, value] : rung.settings) {
            if (!ladder.base.contains(key)) return fmt::format("{} has no value in [base]", key);
            if (rankAt(key, value) == rankAt(key, ladder.base.at(key)))
                return fmt::format("{} = {} is the base's value already", key, value);
        }
    } catch (const UsageError& error) {
        return error.what();
    }
    if (i == 0) return rung.settings.empty() ? "" : "the first rung is the base and sets nothing";
    const Rung& above = ladder.rungs[i - 1];
    if (!(rung.cost < above.cost))
        return fmt::format("its cost {} is not below {}, the one before's", rung.cost, above.cost);
    if (rung.flip < above.flip) return fmt::format("its flip {} is below {}, the one before's", rung.flip, above.flip);
    if (rung.wrongHits < above.wrongHits)
        return fmt::format("its wrong_hits {} are below {}, the one before's", rung.wrongHits, above.wrongHits);
    return "";
}

/// A frame that is upscaled needs one program more than one of the picture's size; a larger one another, and from 2 on
/// foliage is drawn otherwise (docs/scale.md).
bool scaleServes(float built, float wanted)
{
    const auto kind = [](float scale) { return scale < 1.0f ? 0 : scale == 1.0f ? 1 : scale < 2.0f ? 2 : 3; };
    return kind(built) == kind(wanted) || (built < 1.0f && wanted == 1.0f);
}

} // namespace

double rankAt(const std::string& key, const std::string& value, const std::string& origin)
{
    Options options;
    assign(treeOf(options), {key, value, origin});
    const auto ranks = ranksOf(options);
    const auto rank = ranks.find(key);
    if (rank == ranks.end()) throw UsageError("{}: {} has no order, so that no rung can set it", origin, key);
    return rank->second;
}

std::string faultOf(const Ladder& ladder)
{
    if (ladder.rungs.empty()) return "it has no rungs";
    for (std::size_t i = 0; i < ladder.rungs.size(); ++i)
        if (const std::string fault = faultOfRung(ladder, i); !fault.empty())
            return fmt::format("rung {}: {}", i + 1, fault);
    return "";
}

Options below(const Options& chosen, const Ladder& ladder, const Rung& rung)
{
    Options options = chosen;
    const auto ranks = ranksOf(chosen);
    for (const auto& [key, value] : rung.settings) {
        const double at = rankAt(key, value);
        const double direction = at - rankAt(key, ladder.base.at(key));
        if ((at - ranks.at(key)) * direction > 0.0) assign(treeOf(options), {key, value, "a ladder"});
    }
    return options;
}

std::vector<OwnRung> rungsBelow(const Options& chosen, const Ladder& ladder)
{
    std::vector<OwnRung> own{{chosen, 0, 1.0}};
    for (std::size_t i = 0; i < ladder.rungs.size(); ++i) {
        const Options options = below(chosen, ladder, ladder.rungs[i]);
        // What two rungs agree on is drawn the same, and the lower one's cost is the nearer to the truth.
        if (options == own.back().options)
            own.back() = {options, i, ladder.rungs[i].cost};
        else
            own.push_back({options, i, ladder.rungs[i].cost});
    }
    return own;
}

bool startsAtBase(const Options& chosen, const Ladder& ladder)
{
    const auto ranks = ranksOf(chosen);
    return std::all_of(ladder.base.begin(), ladder.base.end(),
                       [&](const auto& entry) { return ranks.at(entry.first) == rankAt(entry.first, entry.second); });
}

bool isSizeOnly(std::string_view key)
{
    static const std::set<std::string, std::less<>> keys = [] {
        std::set<std::string, std::less<>> found(sizes.begin(), sizes.end());
        Options options;
        for (const FieldRow& row : listFields(treeOf(options)))
            if (row.type == "float" || row.type == "vec2" || row.type == "vec3") found.insert(row.key);
        return found;
    }();
    return keys.contains(key);
}

bool programsServe(const Options& built, const Options& wanted)
{
    if (!scaleServes(built.frame.scale, wanted.frame.scale)) return false;
    Options x = built, y = wanted;
    const std::vector<FieldRow> rowsX = listFields(treeOf(x)), rowsY = listFields(treeOf(y));
    for (std::size_t i = 0; i < rowsX.size(); ++i)
        if (rowsX[i].value != rowsY[i].value && !isSizeOnly(rowsX[i].key)) return false;
    return true;
}

} // namespace tarn
