// Photons become light in the caustics texture (Mihálik 2008, section 8.1).
//
// Points (neither define): each photon's vertex comes from a buffer. FETCH: the same, read from the photon texture.
// MESH: photons are the corners of triangles that carry the light between them.
#include "shared/blocks.glsl"
#include "shared/refraction.glsl"

#if defined(FETCH) || defined(MESH)
uniform sampler2D photons;
uniform int photonEdge; // photons along an edge
#else
layout(location = 0) in vec4 photonV;
#endif
uniform float textureEdge; // texels along an edge

#ifdef MESH
out vec2 cell;  // in photons
out vec3 light;
#else
flat out vec2 centre; // in texels
flat out vec3 light;
#endif

void main()
{
#if defined(FETCH) || defined(MESH)
    ivec2 place = ivec2(gl_VertexID % photonEdge, gl_VertexID / photonEdge);
    vec4 photon = texelFetch(photons, place, 0);
#else
    vec4 photon = photonV;
#endif
    light = photon.z * beerLambert(absorption, photon.w);
    gl_Position = vec4(2.0 * photon.xy - 1.0, 0.0, 1.0);
#ifdef MESH
    cell = vec2(place);
#else
    centre = photon.xy * textureEdge;
    gl_PointSize = 2.0; // the square of it holds the centres of the four nearest texels
    if (photon.z <= 0.0) gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
#endif
}
