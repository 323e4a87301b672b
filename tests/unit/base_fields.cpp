#include "base/error.h"
#include "base/fields.h"
#include "base/log.h"
#include "temp_folder.h"

#include <nlohmann/json.hpp>

#include <array>

namespace tarn::test {
namespace {

enum class Mode { slow, fast };
constexpr std::array modeNames{"slow", "fast"};

struct Sample {
    bool on = false;
    int steps = 3;
    float gain = 0.1f;
    vec2 size{1.0f, 2.0f};
    vec3 colour{0.5f};
    Mode mode = Mode::slow;

    FieldTree tree()
    {
        return [this](FieldVisitor& v) {
            v.enter("sample", "A sample");
            v.field({"on", "Switch"}, on);
            v.field({"steps", "Steps", "", 1, 64}, steps);
            v.enter("light", "Nested");
            v.field({"gain", "Gain", "dB", 0, 10}, gain);
            v.leave();
            v.field({"size", "Size", "m", 0.5}, size);
            v.field({"colour", "Colour", "", 0, 1}, colour);
            v.choice({"mode", "Mode"}, mode, modeNames);
            v.renamed("speed", "mode");
            v.leave();
        };
    }
    void set(const std::string& text) { assign(tree(), parseAssignment(text, "--set")); }
    std::string problem(const std::string& text)
    {
        return messageOf<UsageError>([&] { set(text); });
    }
};

TEST(Fields, AssignsEveryType)
{
    Sample s;
    s.set("sample.steps=12");
    s.set("sample.light.gain = 2.5");
    s.set("sample.size=3,4");
    s.set("sample.colour=0.1, 0.2,0.3");
    s.set("sample.mode=fast");
    EXPECT_EQ(s.steps, 12);
    EXPECT_FLOAT_EQ(s.gain, 2.5f);
    EXPECT_EQ(s.size, vec2(3.0f, 4.0f));
    EXPECT_EQ(s.colour, vec3(0.1f, 0.2f, 0.3f));
    EXPECT_EQ(s.mode, Mode::fast);
}

TEST(Fields, OneNumberFillsAVector)
{
    Sample s;
    s.set("sample.colour=0.25");
    s.set("sample.size=7");
    EXPECT_EQ(s.colour, vec3(0.25f));
    EXPECT_EQ(s.size, vec2(7.0f));
}

TEST(Fields, BoolHasThreeSpellings)
{
    Sample s;
    for (const char* yes : {"true", "on", "1"}) {
        s.on = false;
        s.set(std::string("sample.on=") + yes);
        EXPECT_TRUE(s.on) << yes;
    }
    for (const char* no : {"false", "off", "0"}) {
        s.on = true;
        s.set(std::string("sample.on=") + no);
        EXPECT_FALSE(s.on) << no;
    }
    EXPECT_CONTAINS(s.problem("sample.on=maybe"), "must be true or false, not 'maybe'");
}

TEST(Fields, WrongValuesNameKeyRangeAndUnit)
{
    Sample s;
    EXPECT_EQ(s.problem("sample.steps=65"), "--set: sample.steps must be 1 to 64, not '65'");
    EXPECT_EQ(s.problem("sample.light.gain=-1"), "--set: sample.light.gain must be 0 to 10 dB, not '-1'");
    EXPECT_EQ(s.problem("sample.size=0.1,1"), "--set: sample.size must be at least 0.5 m, not '0.1,1'");
    EXPECT_CONTAINS(s.problem("sample.steps=3.5"), "must be a whole number");
    EXPECT_CONTAINS(s.problem("sample.steps=99999999999"), "must be a whole number");
    EXPECT_CONTAINS(s.problem("sample.light.gain=abc"), "must be a number");
    EXPECT_CONTAINS(s.problem("sample.light.gain="), "must be a number");
    EXPECT_CONTAINS(s.problem("sample.light.gain=nan"), "must be finite");
    EXPECT_CONTAINS(s.problem("sample.size=inf"), "must be finite");
    EXPECT_CONTAINS(s.problem("sample.size=1e300"), "must be finite");
    EXPECT_CONTAINS(s.problem("sample.colour=1,2"), "three numbers");
    EXPECT_CONTAINS(s.problem("sample.colour=1,,0"), "three numbers");
    EXPECT_CONTAINS(s.problem("sample.mode=medium"), "must be one of slow, fast, not 'medium'");
}

TEST(Fields, AWrongValueChangesNothing)
{
    Sample s;
    s.problem("sample.colour=0.1,0.2,7");
    EXPECT_EQ(s.colour, vec3(0.5f));
}

TEST(Fields, UnknownKeySuggestsTheNearest)
{
    Sample s;
    EXPECT_EQ(s.problem("sample.stesp=3"), "--set: there is no option 'sample.stesp'; did you mean 'sample.steps'?");
    EXPECT_CONTAINS(s.problem("steps=3"), "did you mean 'sample.steps'?");
    EXPECT_CONTAINS(s.problem("zzzzzzzzzz=3"), "'tarn options' lists them");
}

TEST(Fields, AnOldNameStillSetsTheFieldAndSaysSo)
{
    Sample s;
    const log::Capture messages;
    s.set("sample.speed=fast");
    EXPECT_EQ(s.mode, Mode::fast);
    EXPECT_TRUE(messages.contains("--set: sample.speed is now called sample.mode"));
    EXPECT_EQ(s.problem("sample.speed=medium"), "--set: sample.mode must be one of slow, fast, not 'medium'");
    EXPECT_CONTAINS(s.problem("speed=fast"), "there is no option 'speed'");
}

TEST(Fields, AssignmentNeedsKeyAndEqualsSign)
{
    EXPECT_CONTAINS(messageOf<UsageError>([] { parseAssignment("steps", "--set"); }), "key=value");
    EXPECT_CONTAINS(messageOf<UsageError>([] { parseAssignment("=3", "--set"); }), "key=value");
    const Assignment a = parseAssignment("a.b = x=y ", "--set");
    EXPECT_EQ(a.key, "a.b");
    EXPECT_EQ(a.value, "x=y");
}

TEST(Fields, ListAndJsonShowTheSameTree)
{
    Sample s;
    const auto rows = listFields(s.tree());
    ASSERT_EQ(rows.size(), 6u);
    EXPECT_EQ(rows[2].key, "sample.light.gain");
    EXPECT_EQ(rows[2].value, "0.1");
    EXPECT_EQ(rows[2].unit, "dB");
    EXPECT_EQ(rows[2].range, "0 to 10");
    EXPECT_EQ(rows[5].range, "slow | fast");
    EXPECT_EQ(rows[5].value, "slow");

    const auto json = toJson(s.tree());
    EXPECT_EQ(json.dump(), R"({"sample":{"colour":[0.5,0.5,0.5],"light":{"gain":0.1},"mode":"slow","on":false,)"
                           R"("size":[1.0,2.0],"steps":3}})");
}

TEST(Fields, ListedValuesCanBeAssigned)
{
    Sample s;
    s.colour = {0.1f, 0.7f, 1.0f / 3.0f};
    s.mode = Mode::fast;
    s.on = true;
    Sample copy;
    for (const auto& row : listFields(s.tree())) copy.set(row.key + "=" + row.value);
    EXPECT_EQ(copy.colour, s.colour);
    EXPECT_EQ(copy.mode, s.mode);
    EXPECT_TRUE(copy.on);
}

} // namespace
} // namespace tarn::test
