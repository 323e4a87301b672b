// Every option of a frame. One struct per feature, one visit() each: see base/fields.h.
#pragma once

#include "base/fields.h"
#include "base/math.h"
#include "optics/fresnel_table.h"
#include "plan/rules.h"

#include <array>

namespace tarn {

struct FrameOptions {
    enum class ToneCurve { linear, reinhard, aces };
    enum class Upscaler { bilinear, edge };
    enum class Antialiasing { none, fxaa, msaa };
    float exposure = 1.0f;
    ToneCurve toneCurve = ToneCurve::aces;
    float scale = 1.0f;
    Upscaler upscaler = Upscaler::edge;
    Antialiasing antialiasing = Antialiasing::msaa;
    int msaa = 4;
    bool depthPrepass = true;
    float anisotropy = 8.0f;
    float targetMs = 33.3f;

    /// Of each pixel that is drawn.
    int samples() const { return antialiasing == Antialiasing::msaa ? msaa : 1; }
    bool operator==(const FrameOptions&) const = default;
};

struct WaterOptions {
    enum class Normals { pixel, vertex };
    enum class Fresnel { schlick, table, exact };
    enum class Attenuation { exponential, linear };
    enum class Specular { physical, phong };
    enum class Grid { uniform, focused };
    bool enabled = true;
    bool reflects = true;
    Grid grid = Grid::uniform;
    int gridSize = 49;
    int surfaceSteps = 1;
    Normals normals = Normals::pixel;
    bool filterWaves = true;
    Fresnel fresnel = Fresnel::exact;
    float schlickExponent = 5.0f;
    int fresnelTable = 1024;
    optics::TableFilter fresnelFilter = optics::TableFilter::nearest;
    Attenuation attenuation = Attenuation::exponential;
    float attenuationLength = 7.5f;
    float sunSlopeDeviation = 0.02f;
    Specular specular = Specular::physical;
    float phongExponent = 256.0f;
    float phongStrength = 2.0f;
    bool operator==(const WaterOptions&) const = default;
};

struct DetailOptions {
    float pixels = 0.0f;
    bool operator==(const DetailOptions&) const = default;
};

enum class DepthFormat { depth16, depth24, depth32f };

struct RefractionOptions {
    enum class Method { planar, iterative, raycast, combined, automatic };
    enum class CameraMode { main, snell, flat };
    bool enabled = true;
    Method method = Method::iterative;
    int steps = 3;
    CameraMode camera = CameraMode::snell;
    int targetSize = 512;
    DepthFormat depth = DepthFormat::depth24;
    float clipOffset = 0.1f;
    float fovExtensionNear = 1.5f;
    float fovExtensionFar = 1.2f;
    int interval = 1; ///< frames
    bool operator==(const RefractionOptions&) const = default;
};

struct ReflectionOptions {
    enum class Method { distance, iterative, raycast, combined, automatic };
    enum class Facets { one, three, five };
    bool enabled = true;
    Method method = Method::iterative;
    int steps = 4;
    Facets facets = Facets::three;
    float distance = 1.0f; ///< c of eq. 6
    int targetSize = 512;
    float clipOffset = 0.1f;
    float fovExtensionNear = 1.5f;
    float fovExtensionFar = 1.2f;
    int interval = 1; ///< frames
    bool operator==(const ReflectionOptions&) const = default;
};

struct HeightsOptions {
    enum class March { classic, pyramid };
    enum class Filter { nearest, linear };
    int mapSize = 1024;
    float border = 2.0f;
    March march = March::pyramid;
    float unit = 1.0f;
    Filter filter = Filter::nearest;
    int refine = 0;
    bool operator==(const HeightsOptions&) const = default;
};

struct SunlightOptions {
    bool shadows = true;
    int mapSize = 2048;
    int cascades = 3;
    DepthFormat depth = DepthFormat::depth24;
    int taps = 2;
    float bias = 0.02f;
    bool operator==(const SunlightOptions&) const = default;
};

struct CausticsOptions {
    enum class Method { cpu, points, fetch, mesh };
    bool enabled = true;
    Method method = Method::fetch;
    int textureSize = 256;
    int photons = 256;
    int steps = 2;
    int filter = 2;
    float extent = 0.0f;
    int interval = 1; ///< frames
    bool operator==(const CausticsOptions&) const = default;
};
struct UnderwaterOptions {
    enum class Refraction { paper, exact };
    bool enabled = true;
    Refraction refraction = Refraction::exact;
    float distance = 1.5f; ///< m of eqs. 13 and 15
    bool operator==(const UnderwaterOptions&) const = default;
};
struct GlowOptions {
    bool enabled = true;
    float exponent = 200.0f;
    vec3 colour{1.0f, 1.0f, 0.8f};
    float strength = 1.0f;
    int divisor = 8;
    bool operator==(const GlowOptions&) const = default;
};

struct StereoOptions {
    enum class Output { off, sideBySide, anaglyph, pair };
    Output output = Output::off;
    float separation = 0.065f;
    float convergence = 5.0f;

    bool isOn() const { return output != Output::off; }
    bool operator==(const StereoOptions&) const = default;
};

/// What the frame plan may leave out (plan/rules.h).
struct PlanOptions {
    bool enabled = true;
    bool exact = false;
    std::array<bool, ruleCount> rules = allRules(); ///< by RuleId

    /// Whether a rule may be applied.
    bool allows(RuleId id) const
    {
        return enabled && rules[static_cast<std::size_t>(id)] && !(exact && rule(id).bound);
    }
    bool operator==(const PlanOptions&) const = default;
};

struct Options {
    PlanOptions plan;
    FrameOptions frame;
    DetailOptions detail;
    WaterOptions water;
    RefractionOptions refraction;
    ReflectionOptions reflection;
    HeightsOptions heights;
    SunlightOptions sunlight;
    CausticsOptions caustics;
    UnderwaterOptions underwater;
    GlowOptions glow;
    StereoOptions stereo;
    bool operator==(const Options&) const = default;
};

void visit(FieldVisitor& visitor, Options& options);

} // namespace tarn
