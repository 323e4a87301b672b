// A ray through a map of heights and its pyramid, whose mip level n holds the range of 2^n + 1 by 2^n + 1 texels' centres:
// common to the marches through the bed and through what stands over the water.
//
// In the map's own coordinates the centre of texel (i, j) is at (i, j).

// rect: what the map covers, centre x, z and half extent x, z, m; size: its texels.
vec2 mapTexel(vec2 xz, vec4 rect, ivec2 size) { return (xz - rect.xy + rect.zw) * (0.5 / rect.zw) * vec2(size) - 0.5; }

#ifdef PYRAMID
struct PyramidRay {
    vec3 start; // map coordinates, and the height
    vec3 along; // how these change for each metre
    vec2 size;  // of the map, texels
    int top;    // mip level of a single block
    float past; // metres by which a step goes past a cell's edge, more than rounding takes back
};

// The block that a ray is in, at one mip level.
struct PyramidBlock {
    vec3 here;    // the ray's position, map coordinates and height
    vec2 corner;  // the block's number; at mip level 0 the cell's first texel
    float within; // metres to where the ray leaves it
    bool isOnMap;
};

const int maxPyramidSteps = 200; // more than a ray needs to cross the whole map over undulating ground

PyramidRay pyramidRay(vec3 from, vec3 direction, vec4 rect, ivec2 size)
{
    PyramidRay ray;
    ray.size = vec2(size);
    ray.top = int(log2(ray.size.x) + 0.5);
    ray.start = vec3(mapTexel(from.xz, rect, size), from.y);
    ray.along = vec3(direction.xz * ray.size * 0.5 / rect.zw, direction.y);
    ray.past = 1.0e-3 / max(max(abs(ray.along.x), abs(ray.along.y)), 1.0e-3);
    return ray;
}

// end: metres beyond which nothing can be met.
PyramidBlock pyramidBlock(PyramidRay ray, float t, int mipLevel, float end)
{
    PyramidBlock block;
    block.here = ray.start + t * ray.along;
    block.isOnMap = all(greaterThanEqual(block.here.xy, vec2(-0.5))) && all(lessThanEqual(block.here.xy, ray.size - 0.5));
    float blockSize = exp2(float(mipLevel));
    block.corner = floor(block.here.xy / blockSize);
    vec2 direction = ray.along.xy;
    vec2 safe = vec2(abs(direction.x) < 1.0e-6 ? 1.0e-6 : direction.x, abs(direction.y) < 1.0e-6 ? 1.0e-6 : direction.y);
    vec2 exits = ((block.corner + step(vec2(0.0), safe)) * blockSize - block.here.xy) / safe;
    block.within = max(min(min(exits.x, exits.y), end - t), 0.0);
    return block;
}
#endif
