// Wavefront OBJ files, through tinyobjloader. Private to src/scene.
#pragma once

#include "scene/mtl_file.h"
#include "scene/obj_scan.h"
#include "scene/scene.h"

#include <filesystem>
#include <limits>

namespace tarn {

/// MeshPart::material of faces whose own is missing, until addGrey() has given them one.
inline constexpr int missingMaterial = std::numeric_limits<int>::max();

/// A mesh in three steps, all of them once and in this order. The first and the last take the time, and may run beside
/// those of other files: they touch nothing else. Records that cannot be used are left out with a warning that names
/// file and line.
class ObjFile {
public:
    /// Reads and checks the text. Throws Error when that cannot be read or has no faces.
    explicit ObjFile(const std::filesystem::path& file);

    /// @param libraries read the files that the text names
    /// @param material an index that replaces the file's own materials, or -1
    void findMaterials(MtlLibrary& libraries, int material);

    /// Throws Error when there is nothing to draw.
    Mesh build();

private:
    std::filesystem::path file_;
    ObjScan scan_;
    MaterialNames indexOf_;
    int fallback_ = missingMaterial;
};

/// Appends a grey material to the scene's for the mesh's faces whose own is missing, if there are any.
void addGrey(Mesh& mesh, Scene& scene);

} // namespace tarn
