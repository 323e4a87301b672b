// What a pass draws into and later ones read: colour textures, a depth texture and their framebuffer, with
// multisampled renderbuffers in front when asked for. Declared anew each frame, rebuilt only when something
// changed:
//
//     target.ensure({.size = size, .colours = {Format::rgba16f}, .depth = Format::depth24, .samples = 4});
//     target.bind();  … draw …
//     target.resolve();
//     program.texture("sceneColour", target.colour());
#pragma once

#include "gl/framebuffer.h"

#include <optional>
#include <string>
#include <vector>

namespace tarn::gl {

struct TargetDesc {
    ivec2 size{1, 1};
    std::vector<Format> colours{};
    std::optional<Format> depth{};
    int samples = 1;                ///< capped by what the driver offers
    Filter filter = Filter::linear; ///< of the colour textures
    Filter depthFilter = Filter::nearest;
    Wrap wrap = Wrap::clamp;
    vec4 border{0.0f};         ///< with Wrap::border; the depth texture's border is 1
    bool mipmaps = false;      ///< of the colour textures; generate them after resolve()
    bool depthCompare = false; ///< depth read through a sampler2DShadow
    bool operator==(const TargetDesc&) const = default;
};

class Target {
public:
    explicit Target(std::string label) : label_(std::move(label)) {}

    /// Returns true when the textures are new, and with them their content undefined.
    bool ensure(const TargetDesc& desc);

    /// Draw here from now on.
    void bind() const { drawFramebuffer().bind(); }
    /// The framebuffer that is drawn into: clear this one.
    const Framebuffer& drawFramebuffer() const;
    /// The framebuffer of the textures.
    const Framebuffer& framebuffer() const { return resolved_; }
    /// Brings the samples into the textures, all of them or only what is read. Nothing is done with one sample, or
    /// where nobody asked for the framebuffer that is drawn into since the last time.
    void resolve() const;
    void resolveColour() const;
    void resolveDepth() const;

    const Texture& colour(int index = 0) const { return colours_.at(static_cast<std::size_t>(index)); }
    Texture& colour(int index = 0) { return colours_.at(static_cast<std::size_t>(index)); }
    const Texture& depth() const { return depth_; }
    bool hasDepth() const { return desc_.depth.has_value(); }
    ivec2 size() const { return desc_.size; }
    int samples() const { return desc_.samples; }
    bool isMultisampled() const { return desc_.samples > 1; }
    const TargetDesc& desc() const { return desc_; }
    const std::string& label() const { return label_; }
    /// False until the first ensure().
    explicit operator bool() const { return built_; }

private:
    void build();
    void buildMultisampled();

    std::string label_;
    TargetDesc desc_;      ///< with the samples there really are
    TargetDesc requested_; ///< as asked
    bool built_ = false;
    std::vector<Texture> colours_;
    Texture depth_;
    std::vector<Renderbuffer> buffers_;
    Framebuffer resolved_;
    Framebuffer multisampled_;
    mutable bool colourIsStale_ = false, depthIsStale_ = false; ///< the textures
};

} // namespace tarn::gl
