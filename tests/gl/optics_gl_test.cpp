// Every function of shaders/shared on the GPU over a grid of inputs, against the C++ build of the same
// source.
//
// A case is one GLSL expression that gives a vec4, the same in C++, and inputs a, b, c (vec4 each) drawn from
// ranges. The inputs travel as float textures, so both sides start from the same bits; tolerances are for
// what GLSL leaves to the driver (exp, pow, sin, sqrt, fused multiplication), relative to the larger of 1 and
// the value.

#include "base/files.h"
#include "gl/buffer.h"
#include "gl/state.h"
#include "gl/vertex_array.h"
#include "gl_test.h"
#include "optics/optics.h"
#include "render/unrolled.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace tarn {
namespace {

constexpr int side = 64;

struct Inputs {
    vec4 a, b, c;
};

struct Case {
    const char* name;
    const char* glsl; ///< a vec4 of a, b, c
    std::function<vec4(const Inputs&)> cpp;
    float tolerance = 2e-6f;
};

vec3 xyz(const vec4& v) { return vec3(v); }
vec4 wide(const vec3& v, float w = 0.0f) { return {v, w}; }

/// a.xyz, b.xyz, c.xyz: unit vectors with a positive y, grazing ones among them. The w are 0..1.
std::vector<Inputs> makeInputs()
{
    std::mt19937 random(7);
    std::uniform_real_distribution<float> unit(0.0f, 1.0f);
    auto direction = [&] {
        const float y = unit(random) < 0.2f ? 0.01f * unit(random) : unit(random);
        const float r = std::sqrt(1.0f - y * y), azimuth = 6.2831853f * unit(random);
        return vec4(r * std::cos(azimuth), y, r * std::sin(azimuth), unit(random));
    };
    std::vector<Inputs> inputs(side * side);
    for (Inputs& input : inputs) input = {direction(), direction(), direction()};
    return inputs;
}

class OpticsGl : public testing::Test {
protected:
    OpticsGl()
    {
        folder_.write("full.vert", test::fullscreenVertex);
        for (const char* file :
             {"blocks", "refraction", "fresnel_table", "depth", "trigonometry", "waves", "normal_map", "intersection",
              "reflection", "lighting", "tonemap", "anaglyph", "sunlight", "caustics", "water_grid"}) {
            const std::string name = std::string("shared/") + file + ".glsl";
            folder_.write(name, readFile(projectRoot() / "shaders" / name));
            includes_ += "#include \"" + name + "\"\n";
        }
    }

    gl::Texture texture(const std::vector<Inputs>& inputs, vec4 Inputs::*member, const char* label)
    {
        std::vector<float> values;
        for (const Inputs& input : inputs)
            for (int i = 0; i < 4; ++i) values.push_back((input.*member)[i]);
        gl::Texture result({.format = gl::Format::rgba32f, .size = {side, side}, .filter = gl::Filter::nearest}, label);
        result.upload(values);
        return result;
    }

    /// The expression for every input, in their order.
    std::vector<vec4> evaluate(const std::string& glsl, const std::vector<Inputs>& inputs)
    {
        folder_.write("test.frag", declarations_ + includes_ +
                                       "uniform sampler2D inputA;\nuniform sampler2D inputB;\n"
                                       "uniform sampler2D inputC;\nout vec4 result;\n"
                                       "vec4 f(vec4 a, vec4 b, vec4 c)\n{\n    return " +
                                       glsl +
                                       ";\n}\nvoid main()\n{\n    ivec2 p = ivec2(gl_FragCoord.xy);\n"
                                       "    result = f(texelFetch(inputA, p, 0), texelFetch(inputB, p, 0),\n"
                                       "               texelFetch(inputC, p, 0));\n}\n");
        gl::Bindings bindings;
        bindings.blocks = {{"FrameBlock", 0}, {"ViewBlock", 1}, {"WavesBlock", 2}, {"SunBlock", 3}};
        gl::ShaderLibrary library(folder_.root(), bindings);
        const auto program = library.program("test", "full.vert", "test.frag", defines_);
        const gl::Texture a = texture(inputs, &Inputs::a, "a"), b = texture(inputs, &Inputs::b, "b"),
                          c = texture(inputs, &Inputs::c, "c");
        gl::Target target("results");
        target.ensure({.size = {side, side}, .colours = {gl::Format::rgba32f}});
        target.bind();
        gl::apply({.depthTest = gl::DepthTest::off});
        program->use();
        // A case that does not read one of them has no such sampler.
        if (program->samplerUnit("inputA")) program->texture("inputA", a);
        if (program->samplerUnit("inputB")) program->texture("inputB", b);
        if (program->samplerUnit("inputC")) program->texture("inputC", c);
        gl::FullscreenTriangle().draw();
        const std::vector<float> values = target.framebuffer().readFloats();
        std::vector<vec4> results;
        for (std::size_t i = 0; i + 3 < values.size(); i += 4)
            results.emplace_back(values[i], values[i + 1], values[i + 2], values[i + 3]);
        return results;
    }

    void check(const Case& test, const std::vector<Inputs>& inputs)
    {
        const std::vector<vec4> gpu = evaluate(test.glsl, inputs);
        ASSERT_EQ(gpu.size(), inputs.size());
        int wrong = 0;
        std::set<float> distinct;
        for (std::size_t i = 0; i < inputs.size(); ++i) {
            const vec4 cpu = test.cpp(inputs[i]);
            distinct.insert(cpu.x);
            const float error = glm::length(gpu[i] - cpu) / std::max(1.0f, glm::length(cpu));
            if (error <= test.tolerance) continue; // false for NaN too
            if (++wrong > 3) continue;
            ADD_FAILURE() << test.name << " at input " << i << ": GPU " << gpu[i].x << ' ' << gpu[i].y << ' '
                          << gpu[i].z << ' ' << gpu[i].w << ", C++ " << cpu.x << ' ' << cpu.y << ' ' << cpu.z << ' '
                          << cpu.w;
        }
        EXPECT_EQ(wrong, 0) << test.name;
        // A function that the inputs leave constant would agree whatever it did.
        EXPECT_GT(distinct.size(), 100u) << test.name;
    }

    void check(const std::vector<Case>& cases)
    {
        const std::vector<Inputs> inputs = makeInputs();
        for (const Case& test : cases) check(test, inputs);
    }

    test::ShaderFolder folder_;
    std::string includes_;
    std::string declarations_; ///< of what the shared files read beside the blocks
    gl::Defines defines_;
};

TEST_F(OpticsGl, Refraction)
{
    using namespace optics;
    check({
        {"refractRay in", "vec4(refractRay(-a.xyz, vec3(0.0, 1.0, 0.0), 1.0 / 1.33), 0.0)",
         [](const Inputs& i) { return wide(refractRay(-xyz(i.a), vec3(0, 1, 0), 1.0f / 1.33f)); }},
        // On the way out, away from the critical angle, where the square root magnifies any rounding.
        {"refractRay out", "a.y > 0.67 ? vec4(refractRay(-a.xyz, vec3(0.0, 1.0, 0.0), 1.33), 0.0) : vec4(a.y)",
         [](const Inputs& i) {
             return i.a.y > 0.67f ? wide(refractRay(-xyz(i.a), vec3(0, 1, 0), 1.33f)) : vec4(i.a.y);
         },
         1e-5f},
        {"total reflection", "a.y < 0.65 ? vec4(refractRay(-a.xyz, vec3(0.0, 1.0, 0.0), 1.33), 1.0) : vec4(a.y)",
         [](const Inputs& i) { return i.a.y < 0.65f ? vec4(0, 0, 0, 1) : vec4(i.a.y); }},
        {"reflectRay", "vec4(reflectRay(-a.xyz, b.xyz), 0.0)",
         [](const Inputs& i) { return wide(reflectRay(-xyz(i.a), xyz(i.b))); }},
        {"fresnelExact", "vec4(fresnelExact(a.y, 1.0 / 1.33), fresnelExact(b.y, 1.0 / 1.31), 0.0, 0.0)",
         [](const Inputs& i) {
             return vec4(fresnelExact(i.a.y, 1.0f / 1.33f), fresnelExact(i.b.y, 1.0f / 1.31f), 0, 0);
         }},
        {"fresnelSchlick", "vec4(fresnelSchlick(a.y, 1.33, 5.0), fresnelSchlick(b.y, 1.31, 0.5 + 8.0 * b.w), 0.0, 0.0)",
         [](const Inputs& i) {
             return vec4(fresnelSchlick(i.a.y, 1.33f, 5.0f), fresnelSchlick(i.b.y, 1.31f, 0.5f + 8.0f * i.b.w), 0, 0);
         },
         1e-6f},
        {"fresnelTable",
         "vec4(fresnelTableCoordinate(a.y, 1024, true), fresnelTableCoordinate(1.1 * b.y, 64, false),"
         " fresnelTableCosine(int(63.0 * a.w), 64, true), fresnelTableCosine(int(63.0 * b.w), 64, false))",
         [](const Inputs& i) {
             return vec4(fresnelTableCoordinate(i.a.y, 1024, true), fresnelTableCoordinate(1.1f * i.b.y, 64, false),
                         fresnelTableCosine(static_cast<int>(63.0f * i.a.w), 64, true),
                         fresnelTableCosine(static_cast<int>(63.0f * i.b.w), 64, false));
         }},
        {"beerLambert", "vec4(beerLambert(a.xyz * a.xyz, 30.0 * a.w), 0.0)",
         [](const Inputs& i) { return wide(beerLambert(xyz(i.a) * xyz(i.a), 30.0f * i.a.w)); }},
        {"linearAttenuation",
         "vec4(linearAttenuation(9.0 * a.w, 7.5), linearAttenuation(a.w - 0.5, 0.1 + b.w), 0.0, 0.0)",
         [](const Inputs& i) {
             return vec4(linearAttenuation(9.0f * i.a.w, 7.5f), linearAttenuation(i.a.w - 0.5f, 0.1f + i.b.w), 0, 0);
         }},
        {"radianceThroughWater", "vec4(radianceThroughWater(a.xyz, b.xyz, c.xyz * c.xyz), 0.0)",
         [](const Inputs& i) { return wide(radianceThroughWater(xyz(i.a), xyz(i.b), xyz(i.c) * xyz(i.c))); }},
        {"radianceThroughSurface", "vec4(radianceThroughSurface(a.y, 1.0 + b.w))",
         [](const Inputs& i) { return vec4(radianceThroughSurface(i.a.y, 1.0f + i.b.w)); }},
    });
}

TEST_F(OpticsGl, Depth)
{
    using namespace optics;
    check({
        {"viewZFromDepth",
         "vec4(viewZFromDepth(a.w, 0.1, 1000.0), viewZFromDepth(1.0, 0.01, 10.0 + 1.0e4 * b.w), 0.0, 0.0)",
         [](const Inputs& i) {
             return vec4(viewZFromDepth(i.a.w, 0.1f, 1000.0f), viewZFromDepth(1.0f, 0.01f, 10.0f + 1.0e4f * i.b.w), 0,
                         0);
         }},
        {"depthFromViewZ", "vec4(depthFromViewZ(-0.1 - 900.0 * a.w * b.w, 0.1, 1000.0))",
         [](const Inputs& i) { return vec4(depthFromViewZ(-0.1f - 900.0f * i.a.w * i.b.w, 0.1f, 1000.0f)); }},
        {"viewZPerDepth", "vec4(viewZPerDepth(-0.1 - 900.0 * a.w, 0.1, 1000.0))",
         [](const Inputs& i) { return vec4(viewZPerDepth(-0.1f - 900.0f * i.a.w, 0.1f, 1000.0f)); }},
    });
}

TEST_F(OpticsGl, Lighting)
{
    using namespace optics;
    check({
        {"shBasis", "vec4(shBasis(int(9.0 * a.w), b.xyz), shBasis(6, a.xyz), shBasis(8, a.xyz), shBasis(4, a.xyz))",
         [](const Inputs& i) {
             return vec4(shBasis(static_cast<int>(9.0f * i.a.w), xyz(i.b)), shBasis(6, xyz(i.a)), shBasis(8, xyz(i.a)),
                         shBasis(4, xyz(i.a)));
         }},
        {"shIrradiance",
         "vec4(shIrradiance(vec4[9](b, c, 0.5 * b, 0.5 * c, b * c, b.yzxw, c.yzxw, b.zxyw, c.zxyw), a.xyz), "
         "0.0)",
         [](const Inputs& i) {
             auto yzx = [](const vec4& v) { return vec4(v.y, v.z, v.x, v.w); };
             auto zxy = [](const vec4& v) { return vec4(v.z, v.x, v.y, v.w); };
             const vec4 c[9]{i.b, i.c, 0.5f * i.b, 0.5f * i.c, i.b * i.c, yzx(i.b), yzx(i.c), zxy(i.b), zxy(i.c)};
             return wide(shIrradiance(c, xyz(i.a)));
         }},
        {"skyIrradianceAtDepth",
         "vec4(skyIrradianceAtDepth(skyIrradianceBelow(vec3(10.0)), a.xyz * a.xyz, 9.0 * a.w, b.xyz), 0.0)",
         [](const Inputs& i) {
             return wide(
                 skyIrradianceAtDepth(skyIrradianceBelow(vec3(10.0f)), xyz(i.a) * xyz(i.a), 9.0f * i.a.w, xyz(i.b)));
         }},
        {"refractedSunDirection", "vec4(refractedSunDirection(vec3(a.x, a.y - 0.1 * b.w, a.z), 1.33), 0.0)",
         [](const Inputs& i) { return wide(refractedSunDirection(vec3(i.a.x, i.a.y - 0.1f * i.b.w, i.a.z), 1.33f)); },
         1e-5f}, // that vector is not unit, which brings the cosine below near zero now and then
        {"sunIrradianceBelow", "vec4(sunIrradianceBelow(vec3(100.0), a.y - 0.02, 1.33), 0.0)",
         [](const Inputs& i) { return wide(sunIrradianceBelow(vec3(100.0f), i.a.y - 0.02f, 1.33f)); }},
        {"deepWaterRadiance", "vec4(deepWaterRadiance(a.xyz, 70.0 * b.xyz, 30.0 * c.xyz), 0.0)",
         [](const Inputs& i) { return wide(deepWaterRadiance(xyz(i.a), 70.0f * xyz(i.b), 30.0f * xyz(i.c))); }},
        // pow magnifies the driver's rounding of its logarithm by the exponent.
        {"blinnPhong", "vec4(blinnPhong(a.y, 200.0 * b.w), blinnPhong(-a.y, 5.0), 0.0, 0.0)",
         [](const Inputs& i) { return vec4(blinnPhong(i.a.y, 200.0f * i.b.w), blinnPhong(-i.a.y, 5.0f), 0, 0); },
         1e-4f},
        {"smithCosLambda", "vec4(smithCosLambda(a.y, 0.001 + b.w))",
         [](const Inputs& i) { return vec4(smithCosLambda(i.a.y, 0.001f + i.b.w)); }},
        {"phongGlint", "vec4(phongGlint(vec3(3.0), a.w, a.xyz, b.xyz, c.xyz, 1.0 + 20.0 * b.w, 2.0), 0.0)",
         [](const Inputs& i) {
             return wide(phongGlint(vec3(3.0f), i.a.w, xyz(i.a), xyz(i.b), xyz(i.c), 1.0f + 20.0f * i.b.w, 2.0f));
         },
         1e-4f},
        {"sunGlint", "vec4(sunGlint(vec3(100.0), a.w, a.xyz, b.xyz, c.xyz, 0.001 + b.w * b.w), 0.0)",
         [](const Inputs& i) {
             return wide(sunGlint(vec3(100.0f), i.a.w, xyz(i.a), xyz(i.b), xyz(i.c), 0.001f + i.b.w * i.b.w));
         },
         1e-4f},
    });
}

TEST_F(OpticsGl, Sunlight)
{
    using namespace optics;
    // Directions a hand above the horizon and more: nothing asks for a sun that has no crossing.
    auto raised = [](const vec4& v) { return vec3(v.x, v.y + 0.1f, v.z); };
    const std::string toSun = "vec3(a.x, a.y + 0.1, a.z)";
    check({
        {"sunPlane", ("vec4(sunPlane(5.0 * b.xyz, 0.5, sunShear(" + toSun + ")), 0.0, 0.0)").c_str(),
         [raised](const Inputs& i) { return vec4(sunPlane(5.0f * xyz(i.b), 0.5f, sunShear(raised(i.a))), 0.0f, 0.0f); },
         1e-5f},
        {"sunPlaneGradient", ("vec4(sunPlaneGradient(b.xyz, sunShear(" + toSun + ")), 0.0, 0.0)").c_str(),
         [raised](const Inputs& i) { return vec4(sunPlaneGradient(xyz(i.b), sunShear(raised(i.a))), 0.0f, 0.0f); },
         1e-3f}, // the divisor passes through zero: it magnifies rounding up to the limit
        {"sunMapUv",
         "vec4(sunMapUv(vec4(1.0, 2.0, 8.0, 5.0), 9.0 * a.xz), sunMapUvDifference(vec4(1.0, 2.0, 8.0, 5.0), b.xz))",
         [](const Inputs& i) {
             const vec4 rect(1.0f, 2.0f, 8.0f, 5.0f);
             return vec4(sunMapUv(rect, 9.0f * vec2(i.a.x, i.a.z)), sunMapUvDifference(rect, vec2(i.b.x, i.b.z)));
         }},
        {"sunMapPlane", "vec4(sunMapPlane(vec4(1.0, 2.0, 8.0, 5.0), a.xz), 0.0, 0.0)",
         [](const Inputs& i) {
             return vec4(sunMapPlane(vec4(1.0f, 2.0f, 8.0f, 5.0f), vec2(i.a.x, i.a.z)), 0.0f, 0.0f);
         }},
    });
}

TEST_F(OpticsGl, Caustics)
{
    using namespace optics;
    const auto xz = [](const vec4& v) { return vec2(v.x, v.z); };
    check({
        {"photonWeight",
         "vec4(photonWeight(1.5 * a.xz), photonFraction(a.w + 0.1, b.w + 0.1), triangleArea(a.xz, b.xz),"
         " isAddedAsPoint(triangleArea(a.xz, b.xz)) ? 1.0 : 0.0)",
         [&](const Inputs& i) {
             const float area = triangleArea(xz(i.a), xz(i.b));
             return vec4(photonWeight(1.5f * xz(i.a)), photonFraction(i.a.w + 0.1f, i.b.w + 0.1f), area,
                         isAddedAsPoint(area) ? 1.0f : 0.0f);
         },
         1e-5f},
        {"photonEntryHeight",
         "vec4(photonEntryHeight(a.w, 0.5 * b.xz, 2.0 * c.xz), photonFlux(a.y + 0.01, 1.33, 0.1, 0.2), 0.0, 0.0)",
         [&](const Inputs& i) {
             return vec4(photonEntryHeight(i.a.w, 0.5f * xz(i.b), 2.0f * xz(i.c)),
                         photonFlux(i.a.y + 0.01f, 1.33f, 0.1f, 0.2f), 0.0f, 0.0f);
         },
         1e-5f},
        {"sunRayAtHeight", "vec4(sunRayAtHeight(5.0 * a.xyz, 9.0 * b.w, 2.0 * c.xz), 0.0)",
         [&](const Inputs& i) { return wide(sunRayAtHeight(5.0f * xyz(i.a), 9.0f * i.b.w, 2.0f * xz(i.c))); }},
        {"photonLight", "vec4(photonLight(a.w, 20.0 * b.w, c.xyz * c.xyz), 0.0)",
         [](const Inputs& i) { return wide(photonLight(i.a.w, 20.0f * i.b.w, xyz(i.c) * xyz(i.c))); }},
        {"causticsFade", "vec4(causticsFade(9.0 * a.xz, vec4(1.0, 0.0, 8.0, 9.0), vec4(0.0, 1.0, 7.0, 8.0), 2.0, b.w))",
         [&](const Inputs& i) {
             return vec4(
                 causticsFade(9.0f * xz(i.a), vec4(1.0f, 0.0f, 8.0f, 9.0f), vec4(0.0f, 1.0f, 7.0f, 8.0f), 2.0f, i.b.w));
         }},
        {"causticsIrradiance", "vec4(causticsIrradiance(a.xyz, vec3(90.0), b.w, 0.5 + 0.5 * c.w), 0.0)",
         [](const Inputs& i) { return wide(causticsIrradiance(xyz(i.a), vec3(90.0f), i.b.w, 0.5f + 0.5f * i.c.w)); }},
        {"causticsFilterWeight", "vec4(causticsFilterWeight(2, int(7.0 * a.w) - 3) + b.w)",
         [](const Inputs& i) { return vec4(causticsFilterWeight(2, static_cast<int>(7.0f * i.a.w) - 3) + i.b.w); }},
    });
}

TEST_F(OpticsGl, ToneCurves)
{
    using namespace optics;
    check({
        {"toneLinear", "vec4(toneLinear(2.0 * a.xyz), 0.0)",
         [](const Inputs& i) { return wide(toneLinear(2.0f * xyz(i.a))); }},
        {"toneReinhard", "vec4(toneReinhard(exp2(30.0 * a.xyz)), 0.0)",
         [](const Inputs& i) { return wide(toneReinhard(glm::exp2(30.0f * xyz(i.a)))); }},
        {"toneAces", "vec4(toneAces(exp2(30.0 * a.xyz)), 0.0)",
         [](const Inputs& i) { return wide(toneAces(glm::exp2(30.0f * xyz(i.a)))); }},
        {"srgbColour", "vec4(srgbColour(a.xyz), srgbFromLinear(0.01 * a.w))",
         [](const Inputs& i) { return wide(srgbColour(xyz(i.a)), srgbFromLinear(0.01f * i.a.w)); }},
        {"anaglyphRedCyan", "vec4(anaglyphRedCyan(a.xyz, b.xyz), 0.0)",
         [](const Inputs& i) { return wide(anaglyphRedCyan(xyz(i.a), xyz(i.b))); }},
        {"linearColour", "vec4(linearColour(a.xyz), linearFromSrgb(0.1 * a.w))",
         [](const Inputs& i) { return wide(linearColour(xyz(i.a)), linearFromSrgb(0.1f * i.a.w)); }},
    });
}

TEST_F(OpticsGl, WavesOneByOne)
{
    using namespace optics;
    auto term = [](const Inputs& i) {
        return WaveTerm{4.0f * vec2(i.a.x, i.a.z), 3.0f * i.b.w, 6.0f * i.c.w, 0.1f, 4.0f * i.a.w, 0.0f, 0.0f};
    };
    const char* const glsl = "WaveTerm(4.0 * a.xz, 3.0 * b.w, 6.0 * c.w, 0.1, 4.0 * a.w, 0.0, 0.0)";
    const std::string sine = std::string("vec4(waveTerm(") + glsl + ", 10.0 * b.xz, 7.0 * c.y), 0.0)";
    const std::string filter =
        std::string("vec4(waveFilter(") + glsl + ", 2.0 * b.w), waveFilteredVariance(" + glsl + ", c.w), 0.0, 0.0)";
    const std::string overPixel = std::string("vec4(waveFilterOverPixel(") + glsl + ", 0.5 * b.xz, 0.5 * c.zx))";
    check({
        // An angle of 70 rad is rounded to 4e-6.
        {"waveTerm", sine.c_str(),
         [term](const Inputs& i) { return wide(waveTerm(term(i), 10.0f * vec2(i.b.x, i.b.z), 7.0f * i.c.y)); }, 1e-5f},
        {"sinCosTogether", "vec4(sinCosTogether(20.0 * b.x), sinCosTogether(0.1 * b.z))",
         [](const Inputs& i) { return vec4(sinCosTogether(20.0f * i.b.x), sinCosTogether(0.1f * i.b.z)); }, 2e-6f},
        {"waveFilterOverPixel", overPixel.c_str(),
         [term](const Inputs& i) {
             return vec4(waveFilterOverPixel(term(i), 0.5f * vec2(i.b.x, i.b.z), 0.5f * vec2(i.c.z, i.c.x)));
         }},
        {"waveFilter", filter.c_str(),
         [term](const Inputs& i) {
             return vec4(waveFilter(term(i), 2.0f * i.b.w), waveFilteredVariance(term(i), i.c.w), 0, 0);
         }},
        {"waveNormal", "vec4(waveNormal(a.xz), 0.0)",
         [](const Inputs& i) { return wide(waveNormal(vec2(i.a.x, i.a.z))); }},
    });
}

TEST_F(OpticsGl, NormalMap)
{
    using namespace optics;
    check({
        {"normalMapSlope", "vec4(normalMapSlope(normalMapNormal(0.5 + 0.5 * a.xyz) + b.xyz, 0.1 + c.w), 0.0, 0.0)",
         [](const Inputs& i) {
             const vec3 sum = normalMapNormal(0.5f + 0.5f * xyz(i.a)) + xyz(i.b);
             return vec4(normalMapSlope(sum, 0.1f + i.c.w), 0.0f, 0.0f);
         },
         1e-5f},
        {"normalMapSlopeVariance",
         "vec4(normalMapFilteredVariance(vec4(a.x, a.y + 0.2, a.z, 40.0 * b.w)), normalMapSlopeVariance(b.w, c.w), "
         "0.0, "
         "0.0)",
         [](const Inputs& i) {
             return vec4(normalMapFilteredVariance(vec4(i.a.x, i.a.y + 0.2f, i.a.z, 40.0f * i.b.w)),
                         normalMapSlopeVariance(i.b.w, i.c.w), 0.0f, 0.0f);
         },
         1e-5f},
    });
}

/// The sums that the passes call, over the uniform blocks' waves and the water's grid: this also proves that C++ and
/// the driver agree on the blocks' layout.
class WaveSumsGl : public OpticsGl {
protected:
    static constexpr int count = 5;

    WaveSumsGl()
    {
        for (int i = 0; i < count; ++i) {
            const float f = static_cast<float>(i);
            waves_.waves[i] = {vec2(1.0f + f, 2.0f - f), 0.5f * f, f, 0.2f, std::hypot(1.0f + f, 2.0f - f), 0.0f, 0.0f};
        }
        frame_.waveCount = count;
        frame_.waterGrid[0] = {-20.0f, 30.0f, 1.0f, 0.8f, -3.0f, 2.5f, 49.0f, 0.0f};
        frame_.waterGrid[1] = {-25.0f, 25.0f, 0.0f, 0.0f, 0.0f, 0.0f, 33.0f, 0.0f};
        wavesBuffer_.update(waves_);
        frameBuffer_.update(frame_);
        declarations_ = "#define WAVE_WEIGHTS\nconst float waveWeights[5] = float[5](1.0, 0.8, 0.5, 0.2, 0.0);\n";
    }

    void checkSums()
    {
        using namespace optics;
        const WaveTerm* waves = waves_.waves;
        const GridAxis* grid = frame_.waterGrid;
        const float weights[count] = {1.0f, 0.8f, 0.5f, 0.2f, 0.0f};
        const auto wideSum = [](const WaveSum& s) { return vec4(s.height, s.slope, 0.0f); };
        const auto xz = [](const vec4& v) { return vec2(v.x, v.z); };
        const auto filter = [&](const Inputs& i) {
            return filteredWaves(waves, count, 3.0f * xz(i.a), i.a.w, 0.5f * xz(i.b), 0.5f * xz(i.c), 0.1f * i.b.w);
        };
        const std::string sum = "waveSum(3.0 * a.xz, a.w)", weighted = "weightedWaveSum(3.0 * a.xz, a.w)",
                          vertex = "gridSum(3.0 * a.xz, 2.0 * b.xz, a.w)",
                          filtered = "filteredWaves(3.0 * a.xz, a.w, 0.5 * b.xz, 0.5 * c.xz, 0.1 * b.w)";
        const auto heightAndSlope = [](const std::string& s) { return "vec4(" + s + ".height, " + s + ".slope, 0.0)"; };
        const std::string sumG = heightAndSlope(sum), weightedG = heightAndSlope(weighted),
                          vertexG = heightAndSlope(vertex);
        const std::string slopesG = "vec4(" + filtered + ".slope, " + filtered + ".meanSlope)";
        const std::string varianceG = "vec4(" + filtered + ".slopeVariance)";
        check({
            {"waveSum", sumG.c_str(),
             [&](const Inputs& i) { return wideSum(waveSum(waves, count, 3.0f * xz(i.a), i.a.w)); }, 1e-5f},
            {"weightedWaveSum", weightedG.c_str(),
             [&](const Inputs& i) { return wideSum(weightedWaveSum(waves, count, weights, 3.0f * xz(i.a), i.a.w)); },
             1e-5f},
            {"gridSum", vertexG.c_str(),
             [&](const Inputs& i) { return wideSum(gridSum(waves, count, 3.0f * xz(i.a), 2.0f * xz(i.b), i.a.w)); },
             1e-5f},
            {"filteredWaves: slopes", slopesG.c_str(),
             [&](const Inputs& i) { return vec4(filter(i).slope, filter(i).meanSlope); }, 1e-5f},
            {"filteredWaves: variance", varianceG.c_str(),
             [&](const Inputs& i) { return vec4(filter(i).slopeVariance); }, 1e-5f},
            // Line numbers are found by a logarithm; where they are wrong by 1e-6 so is the point within the triangle.
            {"gridHeight", "vec4(gridHeight(20.0 * a.xz, a.w, waterGrid[0], waterGrid[1]))",
             [&](const Inputs& i) { return vec4(gridHeight(waves, count, 20.0f * xz(i.a), i.a.w, grid[0], grid[1])); },
             1e-4f},
        });
    }

    blocks::WavesBlock waves_{};
    blocks::FrameBlock frame_{};
    gl::UniformBuffer<blocks::WavesBlock> wavesBuffer_{2, "waves"};
    gl::UniformBuffer<blocks::FrameBlock> frameBuffer_{0, "frame"};
};

TEST_F(WaveSumsGl, AsALoop) { checkSums(); }

TEST_F(WaveSumsGl, WrittenOut)
{
    defines_ = {eachWave(count)};
    checkSums();
}

TEST_F(OpticsGl, Intersection)
{
    using namespace optics;
    auto u = [](const Inputs& i) { return vec3(i.a.x, i.a.y - 1.0f, -3.0f - 4.0f * i.a.w); };
    auto r = [](const Inputs& i) { return glm::normalize(vec3(i.b.x, -0.2f - i.b.y, -0.5f * i.b.w)); };
    const std::string uG = "vec3(a.x, a.y - 1.0, -3.0 - 4.0 * a.w)",
                      rG = "normalize(vec3(b.x, -0.2 - b.y, -0.5 * b.w))";
    const std::string begin = "intersectionBegin(" + uG + ", " + rG + ", depthSample(" + uG + ", -8.0 - c.w))";
    const std::string step = "intersectionStep(" + begin + ", -7.0 - c.w)";
    auto second = [u, r](const Inputs& i) {
        return intersectionStep(intersectionBegin(u(i), r(i), depthSample(u(i), -8.0f - i.c.w)), -7.0f - i.c.w);
    };
    const std::string guess = "intersectionGuess(" + begin + ", 4.0 * c.x - 0.5)";
    const std::string guessed = "vec4(" + guess + ".W, " + guess + ".s)";
    const std::string first = "vec4(" + begin + ".W, " + begin + ".bestDistance)";
    const std::string next = "vec4(" + step + ".W, " + step + ".s)";
    const std::string end = "intersectionEnd(" + step + ")";
    const std::string ended = "vec4(" + end + ".best, length(" + end + ".bestA - " + end + ".best))";
    const std::string best = "vec4(" + step + ".best, " + step + ".bestDistance)";
    auto leapt = [u, r](const Inputs& i) {
        return intersectionStep(intersectionBegin(u(i), r(i), depthSample(u(i), -8.0f)), -60.0f - i.c.w);
    };
    const std::string leaptG =
        "intersectionStep(intersectionBegin(" + uG + ", " + rG + ", depthSample(" + uG + ", -8.0)), -60.0 - c.w)";
    const std::string leap = "vec4(" + leaptG + ".W, " + leaptG + ".s)";
    // Twice something close to the eye, behind which W lies.
    auto near = [u, r](const Inputs& i) {
        const auto begun = intersectionBegin(u(i), r(i), depthSample(u(i), -8.0f));
        return intersectionStep(intersectionStep(begun, -2.0f), -0.2f - 0.1f * i.c.w);
    };
    const std::string halvedG = "intersectionStep(intersectionStep(intersectionBegin(" + uG + ", " + rG +
                                ", depthSample(" + uG + ", -8.0)), -2.0), -0.2 - 0.1 * c.w)";
    const std::string halved = "vec4(" + halvedG + ".W, " + halvedG + ".s)";
    const std::string planar = "vec4(planarIntersection(" + uG + ", " + rG + ", depthSample(" + uG + ", -8.0)), 0.0)";
    const std::string nearest = "vec4(closestOnRay(" + uG + ", " + rG + ", 3.0 * c.xyz, a.xyz + 0.5), 0.0)";
    check({
        {"intersectionBegin", first.c_str(),
         [u, r](const Inputs& i) {
             const auto s = intersectionBegin(u(i), r(i), depthSample(u(i), -8.0f - i.c.w));
             return wide(s.W, s.bestDistance);
         }},
        {"intersectionGuess", guessed.c_str(),
         [u, r](const Inputs& i) {
             const auto s = intersectionGuess(intersectionBegin(u(i), r(i), depthSample(u(i), -8.0f - i.c.w)),
                                              4.0f * i.c.x - 0.5f);
             return wide(s.W, s.s);
         }},
        // Two lines that meet at a small angle magnify rounding by its inverse.
        {"intersectionStep", next.c_str(), [second](const Inputs& i) { return wide(second(i).W, second(i).s); }, 1e-3f},
        {"best", best.c_str(), [second](const Inputs& i) { return wide(second(i).best, second(i).bestDistance); },
         1e-5f},
        {"intersectionEnd", ended.c_str(),
         [second](const Inputs& i) {
             const auto s = intersectionEnd(second(i));
             return wide(s.best, glm::length(s.bestA - s.best));
         },
         1e-3f},
        // A bed far behind W, then one far in front: no intersection between them, so the step by the gap
        // and, where that would leave the interval, the half of it.
        {"step by the gap", leap.c_str(), [leapt](const Inputs& i) { return wide(leapt(i).W, leapt(i).s); }, 1e-4f},
        {"half the interval", halved.c_str(), [near](const Inputs& i) { return wide(near(i).W, near(i).s); }, 1e-4f},
        {"planarIntersection", planar.c_str(),
         [u, r](const Inputs& i) { return wide(planarIntersection(u(i), r(i), depthSample(u(i), -8.0f))); }},
        {"closestOnRay", nearest.c_str(),
         [u, r](const Inputs& i) { return wide(closestOnRay(u(i), r(i), 3.0f * xyz(i.c), xyz(i.a) + 0.5f)); }, 1e-3f},
    });
}

TEST_F(OpticsGl, ChoiceOfTheMirroredPoint)
{
    using namespace optics;
    // Two candidates beside a ray: the nearer in angle counts, unless it is sky and the other hides it.
    auto chosen = [](const Inputs& i) {
        const vec3 U(i.a.x, i.a.y - 1.0f, -3.0f - 4.0f * i.a.w);
        const vec3 R = glm::normalize(vec3(i.b.x, 0.2f + i.b.y, -0.5f - i.b.w));
        auto choice = mirrorBegin(U, R, vec3(0.0f, 1.0f, 0.0f));
        choice = mirrorConsider(choice, U + R, U + 5.0f * R + 0.4f * xyz(i.c), false);
        return mirrorConsider(choice, U + 2.0f * R, U + 900.0f * R + 1.0f, true);
    };
    const std::string U = "vec3(a.x, a.y - 1.0, -3.0 - 4.0 * a.w)", R = "normalize(vec3(b.x, 0.2 + b.y, -0.5 - b.w))";
    const std::string begun = "mirrorBegin(" + U + ", " + R + ", vec3(0.0, 1.0, 0.0))";
    const std::string near =
        "mirrorConsider(" + begun + ", " + U + " + " + R + ", " + U + " + 5.0 * " + R + " + 0.4 * c.xyz, false)";
    const std::string far =
        "mirrorConsider(" + near + ", " + U + " + 2.0 * " + R + ", " + U + " + 900.0 * " + R + " + 1.0, true)";
    const std::string place = "vec4(mirrorChosen(" + far + "), 0.0)";
    const std::string angles =
        "vec4(" + far + ".leastMiss, " + far + ".leastGeometryMiss, mirrorMiss(" + far + "), 0.0)";
    check({
        {"mirrorChosen", place.c_str(), [chosen](const Inputs& i) { return wide(mirrorChosen(chosen(i))); }, 1e-5f},
        {"mirrorConsider", angles.c_str(),
         [chosen](const Inputs& i) {
             const auto choice = chosen(i);
             return vec4(choice.leastMiss, choice.leastGeometryMiss, mirrorMiss(choice), 0.0f);
         },
         1e-5f},
    });
}

} // namespace
} // namespace tarn
