#include "render/passes/caustics.h"

#include "gl/state.h"
#include "optics/optics.h"
#include "render/unrolled.h"

#include <cmath>
#include <span>
#include <string>

namespace tarn {

using Method = CausticsOptions::Method;

const gl::Target& CausticsPass::draw(const CausticsOptions& options, const Inputs& inputs, FrameReport::Pass& stats)
{
    castPhotons(options, inputs);
    // Sums need all of a float's digits, and more range than half floats have: any number of photons may meet.
    // Triangles of the mesh are about as small as texels: several samples find their areas.
    constexpr int meshSamples = 4;
    gathered_.ensure({.size = ivec2(options.textureSize),
                      .colours = {gl::Format::rgba32f},
                      .samples = options.method == Method::mesh ? meshSamples : 1});
    gl::apply({});
    gathered_.drawFramebuffer().clearColour(vec4(0.0f));
    switch (options.method) {
    case Method::cpu: gatherOnProcessor(options, inputs.absorption); break;
    case Method::points:
    case Method::fetch: gatherPoints(options, stats); break;
    case Method::mesh: gatherMesh(options, stats); break;
    }
    gathered_.resolve();
    filter(options);
    return filtered_;
}

gl::Program& CausticsPass::photonProgram(const CausticsOptions& options, const Inputs& inputs)
{
    constexpr int mostWrittenOut = 8;
    const int waves = static_cast<int>(inputs.waveWeights.size());
    gl::Defines defines{{"WAVE_COUNT", std::to_string(waves)},
                        eachWave(waves),
                        unrolled("EACH_STEP", "STEP", options.steps - 1, mostWrittenOut)};
    if (options.steps == 1) defines.emplace_back("PLANAR", "1");
    if (inputs.surfaceMovesSideways) defines.emplace_back("SURFACE_MOVES_SIDEWAYS", "1");
    if (inputs.shadows) defines.emplace_back("SHADOWS", "1");
    auto& program = photonPrograms_[defines];
    if (!program)
        program =
            shaders_.program("caustics photons", "passes/fullscreen.vert", "passes/caustics_photons.frag", defines);
    return *program;
}

void CausticsPass::castPhotons(const CausticsOptions& options, const Inputs& inputs)
{
    gl::Program& program = photonProgram(options, inputs);
    photons_.ensure({.size = ivec2(options.photons), .colours = {gl::Format::rgba32f}, .filter = gl::Filter::nearest});
    gl::apply({.depthTest = gl::DepthTest::off, .depthWrite = false});
    photons_.bind();
    program.use();
    program.texture("sunDepth", inputs.sunDepth);
    if (!inputs.waveWeights.empty()) program.setArray("waveWeights", std::span<const float>(inputs.waveWeights));
    triangle_.draw();
}

std::vector<float> gatherPhotons(const std::vector<float>& photons, int resolution, const vec3& absorption)
{
    std::vector<float> sums(static_cast<std::size_t>(resolution) * static_cast<std::size_t>(resolution) * 4, 0.0f);
    for (std::size_t i = 0; i + 3 < photons.size(); i += 4) {
        if (photons[i + 2] <= 0.0f) continue;
        // Texel k's centre is k + 1/2. A photon whose place is outside has left the texture, whole.
        const vec2 position = vec2(photons[i], photons[i + 1]) * static_cast<float>(resolution);
        if (!(position.x >= 0.0f && position.y >= 0.0f && position.x <= static_cast<float>(resolution) &&
              position.y <= static_cast<float>(resolution)))
            continue;
        const vec3 light = optics::photonLight(photons[i + 2], photons[i + 3], absorption);
        const ivec2 corner(static_cast<int>(std::floor(position.x - 0.5f)),
                           static_cast<int>(std::floor(position.y - 0.5f)));
        for (int y = corner.y; y <= corner.y + 1; ++y) {
            for (int x = corner.x; x <= corner.x + 1; ++x) {
                if (x < 0 || y < 0 || x >= resolution || y >= resolution) continue;
                const vec2 centre(static_cast<float>(x) + 0.5f, static_cast<float>(y) + 0.5f);
                const float weight = optics::photonWeight(centre - position);
                const auto texel = static_cast<std::size_t>(y * resolution + x) * 4;
                for (int c = 0; c < 3; ++c) sums[texel + static_cast<std::size_t>(c)] += weight * light[c];
            }
        }
    }
    return sums;
}

void CausticsPass::gatherOnProcessor(const CausticsOptions& options, const vec3& absorption)
{
    const std::vector<float> sums = gatherPhotons(photons_.framebuffer().readFloats(), options.textureSize, absorption);
    gathered_.colour().upload(std::span<const float>(sums), 4);
}

gl::Program& CausticsPass::gatherProgram(Method method)
{
    auto& program = gatherPrograms_[method];
    if (!program) {
        gl::Defines defines;
        if (method == Method::fetch) defines.emplace_back("FETCH", "1");
        if (method == Method::mesh) defines.emplace_back("MESH", "1");
        program =
            shaders_.program("caustics gather", "passes/caustics_gather.vert", "passes/caustics_gather.frag", defines);
    }
    return *program;
}

void CausticsPass::gatherPoints(const CausticsOptions& options, FrameReport::Pass& stats)
{
    const int count = options.photons * options.photons;
    gl::Program& program = gatherProgram(options.method);
    const bool copies = options.method == Method::points;
    if (copies) {
        if (photonBuffer_.size() == 0) photonBuffer_ = gl::Buffer("photons", gl::Buffer::Usage::dynamic);
        photons_.framebuffer().copyFloatsTo(photonBuffer_);
        photonPoints_ = gl::VertexArray("photons");
        photonPoints_.attributes(photonBuffer_, 4 * sizeof(float), {{0, 4, 0}});
    } else if (bare_.label().empty()) {
        bare_ = gl::VertexArray("fetched photons");
    }
    gl::apply({.depthTest = gl::DepthTest::off, .depthWrite = false, .blend = gl::Blend::add, .shaderPointSize = true});
    gathered_.bind();
    program.use();
    program.set("textureResolution", static_cast<float>(options.textureSize));
    if (!copies) {
        program.texture("photons", photons_.colour());
        program.set("photonsPerSide", options.photons);
    }
    (copies ? photonPoints_ : bare_).draw(gl::Primitive::points, 0, count);
    ++stats.drawCalls;
}

void CausticsPass::gatherMesh(const CausticsOptions& options, FrameReport::Pass& stats)
{
    gl::Program& program = gatherProgram(Method::mesh);
    if (bare_.label().empty()) bare_ = gl::VertexArray("fetched photons");
    gl::apply({.depthTest = gl::DepthTest::off, .depthWrite = false, .blend = gl::Blend::add});
    gathered_.bind();
    program.use();
    program.texture("photons", photons_.colour());
    program.set("photonsPerSide", options.photons);
    program.set("textureResolution", static_cast<float>(options.textureSize));
    const int triangles = 2 * (options.photons - 1) * (options.photons - 1);
    bare_.draw(gl::Primitive::triangles, 0, 3 * triangles);
    stats.triangles += static_cast<std::size_t>(triangles);
    ++stats.drawCalls;
}

void CausticsPass::filter(const CausticsOptions& options)
{
    const ivec2 size(options.textureSize);
    filteredAcross_.ensure({.size = size, .colours = {gl::Format::rgba32f}, .filter = gl::Filter::nearest});
    filtered_.ensure({.size = size, .colours = {gl::Format::rgba16f}, .mipmaps = true});
    gl::apply({.depthTest = gl::DepthTest::off, .depthWrite = false});
    const auto along = [&](const char* axis, const gl::Texture& source, const gl::Target& target) {
        gl::Program& program = filterProgram(axis, options.filter);
        target.bind();
        program.use();
        program.texture("source", source);
        triangle_.draw();
    };
    along("ivec2(1, 0)", gathered_.colour(), filteredAcross_);
    along("ivec2(0, 1)", filteredAcross_.colour(), filtered_);
    filtered_.colour().generateMipmaps();
}

gl::Program& CausticsPass::filterProgram(const char* axis, int radius)
{
    const gl::Defines defines{{"AXIS", axis},
                              {"RADIUS", std::to_string(radius)},
                              unrolled("EACH_TAP", "TAP", 2 * radius + 1, 2 * radius + 1)};
    auto& program = filterPrograms_[defines];
    if (!program)
        program = shaders_.program("caustics filter", "passes/fullscreen.vert", "passes/caustics_filter.frag", defines);
    return *program;
}

} // namespace tarn
