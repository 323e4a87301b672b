#include "obj_file.h"

#include "base/files.h"

#include <fmt/format.h>

#include <iterator>
#include <map>

namespace tarn::lake {

namespace {

/// A fixed number of decimals without trailing zeros, and never "-0".
void append(std::string& text, float value, int decimals)
{
    std::string number = fmt::format("{:.{}f}", value, decimals);
    number.erase(number.find_last_not_of('0') + 1);
    if (number.back() == '.') number.pop_back();
    if (number == "-0") number = "0";
    text += ' ';
    text += number;
}

/// Values rounded to `decimals`, each written once under `keyword`; tells the OBJ index of every original.
template <int N>
std::vector<int> appendOnce(std::string& text, const char* keyword, const std::vector<glm::vec<N, float>>& values,
                            int decimals)
{
    std::map<std::array<long, N>, int> known;
    std::vector<int> indices;
    const float scale = std::pow(10.0f, real(decimals));
    for (const auto& value : values) {
        std::array<long, N> key{};
        for (int c = 0; c < N; ++c) key[static_cast<std::size_t>(c)] = std::lround(value[c] * scale);
        const auto [entry, isNew] = known.try_emplace(key, static_cast<int>(known.size()) + 1);
        indices.push_back(entry->second);
        if (!isNew) continue;
        text += keyword;
        for (int c = 0; c < N; ++c) append(text, value[c], decimals);
        text += '\n';
    }
    return indices;
}

} // namespace

void writeObj(const std::filesystem::path& file, const Mesh& mesh, const std::string& name)
{
    std::string text =
        fmt::format("# Made by make_lake; see README.md in this folder.\nmtllib {}\no {}\n", materialFile, name);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        text += 'v';
        for (int c = 0; c < 3; ++c) append(text, mesh.positions[i][c], 3);
        for (int c = 0; c < 3; ++c) append(text, mesh.colours[i][c], 3);
        text += '\n';
    }
    const std::vector<int> uvs = appendOnce<2>(text, "vt", mesh.uvs, 4);
    const std::vector<int> normals = appendOnce<3>(text, "vn", mesh.normals, 3);
    for (std::size_t material = 0; material < mesh.materials().size(); ++material) {
        fmt::format_to(std::back_inserter(text), "usemtl {}\n", mesh.materials()[material]);
        for (const Face& face : mesh.faces) {
            if (face.material != static_cast<int>(material)) continue;
            text += 'f';
            for (int k = 0; k < face.count; ++k) {
                const Corner& corner = face.corners[static_cast<std::size_t>(k)];
                fmt::format_to(std::back_inserter(text), " {}/{}/{}", corner.position + 1,
                               uvs[static_cast<std::size_t>(corner.uv)],
                               normals[static_cast<std::size_t>(corner.normal)]);
            }
            text += '\n';
        }
    }
    writeFile(file, text);
}

void writeMaterials(const std::filesystem::path& folder)
{
    // Kd is 1 where a picture gives the reflectance; ground pictures have a mean of 0.5 and the vertex
    // colours do the rest.
    writeFile(folder / materialFile, R"(# Made by make_lake; see README.md in this folder.
# Reflectances are linear. Vertex colours multiply them.

newmtl sand
Kd 1 1 1
Ks 0.02 0.02 0.02
Ns 24
map_Kd textures/sand.jpg
norm textures/sand_normal.jpg

newmtl pebbles
Kd 1 1 1
Ks 0.03 0.03 0.03
Ns 40
map_Kd textures/pebbles.jpg
norm textures/pebbles_normal.jpg

newmtl grass
Kd 1 1 1
map_Kd textures/grass.jpg

newmtl forest
Kd 1 1 1
map_Kd textures/forest.jpg
norm textures/forest_normal.jpg

newmtl rock
Kd 1 1 1
Ks 0.03 0.03 0.03
Ns 30
map_Kd textures/rock.jpg
norm textures/rock_normal.jpg

newmtl stone
Kd 1 1 1
Ks 0.03 0.03 0.03
Ns 40
map_Kd textures/rock.jpg

newmtl mountains
Kd 0.75 0.8 0.85
Ke 0.55 0.75 1.05
map_Kd textures/rock.jpg

newmtl bark
Kd 1 1 1
map_Kd textures/bark.jpg
norm textures/bark_normal.jpg

newmtl birch
Kd 1 1 1
map_Kd textures/birch.jpg

newmtl wood
Kd 1 1 1
Ks 0.02 0.02 0.02
Ns 20
map_Kd textures/wood.jpg
norm textures/wood_normal.jpg

newmtl paint
Kd 1 1 1
Ks 0.04 0.04 0.04
Ns 60
map_Kd textures/paint.jpg

newmtl rope
Kd 0.42 0.35 0.24

newmtl leaves
Kd 1 1 1
Tf 0.8 0.8 0.5
map_Kd textures/leaves.png

newmtl needles
Kd 1 1 1
Tf 0.4 0.4 0.3
map_Kd textures/needles.png

newmtl reeds
Kd 1 1 1
Tf 0.6 0.6 0.4
map_Kd textures/reeds.png

newmtl blades
Kd 1 1 1
Tf 0.6 0.6 0.4
map_Kd textures/blades.png

newmtl forest_trees
Kd 1 1 1
Tf 0.6 0.6 0.4
map_Kd textures/forest_trees.png
)");
}

} // namespace tarn::lake
