#include "scene/mesh_source.h"

#include <algorithm>
#include <cmath>

namespace tarn {

namespace {

using Face = MeshSource::Face;

const vec3& positionOf(const MeshSource& source, std::size_t corner)
{
    return source.positions[static_cast<std::size_t>(source.corners[corner].position)];
}

/// Angle at a polygon's corner, radians.
float cornerAngle(const MeshSource& source, const Face& face, std::uint32_t i)
{
    const auto at = [&](std::uint32_t k) -> const vec3& {
        return positionOf(source, face.firstCorner + k % face.cornerCount);
    };
    const vec3 a = at(i + face.cornerCount - 1) - at(i), b = at(i + 1) - at(i);
    const float lengths = glm::length(a) * glm::length(b);
    return lengths > 0.0f ? std::acos(std::clamp(glm::dot(a, b) / lengths, -1.0f, 1.0f)) : 0.0f;
}

vec3 unitOr(const vec3& v, const vec3& fallback)
{
    const float length = glm::length(v);
    return length > 0.0f && std::isfinite(length) ? v / length : fallback;
}

constexpr vec3 upward{0.0f, 1.0f, 0.0f};

/// The sums of normals at each vertex, one per smoothing group: chains from vertex to group.
class SmoothNormals {
public:
    explicit SmoothNormals(MeshSource& source) : source_(source), first_(source.positions.size(), -1) {}

    /// Index into source.normals of the sum for this vertex and group.
    std::int32_t normalOf(std::int32_t position, std::uint32_t group)
    {
        std::int32_t* link = &first_[static_cast<std::size_t>(position)];
        while (*link >= 0) {
            Entry& entry = entries_[static_cast<std::size_t>(*link)];
            if (entry.group == group) return entry.normal;
            if (entry.next < 0) {
                const auto added = static_cast<std::int32_t>(entries_.size());
                entry.next = added; // before push_back moves the entries
                return append(group);
            }
            link = &entry.next;
        }
        *link = static_cast<std::int32_t>(entries_.size());
        return append(group);
    }

private:
    struct Entry {
        std::uint32_t group;
        std::int32_t normal, next;
    };

    std::int32_t append(std::uint32_t group)
    {
        const auto normal = static_cast<std::int32_t>(source_.normals.size());
        source_.normals.emplace_back(0.0f);
        entries_.push_back({group, normal, -1});
        return normal;
    }

    MeshSource& source_;
    std::vector<std::int32_t> first_;
    std::vector<Entry> entries_;
};

bool lacksNormal(const MeshSource& source, const Face& face)
{
    for (std::uint32_t i = 0; i < face.cornerCount; ++i)
        if (source.corners[face.firstCorner + i].normal < 0) return true;
    return false;
}

} // namespace

vec3 newellNormal(const MeshSource& source, const Face& face)
{
    const vec3 origin = positionOf(source, face.firstCorner); // keeps the products small far from zero
    vec3 sum(0.0f);
    for (std::uint32_t i = 0; i < face.cornerCount; ++i) {
        const vec3 a = positionOf(source, face.firstCorner + i) - origin;
        const vec3 b = positionOf(source, face.firstCorner + (i + 1) % face.cornerCount) - origin;
        sum += glm::cross(a, b);
    }
    return sum;
}

void computeNormals(MeshSource& source)
{
    SmoothNormals smooth(source);
    const std::size_t given = source.normals.size();
    for (const Face& face : source.faces) {
        if (!lacksNormal(source, face)) continue;
        const vec3 normal = newellNormal(source, face);
        const auto flat = static_cast<std::int32_t>(source.normals.size());
        if (face.smoothing == 0) source.normals.push_back(normal);
        for (std::uint32_t i = 0; i < face.cornerCount; ++i) {
            Corner& corner = source.corners[face.firstCorner + i];
            if (corner.normal >= 0) continue;
            if (face.smoothing == 0) {
                corner.normal = flat;
                continue;
            }
            corner.normal = smooth.normalOf(corner.position, face.smoothing);
            source.normals[static_cast<std::size_t>(corner.normal)] +=
                unitOr(normal, vec3(0.0f)) * cornerAngle(source, face, i);
        }
    }
    for (std::size_t i = given; i < source.normals.size(); ++i) source.normals[i] = unitOr(source.normals[i], upward);
}

namespace {

/// Ear clipping in the plane that the polygon covers best.
class EarClipper {
public:
    EarClipper(const MeshSource& source, std::vector<Corner>& out) : source_(source), out_(out) {}

    void cut(const Face& face)
    {
        project(face);
        while (ring_.size() > 3) {
            const std::size_t ear = findEar();
            emit(previous(ear), ear, next(ear));
            ring_.erase(ring_.begin() + static_cast<std::ptrdiff_t>(ear));
        }
        emit(0, 1, 2);
    }

private:
    struct Point {
        vec2 at;
        std::uint32_t corner;
    };

    void project(const Face& face)
    {
        const vec3 normal = newellNormal(source_, face);
        const vec3 size = glm::abs(normal);
        const int drop = size.x > size.y ? (size.x > size.z ? 0 : 2) : (size.y > size.z ? 1 : 2);
        const int u = (drop + 1) % 3, v = (drop + 2) % 3;
        // Mirrored when the normal points down the dropped axis, so that every ring runs counter-clockwise.
        const float sign = normal[drop] < 0.0f ? -1.0f : 1.0f;
        ring_.clear();
        for (std::uint32_t i = 0; i < face.cornerCount; ++i) {
            const vec3& p = positionOf(source_, face.firstCorner + i);
            ring_.push_back({{sign * p[u], p[v]}, face.firstCorner + i});
        }
    }

    std::size_t previous(std::size_t i) const { return (i + ring_.size() - 1) % ring_.size(); }
    std::size_t next(std::size_t i) const { return (i + 1) % ring_.size(); }

    static float doubleArea(const vec2& a, const vec2& b, const vec2& c)
    {
        return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    }

    bool isEar(std::size_t i) const
    {
        const vec2 a = ring_[previous(i)].at, b = ring_[i].at, c = ring_[next(i)].at;
        if (doubleArea(a, b, c) <= 0.0f) return false;
        return std::none_of(ring_.begin(), ring_.end(), [&](const Point& point) {
            const vec2 p = point.at;
            if (p == a || p == b || p == c) return false;
            return doubleArea(a, b, p) >= 0.0f && doubleArea(b, c, p) >= 0.0f && doubleArea(c, a, p) >= 0.0f;
        });
    }

    /// The ear whose cut is shortest, which keeps triangles fat. A polygon that crosses itself may have none:
    /// then any corner does.
    std::size_t findEar() const
    {
        std::size_t best = 1;
        float shortest = std::numeric_limits<float>::max();
        // Among very many corners the first ear is good enough, and not quadratic in vain.
        const bool takeFirst = ring_.size() > 64;
        for (std::size_t i = 0; i < ring_.size(); ++i) {
            const float length = glm::distance(ring_[previous(i)].at, ring_[next(i)].at);
            if (length >= shortest || !isEar(i)) continue;
            if (takeFirst) return i;
            shortest = length;
            best = i;
        }
        return best;
    }

    void emit(std::size_t a, std::size_t b, std::size_t c)
    {
        for (const std::size_t i : {a, b, c}) out_.push_back(source_.corners[ring_[i].corner]);
    }

    const MeshSource& source_;
    std::vector<Corner>& out_;
    std::vector<Point> ring_;
};

} // namespace

void triangulate(MeshSource& source)
{
    std::vector<Corner> corners;
    std::vector<Face> triangles;
    corners.reserve(source.corners.size());
    triangles.reserve(source.faces.size());
    EarClipper clipper(source, corners);
    for (const Face& face : source.faces) {
        const std::size_t first = corners.size();
        if (face.cornerCount == 3) {
            const auto begin = source.corners.begin() + face.firstCorner;
            corners.insert(corners.end(), begin, begin + 3);
        } else {
            clipper.cut(face);
        }
        std::size_t kept = first;
        for (std::size_t i = first; i < corners.size(); i += 3) {
            const auto a = corners[i].position, b = corners[i + 1].position, c = corners[i + 2].position;
            if (a == b || b == c || c == a) continue;
            std::copy_n(corners.begin() + static_cast<std::ptrdiff_t>(i), 3,
                        corners.begin() + static_cast<std::ptrdiff_t>(kept));
            triangles.push_back({static_cast<std::uint32_t>(kept), 3, face.material, face.smoothing});
            kept += 3;
        }
        corners.resize(kept);
    }
    source.corners = std::move(corners);
    source.faces = std::move(triangles);
}

} // namespace tarn
