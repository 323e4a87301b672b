// What a reference is of: everything that its picture depends on changes its identity, and names do not.
#include "test_scenes.h"

#include "reference/identity.h"

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

namespace tarn::test {

namespace {

Scene litLake()
{
    Scene scene = rippledLake();
    scene.sun = Sun{normalize(vec3(0.3f, 0.8f, 0.2f)), vec3(3.0f)};
    scene.pointLights.push_back({"near", {0, 3, 0}, vec3(2.0f)});
    scene.spotLights.push_back({"far", {0, 5, 0}});
    addNormalMap(scene, 8, [](const vec2& uv) { return uv; });
    Image picture;
    picture.width = picture.height = 2;
    picture.channels = 3;
    picture.bytes.assign(12, 100);
    scene.images.push_back(picture);
    addBox(scene, {-1, -1, -4}, {1, 2, -3}, addMaterial(scene, vec3(0.4f)));
    scene.materials.back().diffuseMap = static_cast<int>(scene.images.size()) - 1;
    return scene;
}

std::string identityOf(const Scene& scene) { return reference::sceneIdentity(scene, scene.water); }

} // namespace

TEST(ReferenceIdentity, EveryPartOfASceneIsInIt)
{
    struct Row {
        const char* part;
        std::function<void(Scene&)> change;
    };
    const std::vector<Row> rows{
        {"geometry", [](Scene& s) { s.meshes[0].vertices[0].position.y += 1.0e-3f; }},
        {"geometry", [](Scene& s) { s.meshes[0].vertices[0].uv.x += 0.5f; }},
        {"geometry", [](Scene& s) { s.elements[0].translation.x += 0.01f; }},
        {"geometry", [](Scene& s) { s.elements[0].visible = false; }},
        {"materials", [](Scene& s) { s.materials[0].diffuse.x *= 0.5f; }},
        {"materials", [](Scene& s) { s.materials[0].emissive.y = 1.0f; }},
        {"textures", [](Scene& s) { s.images.back().bytes[3] = 101; }},
        {"textures", [](Scene& s) { s.materials.back().diffuseMap = noImage; }},
        {"waves", [](Scene& s) { s.images[static_cast<std::size_t>(s.water.normalMap.image)].floats[0] += 0.1f; }},
        {"sky", [](Scene& s) { s.sky.radiance.z = 7.0f; }},
        {"sky", [](Scene& s) { s.sky.rotation = 1.0f; }},
        {"sun", [](Scene& s) { s.sun->irradiance.x = 4.0f; }},
        {"sun", [](Scene& s) { s.sun.reset(); }},
        {"lights", [](Scene& s) { s.pointLights[0].position.x = 1.0f; }},
        {"lights", [](Scene& s) { s.spotLights[0].outerAngle = 0.6f; }},
        {"water", [](Scene& s) { s.water.ior = 1.2f; }},
        {"water", [](Scene& s) { s.water.absorption.y = 0.3f; }},
        {"waves", [](Scene& s) { s.water.waves[0].phase = 1.0f; }},
        {"waves", [](Scene& s) { s.water.normalMap.bump = 0.5f; }},
    };
    const Scene scene = litLake();
    for (std::size_t i = 0; i < rows.size(); ++i) {
        Scene other = litLake();
        rows[i].change(other);
        EXPECT_EQ(reference::sceneDifference(identityOf(scene), identityOf(other)), std::string("the ") + rows[i].part)
            << "row " << i;
    }
}

TEST(ReferenceIdentity, NamesAreNotInIt)
{
    const Scene scene = litLake();
    Scene other = litLake();
    other.name = "another";
    other.file = "elsewhere/lake.toml";
    other.materials[0].name = other.elements[0].name = "renamed";
    other.images[0].name = "renamed.png";
    other.cameras.push_back(lookAcross());
    EXPECT_EQ(identityOf(scene), identityOf(other));
    EXPECT_EQ(reference::sceneDifference(identityOf(scene), identityOf(other)), "");
}

TEST(ReferenceIdentity, DifferencesAreListed)
{
    const Scene scene = litLake();
    Scene other = litLake();
    other.sky.turbidity = 9.0f;
    EXPECT_EQ(reference::sceneDifference(identityOf(scene), identityOf(other)), "the sky");
    other.materials[0].alpha = 0.9f;
    EXPECT_EQ(reference::sceneDifference(identityOf(scene), identityOf(other)), "the materials and the sky");
    other.water.level = 1.0f;
    EXPECT_EQ(reference::sceneDifference(identityOf(scene), identityOf(other)), "the materials, the sky and the water");
}

// A surface that is not there is seen by nobody.
TEST(ReferenceIdentity, AbsentWaterIsAllTheSame)
{
    Scene a = litLake(), b = litLake();
    a.water.present = b.water.present = false;
    b.water.ior = 1.5f;
    b.water.waves.clear();
    EXPECT_EQ(identityOf(a), identityOf(b));
}

} // namespace tarn::test
