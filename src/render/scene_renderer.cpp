#include "render/scene_renderer.h"

#include "gl/state.h"
#include "render/debug_view.h"
#include "render/unrolled.h"

#include <array>
#include <set>

namespace tarn {

namespace {

enum Feature : unsigned {
    diffuseMap = 1u << 0,
    normalMap = 1u << 1,
    emissiveMap = 1u << 2,
    alphaMap = 1u << 3,
    alphaTest = 1u << 4,
    turnNormal = 1u << 5,
    specular = 1u << 6,
    underwaterEye = 1u << 8,
    alphaToCoverage = 1u << 9,
    debugNormals = 1u << 10,
    sunDisc = 1u << 11,
    transmission = 1u << 12,
    shadows = 1u << 13,
    caustics = 1u << 14,
    depthOnly = 1u << 15,
    skyWaterline = 1u << 16,
    inAir = 1u << 17,
    inWater = 1u << 18,
    flatWater = 1u << 19,
    dithered = 1u << 20,
    forMap = 1u << 21,
    countsFaces = 1u << 22,
};

struct FeatureName {
    Feature feature;
    const char* define;
};
constexpr FeatureName featureNames[] = {
    {diffuseMap, "DIFFUSE_MAP"}, {normalMap, "NORMAL_MAP"},      {emissiveMap, "EMISSIVE_MAP"},
    {alphaMap, "ALPHA_MAP"},     {alphaTest, "ALPHA_TEST"},      {turnNormal, "TURN_NORMAL"},
    {specular, "SPECULAR"},      {underwaterEye, "UNDERWATER"},  {alphaToCoverage, "ALPHA_TO_COVERAGE"},
    {sunDisc, "SUN_DISC"},       {transmission, "TRANSMISSION"}, {shadows, "SHADOWS"},
    {caustics, "CAUSTICS"},      {skyWaterline, "WATERLINE"},    {inAir, "IN_AIR"},
    {inWater, "IN_WATER"},       {flatWater, "FLAT_WATER"},      {dithered, "DITHERED"},
    {forMap, "FOR_MAP"},         {countsFaces, "COUNT_FACES"}};

/// What decides whether a surface is there at all.
constexpr unsigned shapeFeatures = diffuseMap | alphaMap | alphaTest | dithered | countsFaces | flatWater;

gl::Defines definesOf(unsigned features)
{
    gl::Defines defines;
    for (const auto& [feature, define] : featureNames)
        if (features & feature) defines.emplace_back(define, "1");
    return defines;
}

bool transmits(const Material& material) { return material.alphaTested && material.transmission != vec3(0.0f); }

} // namespace

SceneRenderer::SceneRenderer(const GpuScene& scene, gl::ShaderLibrary& shaders)
    : scene_(scene), shaders_(shaders), meshArrays_(scene.scene().meshes.size())
{
    for (const Instance& instance : scene.instances())
        worldFromModelNormal_.push_back(glm::transpose(glm::inverse(mat3(instance.worldFromModel))));
    lightCount_ = drawnLightCount(scene.scene());
    allUnderwater_.upload(std::array<std::uint8_t, 1>{255});
    setWater(scene.scene().water.present ? &scene.scene().water : nullptr);
}

void SceneRenderer::setWater(const WaterBody* water)
{
    constexpr float rim = 0.01f; // as in scene.frag
    water_ = water;
    media_.clear();
    for (const Chunk& chunk : scene_.chunks().all)
        media_.push_back(water ? mediumOf(chunk.boundsW, *water, rim) : Medium::air);
}

unsigned SceneRenderer::features(const Chunk& chunk) const
{
    const Material& material = scene_.scene().materials[static_cast<std::size_t>(chunk.material)];
    unsigned bits = 0;
    switch (media_[static_cast<std::size_t>(&chunk - scene_.chunks().all.data())]) {
    case Medium::air: bits |= inAir; break;
    case Medium::water: bits |= inWater; break;
    case Medium::both: break;
    }
    if (material.diffuseMap != noImage) bits |= diffuseMap;
    if (material.normalMap != noImage) bits |= normalMap;
    if (material.emissiveMap != noImage) bits |= emissiveMap;
    if (material.alphaMap != noImage) bits |= alphaMap;
    if (material.alphaTested) bits |= alphaTest;
    // Foliage keeps the normal of the crown that it stands for; anything else turns towards the eye.
    if (material.twoSided && !material.alphaTested) bits |= turnNormal;
    if (material.specular != vec3(0.0f)) bits |= specular;
    if (transmits(material)) bits |= transmission;
    return bits;
}

gl::Program& SceneRenderer::sceneProgram(unsigned bits, const SceneVariant& variant)
{
    if (variant.underwaterEye || variant.waterline) bits |= underwaterEye;
    if (variant.throughFlatWater) bits |= flatWater;
    if (variant.alphaToCoverage && (bits & alphaTest)) bits |= alphaToCoverage;
    if (variant.dithersCutOuts && (bits & alphaTest) && (bits & (diffuseMap | alphaMap))) bits |= dithered;
    if (variant.depthIsDrawn) bits &= ~(alphaTest | alphaToCoverage | dithered);
    if (variant.debugNormals) bits |= debugNormals;
    if (variant.shadows) bits |= shadows;
    if (variant.caustics && !(bits & inAir)) bits |= caustics;
    if (variant.forMap) bits |= forMap;
    if (variant.countsFaces) bits |= countsFaces;
    if (variant.depthOnly || variant.countsFaces) {
        bits &= shapeFeatures;
        if (!(bits & alphaTest)) bits &= countsFaces | flatWater; // maps matter to cut-outs only
        bits |= depthOnly;
    }
    const int taps = variant.shadows ? sunMaps_.taps : 0;
    auto& program = scenePrograms_[{bits, taps}];
    if (!program) {
        gl::Defines defines = definesOf(bits);
        if (bits & debugNormals)
            defines.emplace_back("DEBUG_VIEW", std::to_string(static_cast<int>(DebugView::normals)));
        if (taps > 0) defines.emplace_back("SHADOW_TAPS", std::to_string(taps));
        const bool shapeOnly = (bits & depthOnly) != 0;
        if (!shapeOnly) defines.push_back(unrolled("EACH_LIGHT", "LIGHT", lightCount_, lightCount_));
        program = shaders_.program(shapeOnly ? "sunlight" : "scene", "passes/scene.vert",
                                   shapeOnly ? "passes/sunlight.frag" : "passes/scene.frag", defines);
    }
    return *program;
}

gl::Program& SceneRenderer::skyProgram(const SceneVariant& variant)
{
    unsigned bits = 0;
    if (variant.sunDisc) bits |= sunDisc;
    if (variant.underwaterEye) bits |= underwaterEye;
    if (variant.waterline) bits |= skyWaterline;
    auto& program = skyPrograms_[bits];
    if (!program) program = shaders_.program("sky", "passes/sky.vert", "passes/sky.frag", definesOf(bits));
    return *program;
}

void SceneRenderer::prepare(const SceneVariant& variant)
{
    for (const Chunk& chunk : scene_.chunks().all) sceneProgram(features(chunk), variant);
    skyProgram(variant);
}

void SceneRenderer::setMaterial(gl::Program& program, const Material& material, bool dithers) const
{
    using MapUse = GpuScene::MapUse;
    program.set("diffuseReflectance", material.diffuse);
    program.set("emittedRadiance", material.emissive);
    if (material.specular != vec3(0.0f)) {
        program.set("specularReflectance", material.specular);
        program.set("shininess", material.shininess);
    }
    if (transmits(material)) program.set("transmission", material.transmission);
    if (material.alphaTested) {
        program.set("alpha", material.alpha);
        program.set("alphaCutoff", material.alphaCutoff);
    }
    const auto map = [&](int image, MapUse use) -> const gl::Texture& {
        return dithers && material.alphaTested ? scene_.coverage(image, use) : scene_.texture(image, use);
    };
    if (material.diffuseMap != noImage) program.texture("diffuseMap", map(material.diffuseMap, MapUse::colour));
    if (material.normalMap != noImage) program.texture("normalMap", scene_.texture(material.normalMap, MapUse::data));
    if (material.emissiveMap != noImage)
        program.texture("emissiveMap", scene_.texture(material.emissiveMap, MapUse::colour));
    if (material.alphaMap != noImage) program.texture("alphaMap", map(material.alphaMap, MapUse::data));
}

void SceneRenderer::draw(const View& view, const SceneVariant& variant, const WaterCover& cover, bool cull,
                         FrameReport::Pass& stats)
{
    if (media_.size() != scene_.chunks().all.size())
        setWater(water_); // another renderer has asked the scene for levels of detail
    const auto chunks = visibleChunks(scene_.chunks(), scene_.scene().materials, view, cover, cull, water_);
    if (variant.depthFirst && !variant.depthOnly)
        drawDepthFirst(chunks, view, variant, stats);
    else
        drawChunks(chunks, view, variant, stats);
    if (variant.sky) drawSky(variant);
}

/// Foliage hides foliage many times over, and a shader that discards cannot be kept from what is hidden. Its shape goes
/// first, in a shader of one lookup; what is solid hides little of itself and is shaded at once; then foliage is shaded
/// where its depth was left.
void SceneRenderer::drawDepthFirst(const std::vector<const Chunk*>& chunks, const View& view,
                                   const SceneVariant& variant, FrameReport::Pass& stats)
{
    std::vector<const Chunk*> cutOuts, solids;
    for (const Chunk* chunk : chunks) {
        const Material& material = scene_.scene().materials[static_cast<std::size_t>(chunk->material)];
        (material.alphaTested ? cutOuts : solids).push_back(chunk);
    }
    SceneVariant shape = variant;
    shape.depthOnly = true;
    shape.shadows = shape.caustics = false;
    shape.waterline = nullptr;
    drawChunks(cutOuts, view, shape, stats);
    drawChunks(solids, view, variant, stats);
    SceneVariant shaded = variant;
    shaded.depthIsDrawn = true;
    drawChunks(cutOuts, view, shaded, stats);
}

void SceneRenderer::drawChunks(const std::vector<const Chunk*>& chunks, const View& view, const SceneVariant& variant,
                               FrameReport::Pass& stats)
{
    const gl::Program* lastProgram = nullptr;
    int lastMaterial = -1;
    int lastInstance = -1;
    int lastState = -1;
    std::set<std::pair<const gl::Program*, int>> warm; // with the state
    for (const Chunk* chunk : chunks) {
        const Material& material = scene_.scene().materials[static_cast<std::size_t>(chunk->material)];
        if (variant.countsFaces && (material.twoSided || material.alphaTested)) continue; // sheets, with nothing within
        const int state = (material.twoSided || variant.bothSides || variant.countsFaces ? 1 : 0) |
                          (material.alphaTested && variant.alphaToCoverage ? 2 : 0);
        if (state != lastState) {
            // Back faces go before clipping, or the clip plane would show the insides of what it cuts (Fig. 3).
            gl::apply({.depthTest = variant.countsFaces    ? gl::DepthTest::off
                                    : variant.depthIsDrawn ? gl::DepthTest::equal
                                                           : gl::DepthTest::less,
                       .depthWrite = !variant.depthIsDrawn,
                       .depthClamp = variant.countsFaces, // what stands over the map's range counts too
                       .cull = (state & 1) ? gl::Cull::none : gl::Cull::back,
                       .clockwiseFront = view.mirrored,
                       .blend = variant.countsFaces ? gl::Blend::add : gl::Blend::none,
                       .clipDistances = view.clips() ? 1 : 0,
                       .colourWrite = !(variant.depthFirst && variant.depthOnly),
                       .alphaToCoverage = (state & 2) != 0,
                       .scissor = variant.scissor});
            lastState = state;
        }
        const unsigned bits = features(*chunk);
        gl::Program& program = sceneProgram(bits, variant);
        if (warmingUp_ && !warm.insert({&program, state}).second) continue;
        const bool newProgram = &program != lastProgram;
        if (newProgram) {
            program.use();
            if (variant.waterline || variant.underwaterEye)
                program.texture("waterline", variant.waterline ? *variant.waterline : allUnderwater_);
            if (variant.shadows) program.texture("sunDepth", *sunMaps_.depth);
            if (variant.caustics && !(bits & inAir)) program.texture("causticsMap", *sunMaps_.caustics);
        }
        if (newProgram || chunk->material != lastMaterial) setMaterial(program, material, variant.dithersCutOuts);
        if (newProgram || chunk->instance != lastInstance) {
            const auto i = static_cast<std::size_t>(chunk->instance);
            program.set("worldFromModel", scene_.instances()[i].worldFromModel);
            program.set("worldFromModelNormal", worldFromModelNormal_[i]);
        }
        if (variant.dithersCutOuts && material.alphaTested)
            program.set("chunk", static_cast<int>(chunk - scene_.chunks().all.data()));
        if (variant.shadows) program.set("geometryError", chunk->error);
        lastProgram = &program;
        lastMaterial = chunk->material;
        lastInstance = chunk->instance;
        meshArray(chunk->mesh)
            .drawIndexed(gl::Primitive::triangles, static_cast<int>(chunk->firstIndex),
                         static_cast<int>(warmingUp_ ? 3 : chunk->indexCount));
        stats.triangles += chunk->indexCount / 3;
        ++stats.drawCalls;
    }
}

const gl::VertexArray& SceneRenderer::meshArray(int mesh)
{
    MeshArray& known = meshArrays_[static_cast<std::size_t>(mesh)];
    const MeshBuffers& buffers = scene_.buffers(mesh);
    if (known.indices != buffers.indices)
        known = {buffers.indices, meshVertexArray(scene_.scene().meshes[static_cast<std::size_t>(mesh)].name, buffers)};
    return known.array;
}

void SceneRenderer::drawSky(const SceneVariant& variant)
{
    gl::apply({.depthTest = gl::DepthTest::lessEqual, .depthWrite = false, .scissor = variant.scissor});
    gl::Program& program = skyProgram(variant);
    program.use();
    if (!variant.underwaterEye) program.texture("skyMap", scene_.skyMap());
    if (variant.waterline) program.texture("waterline", *variant.waterline);
    triangle_.draw();
}

} // namespace tarn
