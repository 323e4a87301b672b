// The physics of shaders/shared as C++, from the same files that the GPU runs: tarn::optics in float,
// tarn::optics64 in double.
//
//     const vec3 below = optics::refractRay(direction, normal, 1.0f / water.ior);
//     const double F = optics64::fresnelExact(0.5, 1.0 / 1.33);
//
// What each function does, its units and its source stand in shaders/shared/*.glsl; their order there is the
// order here. The difference between the two namespaces is the rounding error of the formula, and tests
// measure it.
#pragma once

#include "base/math.h"
#include "optics/blocks.h"

#include <cmath>

namespace tarn {

// The GLSL names that the shared files use. Declared name by name, so that a shared file that reaches for
// another function fails to compile here rather than finding some `abs` for int.
// clang-format off
namespace optics {
using glm::vec2; using glm::vec3; using glm::vec4; using glm::mat3; using glm::mat4;
using blocks::GridAxis; using blocks::LightTerm; using blocks::WaveTerm; using blocks::maxLights; using blocks::maxWaves;
using glm::abs; using glm::clamp; using glm::cos; using glm::cross; using glm::dot; using glm::exp; using glm::exp2;
using glm::floor; using glm::length; using glm::log; using glm::max; using glm::min; using glm::mix; using glm::normalize;
using glm::pow; using glm::sin; using glm::sqrt;
} // namespace optics

namespace optics64 {
using glm::dvec2; using glm::dvec3; using glm::dvec4; using glm::dmat3; using glm::dmat4;
using glm::abs; using glm::clamp; using glm::cos; using glm::cross; using glm::dot; using glm::exp; using glm::exp2;
using glm::floor; using glm::length; using glm::log; using glm::max; using glm::min; using glm::mix; using glm::normalize;
using glm::pow; using glm::sin; using glm::sqrt;
} // namespace optics64
// clang-format on

// What shaders take from trigonometry.glsl.
namespace optics {
inline vec2 sineAndCosine(float angle) { return {std::sin(angle), std::cos(angle)}; }
} // namespace optics
namespace optics64 {
inline dvec2 sineAndCosine(double angle) { return {std::sin(angle), std::cos(angle)}; }
} // namespace optics64

} // namespace tarn

#define WAVE_WEIGHTS
#include "generated/blocks_double.h"
#include "generated/optics_double.h"
#include "generated/optics_float.h"
#undef WAVE_WEIGHTS
#undef EACH_WAVE // the loop of waves.glsl
