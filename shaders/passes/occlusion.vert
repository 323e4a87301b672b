// A box that holds what may be hidden: 12 triangles from the number of the vertex alone.
#include "shared/blocks.glsl"

uniform vec3 boxLower; // world
uniform vec3 boxUpper;

void main()
{
    // Two triangles a face; the face's axis and side, and the corner within it.
    int face = gl_VertexID / 6, corner = gl_VertexID % 6;
    int axis = face / 2;
    float side = float(face % 2);
    vec2 within = vec2(corner == 1 || corner == 2 || corner == 4 ? 1.0 : 0.0, corner == 2 || corner == 4 || corner == 5 ? 1.0 : 0.0);
    vec3 fraction = axis == 0 ? vec3(side, within) : axis == 1 ? vec3(within.x, side, within.y) : vec3(within, side);
    gl_Position = clipFromWorld * vec4(mix(boxLower, boxUpper, fraction), 1.0);
}
