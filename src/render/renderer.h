// One frame of a scene, top to bottom. Needs a current GL context of at least 3.3 core for its whole life.
//
//     auto shaders = makeShaderLibrary();
//     gl::Profiler profiler;
//     Renderer renderer(scene, options, *shaders, profiler);
//     renderer.render({camera, 1.5, {640, 480}});
//     writeImage("lake.png", renderer.readDisplay());
#pragma once

#include "plan/frame_plan.h"
#include "plan/options.h"
#include "render/debug_view.h"
#include "render/height_field.h"
#include "render/sun_views.h"
#include "scene/scene.h"

#include <atomic>
#include <memory>
#include <optional>
#include <string>
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

struct FrameInput {
    const Camera& camera;  ///< with stereo.output, between the eyes
    double time = 0.0;     ///< seconds
    ivec2 size{640, 480};  ///< of the picture, or of one eye's, pixels; both at least 1
    DebugView view = DebugView::final;
    /// Scene, water body, camera, time, size and options are those of the last frame: what that drew for the water to
    /// look up stays, and only the picture is drawn anew. For several debug views of one moment. Of no effect in stereo,
    /// where what is looked up is the other eye's.
    bool sameMoment = false;
    /// From 1: of the samples of a moment that are averaged, the how-many-eth this frame is. It is jittered within a pixel,
    /// and what is shown is the mean of all so far. Everything else is that of the frames before. 0: this frame alone. Of no
    /// effect in debug views and in stereo.
    int sample = 0;
    /// Looked at between passes: once it is true, render() throws FrameAbandoned. Null: the frame is drawn to its end.
    const std::atomic<bool>* abandoned = nullptr;
};

/// Nobody waits for the frame any more. What the renderer shows is undefined until the next one.
struct FrameAbandoned {};

/// What a frame did. Valid until the next one.
struct FrameStats {
    FramePlan plan; ///< in stereo the right eye's
    struct Pass {
        std::string name;
        std::size_t triangles = 0;
        std::size_t drawCalls = 0;
    };
    std::vector<Pass> passes; ///< in the order they began; both eyes' added up
    std::size_t triangles() const;
    /// The pass of a name, added where there is none.
    Pass& of(const std::string& name);
};

/// Values that no target may hold.
struct BadPixels {
    std::string pass; ///< the pass that made them
    std::size_t nan = 0, infinite = 0, negative = 0;
    bool any() const { return nan + infinite + negative > 0; }
};

/// The caustics texture and where it lies: what shaders/passes/scene.frag knows of it.
struct CausticsMap {
    CausticsRegion region;   ///< rows from its least z, columns from its least x
    int edge = 0;            ///< texels
    std::vector<vec3> light; ///< irradiance relative to the sun's above the water, both through a level area
    LevelRect water;         ///< beside it no light enters
    float level = 0.0f;      ///< of the plane that both lie on, m
    vec3 toSun{0.0f};        ///< towards the sun under water: the light of a point crosses the plane along it
};

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

    /// From the next frame on each pass draws one triangle with each program that it needs, and no more of the scene: for
    /// warmUp(), whose pictures nobody sees. What maps hold then is wrong.
    void setWarmingUp(bool warmingUp);

    const FrameStats& render(const FrameInput& input);

    /// Copies the last frame's picture to the default framebuffer of the window.
    void presentToWindow(ivec2 windowSize) const;
    /// The last frame's picture as it is shown; in stereo as readDisplay has it.
    const gl::Framebuffer& display() const;

    /// The last frame as it is shown: 8-bit sRGB, three channels. In stereo an anaglyph, or the left eye's picture on the
    /// left of the right one's.
    Image readDisplay() const;

    /// The last frame's linear radiance, or the debug view's raw values: four floats a pixel (debug views of the
    /// water: alpha is 1 where the water is); in stereo the left eye's on the left. Throws Error for an anaglyph, which
    /// is made of what a display shows.
    Image readLinear() const;

    /// The camera of the last frame's refraction target (of its air's side, when it shows both; of the right eye, when it
    /// shows two), world space.
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
