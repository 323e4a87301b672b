// When the viewer can show a reference beside the live picture, and where on the screen.

#include "app/viewer/comparison_state.h"
#include "app/viewer/input_map.h"
#include "app/viewer/scene_clock.h"

#include <gtest/gtest.h>

#include <limits>

namespace tarn {
namespace {

ReferenceView someView()
{
    ReferenceView view;
    view.camera.eye = vec3(1.0f, 2.0f, 3.0f);
    view.time = 1.5;
    return view;
}

TEST(Comparison, KeyBGoesThroughTheModes)
{
    ComparisonState state(someView());
    state.look(someView().camera, 1.5);
    EXPECT_EQ(state.shown(), ComparisonMode::slider);
    EXPECT_FALSE(state.next());
    EXPECT_EQ(state.shown(), ComparisonMode::errorMap);
    EXPECT_FALSE(state.next());
    EXPECT_EQ(state.shown(), ComparisonMode::off);
    EXPECT_FALSE(state.next());
    EXPECT_EQ(state.shown(), ComparisonMode::slider);
}

TEST(Comparison, AwayFromTheViewItHidesAndBGoesBack)
{
    ComparisonState state(someView());
    Camera aside = someView().camera;
    aside.eye.x += 1.0f;
    state.look(aside, 1.5);
    EXPECT_EQ(state.shown(), ComparisonMode::off);
    EXPECT_NE(state.note().find("view"), std::string::npos);
    EXPECT_TRUE(state.next());
    state.look(someView().camera, 1.5);
    EXPECT_EQ(state.shown(), ComparisonMode::slider) << "the mode is as it was";

    state.look(someView().camera, 1.6);
    EXPECT_EQ(state.shown(), ComparisonMode::off);
    EXPECT_NE(state.note().find("time"), std::string::npos);
    EXPECT_TRUE(state.next());
}

TEST(Comparison, TheSliderStaysInTheWindow)
{
    ComparisonState state(someView());
    EXPECT_FLOAT_EQ(state.slider(), 0.5f);
    state.moveSlider(1);
    EXPECT_FLOAT_EQ(state.slider(), 0.55f);
    state.moveSlider(-3);
    EXPECT_FLOAT_EQ(state.slider(), 0.4f);
    state.moveSlider(100);
    EXPECT_FLOAT_EQ(state.slider(), 1.0f);
    state.setSlider(-3.0f);
    EXPECT_FLOAT_EQ(state.slider(), 0.0f);
    state.setSlider(std::numeric_limits<float>::quiet_NaN());
    EXPECT_FLOAT_EQ(state.slider(), 0.0f);
}

TEST(Comparison, TheNoteNamesTheErrorAndItsScale)
{
    ComparisonState state(someView());
    state.chooseError(ErrorKind::reflection);
    state.next();
    EXPECT_NE(state.note().find("reflection error, white from 5 deg"), std::string::npos) << state.note();
}

// One vertical field of view, so one height; a narrower picture leaves the sides free, a wider one is cut.
TEST(Comparison, PicturesLieOverEachOther)
{
    const ScreenRect same = overlaid({320, 180}, {1280.0f, 720.0f});
    EXPECT_FLOAT_EQ(same.lower.x, 0.0f);
    EXPECT_FLOAT_EQ(same.upper.x, 1280.0f);
    const ScreenRect narrow = overlaid({100, 100}, {1280.0f, 720.0f});
    EXPECT_FLOAT_EQ(narrow.lower.x, 280.0f);
    EXPECT_FLOAT_EQ(narrow.upper.x, 1000.0f);
    EXPECT_FLOAT_EQ(narrow.upper.y, 720.0f);
    EXPECT_FLOAT_EQ(overlaid({200, 50}, {400.0f, 200.0f}).lower.x, -200.0f);
}

TEST(Comparison, OnlyTheSlidersKeysRepeat)
{
    EXPECT_TRUE(repeats(Action::sliderLeft));
    EXPECT_TRUE(repeats(Action::sliderRight));
    EXPECT_FALSE(repeats(Action::compare));
    EXPECT_FALSE(isHeld(Action::sliderLeft));
}

TEST(Comparison, TheClockHoldsAtATime)
{
    SceneClock clock(0.0);
    clock.advance(10.0);
    clock.holdAt(1.5);
    clock.advance(20.0);
    EXPECT_DOUBLE_EQ(clock.time(), 1.5);
    EXPECT_TRUE(clock.paused());
    clock.togglePause();
    clock.advance(21.0);
    EXPECT_DOUBLE_EQ(clock.time(), 2.5);
}

} // namespace
} // namespace tarn
