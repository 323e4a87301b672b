#include "scene/obj_file.h"

#include "base/error.h"
#include "base/files.h"
#include "base/log.h"
#include "scene/mesh_build.h"
#include "scene/text_scan.h"

#include <tiny_obj_loader.h>

#include <algorithm>
#include <cmath>
#include <istream>
#include <streambuf>

namespace tarn {

namespace {

namespace fs = std::filesystem;

/// Reads from memory that stays where it is.
class MemoryStream : private std::streambuf, public std::istream {
public:
    explicit MemoryStream(std::string& text) : std::istream(static_cast<std::streambuf*>(this))
    {
        setg(text.data(), text.data(), text.data() + text.size());
    }
};

void readLibrary(const fs::path& objFile, const ObjScan::Library& library, MtlLibrary& libraries,
                 MaterialNames& indexOf)
{
    // The format allows several names in a line, and exporters write names with blanks: the whole is tried
    // first.
    std::vector<std::string> fileNames{library.name};
    std::error_code error;
    if (!fs::exists(objFile.parent_path() / library.name, error)) {
        std::vector<std::string> words;
        std::string_view rest = library.name;
        for (auto word = nextWord(rest); !word.empty(); word = nextWord(rest)) words.emplace_back(word);
        if (words.size() > 1 && fs::exists(objFile.parent_path() / words.front(), error)) fileNames = words;
    }
    for (const std::string& name : fileNames) {
        try {
            const MaterialNames& names = libraries.materialsOf(objFile.parent_path() / name);
            indexOf.insert(names.begin(), names.end()); // keeps the first of a name
        } catch (const Error& problem) {
            log::warning("{}:{}: {}; its materials are drawn grey", objFile.string(), library.line, problem.what());
        }
    }
}

/// Collects what tinyobjloader reads.
class Collector {
public:
    Collector(const ObjScan& scan, const MaterialNames& materials, int fallback)
        : scan_(scan), materials_(materials), fallback_(fallback), material_(fallback)
    {
        source.positions.reserve(scan.vertices);
        source.normals.reserve(scan.normals);
        source.uvs.reserve(scan.uvs);
        source.faces.reserve(scan.faces);
        source.corners.reserve(3 * scan.faces);
    }

    MeshSource source;

    tinyobj::callback_t callbacks() const
    {
        tinyobj::callback_t c;
        c.vertex_cb = [](void* self, float x, float y, float z, float) {
            static_cast<Collector*>(self)->source.positions.emplace_back(x, y, z);
        };
        c.normal_cb = [](void* self, float x, float y, float z) {
            static_cast<Collector*>(self)->source.normals.emplace_back(x, y, z);
        };
        c.texcoord_cb = [](void* self, float u, float v, float) {
            static_cast<Collector*>(self)->source.uvs.emplace_back(u, v);
        };
        c.index_cb = [](void* self, tinyobj::index_t* indices, int count) {
            static_cast<Collector*>(self)->addFace(indices, count);
        };
        c.usemtl_cb = [](void* self, const char* name, int) { static_cast<Collector*>(self)->useMaterial(name); };
        return c;
    }

private:
    static std::int32_t absolute(int index, std::size_t count)
    {
        return index > 0 ? index - 1 : index < 0 ? static_cast<std::int32_t>(count) + index : -1;
    }

    void addFace(const tinyobj::index_t* indices, int count)
    {
        const auto first = static_cast<std::uint32_t>(source.corners.size());
        for (int i = 0; i < count; ++i)
            source.corners.push_back({absolute(indices[i].vertex_index, source.positions.size()),
                                      absolute(indices[i].texcoord_index, source.uvs.size()),
                                      absolute(indices[i].normal_index, source.normals.size())});
        while (run_ < scan_.smoothing.size() && scan_.smoothing[run_].firstFace <= source.faces.size())
            smoothing_ = scan_.smoothing[run_++].group;
        source.faces.push_back({first, static_cast<std::uint32_t>(count), material_, smoothing_});
    }

    void useMaterial(std::string_view name)
    {
        const auto found = materials_.find(std::string(trimBlanks(name)));
        material_ = found == materials_.end() ? fallback_ : found->second;
    }

    const ObjScan& scan_;
    const MaterialNames& materials_;
    int fallback_, material_;
    std::uint32_t smoothing_ = 0;
    std::size_t run_ = 0;
};

/// Normals without a direction count as missing; coordinates that no float holds as zero.
void cleanUp(MeshSource& source)
{
    std::vector<bool> usable(source.normals.size());
    for (std::size_t i = 0; i < usable.size(); ++i) {
        const float length = glm::length(source.normals[i]);
        usable[i] = length > 0.0f && std::isfinite(length);
        if (usable[i]) source.normals[i] /= length;
    }
    for (vec2& uv : source.uvs)
        if (!std::isfinite(uv.x) || !std::isfinite(uv.y)) uv = vec2(0.0f);
    for (Corner& corner : source.corners)
        if (corner.normal >= 0 && !usable[static_cast<std::size_t>(corner.normal)]) corner.normal = -1;
}

void warnOfUnknown(const ObjScan& scan, const MaterialNames& indexOf, const fs::path& file)
{
    for (const auto& [name, line] : scan.materialLines) {
        if (indexOf.contains(name)) continue;
        log::warning("{}:{}: there is no material '{}'; drawn grey", file.string(), line, name);
    }
}

} // namespace

ObjFile::ObjFile(const fs::path& file) : file_(file), scan_(scanObj(readFile(file), file)) {}

void ObjFile::findMaterials(MtlLibrary& libraries, int material)
{
    if (material >= 0) {
        fallback_ = material;
        return;
    }
    for (const auto& library : scan_.libraries) readLibrary(file_, library, libraries, indexOf_);
    warnOfUnknown(scan_, indexOf_, file_);
}

Mesh ObjFile::build()
{
    Collector collector(scan_, indexOf_, fallback_);
    MemoryStream stream(scan_.text);
    std::string warning, error;
    if (!tinyobj::LoadObjWithCallback(stream, collector.callbacks(), &collector, nullptr, &warning, &error))
        throw Error("{}: cannot be read ({})", file_.string(), error);

    MeshSource& source = collector.source;
    source.colours = std::move(scan_.colours);
    scan_.text = {};
    cleanUp(source);
    computeNormals(source);
    triangulate(source);
    if (source.faces.empty())
        throw Error("{}: nothing to draw, every face has fewer than three different corners", file_.string());
    return buildMesh(source, file_.stem().string());
}

void addGrey(Mesh& mesh, Scene& scene)
{
    const auto grey = static_cast<int>(scene.materials.size());
    bool isUsed = false;
    for (MeshPart& part : mesh.parts) {
        if (part.material != missingMaterial) continue;
        part.material = grey;
        isUsed = true;
    }
    if (!isUsed) return;
    Material material;
    material.name = "grey";
    material.fromModel = true;
    scene.materials.push_back(material);
}

} // namespace tarn
