// make_terrain: draws assets/bench, the terrain that water renderers are compared on: hills round a lake.
//
// 224 x 224 cells over 100 m x 100 m are 100,352 triangles. The height over the water is
//
//     h = 12 m (0.6 (3 r^2 - 1) + 0.25 noise)        r: distance from the middle over 50 m
//
// with smooth value noise from -1 to 1. Only sums, products and quotients of doubles are used, so that the
// files are the same on every machine.

#include "base/error.h"
#include "base/files.h"
#include "scene/image.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iostream>

namespace tarn {

namespace {

constexpr const char* usage = "usage: make_terrain --out FOLDER";
constexpr int cells = 224;          // along each edge
constexpr double halfExtent = 50.0; // m
constexpr int cellsPerTile = 16;    // that the picture of the ground covers
constexpr int texels = 512;         // along an edge of that picture
constexpr std::uint32_t seed = 18;

double fade(double t) { return t * t * t * (t * (6.0 * t - 15.0) + 10.0); }
double mix(double a, double b, double t) { return a + (b - a) * t; }

/// -1 to 1, for a point of the lattice.
double latticeValue(int x, int z, std::uint32_t layer)
{
    std::uint32_t h = (seed + layer) * 0x9e3779b9u;
    for (const int word : {x, z}) {
        h ^= static_cast<std::uint32_t>(word);
        h *= 0x85ebca6bu;
        h ^= h >> 13;
        h *= 0xc2b2ae35u;
        h ^= h >> 16;
    }
    return static_cast<double>(h) / 2147483647.5 - 1.0;
}

int wrapped(int i, int period) { return period > 0 ? ((i % period) + period) % period : i; }

/// Value noise, -1 to 1, with a lattice of spacing 1. With a period it repeats after so many cells.
double valueNoise(double x, double z, std::uint32_t layer, int period = 0)
{
    const double floorX = std::floor(x), floorZ = std::floor(z);
    const int i = static_cast<int>(floorX), k = static_cast<int>(floorZ);
    const auto at = [&](int di, int dk) {
        return latticeValue(wrapped(i + di, period), wrapped(k + dk, period), layer);
    };
    const double u = fade(x - floorX), v = fade(z - floorZ);
    return mix(mix(at(0, 0), at(1, 0), u), mix(at(0, 1), at(1, 1), u), v);
}

/// Octaves of half the amplitude at twice the frequency each; -1 to 1.
double octaves(double x, double z, int count, std::uint32_t layer, int period = 0)
{
    double sum = 0.0, amplitude = 1.0, total = 0.0;
    for (int octave = 0; octave < count; ++octave) {
        sum += amplitude * valueNoise(x, z, layer + static_cast<std::uint32_t>(octave), period);
        total += amplitude;
        amplitude *= 0.5;
        x *= 2.0;
        z *= 2.0;
        period *= 2;
    }
    return sum / total;
}

/// m above the water, at a place in m from the middle.
double height(double x, double z)
{
    constexpr double latticeSpacing = 14.0; // m
    constexpr int octaveCount = 4;
    const double rSquared = (x * x + z * z) / (halfExtent * halfExtent);
    const double noise = octaves(x / latticeSpacing, z / latticeSpacing, octaveCount, 0);
    return 12.0 * (0.6 * (3.0 * rSquared - 1.0) + 0.25 * noise);
}

double coordinate(int line) { return halfExtent * (2.0 * line / cells - 1.0); }

/// Without trailing zeros, and never "-0".
std::string number(double value, int decimals)
{
    std::string text = fmt::format("{:.{}f}", value, decimals);
    if (text.find('.') != std::string::npos) text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return text == "-0" ? "0" : text;
}

/// Indices count back from the face's own line, which makes the file a third smaller; normals are left to the
/// reader, who smooths them.
std::string terrainObj()
{
    std::string text = "# Made by make_terrain; see README.md in this folder.\nmtllib terrain.mtl\no "
                       "terrain\ns 1\nusemtl ground\n";
    for (int row = 0; row <= cells; ++row)
        for (int column = 0; column <= cells; ++column) {
            const double x = coordinate(column), z = coordinate(row);
            text += fmt::format("v {} {} {}\nvt {} {}\n", number(x, 3), number(height(x, z), 3), number(z, 3),
                                number(static_cast<double>(column) / cellsPerTile, 4),
                                number(static_cast<double>(-row) / cellsPerTile, 4));
            if (row == 0 || column == 0) continue;
            constexpr int above = cells + 2; // how far back the vertex of the row before is
            const auto corner = [](int back) { return fmt::format(" -{0}/-{0}", back); };
            text += "f" + corner(1) + corner(above) + corner(above + 1) + "\n";
            text += "f" + corner(1) + corner(above + 1) + corner(2) + "\n";
        }
    return text;
}

constexpr const char* materials = R"(# Made by make_terrain; see README.md in this folder.
newmtl ground
Kd 1 1 1
map_Kd ground.jpg
)";

/// Grass with bare earth between, seamless; sRGB.
Image groundPicture()
{
    constexpr double grass[3] = {92, 108, 52}, dryGrass[3] = {124, 124, 70}, earth[3] = {112, 98, 70};
    Image image;
    image.name = "ground";
    image.width = image.height = texels;
    image.channels = 3;
    for (int row = 0; row < texels; ++row)
        for (int column = 0; column < texels; ++column) {
            const double u = (column + 0.5) / texels, v = (row + 0.5) / texels;
            const double patches = octaves(6.0 * u, 6.0 * v, 4, 100, 6);
            const double bare = std::clamp(3.0 * (octaves(5.0 * u, 5.0 * v, 5, 200, 5) - 0.12), 0.0, 1.0);
            const double blade = 1.0 + 0.22 * octaves(64.0 * u, 64.0 * v, 2, 300, 64);
            for (int c = 0; c < 3; ++c) {
                const double green = mix(grass[c], dryGrass[c], std::clamp(0.5 + 0.8 * patches, 0.0, 1.0));
                const double value = mix(green, earth[c], bare) * blade;
                image.bytes.push_back(static_cast<std::uint8_t>(std::clamp(std::lround(value), 0l, 255l)));
            }
        }
    return image;
}

/// Where the ground towards -x rises over a height, m from the middle.
double shoreDistance(double above)
{
    double distance = 0.0;
    while (height(-distance, 0.0) < above) distance += 0.05;
    return distance;
}

std::string sceneText()
{
    constexpr double standing = 0.3, eyeHeight = 1.7; // m
    const double shore = -shoreDistance(standing);
    std::string text = R"(# Made by make_terrain; see README.md in this folder.
name = "The terrain of comparisons"

[options]
frame.exposure = 0.065

[sun]
elevation = 38.5
azimuth = 48.0

[sky]
kind = "daylight"
turbidity = 2.6

[water]
level = 0.0
extent = [70, 70]
ior = 1.33
absorption = [0.36, 0.085, 0.115]
colour = [0.006, 0.026, 0.028]
)";
    struct Sine {
        double amplitude, wavelength, direction, phase; // m, m, degrees, degrees
    };
    constexpr Sine sines[] = {{0.018, 6.1, 60, 14},
                              {0.015, 4.3, -11, 169},
                              {0.011, 2.9, 66, 270},
                              {0.008, 2.0, -25, 310},
                              {0.005, 1.3, 54, 242}};
    for (const Sine& s : sines)
        text += fmt::format("\n[[water.waves]]\namplitude = {}\nwavelength = {}\ndirection = {}\nphase = {}\n",
                            s.amplitude, s.wavelength, s.direction, s.phase);
    text += R"(
[[models]]
name = "terrain"
file = "terrain.obj"

[[elements]]
name = "terrain"
shape = "terrain"
)";
    struct View {
        const char* name;
        double eye[3], target[3], fov; // m, m, degrees
    };
    const View views[] = {
        {"shore", {shore, height(shore, 0.0) + eyeHeight, 0.0}, {30.0, -1.0, -8.0}, 50.0},
        {"above", {0.0, 115.0, 66.0}, {0.0, 0.0, 3.0}, 54.0},
    };
    for (const View& view : views)
        text += fmt::format("\n[[cameras]]\nname = \"{}\"\neye = [{:.3f}, {:.3f}, {:.3f}]\ntarget = [{:.3f}, "
                            "{:.3f}, {:.3f}]\n"
                            "fov = {:.1f}\nnear = 0.1\nfar = 400.0\n",
                            view.name, view.eye[0], view.eye[1], view.eye[2], view.target[0], view.target[1],
                            view.target[2], view.fov);
    return text;
}

void run(int count, char** words)
{
    if (count != 3 || std::string_view(words[1]) != "--out") throw UsageError("{}", usage);
    const std::filesystem::path folder = words[2];
    makeFolder(folder);
    writeFile(folder / "terrain.obj", terrainObj());
    writeFile(folder / "terrain.mtl", materials);
    writeFile(folder / "terrain.toml", sceneText());
    writeImage(folder / "ground.jpg", groundPicture());
}

} // namespace

} // namespace tarn

int main(int argumentCount, char** arguments)
{
    try {
        tarn::run(argumentCount, arguments);
        return 0;
    } catch (const tarn::UsageError& error) {
        std::cerr << "make_terrain: error: " << error.what() << '\n';
        return 2;
    } catch (const std::exception& error) {
        std::cerr << "make_terrain: error: " << error.what() << '\n';
        return 1;
    }
}
