#include "scene/camera.h"
#include "scene/scene.h"

#include <gtest/gtest.h>

namespace tarn::test {
namespace {

void expectNear(const vec3& a, const vec3& b, float tolerance)
{
    EXPECT_LE(glm::length(a - b), tolerance)
        << a.x << ' ' << a.y << ' ' << a.z << " against " << b.x << ' ' << b.y << ' ' << b.z;
}

vec3 project(const mat4& clipFromA, const vec3& point)
{
    const vec4 clip = clipFromA * vec4(point, 1.0f);
    return vec3(clip) / clip.w;
}

TEST(Camera, LooksAlongMinusZ)
{
    Camera camera;
    camera.eye = {3.0f, 4.0f, 5.0f};
    camera.target = {3.0f, 4.0f, 0.0f};
    expectNear(vec3(viewFromWorld(camera) * vec4(4.0f, 6.0f, 2.0f, 1.0f)), {1.0f, 2.0f, -3.0f}, 1e-5f);
}

TEST(Camera, LookingStraightDownStaysFinite)
{
    Camera camera;
    camera.eye = {0.0f, 5.0f, 0.0f};
    camera.target = {0.0f, 0.0f, 0.0f};
    const vec3 below = vec3(viewFromWorld(camera) * vec4(0.0f, 0.0f, 0.0f, 1.0f));
    expectNear(below, {0.0f, 0.0f, -5.0f}, 1e-5f);
}

TEST(Camera, FieldOfViewAndExtension)
{
    Camera camera;
    camera.verticalFov = pi / 2.0f;
    camera.nearPlane = 0.5f;
    camera.farPlane = 100.0f;
    // tan 45° = 1: the point one to the side at depth one lies on the edge.
    expectNear(project(clipFromView(camera, 2.0f), {2.0f, 1.0f, -1.0f}),
               {1.0f, 1.0f, project(clipFromView(camera, 2.0f), {0.0f, 0.0f, -1.0f}).z}, 1e-5f);
    const vec3 extended = project(clipFromView(camera, 2.0f, 1.5f), {2.0f, 1.0f, -1.0f});
    EXPECT_NEAR(extended.x, 1.0f / 1.5f, 1e-6f);
    EXPECT_NEAR(extended.y, 1.0f / 1.5f, 1e-6f);
    EXPECT_NEAR(project(clipFromView(camera, 1.0f), {0.0f, 0.0f, -0.5f}).z, -1.0f, 1e-5f);
    EXPECT_NEAR(project(clipFromView(camera, 1.0f), {0.0f, 0.0f, -100.0f}).z, 1.0f, 1e-4f);
}

TEST(Camera, AShiftedLensLooksBesideItsAxis)
{
    Camera camera;
    camera.verticalFov = pi / 2.0f;
    camera.lensShift = 0.5f;
    for (const float extension : {1.0f, 1.5f}) {
        const mat4 clip = clipFromView(camera, 2.0f, extension);
        EXPECT_NEAR(project(clip, {1.5f, -0.3f, -3.0f}).x, 0.0f, 1e-6f) << "the middle";
        EXPECT_NEAR(project(clip, {0.5f + 2.0f * extension, 0.0f, -1.0f}).x, 1.0f, 1e-6f) << "the right edge";
        EXPECT_NEAR(project(clip, {0.5f - 2.0f * extension, 0.0f, -1.0f}).x, -1.0f, 1e-6f) << "the left edge";
        const ViewTangents tangents(clip);
        EXPECT_NEAR(tangents.middle.x, 0.5f, 1e-6f);
        EXPECT_NEAR(tangents.middle.y, 0.0f, 1e-6f);
        EXPECT_NEAR(tangents.half.x, 2.0f * extension, 1e-6f);
        EXPECT_NEAR(tangents.half.y, extension, 1e-6f);
    }
}

TEST(Frustum, KeepsWhatIsInsideAndDropsWhatIsOut)
{
    Camera camera;
    camera.eye = {0.0f, 0.0f, 0.0f};
    camera.target = {0.0f, 0.0f, -1.0f};
    camera.verticalFov = pi / 2.0f;
    camera.nearPlane = 1.0f;
    camera.farPlane = 10.0f;
    const Frustum frustum(clipFromView(camera, 1.0f) * viewFromWorld(camera));
    const auto box = [](const vec3& centre, float half) {
        Bounds bounds;
        bounds.add(centre - half);
        bounds.add(centre + half);
        return bounds;
    };
    EXPECT_TRUE(frustum.intersects(box({0.0f, 0.0f, -5.0f}, 0.1f)));
    EXPECT_TRUE(frustum.intersects(box({5.0f, 0.0f, -5.0f}, 0.1f))) << "on the edge";
    EXPECT_TRUE(frustum.intersects(box({0.0f, 0.0f, 0.0f}, 100.0f))) << "around all of it";
    EXPECT_FALSE(frustum.intersects(box({6.0f, 0.0f, -5.0f}, 0.1f)));
    EXPECT_FALSE(frustum.intersects(box({0.0f, -6.0f, -5.0f}, 0.1f)));
    EXPECT_FALSE(frustum.intersects(box({0.0f, 0.0f, 5.0f}, 0.1f))) << "behind";
    EXPECT_FALSE(frustum.intersects(box({0.0f, 0.0f, -0.5f}, 0.1f))) << "before the near plane";
    EXPECT_FALSE(frustum.intersects(box({0.0f, 0.0f, -11.0f}, 0.1f))) << "beyond the far plane";
    EXPECT_FALSE(frustum.intersects(Bounds())) << "nothing";
}

Scene sceneOfOneBox()
{
    Scene scene;
    Mesh mesh;
    mesh.bounds.add({-1.0f, -1.0f, -1.0f});
    mesh.bounds.add({1.0f, 1.0f, 1.0f});
    scene.meshes.push_back(mesh);
    Primitive box;
    box.name = "box";
    box.mesh = 0;
    scene.primitives.push_back(box);
    return scene;
}

TEST(SceneTree, TransformsNest)
{
    Scene scene = sceneOfOneBox();
    Element group, child;
    group.translation = {10.0f, 0.0f, 0.0f};
    group.rotation = {0.0f, pi / 2.0f, 0.0f}; // +x to -z
    child.shape = "box";
    child.translation = {2.0f, 0.0f, 0.0f};
    child.scale = vec3(0.5f);
    group.children.push_back(child);
    scene.elements.push_back(group);

    const auto instances = flatten(scene);
    ASSERT_EQ(instances.size(), 1u);
    EXPECT_EQ(instances[0].name, "box");
    expectNear(vec3(instances[0].worldFromModel * vec4(1.0f, 0.0f, 0.0f, 1.0f)), {10.0f, 0.0f, -2.5f}, 1e-5f);
    expectNear(worldBounds(scene).lower, {9.5f, -0.5f, -2.5f}, 1e-5f);
}

TEST(SceneTree, RotatesAboutXThenYThenZ)
{
    Scene scene = sceneOfOneBox();
    Element element;
    element.shape = "box";
    element.rotation = {pi / 2.0f, pi / 2.0f, 0.0f};
    scene.elements.push_back(element);
    // About x: +y to +z; then about y: +z to +x.
    expectNear(vec3(flatten(scene)[0].worldFromModel * vec4(0.0f, 1.0f, 0.0f, 0.0f)), {1.0f, 0.0f, 0.0f}, 1e-6f);
}

TEST(SceneTree, HiddenElementsHideTheirChildren)
{
    Scene scene = sceneOfOneBox();
    Element group, child;
    child.shape = "box";
    group.children.push_back(child);
    group.visible = false;
    scene.elements.push_back(group);
    EXPECT_TRUE(flatten(scene).empty());
    EXPECT_TRUE(worldBounds(scene).empty());
    scene.elements[0].visible = true;
    EXPECT_EQ(flatten(scene).size(), 1u);
}

TEST(SceneTree, FindsCamerasByName)
{
    Scene scene;
    scene.cameras.resize(2);
    scene.cameras[1].name = "pier";
    EXPECT_EQ(scene.findCamera("pier"), &scene.cameras[1]);
    EXPECT_EQ(scene.findCamera("Pier"), nullptr);
}

} // namespace
} // namespace tarn::test
