// A first look at the text of a Wavefront OBJ file. Private to src/scene.
//
// tinyobjloader takes much in silence (a zero index, an index out of range, "nan", a face with two corners)
// and knows no line numbers. So every line is checked first; a line that cannot be used is reported as
// file:line and turned into a comment, and tinyobjloader then reads text in which every record is sound.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace tarn {

struct ObjScan {
    std::string text; ///< the file, made safe

    struct Library {
        std::string name;
        std::size_t line;
    };
    std::vector<Library> libraries;
    std::map<std::string, std::size_t> materialLines; ///< the line that first uses each material

    struct SmoothingRun {
        std::size_t firstFace;
        std::uint32_t group; ///< 0: off
    };
    std::vector<SmoothingRun> smoothing;

    std::vector<std::uint32_t> colours; ///< RGBA8 per vertex, or empty when no vertex has one
    std::size_t vertices = 0, uvs = 0, normals = 0, faces = 0;
};

/// Warns about each line that is left out. Throws Error when no face is left.
ObjScan scanObj(std::string text, const std::filesystem::path& file);

} // namespace tarn
