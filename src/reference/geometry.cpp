#include "reference/geometry.h"

#include "base/error.h"
#include "reference/embree.h"
#include "reference/texture_lookup.h"

#include <cmath>

namespace tarn::reference {

namespace {

/// A mesh with what the filter must know of it.
struct MeshRays {
    const Scene* scene = nullptr;
    const Mesh* mesh = nullptr;
    std::vector<int> materialOf; ///< of each triangle
    RayScene rays;

    const Material& material(unsigned triangle) const
    {
        return scene->materials[static_cast<std::size_t>(materialOf[triangle])];
    }
};

struct Corners {
    const Vertex *a, *b, *c;
};

Corners cornersOf(const Mesh& mesh, unsigned triangle)
{
    const std::uint32_t* index = &mesh.indices[3 * static_cast<std::size_t>(triangle)];
    return {&mesh.vertices[index[0]], &mesh.vertices[index[1]], &mesh.vertices[index[2]]};
}

template <typename T> T mixed(const T& a, const T& b, const T& c, float u, float v)
{
    return (1.0f - u - v) * a + u * b + v * c;
}

const Image& imageOf(const Scene& scene, int index) { return scene.images[static_cast<std::size_t>(index)]; }

/// Coverage of an alpha-tested surface, as scene.frag computes it.
float coverage(const Scene& scene, const Material& material, vec2 uv)
{
    float alpha = material.alpha;
    if (material.diffuseMap != noImage)
        alpha *= sampleTexture(imageOf(scene, material.diffuseMap), uv, Encoding::srgb).w;
    if (material.alphaMap != noImage) alpha *= sampleTexture(imageOf(scene, material.alphaMap), uv, Encoding::linear).x;
    return alpha;
}

/// Turns away hits that are not there: holes of foliage, and the back of what the viewer draws from the front only.
void filter(const RTCFilterFunctionNArguments* arguments)
{
    if (arguments->valid[0] == 0) return;
    const auto& mesh = *static_cast<const MeshRays*>(arguments->geometryUserPtr);
    const unsigned triangle = RTCHitN_primID(arguments->hit, arguments->N, 0);
    const Material& material = mesh.material(triangle);
    const auto sides = static_cast<Sides>(RTCRayN_id(arguments->ray, arguments->N, 0));
    if (sides == Sides::asDrawn && !material.twoSided) {
        const float along = RTCHitN_Ng_x(arguments->hit, 1, 0) * RTCRayN_dir_x(arguments->ray, 1, 0) +
                            RTCHitN_Ng_y(arguments->hit, 1, 0) * RTCRayN_dir_y(arguments->ray, 1, 0) +
                            RTCHitN_Ng_z(arguments->hit, 1, 0) * RTCRayN_dir_z(arguments->ray, 1, 0);
        if (along >= 0.0f) {
            arguments->valid[0] = 0;
            return;
        }
    }
    if (!material.alphaTested) return;
    const Corners k = cornersOf(*mesh.mesh, triangle);
    const vec2 uv = mixed(k.a->uv, k.b->uv, k.c->uv, RTCHitN_u(arguments->hit, arguments->N, 0),
                          RTCHitN_v(arguments->hit, arguments->N, 0));
    if (coverage(*mesh.scene, material, uv) < material.alphaCutoff) arguments->valid[0] = 0;
}

std::vector<int> materialsOf(const Mesh& mesh)
{
    std::vector<int> materials(mesh.indices.size() / 3, 0);
    for (const MeshPart& part : mesh.parts)
        for (std::uint32_t i = part.firstIndex / 3; i < (part.firstIndex + part.indexCount) / 3; ++i)
            materials[i] = part.material;
    return materials;
}

RayScene raysOf(RTCDevice device, MeshRays& mesh)
{
    RayScene rays(rtcNewScene(device));
    rtcSetSceneFlags(rays.get(), RTC_SCENE_FLAG_ROBUST); // a ray between two triangles would see through the bed
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, mesh.mesh->vertices.data(),
                               offsetof(Vertex, position), sizeof(Vertex), mesh.mesh->vertices.size());
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, mesh.mesh->indices.data(), 0,
                               3 * sizeof(std::uint32_t), mesh.mesh->indices.size() / 3);
    rtcSetGeometryUserData(geometry, &mesh);
    rtcSetGeometryIntersectFilterFunction(geometry, filter);
    rtcSetGeometryOccludedFilterFunction(geometry, filter);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(rays.get(), geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(rays.get());
    return rays;
}

} // namespace

struct Geometry::State {
    const Scene& scene;
    Device device;
    std::vector<MeshRays> meshes; ///< as Scene::meshes
    std::vector<Instance> instances;
    std::vector<mat3> worldFromModelNormal; ///< of each instance
    RayScene world;
};

Geometry::Geometry(const Scene& scene) : state_(new State{scene, Device(rtcNewDevice(nullptr)), {}, {}, {}, {}})
{
    State& s = *state_;
    if (!s.device) throw Error("Embree cannot start (error {})", static_cast<int>(rtcGetDeviceError(nullptr)));
    s.meshes.resize(scene.meshes.size());
    s.world.reset(rtcNewScene(s.device.get()));
    rtcSetSceneFlags(s.world.get(), RTC_SCENE_FLAG_ROBUST);
    for (Instance& instance : flatten(scene)) {
        MeshRays& mesh = s.meshes[static_cast<std::size_t>(instance.mesh)];
        const Mesh& source = scene.meshes[static_cast<std::size_t>(instance.mesh)];
        if (source.indices.empty()) continue;
        if (!mesh.rays) {
            mesh.scene = &scene;
            mesh.mesh = &source;
            mesh.materialOf = materialsOf(source);
            mesh.rays = raysOf(s.device.get(), mesh);
        }
        RTCGeometry placed = rtcNewGeometry(s.device.get(), RTC_GEOMETRY_TYPE_INSTANCE);
        rtcSetGeometryInstancedScene(placed, mesh.rays.get());
        rtcSetGeometryTransform(placed, 0, RTC_FORMAT_FLOAT4X4_COLUMN_MAJOR, glm::value_ptr(instance.worldFromModel));
        rtcCommitGeometry(placed);
        rtcAttachGeometryByID(s.world.get(), placed, static_cast<unsigned>(s.instances.size()));
        rtcReleaseGeometry(placed);
        s.worldFromModelNormal.push_back(glm::transpose(glm::inverse(mat3(instance.worldFromModel))));
        bounds_.add(source.bounds.transformed(instance.worldFromModel));
        s.instances.push_back(std::move(instance));
    }
    rtcCommitScene(s.world.get());
    if (const RTCError error = rtcGetDeviceError(s.device.get()); error != RTC_ERROR_NONE)
        throw Error("{}: Embree cannot take the scene in (error {})", scene.file.string(), static_cast<int>(error));
}

Geometry::~Geometry() = default;

std::optional<Hit> Geometry::intersect(const Ray& ray, double tMin, double tMax, Sides sides) const
{
    RTCRayHit query{};
    query.ray = makeRay(ray.origin, ray.direction, tMin, tMax, static_cast<unsigned>(sides));
    reference::intersect(state_->world.get(), query);
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
    return Hit{query.ray.tfar, query.hit.instID[0], query.hit.primID, query.hit.u, query.hit.v};
}

bool Geometry::occluded(const Ray& ray, double tMin, double tMax) const
{
    return reference::occluded(state_->world.get(),
                               makeRay(ray.origin, ray.direction, tMin, tMax, static_cast<unsigned>(Sides::both)));
}

namespace {

vec4 unpackColour(std::uint32_t c)
{
    return vec4(static_cast<float>(c & 255u), static_cast<float>(c >> 8 & 255u), static_cast<float>(c >> 16 & 255u),
                static_cast<float>(c >> 24 & 255u)) /
           255.0f;
}

vec3 normalised(const vec3& v)
{
    const float length = glm::length(v);
    return length > 0.0f ? v / length : vec3(0.0f, 1.0f, 0.0f);
}

/// The normal map, as scene.frag's shadingNormal.
vec3 mapped(const vec3& n, const vec4& tangentW, const Image& map, vec2 uv)
{
    vec3 t = vec3(tangentW) - n * glm::dot(n, vec3(tangentW));
    const float length2 = glm::dot(t, t);
    if (length2 <= 1e-12f) return n;
    t /= std::sqrt(length2);
    const vec3 b = tangentW.w * glm::cross(n, t);
    const vec3 m = vec3(sampleTexture(map, uv, Encoding::linear)) * 2.0f - 1.0f;
    return normalised(m.x * t + m.y * b + m.z * n);
}

} // namespace

SurfacePoint Geometry::surfaceAt(const Ray& ray, const Hit& hit) const
{
    const State& s = *state_;
    const Instance& instance = s.instances[hit.instance];
    const MeshRays& mesh = s.meshes[static_cast<std::size_t>(instance.mesh)];
    const Corners k = cornersOf(*mesh.mesh, hit.triangle);
    const auto at = [&](auto member) { return mixed(k.a->*member, k.b->*member, k.c->*member, hit.u, hit.v); };
    const mat3& worldFromNormal = s.worldFromModelNormal[hit.instance];

    SurfacePoint point;
    point.material = &mesh.material(hit.triangle);
    const Material& material = *point.material;
    point.position = ray.origin + hit.distance * ray.direction;
    const vec3 flat = worldFromNormal * glm::cross(k.b->position - k.a->position, k.c->position - k.a->position);
    const bool isFront = glm::dot(dvec3(flat), ray.direction) < 0.0;
    point.geometricNormal = normalised(isFront ? flat : -flat);

    const vec2 uv = at(&Vertex::uv);
    point.normal = normalised(worldFromNormal * at(&Vertex::normal));
    if (material.normalMap != noImage) {
        const vec4 tangent = at(&Vertex::tangent);
        const vec3 along = mat3(instance.worldFromModel) * vec3(tangent);
        point.normal = mapped(point.normal, vec4(along, tangent.w), imageOf(s.scene, material.normalMap), uv);
    }
    // Foliage keeps the normal of the crown that it stands for; anything else turns towards the eye.
    if (material.twoSided && !material.alphaTested && !isFront) point.normal = -point.normal;

    const vec4 tint =
        mixed(unpackColour(k.a->colour), unpackColour(k.b->colour), unpackColour(k.c->colour), hit.u, hit.v);
    point.albedo = material.diffuse * vec3(tint);
    if (material.diffuseMap != noImage)
        point.albedo *= vec3(sampleTexture(imageOf(s.scene, material.diffuseMap), uv, Encoding::srgb));
    point.emitted = material.emissive;
    if (material.emissiveMap != noImage)
        point.emitted *= vec3(sampleTexture(imageOf(s.scene, material.emissiveMap), uv, Encoding::srgb));
    return point;
}

} // namespace tarn::reference
