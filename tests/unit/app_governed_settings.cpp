// What the viewer draws with, between a person's own settings and the ladder's: no window is needed.

#include "app/viewer/governed_settings.h"
#include "small_ladder.h"
#include "temp_folder.h"

#include <gtest/gtest.h>

namespace tarn {
namespace {

using test::smallLadder;

/// Draws what the governed settings ask for, on a machine of formulas.
struct Watched {
    GovernedSettings governed;
    double load = 100.0, now = 0.0;
    bool still = false;
    GovernedSettings::Part part{};

    Options frame(bool disturbed, bool suspended = false)
    {
        part = governed.next({now, disturbed, still, suspended});
        const Options drawn = governed.drawn().options;
        const Ladder ladder = smallLadder();
        double ms = load;
        for (const OwnRung& rung : rungsBelow(Options{}, ladder))
            if (rung.options == drawn) ms = load * rung.cost;
        now += 1e-3 * ms;
        if (!part.isFinal) governed.took({drawn, part.sample, ms, now});
        return drawn;
    }
};

TEST(GovernedSettings, BeginWithTheCheapestAndRiseToTheTarget)
{
    Watched watched{{smallLadder(), Settings{}, "A pond"}};
    watched.load = 58.0;
    for (const OwnRung& rung : rungsBelow(Options{}, smallLadder())) watched.governed.noteBuilt(rung.options);
    EXPECT_EQ(watched.frame(true).caustics.photons, 64);
    for (int i = 0; i < 200; ++i) watched.frame(true);
    EXPECT_EQ(watched.governed.drawn().options, rungsBelow(Options{}, smallLadder())[2].options) << "58 ms by 0.5";
    EXPECT_EQ(watched.governed.text(33.4), "33 fps, error 0.14, 5 % wrong hits (msaa 1, reflection.facets one)");
}

TEST(GovernedSettings, ChangeNoProgramsInAMovement)
{
    Watched watched{{smallLadder(), Settings{}, "A pond"}};
    watched.load = 20.0;
    for (int i = 0; i < 200; ++i) {
        EXPECT_EQ(watched.frame(true).reflection.facets, ReflectionOptions::Facets::one);
        EXPECT_FALSE(watched.governed.toBuild());
    }
    for (int i = 0; i < 200; ++i) watched.frame(false);
    ASSERT_TRUE(watched.governed.toBuild()) << "the waves move, but nobody does";
    EXPECT_EQ(*watched.governed.toBuild(), Options{});
    watched.governed.noteBuilt(Options{});
    for (int i = 0; i < 20; ++i) watched.frame(true);
    EXPECT_EQ(watched.governed.drawn().options, Options{});
    EXPECT_FALSE(watched.governed.toBuild());
}

TEST(GovernedSettings, ThePersonsOwnSettingsStayTheirs)
{
    Settings own;
    own.options.caustics.photons = 32;
    Watched watched{{smallLadder(), own, "A pond"}};
    watched.load = 1000.0;
    EXPECT_EQ(watched.frame(true).caustics.photons, 32);
    EXPECT_EQ(watched.frame(true).frame.msaa, 1);
    EXPECT_CONTAINS(watched.governed.text(1.0), "error about 0.20");
    own.options.frame.exposure = 0.5f;
    own.options.glow.enabled = false;
    watched.governed.setOwn(own);
    const Options drawn = watched.frame(true);
    EXPECT_EQ(drawn.frame.exposure, 0.5f);
    EXPECT_FALSE(drawn.glow.enabled);
    EXPECT_EQ(drawn.frame.msaa, 1);
}

TEST(GovernedSettings, OffShowsTheOwnSettings)
{
    Settings on, off;
    off.options.frame.targetMs = 0.0f;
    Watched watched{{smallLadder(), on, "A pond"}};
    watched.load = 1000.0;
    EXPECT_EQ(watched.frame(true).frame.msaa, 1);
    EXPECT_FALSE(watched.governed.setOwn(on)) << "nothing has changed";
    EXPECT_TRUE(watched.governed.setOwn(off));
    EXPECT_EQ(watched.frame(true), off.options);
    EXPECT_EQ(watched.governed.text(1.0), "");
    watched.still = true;
    for (int i = 0; i < 100; ++i) EXPECT_EQ(watched.frame(false), off.options);
    EXPECT_EQ(watched.part.sample, 0) << "nothing is refined";
    EXPECT_FALSE(watched.part.isFinal);
    watched.governed.setOwn(on);
    EXPECT_EQ(watched.frame(true).frame.msaa, 1);
    EXPECT_EQ(watched.frame(true, true), on.options) << "while something is measured";
    EXPECT_EQ(watched.frame(true).frame.msaa, 1);
}

TEST(GovernedSettings, AStillPictureEndsAsTheOwnSettingsAveraged)
{
    Watched watched{{smallLadder(), Settings{}, "Another pond"}};
    watched.still = true;
    for (const OwnRung& rung : rungsBelow(Options{}, smallLadder())) watched.governed.noteBuilt(rung.options);
    for (int i = 0; i < 50; ++i) watched.frame(true);
    for (int i = 0; i < 200; ++i) watched.frame(false);
    EXPECT_TRUE(watched.part.isFinal);
    EXPECT_EQ(watched.governed.drawn().options, Options{});
    EXPECT_EQ(watched.governed.text(30.0), "at rest: 16 of 16 samples, error about 0.10, 4 % wrong hits or less");
    EXPECT_TRUE(watched.part.isRefining);
    EXPECT_EQ(watched.frame(true).caustics.photons, 64) << "and the first touch brings the fluid ones";
    EXPECT_EQ(watched.part.sample, 0);
    EXPECT_FALSE(watched.part.isRefining);
}

} // namespace
} // namespace tarn
