#include "trees.h"

#include <algorithm>

namespace tarn::lake {

namespace {

constexpr int columns = 4, rows = 2;

/// The picture a material wears here, small enough that a texel is about a pixel of the impostor.
struct Skins {
    Canvas leaves, needles;
    const Canvas* find(const std::string& material) const
    {
        if (material == "leaves") return &leaves;
        return material == "needles" ? &needles : nullptr;
    }
};

Canvas reduced(const Canvas& canvas, int size)
{
    Canvas small = canvas.halved();
    while (small.size() > size) small = small.halved();
    small.bleed();
    return small;
}

vec4 sample(const Canvas* skin, const std::string& material, vec2 uv)
{
    if (!skin) return vec4(material == "birch" ? vec3(0.5f) : vec3(0.14f, 0.11f, 0.085f), 1.0f);
    const float n = real(skin->size());
    const auto pixel = [n](float s) { return static_cast<int>(std::floor(std::min(std::max(s, 0.0f), n - 1.0f))); };
    return skin->at(pixel(uv.x * n), pixel((1.0f - uv.y) * n));
}

/// Draws triangles seen from +z, without perspective, into a rectangle of the canvas.
class SideView {
public:
    SideView(Canvas& canvas, ivec2 origin, ivec2 size, vec2 lower, vec2 extent)
        : canvas_(canvas), origin_(origin), size_(size), lower_(lower), scale_(vec2(size) / extent),
          depths_(static_cast<std::size_t>(size.x * size.y), -1e9f)
    {}

    void draw(const Mesh& mesh, const Face& face, const std::array<std::size_t, 3>& corners, const Skins& skins)
    {
        const std::string& material = mesh.materials()[static_cast<std::size_t>(face.material)];
        const Canvas* skin = skins.find(material);
        std::array<vec3, 3> p, colours;
        std::array<vec2, 3> uvs;
        for (std::size_t k = 0; k < 3; ++k) {
            const Corner& corner = face.corners[corners[k]];
            const vec3 world = mesh.positions[static_cast<std::size_t>(corner.position)];
            const vec2 flat = (vec2(world.x, world.y) - lower_) * scale_;
            p[k] = vec3(flat.x, real(size_.y) - flat.y, world.z);
            colours[k] = mesh.colours[static_cast<std::size_t>(corner.position)];
            uvs[k] = mesh.uvs[static_cast<std::size_t>(corner.uv)];
        }
        const auto cross = [](const vec3& a, const vec3& b, const vec3& c) {
            return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
        };
        const float area = cross(p[0], p[1], p[2]);
        if (std::abs(area) < 1e-4f) return;
        const vec3 low = glm::min(p[0], glm::min(p[1], p[2])), high = glm::max(p[0], glm::max(p[1], p[2]));
        for (int y = std::max(0, static_cast<int>(low.y)); y <= std::min(size_.y - 1, static_cast<int>(high.y)); ++y) {
            for (int x = std::max(0, static_cast<int>(low.x)); x <= std::min(size_.x - 1, static_cast<int>(high.x));
                 ++x) {
                const vec3 at(real(x) + 0.5f, real(y) + 0.5f, 0.0f);
                const vec3 w(cross(p[1], p[2], at) / area, cross(p[2], p[0], at) / area, cross(p[0], p[1], at) / area);
                if (std::min(w.x, std::min(w.y, w.z)) < 0.0f) continue;
                float& depth = depths_[static_cast<std::size_t>(y * size_.x + x)];
                const float z = w.x * p[0].z + w.y * p[1].z + w.z * p[2].z;
                if (z <= depth) continue;
                const vec4 texel = sample(skin, material, w.x * uvs[0] + w.y * uvs[1] + w.z * uvs[2]);
                if (texel.w < 0.45f) continue;
                depth = z;
                canvas_.at(origin_.x + x, origin_.y + y) =
                    vec4(vec3(texel) * (w.x * colours[0] + w.y * colours[1] + w.z * colours[2]), 1.0f);
            }
        }
    }

private:
    Canvas& canvas_;
    ivec2 origin_, size_;
    vec2 lower_, scale_;
    std::vector<float> depths_;
};

} // namespace

Impostors drawImpostors(const std::vector<const Mesh*>& trees, const FoliageTextures& textures)
{
    const Skins skins{reduced(textures.leaves, 256), reduced(textures.needles, 256)};
    Canvas large(2 * textureSize, Canvas::Edge::cut);
    Impostors impostors;
    const ivec2 cell(large.size() / columns, large.size() / rows);
    constexpr int margin = 12;
    for (int i = 0; i < std::min(static_cast<int>(trees.size()), columns * rows); ++i) {
        const Mesh& tree = *trees[static_cast<std::size_t>(i)];
        float reach = 0.0f, height = 0.0f;
        for (const vec3& p : tree.positions) {
            reach = std::max(reach, std::abs(p.x));
            height = std::max(height, p.y);
        }
        const ivec2 origin = ivec2(i % columns, i / columns) * cell + ivec2(margin);
        const ivec2 size = cell - ivec2(2 * margin);
        SideView view(large, origin, size, {-reach, 0.0f}, {2.0f * reach, height});
        for (const Face& face : tree.faces) {
            view.draw(tree, face, {0, 1, 2}, skins);
            if (face.count == 4) view.draw(tree, face, {0, 2, 3}, skins);
        }
        const float n = real(large.size());
        impostors.cells.push_back({{real(origin.x) / n, 1.0f - real(origin.y + size.y) / n},
                                   {real(origin.x + size.x) / n, 1.0f - real(origin.y) / n},
                                   {2.0f * reach, height}});
    }
    impostors.picture = large.halved();
    impostors.picture.bleed();
    return impostors;
}

} // namespace tarn::lake
