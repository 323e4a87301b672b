#include "scene_text.h"

#include <fmt/format.h>

#include <iterator>

namespace tarn::lake {

namespace {

constexpr float windDirection = 24.0f; // degrees from +x towards +z
constexpr float rmsSlope = 0.066f;     // a light breeze: Cox & Munk 1954 give 0.08 for 1 m/s and more
constexpr int waveCount = 20;
constexpr float longest = 6.3f, shortest = 0.28f;

constexpr const char* header = R"(# Made by make_lake; see README.md in this folder.
name = "The lake"

[options]
frame.exposure = 0.065
frame.antialiasing = "fxaa"
refraction.camera = "flat"
refraction.steps = 4
reflection.facets = "five"
caustics.texture_size = 512
glow.strength = 0.3

[sun]
elevation = 38.5
azimuth = 48.0

[sky]
kind = "daylight"
turbidity = 2.6

[water]
level = 0.0
centre = [-1, -2]
extent = [146, 112]
ior = 1.33
absorption = [0.36, 0.085, 0.115]
colour = [0.006, 0.026, 0.028]
)";

std::string point(const vec3& p) { return fmt::format("[{:.3f}, {:.3f}, {:.3f}]", p.x, p.y, p.z); }

float degrees(float radians)
{
    const float turn = std::fmod(glm::degrees(radians), 360.0f);
    return turn < 0.0f ? turn + 360.0f : turn;
}

/// Components with equal shares of the slope, wavelengths in a geometric row that is shaken so that no two
/// are in a simple ratio; long ones keep to the wind, short ones stray from it.
void appendWaves(std::string& text, Random& random)
{
    const float ratio = std::pow(shortest / longest, 1.0f / real(waveCount - 1));
    float sum = 0.0f;
    std::vector<float> shares;
    for (int i = 0; i < waveCount; ++i) {
        const float t = real(i) / real(waveCount - 1);
        shares.push_back(mix(0.32f, 1.0f, smoothStep(0.0f, 0.55f, t)));
        sum += shares.back() * shares.back();
    }
    for (int i = 0; i < waveCount; ++i) {
        const float t = real(i) / real(waveCount - 1);
        const float wavelength = longest * std::pow(ratio, real(i)) * random.range(0.93f, 1.07f);
        const float slope = rmsSlope * shares[static_cast<std::size_t>(i)] / std::sqrt(sum);
        const float amplitude = slope * std::sqrt(2.0f) * wavelength / (2.0f * pi);
        const float stray = mix(38.0f, 85.0f, t) * (i % 2 == 0 ? 1.0f : -1.0f) * std::sqrt(random.unit());
        fmt::format_to(std::back_inserter(text),
                       "\n[[water.waves]]\namplitude = {:.5f}\nwavelength = {:.4f}\ndirection = "
                       "{:.2f}\nphase = {:.1f}\n",
                       amplitude, wavelength, windDirection + stray, random.range(0.0f, 360.0f));
    }
}

void appendElement(std::string& text, const std::string& name, const std::string& shape)
{
    fmt::format_to(std::back_inserter(text), "\n[[elements]]\nname = \"{}\"\nshape = \"{}\"\n", name, shape);
}

void appendPlace(std::string& text, const vec3& position, float turn, float scale)
{
    fmt::format_to(std::back_inserter(text), "translation = {}\nrotation = [0, {:.2f}, 0]\n", point(position),
                   degrees(turn));
    if (scale != 1.0f) fmt::format_to(std::back_inserter(text), "scale = {:.3f}\n", scale);
}

} // namespace

std::string sceneText(const SceneParts& parts, Random random)
{
    std::string text = header;
    appendWaves(text, random);
    const auto model = [&](const std::string& name) {
        fmt::format_to(std::back_inserter(text), "\n[[models]]\nname = \"{0}\"\nfile = \"{0}.obj\"\n", name);
    };
    for (const std::string& name : parts.placedModels) model(name);
    model("boat");
    for (const Species& species : *parts.species) model(species.name);

    for (const std::string& name : parts.placedModels) appendElement(text, name, name);
    appendElement(text, "boat", "boat");
    appendPlace(text, vec3(parts.worldFromBoat[3]), parts.boatTurn, 1.0f);
    int number = 0;
    for (const StandingTree& tree : *parts.trees) {
        const std::string& kind = (*parts.species)[tree.species].name;
        appendElement(text, fmt::format("{} {}", kind, ++number), kind);
        appendPlace(text, tree.foot, tree.turn, tree.scale);
    }
    for (const View& view : *parts.views)
        fmt::format_to(std::back_inserter(text),
                       "\n[[cameras]]\nname = \"{}\"\neye = {}\ntarget = {}\nfov = {:.1f}\nnear = 0.1\nfar = 1300.0\n",
                       view.name, point(view.eye), point(view.target), view.fov);
    return text;
}

} // namespace tarn::lake
