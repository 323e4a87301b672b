// frame.supersampling: a picture is the mean of one that is drawn larger.
#include "gl/shader_library.h"
#include "studio.h"
#include "test_scenes.h"

namespace tarn::test {
namespace {

Camera lookAcross()
{
    Camera camera;
    camera.eye = vec3(0.0f, 1.5f, 4.0f);
    camera.target = vec3(0.3f, -0.5f, -1.0f);
    return camera;
}

/// A flat lake that reflects, refracts and is lit; waves put detail of less than a pixel into it.
Scene rippledLake()
{
    Scene scene = flatLake(1.5f);
    Wave wave;
    wave.amplitude = 0.03f;
    wave.wavelength = 0.4f;
    wave.direction = 20.0f;
    scene.water.waves = {wave};
    scene.sun = Sun{normalize(vec3(1.0f, 1.0f, 0.5f)), vec3(8.0f), false};
    return scene;
}

TEST(FrameSupersampling, APixelIsTheMeanOfThoseDrawnForIt)
{
    const Scene scene = rippledLake();
    for (const int edge : {2, 3}) {
        Options options;
        options.frame.msaa = 1;
        options.glow.enabled = false;
        Studio studio(scene, options);
        const ivec2 size(40, 30);
        const Image large = studio.linear(lookAcross(), edge * size, 0.7);
        options.frame.supersampling = edge;
        studio.setOptions(options, scene.water);
        const Image mean = studio.linear(lookAcross(), size, 0.7);
        ASSERT_EQ(ivec2(mean.width, mean.height), size);
        bool isAnyMixed = false;
        for (int y = 0; y < size.y; ++y) {
            for (int x = 0; x < size.x; ++x) {
                vec4 expected(0.0f);
                for (int j = 0; j < edge; ++j)
                    for (int i = 0; i < edge; ++i)
                        expected += pixel(large, edge * x + i, edge * y + j);
                expected /= static_cast<float>(edge * edge);
                const vec4 is = pixel(mean, x, y);
                for (int c = 0; c < 3; ++c)
                    EXPECT_NEAR(is[c], expected[c], 1e-3f * expected[c] + 1e-5f) << x << "," << y;
                const vec4 one = pixel(large, edge * x, edge * y);
                isAnyMixed = isAnyMixed || std::abs(one.x - expected.x) > 0.05f * expected.x;
            }
        }
        EXPECT_TRUE(isAnyMixed); // else a copy of one of the pixels would pass
    }
}

// The mean of positions is none.
TEST(FrameSupersampling, RawValuesAreThoseOfThePixelsCentre)
{
    const Scene scene = rippledLake();
    Options options;
    Studio studio(scene, options);
    const Image plain = studio.linear(lookAcross(), {40, 30}, 0.7, DebugView::positionW);
    options.frame.supersampling = 3;
    studio.setOptions(options, scene.water);
    const Image same = studio.linear(lookAcross(), {40, 30}, 0.7, DebugView::positionW);
    EXPECT_EQ(plain.floats, same.floats);
}

} // namespace
} // namespace tarn::test
