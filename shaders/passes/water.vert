// The water's grid, displaced by the waves.
#include "shared/blocks.glsl"
#include "shared/trigonometry.glsl"
#include "shared/waves.glsl"
#include "shared/water_grid.glsl"

layout(location = 0) in vec2 line; // of the grid along x and along z, from 0

out vec3 drawnW;
#ifdef VERTEX_NORMALS
out vec2 vertexSlope;
#endif

void main()
{
    vec2 xz = vec2(gridPosition(waterGrid[0], line.x), gridPosition(waterGrid[1], line.y));
    vec2 cell = vec2(gridCell(waterGrid[0], line.x), gridCell(waterGrid[1], line.y));
    WaveSum sum = gridSum(xz, cell, time);
    drawnW = vec3(xz.x, waterLevel + sum.height, xz.y);
#ifdef VERTEX_NORMALS
    vertexSlope = sum.slope;
#endif
    gl_Position = clipFromWorld * vec4(drawnW, 1.0);
}
