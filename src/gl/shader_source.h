// Puts the text of a shader together from files, and turns the driver's messages back into file and line. No
// OpenGL.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tarn::gl {

/// Name and value of preprocessor definitions: {{"WATER_STEPS", "8"}}.
using Defines = std::vector<std::pair<std::string, std::string>>;

struct ShaderSource {
    std::string text;
    /// The files in it, relative to the root, in the order of the numbers that #line gives them.
    std::vector<std::string> files;
};

/// `#version 330 core`, the definitions, shared/glsl_prelude.glsl, then the file with every `#include "path"`
/// replaced by that file, once each. Paths are relative to the root. Throws Error
/// "shaders/passes/water.frag:3: …" when an include is malformed or its file missing.
/// @param visited receives every file named on the way, also when it throws, so that a mended file is noticed
ShaderSource assembleShader(const std::filesystem::path& root, const std::string& file, const Defines& defines,
                            std::vector<std::string>* visited = nullptr);

/// The compiler's log with "shaders/passes/water.frag:12: message" for what was written "1:100012(5): error:
/// message" (Mesa), "1(100012) : error C1008: message" (NVIDIA) or "ERROR: 1:100012: message" (AMD, Apple,
/// ANGLE). Lines of another form stay as they are.
std::string nameFilesInLog(std::string_view log, const std::filesystem::path& root,
                           const std::vector<std::string>& files);

} // namespace tarn::gl
