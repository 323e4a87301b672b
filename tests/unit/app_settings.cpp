// Who wins when several places set an option, the names of output files, and the choice of a camera.

#include "app/output.h"
#include "app/scene_setup.h"
#include "app/settings.h"
#include "base/error.h"
#include "base/files.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>
#include <unistd.h>

namespace tarn {
namespace {

namespace fs = std::filesystem;

class SettingsTest : public testing::Test {
protected:
    void SetUp() override { fs::create_directories(folder_); }
    void TearDown() override { fs::remove_all(folder_); }

    fs::path optionsFile(const std::string& text) const
    {
        writeFile(folder_ / "options.toml", text);
        return folder_ / "options.toml";
    }

    std::string complaint(const std::string& optionsText) const
    {
        try {
            resolveSettings(Scene{}, {{optionsFile(optionsText)}, {}});
        } catch (const UsageError& error) {
            return error.what();
        }
        return "";
    }

    fs::path folder_ = fs::temp_directory_path() / ("tarn settings " + std::to_string(getpid()));
};

TEST_F(SettingsTest, LaterPlacesWin)
{
    Scene scene;
    EXPECT_EQ(resolveSettings(scene, {}).options.refraction.steps, RefractionOptions{}.steps);
    scene.options = {{"refraction.steps", "11", "lake.toml:3"}};
    EXPECT_EQ(resolveSettings(scene, {}).options.refraction.steps, 11);
    const fs::path file = optionsFile("[refraction]\nsteps = 12\n");
    EXPECT_EQ(resolveSettings(scene, {{file}, {}}).options.refraction.steps, 12);
    EXPECT_EQ(resolveSettings(scene, {{file}, {"refraction.steps=13"}}).options.refraction.steps, 13);
    EXPECT_EQ(resolveSettings(scene, {{}, {"refraction.steps=13", "refraction.steps=14"}}).options.refraction.steps,
              14);
}

TEST_F(SettingsTest, WaterKeysReachBothTheBodyAndItsDrawing)
{
    Scene scene;
    scene.water.level = 3.0f;
    const Settings settings =
        resolveSettings(scene, {{}, {"water.grid_size=129", "water.ior=1.5", "water.absorption=0.1,0.2,0.3"}});
    EXPECT_EQ(settings.options.water.gridSize, 129);
    EXPECT_FLOAT_EQ(settings.water.level, 3.0f);
    EXPECT_FLOAT_EQ(settings.water.ior, 1.5f);
    EXPECT_EQ(settings.water.absorption, vec3(0.1f, 0.2f, 0.3f));
    const nlohmann::json json = nlohmann::json::parse(settingsJson(settings));
    EXPECT_EQ(json["water"]["grid_size"], 129);
    EXPECT_EQ(json["water"]["ior"], 1.5);
    EXPECT_EQ(json["refraction"]["camera"], "snell");
}

TEST_F(SettingsTest, EveryKindOfValueInAnOptionsFile)
{
    const fs::path file =
        optionsFile("water.absorption = [0.5, 1, 2.5]\n"
                    "[frame]\ntone_curve = \"reinhard\"\nexposure = 0.25\n[plan]\ncull_chunks = false\n"
                    "[refraction]\nsteps = 8 # whole\n");
    const Settings settings = resolveSettings(Scene{}, {{file}, {}});
    EXPECT_EQ(settings.water.absorption, vec3(0.5f, 1.0f, 2.5f));
    EXPECT_EQ(settings.options.frame.toneCurve, FrameOptions::ToneCurve::reinhard);
    EXPECT_FLOAT_EQ(settings.options.frame.exposure, 0.25f);
    EXPECT_FALSE(settings.options.plan.rules[static_cast<std::size_t>(RuleId::cullChunks)]);
    EXPECT_EQ(settings.options.refraction.steps, 8);
}

TEST_F(SettingsTest, MistakesNameFileAndLine)
{
    const std::string unknown = complaint("[refraction]\n\nstep = 3\n");
    EXPECT_NE(unknown.find("options.toml:3"), std::string::npos) << unknown;
    EXPECT_NE(unknown.find("refraction.steps"), std::string::npos) << unknown;
    EXPECT_NE(complaint("[refraction]\nsteps = 65\n").find("options.toml:2"), std::string::npos);
    EXPECT_NE(complaint("[refraction]\nsteps = \"many\"\n").find("many"), std::string::npos);
    EXPECT_NE(complaint("[refraction]\nsteps = [[1]]\n").find("options.toml:2"), std::string::npos);
    EXPECT_NE(complaint("[refraction\n").find("options.toml:1"), std::string::npos);
    EXPECT_THROW(resolveSettings(Scene{}, {{folder_ / "missing.toml"}, {}}), Error);
}

TEST_F(SettingsTest, TheScenesMistakesAreNotWrongUsage)
{
    Scene scene;
    scene.options = {{"refraction.steps", "many", "lake.toml:3"}};
    try {
        resolveSettings(scene, {});
        FAIL() << "nothing was thrown";
    } catch (const UsageError&) {
        FAIL() << "the command line is not to blame";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("lake.toml:3"), std::string::npos);
    }
}

TEST_F(SettingsTest, OutputsAreCheckedBeforeAnyWork)
{
    EXPECT_NO_THROW(requireWritablePicture(folder_ / "a.png"));
    EXPECT_NO_THROW(requireWritablePicture(folder_ / "a.exr"));
    EXPECT_NO_THROW(requireWritablePicture("a.png"));
    EXPECT_THROW(requireWritablePicture(folder_ / "a.gif"), UsageError);
    EXPECT_THROW(requireWritablePicture(folder_ / "a"), UsageError);
    EXPECT_THROW(requireWritablePicture(folder_ / "nowhere" / "a.png"), Error);
    fs::create_directory(folder_ / "dir.png");
    EXPECT_THROW(requireWritablePicture(folder_ / "dir.png"), Error);
    EXPECT_THROW(requireWritableFolder(folder_ / "nowhere"), Error);
    EXPECT_THROW(requireWritableFolder(optionsFile("")), Error);
}

TEST(Output, SequencesNameTheirFiles)
{
    const auto files = sequenceFiles("a 100%/name_%04d.png", 3);
    ASSERT_EQ(files.size(), 3u);
    EXPECT_EQ(files[0], "a 100%/name_0000.png");
    EXPECT_EQ(files[2], "a 100%/name_0002.png");
    EXPECT_EQ(sequenceFiles("%d.exr", 11).back(), "10.exr");
    EXPECT_EQ(sequenceFiles("plain.png", 1).front(), "plain.png");
    EXPECT_EQ(sequenceFiles("%03d.png", 1).front(), "000.png");
    EXPECT_THROW(sequenceFiles("plain.png", 2), UsageError);
    EXPECT_THROW(sequenceFiles("%d_%d.png", 2), UsageError);
    EXPECT_THROW(sequenceFiles("%s.png", 2), UsageError);
}

TEST(Output, CameraNamesBecomeFileNames)
{
    EXPECT_EQ(fileNameFrom("pier_posts-2"), "pier_posts-2");
    EXPECT_EQ(fileNameFrom("under the  surface!"), "under-the-surface");
    EXPECT_EQ(fileNameFrom("../../etc/passwd"), "-..-etc-passwd");
    EXPECT_EQ(fileNameFrom(".hidden"), "hidden");
    EXPECT_EQ(fileNameFrom(""), "unnamed");
    EXPECT_EQ(fileNameFrom(".."), "unnamed");
}

Scene twoCameras()
{
    Scene scene;
    Camera pier;
    pier.name = "pier";
    Camera above;
    above.name = "above";
    above.eye = vec3(0.0f, 9.0f, 1.0f);
    scene.cameras = {pier, above};
    return scene;
}

TEST(ChooseCamera, NamedFirstAndReplacedParts)
{
    const Scene scene = twoCameras();
    EXPECT_EQ(chooseCamera(scene, {}).name, "pier");
    CameraArguments arguments;
    arguments.name = "above";
    arguments.target = vec3(5.0f, 0.0f, 0.0f);
    const Camera camera = chooseCamera(scene, arguments);
    EXPECT_EQ(camera.eye, vec3(0.0f, 9.0f, 1.0f));
    EXPECT_EQ(camera.target, vec3(5.0f, 0.0f, 0.0f));
}

TEST(ChooseCamera, NoViewIsAnError)
{
    const Scene scene = twoCameras();
    const auto complaint = [&](const CameraArguments& arguments) -> std::string {
        try {
            chooseCamera(scene, arguments);
        } catch (const UsageError& error) {
            return error.what();
        }
        return "";
    };
    CameraArguments misspelt;
    misspelt.name = "peir";
    EXPECT_NE(complaint(misspelt).find("did you mean pier?"), std::string::npos) << complaint(misspelt);
    CameraArguments point;
    point.eye = point.target = vec3(1.0f);
    EXPECT_NE(complaint(point), "");
    CameraArguments alongUp;
    alongUp.eye = vec3(0.0f, 5.0f, 0.0f);
    alongUp.target = vec3(0.0f);
    EXPECT_NE(complaint(alongUp).find("--up"), std::string::npos);
    alongUp.up = vec3(0.0f, 0.0f, -1.0f);
    EXPECT_EQ(complaint(alongUp), "");
}

} // namespace
} // namespace tarn
