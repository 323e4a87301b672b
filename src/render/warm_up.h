// Builds programs before the frames that need them: frames of all sorts, drawn tiny and with one triangle for each
// program, make a driver finish what it leaves for the first draw.
#pragma once

#include "render/renderer.h"

#include <functional>
#include <memory>

namespace tarn {

/// Every program that a flight may ask for, for the options and the water that the renderer has; debug views are left
/// for when they are asked for.
/// @param water the renderer's
void warmUp(Renderer& renderer, const WaterBody& water, Progress* progress = nullptr);

/// The same bit by bit, beside a renderer whose pictures are shown: it has a renderer of its own with the same
/// programs.
///
///     Rehearsal rehearsal(scene, shaders, options, water, progress);
///     rehearsal.build(view);                 // all that a view needs
///     while (rehearsal.buildOthers(1)) …     // what other views will need
class Rehearsal {
public:
    struct View {
        Camera camera;
        double time = 0.0;
        ivec2 size{1}; ///< of the picture whose view it is
    };

    /// @param progress null: none
    Rehearsal(std::shared_ptr<GpuScene> scene, gl::ShaderLibrary& shaders, const Options& options,
              const WaterBody& water, Progress* progress);
    ~Rehearsal();

    /// Two rehearsals that begin with different programs meet in the middle, where a driver's cache has what the other
    /// built.
    enum class Order { evenFirst, oddFirst };

    void setOptions(const Options& options, const WaterBody& water);
    void build(const View& view, Order order = Order::evenFirst);
    /// At most so many programs. Returns false when none is left.
    bool buildOthers(std::size_t most);

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace tarn
