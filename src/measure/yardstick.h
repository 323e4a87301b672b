// The yardstick: what one plain pass costs on this machine, so that figures of different machines can be
// compared as ratios.
//
// The terrain of assets/bench, 100,352 triangles with one picture, drawn once into 1024x768 pixels of RGBA8
// and a depth of 24 bits: seen from straight above, all of it, so that it fills the picture and hides
// nothing; one texture fetch with trilinear filtering, no light, one sample a pixel. It depends on nothing
// that can be set. docs/benchmarks.md says how it is used.
#pragma once

#include "gl/buffer.h"
#include "gl/program.h"
#include "gl/shader_library.h"
#include "gl/target.h"
#include "gl/vertex_array.h"
#include "measure/benchmark.h"

#include <memory>

namespace tarn {

struct Scene;

/// Needs a current context for its whole life.
class Yardstick : public BenchSubject {
public:
    /// Loads the terrain. Throws Error when assets/bench is not as it should be.
    explicit Yardstick(gl::ShaderLibrary& shaders);

    std::string name() const override { return "yardstick"; }
    void draw(int index) override;
    std::vector<BenchPass> drawPasses(int index) override;

    /// What the last draw() left: 1024x768 pixels, RGBA8.
    const gl::Target& target() const { return target_; }

private:
    void uploadMesh(const Scene& scene);
    void uploadPicture(const Scene& scene);

    std::shared_ptr<gl::Program> program_;
    gl::Buffer vertices_, indices_;
    gl::VertexArray mesh_;
    gl::Texture picture_;
    gl::Target target_{"yardstick"};
    int indexCount_ = 0;
};

} // namespace tarn
