// Photons become light in the caustics map (Mihálik 2008, section 8.1).
//
// Points (neither define): each photon's vertex comes from a buffer. FETCH: the same, read from the photon texture.
// MESH: photons are the corners of triangles that carry the light between them.
#include "shared/blocks.glsl"
#include "shared/refraction.glsl"
#include "shared/caustics.glsl"

#if defined(FETCH) || defined(MESH)
uniform sampler2D photons;
uniform int photonsPerSide; // the lattice is square
#else
layout(location = 0) in vec4 photonV;
#endif
uniform float textureResolution; // texels per side of the map

flat out vec3 light;
flat out vec2 centre; // of a point, in texels
#ifdef MESH
flat out float isPoint; // 1: the triangle was too small to be drawn as one
#endif

vec3 lightOf(vec4 photon) { return photonLight(photon.z, photon.w, absorption); }

#ifdef MESH
void main()
{
    int triangle = gl_VertexID / 3;
    int own = gl_VertexID % 3;
    int cell = triangle / 2;
    ivec2 first = ivec2(cell % (photonsPerSide - 1), cell / (photonsPerSide - 1)); // photon at the cell's corner
    ivec2 offset[3] = (triangle & 1) == 0 ? ivec2[3](ivec2(0, 0), ivec2(0, 1), ivec2(1, 0))
                                          : ivec2[3](ivec2(1, 0), ivec2(0, 1), ivec2(1, 1));
    vec2 corner[3]; // on the bed, in texels
    light = vec3(0.0);
    for (int i = 0; i < 3; ++i) {
        vec4 photon = texelFetch(photons, first + offset[i], 0);
        corner[i] = photon.xy * textureResolution;
        light += lightOf(photon) / 6.0; // the triangle is half a photon's cell
    }
    float area = triangleArea(corner[1] - corner[0], corner[2] - corner[0]);
    centre = (corner[0] + corner[1] + corner[2]) / 3.0;

    // A point with the same light is drawn as a triangle round that point's square.
    isPoint = isAddedAsPoint(area) ? 1.0 : 0.0;
    vec2 position = corner[own];
    if (isPoint > 0.5)
        position = centre + vec2(own == 1 ? 4.5 : -1.5, own == 2 ? 4.5 : -1.5);
    else
        light /= area;
    gl_Position = vec4(2.0 * position / textureResolution - 1.0, 0.0, 1.0);
}
#else
void main()
{
#ifdef FETCH
    vec4 photon = texelFetch(photons, ivec2(gl_VertexID % photonsPerSide, gl_VertexID / photonsPerSide), 0);
#else
    vec4 photon = photonV;
#endif
    light = lightOf(photon);
    centre = photon.xy * textureResolution;
    gl_PointSize = 2.0; // the square of it holds the centres of the four nearest texels
    gl_Position = photon.z > 0.0 ? vec4(2.0 * photon.xy - 1.0, 0.0, 1.0) : vec4(2.0, 2.0, 2.0, 1.0);
}
#endif
