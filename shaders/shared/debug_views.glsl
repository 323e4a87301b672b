// The debug views: pictures of a frame's intermediate values, shown in place of the final one. One table for the shaders that
// write them, for C++ (src/render/debug_view.h) and for what `tarn options` says.
//
// A new view is a code and a row here, a case of `#if DEBUG_VIEW` in the shader that writes it or of selectShown in
// src/render/renderer.cpp, and nothing else; what is forgotten does not compile.

// What a program is to write: the value of its DEBUG_VIEW.
#define DEBUG_VIEW_FINAL 0
#define DEBUG_VIEW_SCENE_DEPTH 1
#define DEBUG_VIEW_REFRACTION 2
#define DEBUG_VIEW_REFRACTION_DEPTH 3
#define DEBUG_VIEW_REFLECTION 4
#define DEBUG_VIEW_FRESNEL 5
#define DEBUG_VIEW_PATH_LENGTH 6
#define DEBUG_VIEW_POSITION_W 7
#define DEBUG_VIEW_NORMALS 8
#define DEBUG_VIEW_CAUSTICS 9
#define DEBUG_VIEW_POSITION_U 10
#define DEBUG_VIEW_POSITION_A 11
#define DEBUG_VIEW_REFLECTION_HIT 12

// How present.frag turns the values of a view into colours: the value of its DISPLAY.
#define DISPLAY_RADIANCE 0  // exposed and tone-mapped, as the final picture
#define DISPLAY_LENGTH 1    // metres
#define DISPLAY_POSITION 2  // world space; alpha 2: a direction
#define DISPLAY_DIRECTION 3 // a unit vector
#define DISPLAY_FRACTION 4  // 0 to 1
#define DISPLAY_RELATIVE 5  // 1 is flat water without loss

#ifdef DEBUG_VIEW_ROW
// Read by C++ alone, which makes strings of name, unit and description: no commas and no quotes in them.
// Enumerator, its code, name on the command line, what writes it (DebugWriter), display, unit, description.
DEBUG_VIEW_ROW(final, DEBUG_VIEW_FINAL, final, all, DISPLAY_RADIANCE, kcd/m^2, the picture itself)
DEBUG_VIEW_ROW(sceneDepth, DEBUG_VIEW_SCENE_DEPTH, scene-depth, scene, DISPLAY_LENGTH, m, depth of the scene along the axis of the eye)
DEBUG_VIEW_ROW(refractionColour, DEBUG_VIEW_REFRACTION, refraction, refraction, DISPLAY_RADIANCE, kcd/m^2, the refraction target as rendered)
DEBUG_VIEW_ROW(refractionDepth, DEBUG_VIEW_REFRACTION_DEPTH, refraction-depth, refraction, DISPLAY_LENGTH, m, its depth along the axis of the refraction camera)
DEBUG_VIEW_ROW(reflection, DEBUG_VIEW_REFLECTION, reflection, reflection, DISPLAY_RADIANCE, kcd/m^2, the reflection target as rendered)
DEBUG_VIEW_ROW(fresnel, DEBUG_VIEW_FRESNEL, fresnel, water, DISPLAY_FRACTION, 1, the reflectance F of the water)
DEBUG_VIEW_ROW(pathLength, DEBUG_VIEW_PATH_LENGTH, path-length, water, DISPLAY_LENGTH, m, |A - U|: length of the path through the water)
DEBUG_VIEW_ROW(positionW, DEBUG_VIEW_POSITION_W, w-position, water, DISPLAY_POSITION, m, W: where the refracted ray is taken to end; world space)
DEBUG_VIEW_ROW(normals, DEBUG_VIEW_NORMALS, normals, sceneAndWater, DISPLAY_DIRECTION, 1, shading normals in world space)
DEBUG_VIEW_ROW(caustics, DEBUG_VIEW_CAUSTICS, caustics, caustics, DISPLAY_RELATIVE, 1, the caustics map: irradiance of a level area relative to the same above the water)
DEBUG_VIEW_ROW(positionU, DEBUG_VIEW_POSITION_U, surface-position, water, DISPLAY_POSITION, m, U: the point of the water surface; world space)
DEBUG_VIEW_ROW(positionA, DEBUG_VIEW_POSITION_A, a-position, water, DISPLAY_POSITION, m, A: the point whose picture is taken for that of W; world space; alpha 1/2: W has no valid sample)
DEBUG_VIEW_ROW(reflectionHit, DEBUG_VIEW_REFLECTION_HIT, reflection-position, water, DISPLAY_POSITION, m, the point that the reflection shows; world space; alpha 2: the direction of what it shows)
#endif
