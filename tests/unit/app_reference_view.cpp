// The view that a reference was made from, out of its header; and what it looks like.

#include "app/picture_header.h"
#include "app/reference_view.h"
#include "app/scene_setup.h"
#include "base/error.h"

#include <gtest/gtest.h>

namespace tarn {
namespace {

SceneSetup lake()
{
    SceneSetup sceneSetup;
    sceneSetup.scene.file = "lake.toml";
    sceneSetup.scene.cameras.resize(2);
    sceneSetup.scene.cameras[0].name = "first";
    sceneSetup.scene.cameras[0].farPlane = 300.0f;
    sceneSetup.scene.cameras[1].name = "shore";
    sceneSetup.scene.cameras[1].farPlane = 777.0f;
    return sceneSetup;
}

Camera crooked()
{
    Camera camera;
    camera.name = "shore";
    camera.eye = vec3(0.1f, 1.0f / 3.0f, -7.7f);
    camera.target = vec3(3.3f, 0.2f, 0.7f);
    camera.up = vec3(0.1f, 1.0f, 0.0f);
    camera.verticalFov = 0.777f;
    return camera;
}

std::string complaint(const reference::Picture& picture)
{
    try {
        referenceView(picture, lake().scene, "truth.exr");
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

TEST(ReferenceView, AnEyesShearedFrustumComesBackToo)
{
    const SceneSetup sceneSetup = lake();
    Camera eye = crooked();
    eye.lensShift = 0.0123f;
    reference::Picture picture(ivec2(2, 2));
    picture.metadata = pictureHeader(sceneSetup, eye, 0.0);
    EXPECT_EQ(referenceView(picture, sceneSetup.scene, "truth.exr").camera.lensShift, eye.lensShift);
    EXPECT_FALSE(isSameView(eye, crooked()));
    EXPECT_EQ(pictureHeader(sceneSetup, crooked(), 0.0).at("tarn:camera").find("lens"), std::string::npos);
}

TEST(ReferenceView, ComesBackFromTheHeader)
{
    const SceneSetup sceneSetup = lake();
    reference::Picture picture(ivec2(2, 2));
    picture.metadata = pictureHeader(sceneSetup, crooked(), 1.0 / 3.0);
    const ReferenceView view = referenceView(picture, sceneSetup.scene, "truth.exr");
    EXPECT_EQ(view.camera.name, "shore");
    EXPECT_EQ(view.camera.eye, crooked().eye);
    EXPECT_EQ(view.camera.target, crooked().target);
    EXPECT_EQ(view.camera.up, crooked().up);
    EXPECT_NEAR(view.camera.verticalFov, crooked().verticalFov, 1e-6f);
    EXPECT_EQ(view.camera.farPlane, 777.0f);
    EXPECT_DOUBLE_EQ(view.time, 1.0 / 3.0);
    EXPECT_TRUE(isSameView(view.camera, crooked()));

    Camera unnamed = crooked();
    unnamed.name = "gone";
    picture.metadata = pictureHeader(sceneSetup, unnamed, 0.0);
    EXPECT_EQ(referenceView(picture, sceneSetup.scene, "truth.exr").camera.farPlane, 300.0f);
}

TEST(ReferenceView, AHeaderThatDoesNotSayIsAnError)
{
    reference::Picture picture(ivec2(1, 1));
    EXPECT_NE(complaint(picture).find("truth.exr"), std::string::npos);
    picture.metadata = pictureHeader(lake(), crooked(), 0.0);
    EXPECT_EQ(complaint(picture), "");
    for (const char* broken : {"", "{", "[]", R"({"name": "shore", "eye": [1, 2]})"}) {
        picture.metadata["tarn:camera"] = broken;
        EXPECT_NE(complaint(picture).find("truth.exr"), std::string::npos) << broken;
    }
    picture.metadata = pictureHeader(lake(), crooked(), 0.0);
    picture.metadata["tarn:time"] = "noon";
    EXPECT_NE(complaint(picture), "");
}

TEST(ReferenceView, AStepAsideIsAnotherView)
{
    const Camera camera = crooked();
    EXPECT_TRUE(isSameView(camera, camera));
    Camera further = camera;
    further.target = camera.eye + 2.0f * (camera.target - camera.eye); // the same direction
    EXPECT_TRUE(isSameView(camera, further));
    Camera aside = camera;
    aside.eye.x += 0.01f;
    EXPECT_FALSE(isSameView(camera, aside));
    Camera turned = camera;
    turned.target.x += 0.01f;
    EXPECT_FALSE(isSameView(camera, turned));
    Camera tilted = camera;
    tilted.up.x += 0.01f;
    EXPECT_FALSE(isSameView(camera, tilted));
    Camera wider = camera;
    wider.verticalFov += 0.001f;
    EXPECT_FALSE(isSameView(camera, wider));
}

TEST(ReferenceView, ItIsShownWithTheExposureAndTheToneCurve)
{
    reference::Picture picture(ivec2(2, 1));
    picture.radiance = {vec3(0.25f, 0.0f, 100.0f), vec3(0.5f)};
    FrameOptions options;
    options.toneCurve = FrameOptions::ToneCurve::linear;
    options.exposure = 2.0f;
    const Image image = displayPicture(picture, options);
    EXPECT_EQ(image.bytes, (std::vector<std::uint8_t>{188, 0, 255, 255, 255, 255}));
    options.toneCurve = FrameOptions::ToneCurve::reinhard;
    EXPECT_EQ(displayPicture(picture, options).bytes[3], 188); // 1 / (1 + 1)
}

} // namespace
} // namespace tarn
