// Wavefront MTL files, through tinyobjloader. Private to src/scene.
#pragma once

#include "scene/scene.h"
#include "scene/textures.h"

#include <filesystem>
#include <map>
#include <string>

namespace tarn {

/// Index into Scene::materials by name; the first of a name wins.
using MaterialNames = std::map<std::string, int>;

/// The MTL files of a scene, each read once however many models name it.
class MtlLibrary {
public:
    MtlLibrary(Scene& scene, TextureQueue& textures) : scene_(scene), textures_(textures) {}

    /// The materials of `file`, appended to scene.materials the first time.
    /// Warns, as file:line, about values that cannot be used. Throws Error when the file cannot be read.
    const MaterialNames& materialsOf(const std::filesystem::path& file);

private:
    MaterialNames read(const std::filesystem::path& file);

    Scene& scene_;
    TextureQueue& textures_;
    std::map<std::filesystem::path, MaterialNames> known_;
};

} // namespace tarn
