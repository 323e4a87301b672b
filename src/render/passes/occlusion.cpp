#include "render/passes/occlusion.h"

#include "gl/state.h"

#include <algorithm>

namespace tarn {

namespace {

/// Rounding may put geometry a little beside its bounds, m.
float roomAbout(const Bounds& box, const vec3& eye)
{
    return 0.01f + 1.0e-4f * std::max(glm::distance(eye, box.lower), glm::distance(eye, box.upper));
}

} // namespace

void OcclusionPass::prepare()
{
    if (!program_) program_ = shaders_.program("occlusion", "passes/occlusion.vert", "passes/occlusion.frag");
}

bool OcclusionPass::canAsk(const Bounds& box, const vec3& eye)
{
    return glm::distance(eye, glm::clamp(eye, box.lower, box.upper)) > 2.0f * roomAbout(box, eye);
}

void OcclusionPass::ask(gl::VisibilityQuery& query, const Bounds& box, const vec3& eye)
{
    prepare();
    gl::apply({.depthTest = gl::DepthTest::lessEqual,
               .depthWrite = false,
               .depthClamp = true,
               .colourWrite = false,
               .depthOffset = vec2(-1.0f, -4.0f)}); // depth has steps, wide ones far away
    program_->use();
    const vec3 room(roomAbout(box, eye));
    program_->set("boxLower", box.lower - room);
    program_->set("boxUpper", box.upper + room);
    gl::VisibilityQuery::Scope asking(query);
    bare_.draw(gl::Primitive::triangles, 0, 36);
}

void HiddenParts::count(std::size_t parts)
{
    if (parts == parts_.size()) return;
    parts_ = std::vector<Part>(parts);
    wereAllHidden_ = false;
}

void HiddenParts::takeAnswers()
{
    bool isAny = false, isAllHidden = true;
    for (Part& part : parts_) {
        if (!part.isNew) continue;
        const std::optional<bool> seen = part.drawn.poll();
        isAny = true;
        isAllHidden = isAllHidden && seen && !*seen;
        if (!seen) continue; // still on its way
        part.wasHidden = !*seen;
        part.isNew = false;
    }
    if (isAny) wereAllHidden_ = isAllHidden;
}

} // namespace tarn
