// Scene files: TOML, or a bare Wavefront OBJ.
//
// Units are metres, seconds and degrees; y is up. Light is linear RGB: radiance in kcd/m², irradiance in klx. Where a
// colour, an absorption or a scale is asked for, one number stands for equal ones. Every key is optional but those
// marked (!); the values shown are defaults or examples. Unknown keys, wrong types and values out of range are errors
// that name file, line and the nearest valid key. Paths are relative to the scene file.
//
//     name = "The lake"
//
//     [options]                      # any option of `tarn options`; dotted or nested, arrays for vectors
//     frame.exposure = 0.1
//
//     [sun]                          # absent: no sun
//     elevation = 35.0               # degrees above the horizon, -90..90
//     azimuth = 120.0                # degrees in the xz plane, from +x towards +z (as wave directions)
//     # direction = [0.3, 0.6, 0.2]  # instead of elevation/azimuth: towards the sun (normalised on loading)
//     irradiance = "auto"            # "auto" (daylight model), a number, or [r, g, b], on a surface facing the sun
//
//     [sky]                          # absent: daylight
//     kind = "daylight"              # "constant" | "daylight" | "picture"
//     radiance = [1, 1, 1]           # constant: its radiance; picture: multiplies it; 0..
//     turbidity = 3.0                # daylight, 2 (clear) .. 10 (haze)
//     ground_albedo = 0.15           # daylight, below the horizon, 0..1
//     file = "sky.exr"               # picture (!): 2:1 latitude-longitude, or cube map: 4:3 or 3:4 cross,
//                                    # 6:1 or 1:6 strip (right, left, top, bottom, front, back; front is -z)
//     rotation = 0.0                 # picture, about y, degrees
//     lighting = 1.0                 # scales the light it casts, not what is seen of it, 0..
//
//     [water]                        # absent: no water
//     level = 0.0                    # y of the surface at rest
//     centre = [0, 0]                # x, z
//     extent = [100, 100]            # edge lengths x, z (or one number), > 0
//     ior = 1.33                     # 1..4
//     absorption = [0.5, 0.5, 0.5]   # 1/m, 0..
//     colour = [0.0, 0.2, 0.1]       # reflectance of infinitely deep water, 0..1
//
//     normal_map = "ripples.png"     # ripples: normals with x, y (up), z in red, green, blue; seamless. With it only:
//     normal_map_tile = 2.0          # edge of the water that it covers once, m, 0.001..10000
//     normal_map_bump = 1.0          # factor on the upward part: 1 plain, 0 steepest
//
//     [[water.normal_layers]]        # of that map: four, or none for the defaults
//     velocity = [0.31, 0.08]        # of its drift along x and z, m/s (!)
//
//     [[water.waves]]                # at most 64
//     amplitude = 0.05               # m, 0..
//     wavelength = 4.0               # m, > 0
//     direction = 0.0                # degrees, from +x towards +z
//     phase = 0.0                    # degrees
//     period = 0.0                   # s; 0: deep-water dispersion
//
//     [maps.bed]                     # the bed's map of heights as a picture, where rays are marched
//     (scene/map_picture.h); file = "bed.exr"               # (!) absent: it is drawn centre = [0, 0]                #
//     x, z of what it covers, and extent = [100, 100]            # edge lengths x, z (or one number), m, > 0: without
//     it as the file's header says
//
//     [maps.above_water]                  # the same of what stands over the water
//     file = "above_water.exr"
//
//     [[materials]]
//     name = "checker"               # (!)
//     diffuse = [0.8, 0.8, 0.8]      # 0..1
//     specular = [0, 0, 0]           # 0..1
//     transmission = [0, 0, 0]       # 0..1, of thin alpha-tested leaves: share of the diffuse reflectance
//     shininess = 32.0               # 1..10000
//     emissive = [0, 0, 0]           # 0.., radiance
//     alpha = 1.0                    # 0..1
//     diffuse_map = "checker.png"
//     emissive_map = "…"
//     alpha_map = "…"
//     normal_map = "…"               # tangent space; or
//     bump_map = "…"                 # a height picture, made into normals: black to white is 2 % of the picture's
//     width bump_scale = 1.0               # times this two_sided = false alpha_cutoff = 0.5             # 0..1
//
//     [[models]]
//     name = "trees"                 # (!)
//     file = "trees.obj"             # (!)
//     material = "checker"           # overrides the MTL's for the whole model
//
//     [[primitives]]
//     name = "bed"                   # (!)
//     kind = "plane"                 # (!) "plane" (xz, normal +y) | "box" | "sphere"; centred on the origin
//     size = [10, 1, 10]             # plane: x and z extents (y unused); box: edges; sphere: diameters. > 0
//     segments = 1                   # plane: quads a side (default 1); sphere: rings (default 32); 1..1024
//     uv_scale = [1, 1]              # repeats of the texture over a plane, a box face, once round a sphere
//     material = "checker"           # default: grey
//
//     [[elements]]                   # absent: every model and primitive once, where it is
//     name = "the bed"
//     shape = "bed"                  # name of a model or primitive; absent: only a group
//     translation = [0, -2, 0]
//     rotation = [0, 0, 0]           # degrees, about x, then y, then z
//     scale = [1, 1, 1]              # or one number; not 0
//     visible = true
//     [[elements.children]]          # the same again, relative to the parent, up to 64 deep
//
//     [[point_lights]]
//     name = "lamp"
//     position = [0, 2, 0]
//     intensity = [1, 1, 1]          # irradiance at distance r is intensity / r²
//
//     [[spot_lights]]
//     name = "torch"
//     position = [0, 2, 0]
//     direction = [0, -1, 0]
//     intensity = [1, 1, 1]
//     inner_angle = 20.0             # half angles, 0 < inner <= outer < 90
//     outer_angle = 28.6
//
//     [[cameras]]                    # absent: cameras from the bounds ("overview", "side", "top")
//     name = "overview"              # (!)
//     eye = [0, 2, 10]
//     target = [0, 0, 0]
//     up = [0, 1, 0]
//     fov = 50.0                     # vertical, degrees, 1..170
//     near = 0.1                     # > 0, < far
//     far = 1000.0
//
// A bare OBJ gets its cameras from its bounds, a daylight sky with sun, frame.exposure = 0.1, and water a quarter up
// its height.
#pragma once

#include "base/progress.h"
#include "scene/scene.h"

#include <filesystem>

namespace tarn {

struct LoadOptions {
    std::optional<float> waterLevel; ///< overrides the file's (and gives a bare OBJ its lake)
    Progress* progress = nullptr;    ///< told about files read and pictures decoded; may be null
};

/// Loads `file` and everything it names. Throws Error (one line: file, place, what to do) when nothing can be
/// drawn; warns (file:line) and carries on when something can.
Scene loadScene(const std::filesystem::path& file, const LoadOptions& options = {});

/// Writes the TOML that loadScene reads back to the same scene (models and pictures stay in their files).
/// The file appears whole or not at all.
void saveScene(const Scene& scene, const std::filesystem::path& file);

} // namespace tarn
