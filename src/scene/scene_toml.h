// The TOML text of a scene file as a Scene that has not read its models and pictures yet. Private to
// src/scene.
#pragma once

#include "scene/scene.h"
#include "scene/textures.h"

#include <string>

namespace tarn {

/// Throws Error, one line with file, line and key, for anything that the format does not know or allow.
Scene parseScene(const std::string& text, const std::filesystem::path& file, TextureQueue& textures);

} // namespace tarn
