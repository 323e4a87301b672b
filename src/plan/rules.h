// What a frame may leave out: the rules as a table. plan/reduce.h applies those about passes, the renderer those about
// chunks and about what is kept from the last frame.
#pragma once

#include <array>
#include <cstddef>
#include <string>

namespace tarn {

enum class RuleId {
    cullChunks,
    cullHidden,
    waterOutOfView,
    waterHidden,
    onlySkyMirrored,
    noBed,
    bedTooDeep,
    nothingForCaustics,
    glowOutOfView,
    targetBounds,
    keepMaps,
    keepTargets,
    keepFrame,
};
inline constexpr std::size_t ruleCount = 13;

struct Rule {
    const char* name;      ///< the option plan.NAME that allows it
    const char* leavesOut; ///< a sentence
    const char* bound;     ///< of what it changes in the picture, in words; null: nothing, the rule is exact
    int levels;            ///< the same in 1/255 of the display, at most; an exact rule's is rounding, 1
};

const Rule& rule(RuleId id);

constexpr std::array<bool, ruleCount> allRules()
{
    std::array<bool, ruleCount> rules{};
    rules.fill(true);
    return rules;
}

/// What became of a rule in one frame.
struct RuleState {
    bool applies = false;
    std::string why; ///< or why not, in words
};
using RuleStates = std::array<RuleState, ruleCount>;

} // namespace tarn
