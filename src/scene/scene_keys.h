// The keys of a scene file's tables: names, units and ranges, once for reading and writing. Private to
// src/scene.
#pragma once

#include "scene/scene.h"
#include "scene/table_io.h"

namespace tarn {

/// A material's pictures as the file names them.
struct MaterialFiles {
    std::filesystem::path diffuse, emissive, alpha, normal, bump;
    float bumpScale = 1.0f;
};

void keys(TableIo& io, Sky& sky);
void keys(TableIo& io, WaterBody& water); ///< without its waves and layers
void keys(TableIo& io, Wave& wave);
void keys(TableIo& io, WaterNormalMap::Layer& layer);
void keys(TableIo& io, GivenMap& map);
void keys(TableIo& io, Material& material, MaterialFiles& files);
void keys(TableIo& io, Model& model);
void keys(TableIo& io, Primitive& primitive, std::string& materialName);
void keys(TableIo& io, Element& element); ///< without its children
void keys(TableIo& io, PointLight& light);
void keys(TableIo& io, SpotLight& light);
void keys(TableIo& io, Camera& camera);

inline constexpr std::size_t maxWaveCount = 64; ///< blocks.glsl has room for as many

} // namespace tarn
