#include "render/passes/water.h"

#include "gl/state.h"
#include "render/unrolled.h"

namespace tarn {

namespace {

/// Whether the mirrored point is found in the mirrored picture's depth.
bool searchesReflection(const Options& options, const WaterPass::Inputs& inputs)
{
    const bool asPublished = inputs.underwater && options.underwater.refraction == UnderwaterOptions::Refraction::paper;
    return inputs.reflection && !asPublished && options.reflection.method != ReflectionOptions::Method::distance;
}

void addBedDefines(gl::Defines& defines, const HeightsOptions& options, const WaterPass::Bed& bed)
{
    defines.emplace_back("RAYCAST", "1");
    if (options.march == HeightsOptions::March::classic) {
        if (options.filter == HeightsOptions::Filter::linear) defines.emplace_back("MARCH_LINEAR", "1");
        defines.emplace_back("MARCH_REFINE", std::to_string(options.refine));
    }
    if (bed.lit.caustics) defines.emplace_back("CAUSTICS", "1");
    if (!bed.lit.shadows) return;
    defines.emplace_back("SHADOWS", "1");
    defines.emplace_back("SHADOW_TAPS", std::to_string(bed.sun.taps));
}

void setBed(gl::Program& p, const WaterPass::Bed& bed)
{
    const HeightField& field = bed.map.field();
    p.texture("bedHeights", bed.map.heights());
    p.texture("bedRadiance", bed.map.radiance());
    p.texture("bedResponse", bed.map.response());
    p.set("bedRect", vec4(field.rect.centre, field.rect.halfExtent));
    p.set("bedLowest", field.lowest);
    if (bed.lit.caustics) p.texture("causticsMap", *bed.sun.caustics);
    if (!bed.lit.shadows) return;
    p.texture("sunDepth", *bed.sun.depth);
}

void setAboveWater(gl::Program& p, const AboveWaterHeightsPass& aboveWater)
{
    using From = AboveWaterHeightsPass::From;
    p.texture("aboveWaterHeights", aboveWater.heights());
    p.texture("aboveWaterTops", aboveWater.radiance(From::above));
    p.texture("aboveWaterUndersides", aboveWater.radiance(From::below));
    p.set("aboveWaterRect", vec4(aboveWater.rect().centre, aboveWater.rect().halfExtent));
    p.set("aboveWaterHighest", aboveWater.highest());
}

bool showsPhong(const Options& options, const WaterPass::Inputs& inputs)
{
    return !inputs.underwater && options.water.reflects && options.water.specular == WaterOptions::Specular::phong;
}

bool fadesLinearly(const Options& options, const WaterPass::Inputs& inputs)
{
    return !inputs.underwater && options.water.attenuation == WaterOptions::Attenuation::linear;
}

bool readsFresnelTable(const Options& options, const WaterPass::Inputs& inputs)
{
    return !inputs.underwater && options.water.reflects && options.water.fresnel == WaterOptions::Fresnel::table;
}

} // namespace

gl::Program& WaterPass::program(const Options& options, const Inputs& inputs)
{
    gl::Defines defines{{"DEBUG_VIEW", std::to_string(static_cast<int>(writtenByWater(inputs.view)))},
                        eachWave(inputs.waveCount)};
    if (inputs.underwater) defines.emplace_back("UNDERWATER", "1");
    if (inputs.underwater && options.underwater.refraction == UnderwaterOptions::Refraction::paper)
        defines.emplace_back("PAPER", "1");
    if (inputs.waterline) defines.emplace_back("WATERLINE", "1");
    if (inputs.refraction) defines.emplace_back("REFRACTION", "1");
    if (inputs.refraction && inputs.refractionView->flatWater) defines.emplace_back("FLAT_CAMERA", "1");
    if (inputs.reflection) defines.emplace_back("REFLECTION", "1");
    if (options.refraction.method != RefractionOptions::Method::planar) defines.emplace_back("ITERATIVE", "1");
    if (inputs.bed) addBedDefines(defines, options.heights, *inputs.bed);
    if (inputs.bed && inputs.refraction) defines.emplace_back("BED_TARGET", "1");
    if (inputs.aboveWater) defines.emplace_back("RAYCAST_REFLECTION", "1");
    if ((inputs.bed || inputs.aboveWater) && options.heights.march == HeightsOptions::March::pyramid)
        defines.emplace_back("PYRAMID", "1");
    if (options.water.filterWaves) defines.emplace_back("FILTER_WAVES", "1");
    if (options.water.normals == WaterOptions::Normals::vertex) defines.emplace_back("VERTEX_NORMALS", "1");
    if (!options.water.reflects) defines.emplace_back("NO_REFLECTION", "1");
    if (inputs.normalMap) defines.emplace_back("NORMAL_MAP", "1");
    addSurfaceSteps(defines, options.water.surfaceSteps);
    if (options.water.fresnel == WaterOptions::Fresnel::exact) defines.emplace_back("EXACT_FRESNEL", "1");
    if (readsFresnelTable(options, inputs))
        defines.emplace_back("FRESNEL_TABLE",
                             options.water.fresnelFilter == optics::TableFilter::linear ? "true" : "false");
    if ((inputs.refraction || inputs.bed) && fadesLinearly(options, inputs))
        defines.emplace_back("LINEAR_ATTENUATION", "1");
    if (showsPhong(options, inputs)) defines.emplace_back("PHONG", "1");
    constexpr int mostSteps = 8;
    if (inputs.refraction)
        defines.push_back(unrolled("EACH_REFRACTION_STEP", "REFRACTION_STEP", options.refraction.steps - 1, mostSteps));
    if (searchesReflection(options, inputs)) {
        defines.emplace_back("ITERATIVE_REFLECTION", "1");
        defines.push_back(unrolled("EACH_REFLECTION_STEP", "REFLECTION_STEP", options.reflection.steps - 1, mostSteps));
    }
    if (!inputs.underwater && options.water.reflects && options.reflection.facets != ReflectionOptions::Facets::one) {
        const int facets = options.reflection.facets == ReflectionOptions::Facets::three ? 3 : 5;
        defines.emplace_back("FACETS", std::to_string(facets));
        defines.push_back(unrolled("EACH_FACET", "FACET", facets - 1, facets)); // beside the one in the middle
    }
    auto& program = programs_[defines];
    if (!program) program = shaders_.program("water", "passes/water.vert", "passes/water.frag", defines);
    return *program;
}

void WaterPass::draw(const gl::Target& frame, WaterGrid& grid, const Options& options, const Inputs& inputs,
                     FrameReport::Pass& stats)
{
    gl::Program& p = program(options, inputs);
    const auto use = [&] {
        gl::apply({});
        frame.bind();
        p.use();
    };
    use();
    p.texture("skyMap", inputs.skyMap);
    p.set("footprint", inputs.footprint);
    if (inputs.bed) setBed(p, *inputs.bed);
    if (inputs.aboveWater) setAboveWater(p, *inputs.aboveWater);
    if ((inputs.bed || inputs.aboveWater) && options.heights.march == HeightsOptions::March::classic)
        p.set("marchUnit", options.heights.unit);
    if (inputs.waterline) p.texture("waterline", *inputs.waterline);
    if (options.water.fresnel == WaterOptions::Fresnel::schlick || inputs.underwater)
        p.set("schlickExponent", options.water.schlickExponent);
    if (readsFresnelTable(options, inputs)) p.texture("fresnelTable", fresnelTable_.of(inputs.ior, options.water));
    if (inputs.refraction) {
        const View& view = *inputs.refractionView;
        p.texture("refractionColour", inputs.refraction->colour());
        p.set("refractionViewFromWorld", view.viewFromWorld);
        p.set("refractionClipFromView", view.clipFromView);
        p.texture("refractionDepth", inputs.refraction->depth());
        if (view.flatWater) p.texture("refractionPosition", inputs.refraction->colour(1));
        p.set("worldFromRefractionView", glm::inverse(view.viewFromWorld));
        p.set("refractionNearFar", vec2(view.nearPlane, view.farPlane));
    }
    if ((inputs.refraction || inputs.bed) && fadesLinearly(options, inputs))
        p.set("attenuationLength", options.water.attenuationLength);
    if (inputs.normalMap) inputs.normalMap.set(p);
    if (showsPhong(options, inputs)) {
        p.set("phongExponent", options.water.phongExponent);
        p.set("phongStrength", options.water.phongStrength);
    }
    if (inputs.underwater) p.set("refractionDistance", options.underwater.distance);
    if (inputs.reflection) {
        p.texture("reflectionColour", inputs.reflection->colour());
        const View& view = *inputs.reflectionView;
        const bool searches = searchesReflection(options, inputs);
        if (!searches) {
            p.set("reflectionClipFromWorld", view.clipFromWorld());
            p.set("reflectionDistance", inputs.underwater ? options.underwater.distance : options.reflection.distance);
        }
        if (searches || inputs.view == DebugView::reflectionHit) {
            p.texture("reflectionDepth", inputs.reflection->depth());
            p.set("reflectionClipFromView", view.clipFromView);
            p.set("reflectionNearFar", vec2(view.nearPlane, view.farPlane));
        }
        if (searches) {
            p.set("reflectionViewFromWorld", view.viewFromWorld);
        }
        if (inputs.view == DebugView::reflectionHit) p.set("worldFromReflectionView", glm::inverse(view.viewFromWorld));
    }
    if (inputs.culling)
        grid.draw(options.water.gridSize, *inputs.culling, stats, use);
    else
        grid.draw(options.water.gridSize, stats);
}

} // namespace tarn
