// `tarn compare` on files of every kind, good and bad.
#include "app/commands.h"
#include "base/error.h"
#include "base/files.h"
#include "base/log.h"
#include "scene/image.h"

#include "temp_folder.h"

#include <nlohmann/json.hpp>

#include <limits>

namespace tarn {
namespace {

class Compare : public testing::Test {
protected:
    /// A linear picture of 4x3 pixels.
    std::filesystem::path linear(const std::string& name, float value, const std::string& settings = "",
                                 int channels = 3, const std::vector<std::string>& names = {}) const
    {
        Image image{name, 4, 3, channels, {}, {}};
        image.floats.assign(image.size(), value);
        std::map<std::string, std::string> header;
        if (!settings.empty()) header["tarn:settings"] = settings;
        writeImage(folder_.path() / name, image, header, names);
        return folder_.path() / name;
    }
    std::filesystem::path shown(const std::string& name, std::uint8_t value, int width = 4, int channels = 3) const
    {
        Image image{name, width, 3, channels, {}, {}};
        image.bytes.assign(image.size(), value);
        writeImage(folder_.path() / name, image);
        return folder_.path() / name;
    }
    nlohmann::json figures(CompareCommand command) const
    {
        command.json = (folder_.path() / "figures.json").string();
        testing::internal::CaptureStdout();
        run(command);
        printed_ = testing::internal::GetCapturedStdout();
        return nlohmann::json::parse(readFile(command.json));
    }
    static CompareCommand of(const std::filesystem::path& reference, const std::filesystem::path& test)
    {
        CompareCommand command;
        command.reference = reference;
        command.test = test;
        return command;
    }
    static std::string complaint(const CompareCommand& command)
    {
        return test::messageOf<Error>([&] { run(command); });
    }

    test::TempFolder folder_;
    mutable std::string printed_;
};

constexpr auto settings = R"({"frame": {"exposure": 0.5, "tone_curve": "reinhard"}, "water": {"level": 1}})";

TEST_F(Compare, PicturesAsShown)
{
    const auto json = figures(of(shown("a.png", 0), shown("b.png", 255)));
    EXPECT_NEAR(json["flip"], 0.9674, 1e-3);
    EXPECT_NEAR(json["rmse"], 1.0, 1e-6);
    EXPECT_NEAR(json["psnr"], 0.0, 1e-6);
    EXPECT_EQ(json["size"], nlohmann::json({4, 3}));
    EXPECT_FALSE(json.contains("exposure"));
    EXPECT_CONTAINS(printed_, "mean FLIP");
    EXPECT_EQ(printed_.find("tone curve"), std::string::npos) << printed_;
    EXPECT_TRUE(figures(of(shown("a.png", 7), shown("b.png", 7)))["psnr"].is_null());
}

TEST_F(Compare, LinearPicturesWithTheReferencesExposure)
{
    const auto json = figures(of(linear("a.exr", 1.0f, settings), linear("b.exr", 3.0f, settings)));
    EXPECT_EQ(json["exposure"]["value"], 0.5);
    EXPECT_EQ(json["tone_curve"]["value"], "reinhard");
    EXPECT_NEAR(json["rmse"], 1.0, 1e-6); // (3 - 1) · 0.5
    EXPECT_CONTAINS(printed_, "from " + (folder_.path() / "a.exr").string());
    EXPECT_CONTAINS(printed_, "reinhard");
}

TEST_F(Compare, TheCommandLineWinsOverTheHeaderAndTheHeaderOverTheDefaults)
{
    auto command = of(linear("a.exr", 1.0f), linear("b.exr", 3.0f));
    EXPECT_EQ(figures(command)["exposure"], (nlohmann::json{{"value", 1.0}, {"origin", "default"}}));
    EXPECT_EQ(figures(command)["tone_curve"]["value"], "aces");
    linear("b.exr", 3.0f, settings);
    EXPECT_EQ(figures(command)["exposure"]["value"],
              0.5); // the reference's header says nothing, the test's does
    command.exposure = 2.0;
    command.toneCurve = "linear";
    const auto json = figures(command);
    EXPECT_EQ(json["exposure"], (nlohmann::json{{"value", 2.0}, {"origin", "--exposure"}}));
    EXPECT_EQ(json["tone_curve"]["value"], "linear");
    EXPECT_EQ(json["flip"], 0.0); // both are white
    EXPECT_NEAR(json["rmse"], 4.0, 1e-6);
}

TEST_F(Compare, WarnsWhenTheTwoWereShownDifferently)
{
    const log::Capture messages;
    figures(of(linear("a.exr", 1.0f, settings), linear("b.exr", 1.0f, R"({"frame": {"exposure": 0.25}})")));
    EXPECT_TRUE(messages.contains("b.exr was made with another exposure"));
}

TEST_F(Compare, ALinearPictureWithOneAsShown)
{
    // Linear 0.5 is 188 of sRGB.
    auto command = of(linear("a.exr", 0.5f), shown("b.png", 188));
    command.toneCurve = "linear";
    const auto json = figures(command);
    EXPECT_EQ(json["flip"], 0.0);
    EXPECT_EQ(json["rmse"], 0.0);
    EXPECT_CONTAINS(json["values"].get<std::string>(), "8-bit");
}

TEST_F(Compare, FindsColourAmongTheChannelsOfAReference)
{
    const auto picture = linear("a.exr", 0.5f, "", 6, {"R", "G", "B", "N.X", "N.Y", "events"});
    EXPECT_EQ(figures(of(picture, linear("b.exr", 0.5f)))["rmse"], 0.0);
    EXPECT_CONTAINS(complaint(of(linear("n.exr", 1.0f, "", 3, {"X", "Y", "Z"}), picture)), "n.exr: has no channel R");
}

TEST_F(Compare, WritesTheMapAsColoursOrAsValues)
{
    auto command = of(shown("a.png", 0), shown("b.png", 255));
    command.out = folder_.path() / "heat.png";
    figures(command);
    EXPECT_EQ(readImage(command.out).channels, 3);
    command.out = folder_.path() / "map.exr";
    const auto json = figures(command);
    const Image map = readImage(command.out);
    EXPECT_EQ(map.channels, 1);
    EXPECT_NEAR(map.floats[0], json["flip"], 1e-6);
}

TEST_F(Compare, FailsOverTheLimitAfterSayingAll)
{
    auto command = of(shown("a.png", 0), shown("b.png", 255));
    command.maxFlip = 0.5;
    testing::internal::CaptureStdout();
    EXPECT_CONTAINS(complaint(command), "mean FLIP 0.96");
    EXPECT_CONTAINS(testing::internal::GetCapturedStdout(), "mean FLIP");
    command.maxFlip = 0.97;
    EXPECT_LT(figures(command)["flip"], 0.97);
}

TEST_F(Compare, BadPicturesAreOneLine)
{
    const auto good = shown("good.png", 1);
    EXPECT_CONTAINS(complaint(of(good, folder_.path() / "no.png")), "no.png: no such picture");
    EXPECT_CONTAINS(complaint(of(folder_.path() / "no.exr", good)), "no.exr: no such picture");
    EXPECT_CONTAINS(complaint(of(folder_.file("text.png", "no picture"), good)), "text.png");
    EXPECT_CONTAINS(complaint(of(good, shown("wide.png", 1, 5))), "wide.png: has 5x3 pixels, and");
    EXPECT_CONTAINS(complaint(of(good, shown("grey.png", 1, 4, 1))), "grey.png: has 1 channel;");
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_CONTAINS(complaint(of(linear("nan.exr", nan), good)), "nan.exr: the red of pixel 0,0 is NaN");
}

TEST_F(Compare, DamagedSettingsAreNotGuessed)
{
    const auto good = linear("good.exr", 1.0f);
    EXPECT_CONTAINS(complaint(of(linear("a.exr", 1.0f, "{"), good)), "a.exr: its tarn:settings are damaged");
    EXPECT_CONTAINS(complaint(of(linear("b.exr", 1.0f, R"({"frame": {"exposure": "much"}})"), good)),
                    "b.exr: frame.exposure must be a number");
    auto command = of(folder_.path() / "a.exr", good);
    command.exposure = 1.0;
    command.toneCurve = "aces";
    EXPECT_EQ(figures(command)["flip"], 0.0);
}

TEST_F(Compare, ExposureIsForLinearPictures)
{
    auto command = of(shown("a.png", 1), shown("b.png", 1));
    command.exposure = 1.0;
    EXPECT_CONTAINS(test::messageOf<UsageError>([&] { run(command); }), "neither is one");
}

} // namespace
} // namespace tarn
