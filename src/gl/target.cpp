#include "gl/target.h"

#include "gl/context.h"

#include <algorithm>
#include <utility>

namespace tarn::gl {

bool Target::ensure(const TargetDesc& desc)
{
    if (built_ && desc == requested_) return false;
    built_ = false;
    requested_ = desc;
    desc_ = desc;
    desc_.samples = std::clamp(desc.samples, 1, std::max(1, capabilities().maxSamples));
    build();
    if (isMultisampled())
        buildMultisampled();
    else
        multisampled_ = {};
    built_ = true;
    return true;
}

void Target::build()
{
    // The old textures go first: a resize must not need both sizes at once.
    resolved_ = {};
    multisampled_ = {};
    buffers_.clear();
    colours_.clear();
    depth_ = {};

    TextureDesc texture{.size = desc_.size, .mipmaps = desc_.mipmaps, .filter = desc_.filter, .wrap = desc_.wrap};
    texture.border = desc_.border;
    for (const Format format : desc_.colours) {
        texture.format = format;
        colours_.emplace_back(texture, label_ + " colour " + std::to_string(colours_.size()));
    }
    if (desc_.depth) {
        const TextureDesc depthTexture{.format = *desc_.depth,
                                       .size = desc_.size,
                                       .filter = desc_.depthFilter,
                                       .wrap = desc_.wrap,
                                       .border = vec4(1.0f),
                                       .compare = desc_.depthCompare};
        depth_ = Texture(depthTexture, label_ + " depth");
    }
    std::vector<Attachment> attachments(colours_.begin(), colours_.end());
    if (desc_.depth) attachments.emplace_back(depth_);
    resolved_ = Framebuffer(label_, attachments);
}

void Target::buildMultisampled()
{
    std::vector<Format> formats = desc_.colours;
    if (desc_.depth) formats.push_back(*desc_.depth);
    for (const Format format : formats) {
        buffers_.emplace_back(format, desc_.size, desc_.samples,
                              label_ + " samples " + std::to_string(buffers_.size()));
    }
    const std::vector<Attachment> attachments(buffers_.begin(), buffers_.end());
    multisampled_ = Framebuffer(label_ + " multisampled", attachments);
}

const Framebuffer& Target::drawFramebuffer() const
{
    colourIsStale_ = depthIsStale_ = isMultisampled();
    return isMultisampled() ? multisampled_ : resolved_;
}

void Target::resolve() const
{
    resolveColour();
    resolveDepth();
}

void Target::resolveColour() const
{
    if (!std::exchange(colourIsStale_, false)) return;
    for (int i = 0; i < multisampled_.colourCount(); ++i)
        multisampled_.blitTo(resolved_, {.colour = true, .depth = false, .output = i});
}

void Target::resolveDepth() const
{
    if (!std::exchange(depthIsStale_, false) || !hasDepth()) return;
    multisampled_.blitTo(resolved_, {.colour = false, .depth = true});
}

} // namespace tarn::gl
