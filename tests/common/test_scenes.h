// Small scenes whose picture is known, built in memory.
#pragma once

#include "scene/scene.h"

#include <functional>

namespace tarn::test {

/// A quad of a material, facing up, at a height; edge lengths in metres, centred on the axis.
void addFloor(Scene& scene, float height, float edge, int material, int tiles = 1);

/// A box of a material.
void addBox(Scene& scene, const vec3& lower, const vec3& upper, int material);

int addMaterial(Scene& scene, const vec3& diffuse);

/// A square of ground of cells x cells quads from the origin along +x and +z, in strips along x: one chunk each, whose
/// vertices are shared along their borders. Normals are those of the height, texture coordinates metres.
/// @param spacing edge of a quad, m
Mesh groundMesh(const std::function<float(float x, float z)>& height, int cells, float spacing, int strips);

/// A mesh with chunks of its own, placed at the origin.
void addModel(Scene& scene, Mesh mesh);

/// A still lake of a given depth over a flat bed, under a constant sky of radiance 1 and no sun; clear water that
/// takes nothing away, unless the test says so.
/// bedEdge: of the bed; 0 for the lake's own.
Scene flatLake(float depth, float edge = 400.0f, float bedEdge = 0.0f);

/// That lake, lit by a sun; its waves put detail of less than a pixel into a small picture of lookAcross().
Scene rippledLake();
Camera lookAcross();

/// Gives the water a normal map of edge x edge texels in floating point.
/// slope: dy/dx and dy/dz at (u, v) of the picture, v upward
void addNormalMap(Scene& scene, int edge, const std::function<vec2(const vec2& uv)>& slope);

} // namespace tarn::test
