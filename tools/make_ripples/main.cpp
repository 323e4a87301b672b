// make_ripples: draws assets/water/ripples.png, a seamless map of the normals of rippled water.
//
// The surface is a sum of sines whose wave numbers over the picture are whole, so that it repeats at its edges: all of
// 3 to 16 waves along the picture, in every direction, each with a phase of its own and the longer the higher. Equal
// seeds give equal files.

#include "base/error.h"
#include "base/math.h"
#include "scene/image.h"

#include <fmt/format.h>

#include <cmath>
#include <iostream>
#include <numbers>
#include <random>

namespace tarn {

namespace {

constexpr const char* usage = "usage: make_ripples --out FILE.png";
constexpr int edge = 256; // texels
constexpr double leastWaves = 3.0, mostWaves = 16.0;
constexpr double falloff = 2.5;        // amplitude ~ wave number to the power of -falloff
constexpr double slopeDeviation = 0.2; // per axis, of one layer: the mean of four has half of it
constexpr std::uint32_t seed = 7;

struct Sine {
    int x, z; // waves along the picture's edges
    double amplitude, phase;
};

std::vector<Sine> randomSines()
{
    std::mt19937 random(seed);
    const auto unit = [&random] { return (static_cast<double>(random()) + 0.5) / 4294967296.0; };
    std::vector<Sine> sines;
    const int most = static_cast<int>(mostWaves);
    for (int x = 0; x <= most; ++x)
        for (int z = -most; z <= most; ++z) {
            if (x == 0 && z <= 0) continue; // the other half are the same sines
            const double waves = std::hypot(x, z);
            if (waves < leastWaves || waves > mostWaves) continue;
            // Rayleigh's distribution of amplitudes makes heights normal, as a wind sea's are.
            const double height = std::sqrt(-2.0 * std::log(unit()));
            sines.push_back({x, z, height * std::pow(waves, -falloff), 2.0 * std::numbers::pi * unit()});
        }
    return sines;
}

/// dh/du and dh/dv, for heights in edges of the picture.
std::vector<glm::dvec2> slopes(const std::vector<Sine>& sines)
{
    constexpr double twoPi = 2.0 * std::numbers::pi;
    std::vector<glm::dvec2> result;
    double squares = 0.0;
    for (int row = 0; row < edge; ++row)
        for (int column = 0; column < edge; ++column) {
            const double u = (column + 0.5) / edge, v = 1.0 - (row + 0.5) / edge; // +z is upward
            glm::dvec2 slope(0.0);
            for (const Sine& s : sines)
                slope += twoPi * s.amplitude * std::cos(twoPi * (s.x * u + s.z * v) + s.phase) * glm::dvec2(s.x, s.z);
            squares += 0.5 * glm::dot(slope, slope);
            result.push_back(slope);
        }
    const double scale = slopeDeviation / std::sqrt(squares / (edge * edge));
    for (glm::dvec2& slope : result) slope *= scale;
    return result;
}

Image normalMap()
{
    Image image;
    image.name = "ripples";
    image.width = image.height = edge;
    image.channels = 3;
    for (const glm::dvec2& slope : slopes(randomSines())) {
        const glm::dvec3 n = glm::normalize(glm::dvec3(-slope.x, 1.0, -slope.y));
        for (int c = 0; c < 3; ++c)
            image.bytes.push_back(static_cast<std::uint8_t>(std::lround((0.5 * n[c] + 0.5) * 255.0)));
    }
    return image;
}

void run(int count, char** words)
{
    if (count != 3 || std::string_view(words[1]) != "--out") throw UsageError("{}", usage);
    writeImage(words[2], normalMap());
}

} // namespace

} // namespace tarn

int main(int argumentCount, char** arguments)
{
    try {
        tarn::run(argumentCount, arguments);
        return 0;
    } catch (const tarn::UsageError& error) {
        std::cerr << "make_ripples: error: " << error.what() << '\n';
        return 2;
    } catch (const std::exception& error) {
        std::cerr << "make_ripples: error: " << error.what() << '\n';
        return 1;
    }
}
