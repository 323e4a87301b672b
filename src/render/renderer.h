// One frame of a scene, top to bottom. Needs a current GL context of at least 3.3 core for its whole life.
//
//     auto shaders = makeShaderLibrary();
//     gl::Profiler profiler;
//     Renderer renderer(scene, options, *shaders, profiler);
//     renderer.render({camera, 1.5, {640, 480}});
//     writeImage("lake.png", renderer.readDisplay());
#pragma once

#include "plan/options.h"
#include "render/caustics_map.h"
#include "render/frame.h"
#include "render/height_field.h"
#include "scene/scene.h"

#include <memory>
#include <optional>
#include <vector>

namespace tarn {

class GpuScene;
class Progress;
namespace gl {
class Framebuffer;
class ShaderLibrary;
class Profiler;
} // namespace gl

/// The library over projectRoot()/shaders, with the bindings that the passes use.
std::unique_ptr<gl::ShaderLibrary> makeShaderLibrary();

/// Meshes, textures and sky on the graphics card, as a renderer with these options needs them. Keeps a reference to the
/// scene. A thread of its own may do it, in a context of the same share group (render/frame_thread.h).
std::shared_ptr<GpuScene> uploadScene(const Scene& scene, const Options& options, Progress* progress);

class Renderer {
public:
    /// Uploads the scene, bakes its sky and compiles every shader that the options ask for. Keeps references to all
    /// but the progress. Throws Error when a shader does not compile.
    Renderer(const Scene& scene, const Options& options, gl::ShaderLibrary& shaders, gl::Profiler& profiler,
             Progress* progress = nullptr);
    /// The same with a scene that is uploaded already; renderers in one context may share it.
    Renderer(std::shared_ptr<GpuScene> uploaded, const Options& options, gl::ShaderLibrary& shaders,
             gl::Profiler& profiler, Progress* progress = nullptr);
    ~Renderer();
    Renderer(const Renderer&) = delete;
    Renderer& operator=(const Renderer&) = delete;

    /// Takes effect with the next frame. The water body starts as the scene's.
    void setOptions(const Options& options, const WaterBody& water);

    const Options& options() const;
    gl::ShaderLibrary& shaders();

    /// Count NaN, infinity and negative radiance in every target from the next frame on (slow: reads them all back).
    void setChecking(bool checking);

    /// From the next frame on each pass draws one triangle with each program that it needs, and no more of the scene:
    /// for warmUp(), whose pictures nobody sees. What maps hold then is wrong.
    void setWarmingUp(bool warmingUp);

    const FrameReport& render(const FrameInput& input);

    /// Copies the last frame's picture to the default framebuffer of the window.
    void presentToWindow(ivec2 windowSize) const;
    /// The last frame's picture as it is shown; in stereo as readDisplay has it.
    const gl::Framebuffer& display() const;

    /// The last frame as it is shown: 8-bit sRGB, three channels. In stereo an anaglyph, or the left eye's picture on
    /// the left of the right one's.
    Image readDisplay() const;

    /// The last frame's linear radiance, or the debug view's raw values: four floats a pixel (debug views of the
    /// water: alpha is 1 where the water is); in stereo the left eye's on the left. Throws Error for an anaglyph, which
    /// is made of what a display shows.
    Image readLinear() const;

    /// The camera of the last frame's refraction target (of its air's side, when it shows both; of the right eye, when
    /// it shows two), world space.
    const View& refractionView() const;

    /// The map that the last frame's refracted rays were marched through and nothing else, or null.
    const HeightField* heightField() const;

    /// A map that the last frame's rays were marched through, as a picture; nothing where none was. Waits for the GPU.
    std::optional<HeightMapPicture> readMap(MapKind kind) const;

    /// The last frame's caustics texture as it is; nothing when the frame had none. Waits for the GPU.
    std::optional<CausticsMap> readCaustics() const;

    /// What the scene's vertices and indices take in the graphics card's memory, with their levels of detail.
    std::size_t geometryBytes() const;

    /// What the checking found in the last frame, in the order of the passes; only passes that made bad values.
    const std::vector<BadPixels>& badPixels() const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace tarn
