#include "image/render_group.h"

#include "app/session.h"
#include "base/error.h"
#include "base/files.h"

#include <fmt/core.h>

namespace tarn::imagetest {

namespace {

void requireClean(const Renderer& renderer, int errorsBefore)
{
    for (const BadPixels& bad : renderer.badPixels())
        if (bad.any())
            throw Error("pass {} made {} NaN, {} infinite and {} negative values", bad.pass, bad.nan, bad.infinite,
                        bad.negative);
    if (gl::debugErrorCount() > errorsBefore) throw Error("OpenGL reported: {}", gl::lastDebugError());
}

void renderCase(const Case& test, const Scene& scene, Renderer& renderer)
{
    const int errorsBefore = gl::debugErrorCount();
    const Camera camera = chooseCamera(scene, test.camera);
    const Settings settings = resolveSettings(scene, {{}, test.settings});
    renderer.setOptions(settings.options, settings.water);
    renderer.render({camera, test.time, test.size, test.view});
    requireClean(renderer, errorsBefore);
    writeImage(filesOf(test.name).actual, renderer.readDisplay());
}

} // namespace

void renderGroup(const Group& group)
{
    std::filesystem::create_directories(resultFolder());
    for (const Case& test : group.cases) {
        std::filesystem::remove(filesOf(test.name).actual);
        std::filesystem::remove(filesOf(test.name).problem);
    }
    const SceneSetup sceneSetup = loadSceneSetup({group.scene, {}, {}}, nullptr);
    Session session(sceneSetup, {320, 240}, nullptr);
    session.renderer().setChecking(true);
    for (const Case& test : group.cases) {
        try {
            renderCase(test, sceneSetup.scene, session.renderer());
        } catch (const std::exception& error) {
            writeFile(filesOf(test.name).problem, error.what());
            fmt::print("{}: {}\n", test.name, error.what());
        }
    }
    fmt::print("{}: {} cases in {}\n", group.name, group.cases.size(), resultFolder().string());
}

} // namespace tarn::imagetest
