#include "image/lossless.h"

#include "app/session.h"
#include "plan/rules.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>

namespace tarn::imagetest {

namespace {

/// Small targets and maps: what is left out does not depend on their sizes. A case's own options win.
const std::vector<std::string> smallTargets{
    "sunlight.map_size=512", "refraction.target_size=192", "reflection.target_size=192",
    "caustics.photons=128",  "caustics.texture_size=128",  "heights.map_size=256",
    "detail.pixels=0"}; // which plan.exact would refuse

ivec2 smallSize(ivec2 size) { return glm::max(size * 2 / 5, ivec2(16)); }

/// Draws one case with any plan.
class CaseFrames {
public:
    CaseFrames(const Case& test, const Scene& scene, Renderer& renderer)
        : test_(test), scene_(scene), renderer_(renderer), camera_(chooseCamera(scene, test.camera))
    {}

    Image draw(const std::vector<std::string>& plan)
    {
        std::vector<std::string> assignments = smallTargets;
        assignments.insert(assignments.end(), test_.settings.begin(), test_.settings.end());
        assignments.insert(assignments.end(), plan.begin(), plan.end());
        const Settings settings = resolveSettings(scene_, {{}, assignments});
        renderer_.setOptions(settings.options, settings.water);
        rules_ = renderer_.render({camera_, test_.time, smallSize(test_.size), test_.view}).plan.rules;
        return renderer_.readDisplay();
    }

    const RuleStates& rules() const { return rules_; } ///< of the last frame

private:
    const Case& test_;
    const Scene& scene_;
    Renderer& renderer_;
    const Camera camera_;
    RuleStates rules_;
};

int largestDifference(const Image& a, const Image& b)
{
    if (a.bytes.size() != b.bytes.size()) return 255;
    int most = 0;
    for (std::size_t i = 0; i < a.bytes.size(); ++i) most = std::max(most, std::abs(int(a.bytes[i]) - int(b.bytes[i])));
    return most;
}

int allowedLevels(const RuleStates& rules)
{
    int levels = 1;
    for (std::size_t i = 0; i < ruleCount; ++i)
        if (rules[i].applies) levels = std::max(levels, rule(static_cast<RuleId>(i)).levels);
    return levels;
}

bool allowsChange(const RuleStates& rules)
{
    for (std::size_t i = 0; i < ruleCount; ++i)
        if (rules[i].applies && rule(static_cast<RuleId>(i)).bound) return true;
    return false;
}

std::string namesOf(const RuleStates& rules)
{
    std::string names;
    for (std::size_t i = 0; i < ruleCount; ++i)
        if (rules[i].applies) names += std::string(" ") + rule(static_cast<RuleId>(i)).name;
    return names;
}

bool isLossless(const Case& test, const Scene& scene, Renderer& renderer)
{
    CaseFrames frames(test, scene, renderer);
    bool isGood = true;
    const auto compare = [&](const char* what, const Image& picture, const Image& full, int allowed,
                             const RuleStates& rules) {
        const int most = largestDifference(picture, full);
        if (most > 0) fmt::print("{}, {}: up to {}/255; applied:{}\n", test.name, what, most, namesOf(rules));
        if (most > allowed) isGood = false;
    };
    const Image planned = frames.draw({}); // with what the case before left to be kept
    const RuleStates rules = frames.rules();
    const Image again = frames.draw({"plan.keep_frame=false"}); // with what this very view hides and keeps
    const RuleStates rulesAgain = frames.rules();
    const bool isApproximate = allowsChange(rules) || allowsChange(rulesAgain);
    const Image exact = isApproximate ? frames.draw({"plan.exact=true"}) : Image{};
    const RuleStates rulesExact = frames.rules();
    const Image full = frames.draw({"plan.enabled=false"});
    compare("planned", planned, full, allowedLevels(rules), rules);
    compare("once more", again, full, std::max(allowedLevels(rules), allowedLevels(rulesAgain)), rulesAgain);
    if (isApproximate) compare("exact", exact, full, 1, rulesExact);
    return isGood;
}

} // namespace

int checkLossless(const Group& group)
{
    const SceneSetup sceneSetup = loadSceneSetup({group.scene, {}, {}}, nullptr);
    Session session(sceneSetup, {320, 240}, nullptr);
    int failures = 0;
    for (const Case& test : group.cases) {
        if (isLossless(test, sceneSetup.scene, session.renderer())) continue;
        fmt::print("{}: the plan loses more than its rules allow\n", test.name);
        ++failures;
    }
    fmt::print("{}: {} cases planned and in full, {} differ\n", group.name, group.cases.size(), failures);
    return failures;
}

} // namespace tarn::imagetest
