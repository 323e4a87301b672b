// The grid that draws the water: the positions of its vertices, and the surface that its triangles make.
//
// Needs blocks.glsl (GridAxis, WaveTerm) and waves.glsl. Lines of vertices along x and z cross, so that the grid covers
// its rectangle without gaps whatever their distances. On a focused axis the position of line i is
//     centre + scale · sinh(u), u even between `from` and `to` over the lines 1 to vertices - 2:
// about `scale` / (lines per unit of u) apart near the eye and in proportion to the distance far from it, which is how
// perspective shrinks what they draw. The first and the last line are the rectangle's ends, outside the view.
// Metres, seconds, radians.

SHARED float gridSinh(float u) { return 0.5 * (exp(u) - exp(-u)); }
SHARED float gridCosh(float u) { return 0.5 * (exp(u) + exp(-u)); }

// Odd by construction: for a large negative x the usual formula is a difference of equals.
SHARED float gridAsinh(float x)
{
    float size = abs(x);
    float u = log(size + sqrt(size * size + 1.0));
    return x < 0.0 ? -u : u;
}

// u of a focused axis' line.
SHARED float gridParameter(GridAxis axis, float line)
{
    float inner = axis.vertices - 3.0; // cells between the second line and the last but one
    return mix(axis.from, axis.to, clamp((line - 1.0) / inner, 0.0, 1.0));
}

// Position of a line, m; lines count from 0.
SHARED float gridPosition(GridAxis axis, float line)
{
    float last = axis.vertices - 1.0;
    if (line <= 0.0) return axis.lower;
    if (line >= last) return axis.upper;
    if (axis.scale <= 0.0)
        return 0.5 * (axis.lower + axis.upper) + (2.0 * line / last - 1.0) * 0.5 * (axis.upper - axis.lower);
    return clamp(axis.centre + axis.scale * gridSinh(gridParameter(axis, line)), axis.lower, axis.upper);
}

// Distance between a focused axis' lines about this one, m; 0 for an even axis, which fades no waves.
SHARED float gridCell(GridAxis axis, float line)
{
    if (axis.scale <= 0.0) return 0.0;
    float step = (axis.to - axis.from) / (axis.vertices - 3.0);
    return axis.scale * gridCosh(gridParameter(axis, line)) * step;
}

// The line at a position, with the part of the cell beyond it as its fraction: gridPosition's inverse. 0 to vertices - 1.
SHARED float gridLine(GridAxis axis, float position)
{
    float last = axis.vertices - 1.0;
    float x = clamp(position, axis.lower, axis.upper);
    float line;
    if (axis.scale <= 0.0) {
        line = (x - axis.lower) / (axis.upper - axis.lower) * last;
    } else {
        float second = gridPosition(axis, 1.0);
        float lastButOne = gridPosition(axis, last - 1.0);
        if (x < second) {
            line = (x - axis.lower) / (second - axis.lower);
        } else if (x > lastButOne) {
            line = last - (axis.upper - x) / (axis.upper - lastButOne);
        } else {
            float u = gridAsinh((x - axis.centre) / axis.scale);
            line = clamp(1.0 + (u - axis.from) / (axis.to - axis.from) * (last - 2.0), 1.0, last - 1.0);
        }
    }
    return clamp(line, 0.0, last);
}

// The weight of a wave at a vertex whose neighbours are `cell` metres away: 1 with four cells or more to a wavelength, 0 with
// one and a half or fewer. With two to one the triangles approximate such a wave worse than flat ones do, and they jump as the
// vertices follow the eye.
SHARED float gridFade(WaveTerm w, vec2 cell)
{
    float advance = length(w.k * cell); // radians from vertex to vertex
    float x = clamp((advance - 1.5707963) / (4.1887902 - 1.5707963), 0.0, 1.0);
    return 1.0 - x * x * (3.0 - 2.0 * x);
}

// Height and slope of the surface at a vertex.
SHARED WaveSum gridSum(WAVE_ARRAY vec2 position, vec2 cell, float t)
{
    WaveSum sum = noWaves();
#define WAVE(i) sum = addWave(sum, waves[i], gridFade(waves[i], cell), position, t);
    EACH_WAVE
#undef WAVE
    return sum;
}

// Height of one component at a vertex.
SHARED float gridVertexHeight(WaveTerm w, vec2 position, vec2 cell, float t)
{
    return gridFade(w, cell) * waveTerm(w, position, t).x;
}

// A right triangle of the grid, and a point in it.
struct GridTriangle {
    vec2 corner;       // x and z of the vertex at the right angle, m
    vec2 opposite;     // x of the vertex beside it, z of the other
    vec2 cellCorner;   // gridCell of each
    vec2 cellOpposite;
    vec2 weight;       // of the vertices at the ends of the legs along x and z
};

// Height of one component at the triangle's point: linear between the vertices.
SHARED float gridTriangleHeight(WaveTerm w, GridTriangle g, float t)
{
    float corner = gridVertexHeight(w, g.corner, g.cellCorner, t);
    float alongX = gridVertexHeight(w, vec2(g.opposite.x, g.corner.y), vec2(g.cellOpposite.x, g.cellCorner.y), t);
    float alongZ = gridVertexHeight(w, vec2(g.corner.x, g.opposite.y), vec2(g.cellCorner.x, g.cellOpposite.y), t);
    return corner + g.weight.x * (alongX - corner) + g.weight.y * (alongZ - corner);
}

// Height of the surface as it is drawn: the triangulation is that of src/render/water_grid.cpp. x is clamped to the
// rectangle.
SHARED float gridHeight(WAVE_ARRAY vec2 x, float t, GridAxis axisX, GridAxis axisZ)
{
    vec2 line = vec2(min(floor(gridLine(axisX, x.x)), axisX.vertices - 2.0),
                     min(floor(gridLine(axisZ, x.y)), axisZ.vertices - 2.0));
    vec2 lower = vec2(gridPosition(axisX, line.x), gridPosition(axisZ, line.y));
    vec2 upper = vec2(gridPosition(axisX, line.x + 1.0), gridPosition(axisZ, line.y + 1.0));
    vec2 f = clamp((x - lower) / max(upper - lower, vec2(1.0e-9)), vec2(0.0), vec2(1.0));
    vec2 cellLower = vec2(gridCell(axisX, line.x), gridCell(axisZ, line.y));
    vec2 cellUpper = vec2(gridCell(axisX, line.x + 1.0), gridCell(axisZ, line.y + 1.0));
    // The cell's diagonal joins the vertices that its two triangles share.
    bool isFirst = f.x + f.y <= 1.0;
    GridTriangle triangle;
    triangle.corner = isFirst ? lower : upper;
    triangle.opposite = isFirst ? upper : lower;
    triangle.cellCorner = isFirst ? cellLower : cellUpper;
    triangle.cellOpposite = isFirst ? cellUpper : cellLower;
    triangle.weight = isFirst ? f : vec2(1.0) - f;
    float height = 0.0;
#define WAVE(i) height += gridTriangleHeight(waves[i], triangle, t);
    EACH_WAVE
#undef WAVE
    return height;
}
