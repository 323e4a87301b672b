#include "plan/options.h"

#include <array>

namespace tarn {

namespace {

// In the order of the enumerations' values.
constexpr std::array toneCurveNames{"linear", "reinhard", "aces"};
constexpr std::array upscalerNames{"bilinear", "edge"};
constexpr std::array antialiasingNames{"none", "fxaa", "msaa"};
constexpr std::array waterGridNames{"uniform", "focused"};
constexpr std::array waterNormalsNames{"pixel", "vertex"};
constexpr std::array refractionMethodNames{"planar", "iterative", "raycast", "combined", "auto"};
constexpr std::array refractionCameraNames{"main", "snell", "flat"};
constexpr std::array fresnelNames{"schlick", "table", "exact"};
constexpr std::array attenuationNames{"exponential", "linear"};
constexpr std::array specularNames{"physical", "phong"};
constexpr std::array tableFilterNames{"nearest", "linear"};
constexpr std::array reflectionMethodNames{"distance", "iterative", "raycast", "combined", "auto"};
constexpr std::array marchNames{"classic", "pyramid"};
constexpr std::array heightFilterNames{"nearest", "linear"};
constexpr std::array facetsNames{"one", "three", "five"};
constexpr std::array causticsMethodNames{"cpu", "points", "fetch", "mesh"};
constexpr std::array underwaterRefractionNames{"paper", "exact"};
constexpr std::array depthFormatNames{"depth16", "depth24", "depth32f"};
constexpr std::array stereoOutputNames{"off", "side_by_side", "anaglyph", "pair"};

void visit(FieldVisitor& v, FrameOptions& o)
{
    v.field({"exposure", "Factor on the radiance before the tone curve", "", 0.0, 1000.0}, o.exposure);
    v.choice({"tone_curve", "How radiance becomes the 0 to 1 of the screen"}, o.toneCurve, toneCurveNames);
    v.field({"scale",
             "Pixels that are drawn along one edge of a pixel of the picture: fewer are upscaled, more are averaged "
             "before the tone curve",
             "pixels", 0.25, 8.0},
            o.scale);
    v.renamed("supersampling", "scale");
    v.choice({"upscaler",
              "How a picture that was drawn smaller is brought to its size: bilinear, or by a kernel that follows "
              "edges (FSR 1)"},
             o.upscaler, upscalerNames);
    v.choice({"antialiasing",
              "What smooths edges: nothing, a filter of the shown picture (FXAA), or samples of each pixel "
              "(frame.msaa)"},
             o.antialiasing, antialiasingNames);
    v.field({"msaa", "Samples per pixel of the scene and water passes with frame.antialiasing = msaa; 1 is off",
             "samples", 1, 16},
            o.msaa);
    v.field({"depth_prepass",
             "Draw the depth of foliage before its colours where a pixel has one sample, so that what is hidden "
             "is not shaded"},
            o.depthPrepass);
    v.field({"anisotropy", "Largest anisotropy of texture filtering; 1 is off", "", 1.0, 16.0}, o.anisotropy);
    v.field({"target_ms",
             "Time of a frame that the viewer's governor keeps to by cheaper settings while anything moves; 0 is "
             "off. Of no effect outside the viewer",
             "ms", 0.0, 10000.0},
            o.targetMs);
}

void visit(FieldVisitor& v, DetailOptions& o)
{
    v.field({"pixels",
             "By how many pixels of a pass's target its geometry may be off: what is far away is drawn with fewer "
             "triangles. 0 draws everything in full detail and makes no levels",
             "pixels", 0.0, 16.0},
            o.pixels);
}

void visit(FieldVisitor& v, WaterOptions& o)
{
    v.field({"enabled", "Draw the water and all that belongs to it; off shows the dry basin"}, o.enabled);
    v.field({"reflects", "Mirror at all; off shows only what is refracted, with no Fresnel, glint or glow (Lipp's "
                         "NOREFLECTION)"},
            o.reflects);
    v.choice({"grid", "Where the vertices of the surface stand: evenly over the water as published, or where the view "
                      "is, closest near the eye"},
             o.grid, waterGridNames);
    v.field({"grid_size", "Vertices along one edge of the surface's grid", "vertices", 2, 1025}, o.gridSize);
    v.field({"surface_steps",
             "Steps of Newton's method, per pixel, from the grid's triangle to the waves themselves; 0 stays "
             "on the triangle, as published",
             "steps", 0, 8},
            o.surfaceSteps);
    v.choice({"normals", "Where the wave normals are worked out; per vertex is as published"}, o.normals,
             waterNormalsNames);
    v.field({"filter_waves", "Fade waves that are shorter than a pixel into the roughness of what is mirrored"},
            o.filterWaves);
    v.choice({"fresnel",
              "Reflectance seen from above: exact, from a table of that over the cosine (Lipp), or by Schlick's "
              "formula (Mihalik 2008)"},
             o.fresnel, fresnelNames);
    v.field({"schlick_exponent", "q of Schlick's Fresnel (Mihalik 2008, eq. 7)", "", 0.5, 20.0}, o.schlickExponent);
    v.field({"fresnel_table", "Texels of the table of Fresnel's reflectance", "texels", 16, 4096}, o.fresnelTable);
    v.choice({"fresnel_filter", "How that table is read: the nearest texel as published, or texels blended"},
             o.fresnelFilter, tableFilterNames);
    v.choice({"attenuation",
              "How the bed seen from above fades into the water's colour along its ray: by absorption, or "
              "linearly and alike for all colours as Lipp has it. Light's way down to the bed, and what "
              "an eye under water sees, stay exponential"},
             o.attenuation, attenuationNames);
    v.field(
        {"attenuation_length", "Path at which the linear fade ends in the water's colour alone", "m", 0.01, 10000.0},
        o.attenuationLength);
    v.renamed("sun_roughness", "sun_slope_deviation");
    v.field({"sun_slope_deviation", "Deviation of the slope of waves too small to model: width of the sun's glint", "",
             0.001, 0.5},
            o.sunSlopeDeviation);
    v.choice({"specular",
              "The sun's image on the surface: the glint of its radiance on waves too small to model, or Lipp's "
              "Phong highlight, which is on no honest scale: its light's colour is the radiance of a white "
              "diffuse surface that faces the sun"},
             o.specular, specularNames);
    v.field({"phong_exponent", "Exponent of the Phong highlight", "", 1.0, 10000.0}, o.phongExponent);
    v.field({"phong_strength", "Factor on the Phong highlight, before Fresnel", "", 0.0, 1000.0}, o.phongStrength);
}

void visit(FieldVisitor& v, RefractionOptions& o)
{
    v.field({"enabled", "See into the water; off shows the colour of deep water only"}, o.enabled);
    v.choice({"method",
              "How the point W on the bed is found: in the refraction target's depth, planar with the first "
              "approximation only or iterative; raycast, through a map of heights (Lipp); combined, in the target "
              "from where the map's ray ends; auto takes one of the last three, and tarn explain says why"},
             o.method, refractionMethodNames);
    v.field({"steps", "Steps of the iterative intersection (Mihalik 2008, section 7.1)", "steps", 1, 64}, o.steps);
    v.choice({"camera",
              "Camera of the refraction target: the main one, turned by Snell's law (eq. 1-2), or the main one "
              "through a flat surface"},
             o.camera, refractionCameraNames);
    v.field({"target_size", "Edge of the square refraction target", "pixels", 16, 4096}, o.targetSize);
    v.choice({"depth", "Depth format of the refraction target"}, o.depth, depthFormatNames);
    v.field({"interval",
             "Frames from one drawing of the refraction target to the next; those between look the last one up "
             "from where it was drawn. A jump of the camera draws it",
             "frames", 1, 16},
            o.interval);
    v.field({"clip_offset", "How far above the water the refraction target is still drawn", "m", 0.0, 10.0},
            o.clipOffset);
    v.field({"fov_extension_near", "Factor on the target's field of view (tangents) close to the water", "", 1.0, 3.0},
            o.fovExtensionNear);
    v.field({"fov_extension_far", "Factor on the target's field of view (tangents) far above the water", "", 1.0, 3.0},
            o.fovExtensionFar);
}

void visit(FieldVisitor& v, ReflectionOptions& o)
{
    v.field({"enabled", "Mirror the scene above the water; off mirrors the sky only"}, o.enabled);
    v.choice({"method", "How the mirrored point is found: at a distance along the ray as published, by the "
                        "intersection of section 7.1 in the mirrored picture's depth; raycast, through a map of "
                        "heights (Lipp); combined, through that map where the picture does not show what the ray "
                        "meets; auto takes one of the last three"},
             o.method, reflectionMethodNames);
    v.field({"steps", "Steps of that intersection", "steps", 1, 64}, o.steps);
    v.choice({"facets", "Slopes that stand for the waves too small for a pixel; each mirrors on its own"}, o.facets,
             facetsNames);
    v.field(
        {"distance", "c of W = U + cR: how far along the reflected ray the picture is taken (eq. 6)", "m", 0.0, 100.0},
        o.distance);
    v.field({"target_size", "Edge of the square reflection target", "pixels", 16, 4096}, o.targetSize);
    v.field({"interval", "Frames from one drawing of the reflection target to the next, as refraction.interval",
             "frames", 1, 16},
            o.interval);
    v.field({"clip_offset", "How far below the water the reflection target is still drawn", "m", 0.0, 10.0},
            o.clipOffset);
    v.field({"fov_extension_near", "Factor on the target's field of view (tangents) close to the water", "", 1.0, 3.0},
            o.fovExtensionNear);
    v.field({"fov_extension_far", "Factor on the target's field of view (tangents) far above the water", "", 1.0, 3.0},
            o.fovExtensionFar);
}

void visit(FieldVisitor& v, HeightsOptions& o)
{
    v.field({"map_size", "Edge of the square map of heights, rounded up to a power of two", "texels", 16, 4096},
            o.mapSize);
    v.field({"border", "How far the map reaches beyond the water's rectangle", "m", 0.0, 1000.0}, o.border);
    v.choice({"march", "How a ray is followed: in steps as published, or by a pyramid of the largest heights, so that "
                       "nothing is stepped over"},
             o.march, marchNames);
    v.field({"unit", "The unit that the classic march takes 3 to 10 steps in", "m", 0.001, 1000.0}, o.unit);
    v.choice({"filter", "Heights between texels, in the classic march: the nearest as published, or linear"}, o.filter,
             heightFilterNames);
    v.field(
        {"refine", "Halvings of the step that met the ground, in the classic march; 0 is as published", "steps", 0, 16},
        o.refine);
}

void visit(FieldVisitor& v, SunlightOptions& o)
{
    v.field({"shadows", "Shadows of the sun above the water and, along the refracted sun, below it"}, o.shadows);
    v.field({"map_size", "Edge of the square depth maps along the sun", "texels", 16, 8192}, o.mapSize);
    v.field({"cascades",
             "Maps of what stands over the water, each wider and coarser than the one before, at most; 1 "
             "leaves what is beyond the shore without shadows",
             "maps", 1, 3},
            o.cascades);
    v.choice({"depth", "Depth format of these maps"}, o.depth, depthFormatNames);
    v.field({"taps", "Comparisons along one edge of the shadow filter; 1 gives hard, stepped edges", "", 1, 5}, o.taps);
    v.field(
        {"bias", "Height by which an occluder must clear a surface, beside the surface's own slope", "m", 0.0, 10.0},
        o.bias);
}

void visit(FieldVisitor& v, CausticsOptions& o)
{
    v.field({"enabled", "Light gathered by the waves on what lies under water"}, o.enabled);
    v.choice({"method", "How photons become light: added up on the processor, as points from a copy (Mihalik 2008, "
                        "section 8.1) or fetched in place, or as a mesh whose areas tell the intensity"},
             o.method, causticsMethodNames);
    v.field({"texture_size", "Edge of the square caustics texture", "texels", 16, 4096}, o.textureSize);
    v.field({"photons", "Photons along one edge of what the texture covers", "photons", 16, 4096}, o.photons);
    v.field(
        {"steps", "Looks at the bed's depth in a photon's search for it (Mihalik 2008, section 7.1)", "steps", 1, 16},
        o.steps);
    v.field({"filter", "Radius of the binomial filter over the texture; 0 is off", "texels", 0, 2}, o.filter);
    v.field({"interval", "Frames from one drawing of the caustics to the next; between, those of the last waves stay",
             "frames", 1, 16},
            o.interval);
    v.field({"extent",
             "Edge of what the texture covers; 0 takes the whole water when it is small, else what is near "
             "the eye",
             "m", 0.0, 10000.0},
            o.extent);
}

void visit(FieldVisitor& v, UnderwaterOptions& o)
{
    v.field({"enabled", "What an eye under water sees: haze of the water, and the world through Snell's window"},
            o.enabled);
    v.choice({"refraction", "How rays leave the water: as published (eq. 12), or by Snell with total reflection"},
             o.refraction, underwaterRefractionNames);
    v.field({"distance", "m of W = U + mR: how far along its rays the surface looks from below (eqs. 13 and 15)", "m",
             0.0, 100.0},
            o.distance);
}

void visit(FieldVisitor& v, GlowOptions& o)
{
    v.field({"enabled", "Glow round the sun's highlights on the water"}, o.enabled);
    v.field({"exponent", "Of the highlight, (R.E)^exponent (Mihalik 2008, section 9.3)", "", 1.0, 10000.0}, o.exponent);
    v.field({"colour", "Of the sun in the glow; 1 is white on the screen", "", 0.0, 10.0}, o.colour);
    v.field({"strength", "Factor on the glow", "", 0.0, 10.0}, o.strength);
    v.field({"divisor", "The glow's target has the picture's size divided by this", "", 1, 64}, o.divisor);
}

void visit(FieldVisitor& v, StereoOptions& o)
{
    v.choice({"output", "Draw for two eyes: the left one's picture beside the right one's, both in one for red-cyan "
                        "glasses, or one file each"},
             o.output, stereoOutputNames);
    v.field({"separation", "Distance between the eyes", "m", 0.0, 10.0}, o.separation);
    v.field(
        {"convergence", "How far off both eyes see a thing in the same place of their pictures", "m", 0.1, 100000.0},
        o.convergence);
}

void visit(FieldVisitor& v, PlanOptions& o)
{
    v.field({"enabled", "Leave out of each frame what its picture does not need; off draws everything that the options "
                        "ask for, anew in each frame"},
            o.enabled);
    v.field({"exact", "Apply only rules that lose nothing, and none that is declared approximate"}, o.exact);
    for (std::size_t i = 0; i < ruleCount; ++i) {
        const Rule& known = rule(static_cast<RuleId>(i));
        v.field({known.name, known.leavesOut}, o.rules[i]);
    }
}

template <typename Group> void visitGroup(FieldVisitor& v, const char* name, const char* doc, Group& group)
{
    v.enter(name, doc);
    visit(v, group);
    v.leave();
}

} // namespace

void visit(FieldVisitor& visitor, Options& options)
{
    visitGroup(visitor, "plan", "What a frame may leave out", options.plan);
    visitGroup(visitor, "frame", "The whole picture", options.frame);
    visitGroup(visitor, "detail", "Levels of detail", options.detail);
    visitGroup(visitor, "water", "How the water's surface is drawn", options.water);
    visitGroup(visitor, "refraction", "What is seen through the water", options.refraction);
    visitGroup(visitor, "reflection", "What is seen mirrored in the water", options.reflection);
    visitGroup(visitor, "heights", "The maps of heights that the methods raycast look in", options.heights);
    visitGroup(visitor, "sunlight", "The sun's shadows", options.sunlight);
    visitGroup(visitor, "caustics", "Caustics", options.caustics);
    visitGroup(visitor, "underwater", "Under water", options.underwater);
    visitGroup(visitor, "glow", "Glow", options.glow);
    visitGroup(visitor, "stereo", "Two eyes", options.stereo);
}

} // namespace tarn
