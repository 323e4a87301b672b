// Bad scene files: each is one line that names file, line, key and what to do.
#include "base/error.h"
#include "base/log.h"
#include "scene/scene_file.h"
#include "temp_folder.h"

namespace tarn::test {
namespace {

const std::string bed = "[[primitives]]\nname = 'bed'\nkind = 'plane'\n"; // lines 1 to 3

class BadTomlTest : public ::testing::Test {
protected:
    TempFolder folder;
    log::Capture log;

    std::string problem(const std::string& text)
    {
        const auto file = folder.file("test.toml", text);
        return messageOf<Error>([&] { loadScene(file); });
    }
    /// What follows `bed`, starting at line 4, and the message from "test.toml:LINE: " on.
    void expectProblem(const std::string& text, int line, const std::string& message)
    {
        SCOPED_TRACE(text);
        EXPECT_CONTAINS(problem(bed + text), "test.toml:" + std::to_string(line) + ": " + message);
    }
};

TEST_F(BadTomlTest, NothingToOpenOrDraw)
{
    EXPECT_CONTAINS(messageOf<Error>([&] { loadScene(folder.path() / "none.toml"); }), "none.toml: no such file");
    EXPECT_CONTAINS(messageOf<Error>([&] { loadScene(folder.path()); }), "is a directory");
    EXPECT_CONTAINS(problem(""), "test.toml: the file is empty");
    EXPECT_CONTAINS(problem(" \n\r\n"), "test.toml: the file is empty");
    EXPECT_CONTAINS(problem("name = 'x'\n"), "test.toml: nothing to draw");
    EXPECT_CONTAINS(problem("[[models]]\nname = 'x'\nfile = 'none.obj'\n"), "none.obj: no such file");
    EXPECT_CONTAINS(problem("[[models]]\nname = 'x'\nfile = 'a.obj'\n[[models]]\nname = 'y'\nfile = 'b.obj'\n"),
                    "a.obj: no such file");
    EXPECT_CONTAINS(problem(bed + "[[elements]]\nname = 'a group of nothing'\n"), "nothing to draw");
    EXPECT_CONTAINS(problem(bed + "[[elements]]\nshape = 'bed'\nvisible = false\n"), "nothing to draw");
}

TEST_F(BadTomlTest, NotToml)
{
    EXPECT_CONTAINS(problem("name = 'x'\nthis is no toml\n"), "test.toml:2: not valid TOML");
    EXPECT_CONTAINS(problem(std::string("\x80\x01\x00\xff junk", 9)), "test.toml:1: not valid TOML");
    EXPECT_CONTAINS(problem("name = 'cut"), "test.toml:1: not valid TOML");
    EXPECT_CONTAINS(problem("a = 1\na = 2\n"), "test.toml:2: not valid TOML");
}

TEST_F(BadTomlTest, NormalMapsOfWater)
{
    expectProblem("[water]\nnormal_map_bump = 0.5\n", 5, "water.normal_map_bump needs a normal_map");
    expectProblem("[water]\n[[water.normal_layers]]\nvelocity = [1, 2]\n", 5, "water.normal_layers needs a normal_map");
    expectProblem("[water]\nnormal_map = 'a.png'\nnormal_map_bump = 1.5\n", 6, "water.normal_map_bump");
    expectProblem("[water]\nnormal_map = 'a.png'\nnormal_map_tile = 0\n", 6, "water.normal_map_tile");
    expectProblem("[water]\nnormal_map = 'a.png'\n[[water.normal_layers]]\nvelocity = [1, 2]\n", 6,
                  "water.normal_layers must be 4, not 1");
}

/// As every picture: the rest can be drawn, and is.
TEST_F(BadTomlTest, NormalMapsOfWaterThatCannotBeUsedAreWarnings)
{
    Image image;
    image.width = image.height = 2;
    image.channels = 3;
    image.bytes = {128, 255, 128, 128, 255, 128,
                   128, 255, 128, 128, 120, 255}; // the last one as tangent-space maps are
    writeImage(folder.path() / "blue.png", image);
    image.channels = 1;
    image.bytes.resize(4);
    writeImage(folder.path() / "grey.png", image);
    folder.file("no.png", "no picture");
    const std::pair<const char*, const char*> cases[] = {{"none.png", "no such picture"},
                                                         {"no.png", "no.png"},
                                                         {"grey.png", "a normal map needs three channels"},
                                                         {"blue.png", "0.47 at (1, 1)"}};
    for (const auto& [name, message] : cases) {
        SCOPED_TRACE(name);
        const std::size_t before = log.messages().size();
        const Scene scene =
            loadScene(folder.file("test.toml", bed + "[water]\nnormal_map = '" + std::string(name) + "'\n"));
        EXPECT_FALSE(scene.water.normalMap.isSeen());
        ASSERT_EQ(log.messages().size(), before + 1);
        EXPECT_CONTAINS(log.messages().back().text, "test.toml:5: ");
        EXPECT_CONTAINS(log.messages().back().text, message);
    }
}

TEST_F(BadTomlTest, UnknownKeysSuggestTheNearest)
{
    expectProblem("[water]\nlevle = 0\n", 5, "there is no key 'levle' in water; did you mean 'level'?");
    expectProblem("[watr]\n", 4, "there is no key 'watr' in a scene file; did you mean 'water'?");
    expectProblem("[[cameras]]\nname = 'a'\neye = [0, 0, 1]\nfow = 3\n", 7,
                  "there is no key 'fow' in cameras; did you mean 'fov'?");
    expectProblem("[[water.waves]]\nlength = 3\n", 5, "there is no key 'length' in water.waves");
    expectProblem("colour = 3\n", 4, "there is no key 'colour' in primitives");
}

TEST_F(BadTomlTest, WrongTypes)
{
    expectProblem("[water]\nlevel = 'high'\n", 5, "water.level must be a number, not a string");
    expectProblem("[water]\ncentre = 3\n", 5, "water.centre must be 2 numbers in brackets, not an integer");
    expectProblem("[water]\nabsorption = [1, 2]\n", 5,
                  "water.absorption must be 3 numbers in brackets or one number, not 2");
    expectProblem("[water]\nabsorption = [1, 2, 'x']\n", 5, "water.absorption must be a number, not a string");
    expectProblem("[water]\nwaves = 3\n", 5, "water.waves must be tables [[waves]], not an integer");
    expectProblem("[[elements]]\nvisible = 1\n", 5, "elements.visible must be true or false, not an integer");
    expectProblem("segments = 2.5\n", 4, "primitives.segments must be a whole number");
    expectProblem("[[models]]\nname = 3\nfile = 'x.obj'\n", 5, "models.name must be a string in quotes");
    expectProblem("[sun]\nirradiance = 'bright'\n", 5, "sun.irradiance must be \"auto\", a number or three");
    expectProblem("[sun]\nirradiance = true\n", 5, "sun.irradiance must be 3 numbers in brackets or one number");
    EXPECT_CONTAINS(problem("water = 3\n" + bed), "test.toml:1: water must be a table [water], not an integer");
    EXPECT_CONTAINS(problem("name = 3\n" + bed), "test.toml:1: name must be a string in quotes");
}

TEST_F(BadTomlTest, OutOfRange)
{
    expectProblem("[water]\nlevel = nan\n", 5, "water.level must be a finite number");
    expectProblem("[water]\nlevel = -inf\n", 5, "water.level must be a finite number");
    expectProblem("[water]\nior = 0.9\n", 5, "water.ior must be 1 to 4, not 0.9");
    expectProblem("[water]\nextent = [10, 0]\n", 5, "water.extent must be more than 0 and at most 1000000 m, not 0");
    expectProblem("[water]\nabsorption = -1\n", 5, "water.absorption must be 0 to 1000 1/m, not -1");
    expectProblem("[[water.waves]]\nwavelength = -2\n", 5, "water.waves.wavelength must be more than 0");
    expectProblem("[[water.waves]]\namplitude = -2\n", 5, "water.waves.amplitude must be 0 to 1000 m, not -2");
    expectProblem("[sun]\nelevation = 91\n", 5, "sun.elevation must be -90 to 90 degrees, not 91");
    expectProblem("[sun]\ndirection = [0, 0, 0]\n", 5, "sun.direction must not be zero");
    expectProblem("[sun]\ndirection = [0, 1, 0]\nelevation = 3\n", 5, "sun.direction excludes elevation");
    expectProblem("[sky]\nturbidity = 1\n", 5, "sky.turbidity must be 2 to 10, not 1");
    expectProblem("[sky]\nkind = 'cloudy'\n", 5, "sky.kind must be one of constant, daylight, picture, not 'cloudy'");
    expectProblem("[sky]\nkind = 'picture'\n", 4, "sky.file is missing");
    expectProblem("segments = 0\n", 4, "primitives.segments must be 1 to 1024, not 0");
    expectProblem("segments = 99999999999\n", 4, "primitives.segments must be 1 to 1024");
    expectProblem("size = [1, 1, -1]\n", 4, "primitives.size must be more than 0");
    expectProblem("[[elements]]\nshape = 'bed'\nscale = [1, 0, 1]\n", 6, "elements.scale must not be zero");
}

TEST_F(BadTomlTest, TooManyWaves)
{
    std::string text;
    for (int i = 0; i < 65; ++i) text += "[[water.waves]]\n";
    expectProblem(text, 4 + 64, "more than 64 waves");
}

TEST_F(BadTomlTest, Cameras)
{
    const auto camera = [&](const std::string& keys, int line, const std::string& message) {
        expectProblem("[[cameras]]\nname = 'c'\n" + keys, line, "cameras." + message);
    };
    camera("eye = [1, 2, 3]\ntarget = [1, 2, 3]\n", 7, "target must differ from the eye");
    camera("up = [0, 0, 0]\n", 6, "up must not be zero");
    camera("eye = [0, 5, 0]\ntarget = [0, 0, 0]\n", 4, "up must not lie along the view");
    camera("fov = 0\n", 6, "fov must be 1 to 170 degrees, not 0");
    camera("fov = 180\n", 6, "fov must be 1 to 170 degrees, not 180");
    camera("near = 0\n", 6, "near must be more than 0");
    camera("near = 5\nfar = 2\n", 6, "near must be smaller than far");
    expectProblem("[[cameras]]\neye = [0, 1, 2]\n", 4, "cameras.name is missing");
    expectProblem("[[cameras]]\nname = 'c'\n[[cameras]]\nname = 'c'\n", 7, "cameras.name 'c' is already taken");
}

TEST_F(BadTomlTest, References)
{
    expectProblem("[[elements]]\nshape = 'bde'\n", 5,
                  "elements.shape names no model or primitive: 'bde'; did you mean 'bed'?");
    expectProblem("material = 'gold'\n", 4, "primitives.material names no material: 'gold'");
    expectProblem("[[models]]\nname = 'm'\nfile = 'x.obj'\nmaterial = 'gold'\n", 7,
                  "models.material names no material: 'gold'");
    expectProblem("[[models]]\nname = 'bed'\nfile = 'x.obj'\n", 2, "primitives.name 'bed' is already taken");
    expectProblem("[[models]]\nname = 'm'\n", 4, "models.file is missing");
    expectProblem("[[primitives]]\nname = 'x'\n", 4, "primitives.kind is missing");
    expectProblem("[[materials]]\nname = 'm'\nnormal_map = 'a.png'\nbump_map = 'b.png'\n", 7,
                  "materials.bump_map excludes normal_map");
}

TEST_F(BadTomlTest, SpotLights)
{
    expectProblem("[[spot_lights]]\ndirection = [0, 0, 0]\n", 5, "spot_lights.direction must not be zero");
    expectProblem("[[spot_lights]]\ninner_angle = 50\nouter_angle = 40\n", 5,
                  "spot_lights.inner_angle must not be larger");
    expectProblem("[[spot_lights]]\nouter_angle = 90\n", 5, "spot_lights.outer_angle must be more than 0");
}

TEST_F(BadTomlTest, Options)
{
    expectProblem("[options]\na.b = [[1], [2]]\n", 5, "options.a.b must hold numbers, not arrays");
    expectProblem("[options]\na.b = 1979-05-27\n", 5, "options.a.b must be a value, not a date or time");
    EXPECT_CONTAINS(problem("options = 3\n" + bed), "options must be a table");
}

TEST_F(BadTomlTest, ElementsNestedTooDeep)
{
    std::string text, header = "elements";
    for (int i = 0; i < 70; ++i) {
        text += "[[" + header + "]]\n";
        header += ".children";
    }
    EXPECT_CONTAINS(problem(bed + text), "nested more than 64 deep");
}

} // namespace
} // namespace tarn::test
