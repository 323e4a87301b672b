// Maps of heights as pictures: what is written is read, and what no map can be is told in one line.
#include "base/error.h"
#include "scene/image.h"
#include "scene/map_picture.h"
#include "scene/scene_file.h"
#include "temp_folder.h"

#include <cmath>
#include <limits>

namespace tarn::test {
namespace {

/// Every value another.
HeightMapPicture anyMap(MapKind kind, int edge = 16)
{
    HeightMapPicture map;
    map.kind = kind;
    map.resolution = edge;
    map.centre = {1.1f, -20.3f};
    map.extent = {12.7f, 31.9f};
    map.lowest = kind == MapKind::bed ? -7.3f : 0.0f;
    map.light = MapLight{{0.6f, 0.7f, 0.1f}, {3.0f, 2.0f, 1.1f}, {0.3f, 0.4f, 0.5f}, 0.25f, 1.33f, {0.5f, 0.2f, 0.1f}};
    for (int i = 0; i < edge * edge; ++i) {
        const float x = static_cast<float>(i);
        if (kind == MapKind::bed)
            map.heights.push_back(-0.01f * x);
        else
            for (const float y : {1.0f + 0.01f * x, 2.0f + 0.03f * x, 1.0f + 0.01f * x}) map.heights.push_back(y);
        for (std::size_t c = 0; c < 6; ++c) map.colours[c / 3].push_back(0.1f * x + static_cast<float>(c));
    }
    return map;
}

void expectSame(const HeightMapPicture& a, const HeightMapPicture& b)
{
    EXPECT_EQ(a.resolution, b.resolution);
    EXPECT_EQ(a.centre, b.centre);
    EXPECT_EQ(a.extent, b.extent);
    EXPECT_EQ(a.lowest, b.lowest);
    EXPECT_EQ(a.heights, b.heights);
    EXPECT_EQ(a.colours, b.colours);
    ASSERT_EQ(a.light.has_value(), b.light.has_value());
    if (a.light) {
        EXPECT_EQ(a.light->difference(*b.light), "");
    }
}

class MapPictureTest : public ::testing::Test {
protected:
    TempFolder folder;
    std::filesystem::path file = folder.path() / "map.exr";

    /// Channels from elsewhere, without a word in the header.
    void write(int width, int height, const std::vector<std::string>& channels, float value = 1.0f,
               const std::map<std::string, std::string>& header = {})
    {
        Image image;
        image.width = width;
        image.height = height;
        image.channels = static_cast<int>(channels.size());
        image.floats.assign(image.size(), value);
        writeImage(file, image, header, channels);
    }
    std::string problem(MapKind kind) const
    {
        const std::string message = messageOf<Error>([&] { readMapPicture(file, kind); });
        EXPECT_CONTAINS(message, file.string() + ": ");
        return message;
    }
    std::string problemOf(HeightMapPicture map) const
    {
        writeMapPicture(file, map);
        return problem(map.kind);
    }
    const std::vector<std::string> bedChannels{"height",     "radiance.R", "radiance.G", "radiance.B",
                                               "response.R", "response.G", "response.B"};
};

TEST_F(MapPictureTest, IsReadAsItWasWritten)
{
    for (const MapKind kind : {MapKind::bed, MapKind::aboveWater}) {
        HeightMapPicture map = anyMap(kind);
        writeMapPicture(file, map, {{"tarn:scene", "a lake"}});
        const HeightMapPicture read = readMapPicture(file, kind);
        EXPECT_EQ(read.file, file);
        expectSame(map, read);
        map.light.reset();
        writeMapPicture(file, map);
        expectSame(map, readMapPicture(file, kind));
    }
}

TEST_F(MapPictureTest, APictureFromElsewhereNeedsNoHeader)
{
    write(32, 32, bedChannels, 0.5f);
    const HeightMapPicture map = readMapPicture(file, MapKind::bed);
    EXPECT_EQ(map.resolution, 32);
    EXPECT_EQ(map.extent, vec2(0.0f));
    EXPECT_EQ(map.lowest, -0.5f) << "under all of it";
    EXPECT_FALSE(map.light);
}

TEST_F(MapPictureTest, WhatIsNoMapIsRefused)
{
    EXPECT_CONTAINS(problem(MapKind::bed), "no such picture; check the path");
    folder.file("map.exr", "this is no EXR");
    EXPECT_CONTAINS(problem(MapKind::bed), "not a readable picture");
    write(32, 16, bedChannels);
    EXPECT_CONTAINS(problem(MapKind::bed), "square, but this picture has 32x16 pixels; scale or cut it");
    write(48, 48, bedChannels);
    EXPECT_CONTAINS(problem(MapKind::bed), "a power of two from 16 to 4096, not 48; scale it to 64");
    write(8, 8, bedChannels);
    EXPECT_CONTAINS(problem(MapKind::bed), "not 8; scale it to 16");
    write(16, 16, {"height", "radiance.R", "radiance.G", "radiance.B"});
    EXPECT_CONTAINS(problem(MapKind::bed), "has no channel response.R; a map 'bed' needs height, radiance.R");
    write(16, 16, bedChannels);
    EXPECT_CONTAINS(problem(MapKind::aboveWater),
                    "has no channel underside; a map 'above_water' needs underside, top, seen");
    write(16, 16, bedChannels, 1.0f, {{"tarn:extent", "12 metres"}});
    EXPECT_CONTAINS(problem(MapKind::bed), "tarn:extent must be 2 numbers, not '12 metres'");
    write(16, 16, bedChannels, 1.0f, {{"tarn:extent", "12 0"}});
    EXPECT_CONTAINS(problem(MapKind::bed), "tarn:extent must be more than 0 m");
}

TEST_F(MapPictureTest, ValuesThatNoMapCanHaveAreRefused)
{
    constexpr float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
    HeightMapPicture map = anyMap(MapKind::bed);
    map.heights[16 * 2 + 5] = nan;
    EXPECT_CONTAINS(problemOf(map), "height is nan at pixel (5, 2); it must be metres");
    map = anyMap(MapKind::bed);
    map.colours[0][3 * 7 + 1] = -1.0f;
    EXPECT_CONTAINS(problemOf(map), "radiance.G is -1 at pixel (7, 0); it must be 0 to 65504");
    map = anyMap(MapKind::bed);
    map.colours[1][0] = inf;
    EXPECT_CONTAINS(problemOf(map), "response.R is inf at pixel (0, 0)");
    map = anyMap(MapKind::aboveWater);
    map.heights[3 * 4 + 1] = 0.0f;
    EXPECT_CONTAINS(problemOf(map), "underside is 1.04 and top 0 at pixel (4, 0); the top may not be the lower");
    map = anyMap(MapKind::aboveWater);
    map.heights[3 * 4] = nothingAboveWater;
    map.heights[3 * 4 + 1] = map.heights[3 * 4 + 2] = -nothingAboveWater;
    writeMapPicture(file, map);
    EXPECT_NO_THROW(readMapPicture(file, MapKind::aboveWater)) << "nothing stands there";
}

TEST(MapLight, TellsWhatChanged)
{
    const MapLight then{{0.6f, 0.7f, 0.1f}, {3.0f, 2.0f, 1.1f}, {0.3f, 0.4f, 0.5f}, 0.0f, 1.33f, {0.5f, 0.2f, 0.1f}};
    MapLight now = then;
    now.sunIrradiance *= 1.0001f;
    EXPECT_EQ(then.difference(now), "");
    now.sunDirection.z = 0.2f;
    EXPECT_EQ(then.difference(now), "the sun");
    now.absorption.x = 0.6f;
    EXPECT_EQ(then.difference(now), "the sun and the water");
    now.skyIrradiance = vec3(0.0f);
    EXPECT_EQ(then.difference(now), "the sun and the sky and the water");
}

// A scene file and its maps.

constexpr const char* lake = "[[primitives]]\nname = 'bed'\nkind = 'plane'\n[water]\nextent = 20\n"; // lines 1 to 5

class SceneMapsTest : public MapPictureTest {
protected:
    std::filesystem::path scene(const std::string& text) { return folder.file("lake.toml", lake + text); }
    void expectProblem(const std::string& text, int line, const std::string& message)
    {
        EXPECT_CONTAINS(messageOf<Error>([&] { loadScene(scene(text)); }),
                        "lake.toml:" + std::to_string(line) + ": " + message);
    }
};

TEST_F(SceneMapsTest, AreLoadedAndSaved)
{
    writeMapPicture(file, anyMap(MapKind::bed));
    writeMapPicture(folder.path() / "over.exr", anyMap(MapKind::aboveWater));
    const Scene loaded = loadScene(scene(
        "[maps.bed]\nfile = 'map.exr'\n[maps.above_water]\nfile = 'over.exr'\ncentre = [1, 2]\nextent = [30, 40]\n"));
    ASSERT_TRUE(loaded.maps.bed.picture && loaded.maps.aboveWater.picture);
    expectSame(*loaded.maps.bed.picture, anyMap(MapKind::bed));
    EXPECT_EQ(loaded.maps.aboveWater.picture->centre, vec2(1.0f, 2.0f)) << "the scene file wins over the header";
    EXPECT_EQ(loaded.maps.aboveWater.picture->extent, vec2(30.0f, 40.0f));

    std::filesystem::create_directories(folder.path() / "elsewhere");
    const auto saved = folder.path() / "elsewhere" / "saved.toml";
    saveScene(loaded, saved);
    const Scene again = loadScene(saved);
    ASSERT_TRUE(again.maps.bed.picture && again.maps.aboveWater.picture);
    EXPECT_EQ(again.maps.bed.file, std::filesystem::path("../map.exr"));
    expectSame(*again.maps.bed.picture, *loaded.maps.bed.picture);
    expectSame(*again.maps.aboveWater.picture, *loaded.maps.aboveWater.picture);
}

TEST_F(SceneMapsTest, MistakesNameFileAndLine)
{
    expectProblem("[maps.bed]\nfile = 'none.exr'\n", 7, (folder.path() / "none.exr").string() + ": no such picture");
    expectProblem("[maps.bed]\n", 6, "maps.bed.file is missing");
    expectProblem("[maps.bde]\n", 6, "there is no key 'bde' in maps; did you mean 'bed'?");
    expectProblem("[maps.bed]\nflie = 'map.exr'\n", 7, "there is no key 'flie' in maps.bed; did you mean 'file'?");
    expectProblem("[maps.bed]\nfile = 'map.exr'\ncentre = [0, 0]\n", 6,
                  "maps.bed.extent is missing; a centre needs one");
    expectProblem("[maps.bed]\nfile = 'map.exr'\nextent = 0\n", 8, "maps.bed.extent must be more than 0");
    write(16, 16, bedChannels);
    expectProblem("[maps.bed]\nfile = 'map.exr'\n", 6,
                  "maps.bed.extent is missing; " + file.string() + " does not say how many metres it covers");
    expectProblem("[maps.bed]\nfile = 'map.exr'\ncentre = [15, 0]\nextent = 10\n", 7,
                  "maps.bed.file covers none of the water");
}

} // namespace
} // namespace tarn::test
