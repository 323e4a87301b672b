#include "scene/mesh_collapse.h"

#include "scene/nearest_surface.h"
#include "scene/vertex_shift.h"

#include <algorithm>
#include <array>
#include <limits>
#include <queue>
#include <unordered_map>
#include <utility>

namespace tarn {

namespace {

constexpr std::uint32_t none = ~0u;
constexpr float impossible = std::numeric_limits<float>::infinity();

/// Equal for places that are bit for bit the same (and for the two zeros).
struct PlaceHash {
    std::size_t operator()(const vec3& p) const
    {
        std::size_t key = 0;
        for (int axis = 0; axis < 3; ++axis) key = key * 0x9e3779b97f4a7c15ull + std::hash<float>{}(p[axis]);
        return key;
    }
};

class Collapser {
public:
    Collapser(std::span<const Vertex> vertices, std::span<const std::uint32_t> indices, std::span<const float> metresPerUv,
              bool locksBorder)
        : vertices_(vertices), metresPerUv_(metresPerUv), corners_(indices.begin(), indices.end())
    {
        findPlaces(locksBorder);
        findLocked(locksBorder);
    }

    Collapsed run(std::size_t enough, std::size_t target)
    {
        constexpr float farWorse = 2.0f;
        float worst = 0.0f, sufficed = impossible; // until there is enough
        std::size_t left = corners_.size() / 3;
        for (std::uint32_t place = 0; place < triangles_.size(); ++place) rank(place);
        while (left > target && !queue_.empty()) {
            const Candidate next = queue_.top();
            queue_.pop();
            if (next.stamp != stamp_[next.place]) continue;
            if (isDirty_[next.place] || !stillFits(next)) { // what is around it has changed since it was ranked
                rank(next.place);
                continue;
            }
            if (next.cost > farWorse * sufficed) break;
            worst = std::max(worst, next.cost);
            left -= remove(next.place, next.into, next.cost);
            if (left <= enough && sufficed == impossible) sufficed = worst;
        }
        return {remaining(), worst};
    }

private:
    struct Candidate {
        float cost; ///< m
        std::uint32_t place, into, stamp;
        bool operator<(const Candidate& other) const // the least on top, and the same on every run
        {
            return cost != other.cost ? cost > other.cost : place > other.place;
        }
    };

    std::uint32_t corner(std::uint32_t triangle, std::size_t k) const { return corners_[3 * triangle + k]; }
    std::uint32_t placeOf(std::uint32_t triangle, std::size_t k) const { return place_[corner(triangle, k)]; }
    const vec3& at(std::uint32_t vertex) const { return vertices_[vertex].position; }
    bool isGone(std::uint32_t triangle) const { return corners_[3 * triangle] == none; }

    /// What shares a place is one surface; but not cards, which go through each other.
    void findPlaces(bool isOneSurface)
    {
        std::unordered_map<vec3, std::uint32_t, PlaceHash> known;
        known.reserve(vertices_.size());
        for (std::uint32_t i = 0; i < vertices_.size(); ++i)
            place_.push_back(isOneSurface ? known.try_emplace(vertices_[i].position, static_cast<std::uint32_t>(known.size()))
                                                .first->second
                                          : i);
        const std::size_t places = isOneSurface ? known.size() : vertices_.size();
        triangles_.resize(places);
        for (std::uint32_t t = 0; t < corners_.size() / 3; ++t)
            for (std::size_t k = 0; k < 3; ++k) triangles_[placeOf(t, k)].push_back(t);
        stamp_.resize(places);
        isDirty_.resize(places);
        carried_.resize(places);
        isLocked_.resize(places);
    }

    /// Borders, if they are to stay, and with them whatever is not a surface: edges of three triangles and more.
    void findLocked(bool locksBorder)
    {
        if (!locksBorder) return;
        std::unordered_map<std::uint64_t, int> edges;
        edges.reserve(corners_.size());
        const auto key = [](std::uint64_t a, std::uint64_t b) { return std::min(a, b) << 32 | std::max(a, b); };
        for (std::uint32_t t = 0; t < corners_.size() / 3; ++t)
            for (std::size_t k = 0; k < 3; ++k) ++edges[key(placeOf(t, k), placeOf(t, (k + 1) % 3))];
        for (const auto& [edge, count] : edges)
            if (count != 2)
                isLocked_[edge >> 32] = isLocked_[edge & 0xffffffffu] = true;
    }

    /// Finds the neighbour that a place is best drawn into, and queues it.
    void rank(std::uint32_t place)
    {
        isDirty_[place] = false;
        ++stamp_[place];
        if (isLocked_[place] || triangles_[place].empty()) return;
        Candidate best{impossible, place, none, stamp_[place]};
        neighbours(place, around_);
        for (const std::uint32_t into : around_)
            if (const float cost = costOf(place, into, best.cost); cost < best.cost) best = {cost, place, into, best.stamp};
        if (best.into != none) queue_.push(best);
    }

    bool stillFits(const Candidate& candidate)
    {
        neighbours(candidate.place, around_);
        return keepsTopology(candidate.place, candidate.into);
    }

    void neighbours(std::uint32_t place, std::vector<std::uint32_t>& list) const
    {
        list.clear();
        for (const std::uint32_t t : triangles_[place])
            for (std::size_t k = 0; k < 3; ++k)
                if (const std::uint32_t p = placeOf(t, k); p != place && std::find(list.begin(), list.end(), p) == list.end())
                    list.push_back(p);
    }

    /// The corner of a triangle that stands at a place.
    std::uint32_t cornerAt(std::uint32_t triangle, std::uint32_t place) const
    {
        for (std::size_t k = 0; k < 3; ++k)
            if (placeOf(triangle, k) == place) return corner(triangle, k);
        return none;
    }

    /// Which vertex of the place `into` stands in for a vertex of `place`: the one across their common edge, else the most
    /// alike of those there.
    std::uint32_t standIn(std::uint32_t vertex, std::uint32_t place, std::uint32_t into) const
    {
        for (const std::uint32_t t : triangles_[place])
            if (cornerAt(t, place) == vertex)
                if (const std::uint32_t there = cornerAt(t, into); there != none) return there;
        std::uint32_t best = none;
        float least = impossible;
        for (const std::uint32_t t : triangles_[into]) {
            const std::uint32_t there = cornerAt(t, into);
            const float unlike = glm::distance(vertices_[there].normal, vertices_[vertex].normal) +
                                 metresPerUv_[vertex] * glm::distance(vertices_[there].uv, vertices_[vertex].uv);
            if (unlike < least) least = unlike, best = there;
        }
        return best;
    }

    /// How much is missed when a place is drawn into another, m; infinite when the surface would fold.
    /// @param most what is too much anyway
    float costOf(std::uint32_t place, std::uint32_t into, float most)
    {
        if (!keepsTopology(place, into)) return impossible;
        // For each vertex of the place the nearest of the triangles that it had a part in.
        struct Fate {
            std::uint32_t vertex, there;
            float distance2 = impossible;
            std::array<std::uint32_t, 3> corners{};
            vec3 weights{0.0f};
        };
        std::array<Fate, 8> fates;
        std::size_t count = 0;
        const vec3 gone = at(cornerAt(triangles_[place].front(), place));
        for (const std::uint32_t t : triangles_[place]) {
            if (cornerAt(t, into) != none) continue; // it vanishes
            const std::uint32_t vertex = cornerAt(t, place);
            auto* const end = fates.begin() + count;
            auto* fate = std::find_if(fates.begin(), end, [&](const Fate& f) { return f.vertex == vertex; });
            if (fate == end) {
                if (count == fates.size()) return impossible; // a knot of seams
                *fate = {vertex, standIn(vertex, place, into)};
                ++count;
            }
            std::array<std::uint32_t, 3> after{corner(t, 0), corner(t, 1), corner(t, 2)};
            std::replace(after.begin(), after.end(), vertex, fate->there);
            if (folds(t, after)) return impossible;
            const vec3 w = nearestWeights(gone, at(after[0]), at(after[1]), at(after[2]));
            const vec3 away = gone - (w.x * at(after[0]) + w.y * at(after[1]) + w.z * at(after[2]));
            if (const float d2 = glm::dot(away, away); d2 < fate->distance2)
                fate->distance2 = d2, fate->corners = after, fate->weights = w;
        }
        if (count == 0) return impossible; // the last of its chart
        float cost = 0.0f;
        for (const Fate& fate : std::span(fates.data(), count)) {
            cost = std::max(cost, std::sqrt(fate.distance2));
            if (cost + carried_[place] >= most) return impossible;
            const std::array<const Vertex*, 3> shown{&vertices_[fate.corners[0]], &vertices_[fate.corners[1]],
                                                     &vertices_[fate.corners[2]]};
            cost = std::max(cost, seemingShift(vertices_[fate.vertex], shown, fate.weights, metresPerUv_[fate.vertex]));
        }
        return cost + carried_[place];
    }

    /// Two places may become one only when all they have in common are the triangles between them (the link condition,
    /// Dey et al. 1999), and when no third place hangs on one of these alone.
    bool keepsTopology(std::uint32_t place, std::uint32_t into)
    {
        std::size_t shared = 0;
        for (const std::uint32_t t : triangles_[place]) {
            if (cornerAt(t, into) == none) continue;
            ++shared;
            for (std::size_t k = 0; k < 3; ++k)
                if (const std::uint32_t p = placeOf(t, k); p != place && p != into && triangles_[p].size() == 1) return false;
        }
        neighbours(into, aroundInto_);
        std::size_t common = 0;
        for (const std::uint32_t p : around_) // what is around the place is listed already
            common += std::find(aroundInto_.begin(), aroundInto_.end(), p) != aroundInto_.end() ? 1u : 0u;
        return common == shared;
    }

    bool folds(std::uint32_t triangle, const std::array<std::uint32_t, 3>& after) const
    {
        const vec3& a = at(corner(triangle, 0));
        const vec3 before = glm::cross(at(corner(triangle, 1)) - a, at(corner(triangle, 2)) - a);
        const vec3 now = glm::cross(at(after[1]) - at(after[0]), at(after[2]) - at(after[0]));
        constexpr float most = 0.25f; // cosine of how far a triangle may turn
        const float size = glm::length(before) * glm::length(now);
        return size <= 0.0f || glm::dot(before, now) < most * size;
    }

    /// @return how many triangles vanish
    std::size_t remove(std::uint32_t place, std::uint32_t into, float cost)
    {
        neighbours(place, around_);
        std::vector<std::pair<std::uint32_t, std::uint32_t>> standIns;
        for (const std::uint32_t t : triangles_[place]) {
            const std::uint32_t vertex = cornerAt(t, place);
            const auto isIt = [&](const auto& entry) { return entry.first == vertex; };
            if (std::none_of(standIns.begin(), standIns.end(), isIt))
                standIns.emplace_back(vertex, standIn(vertex, place, into));
        }
        std::size_t vanished = 0;
        for (const std::uint32_t t : std::exchange(triangles_[place], {})) {
            if (cornerAt(t, into) != none) {
                for (std::size_t k = 0; k < 3; ++k)
                    if (const std::uint32_t p = placeOf(t, k); p != place) std::erase(triangles_[p], t);
                corners_[3 * t] = none;
                ++vanished;
                continue;
            }
            for (const auto& [vertex, there] : standIns)
                std::replace(corners_.begin() + 3 * t, corners_.begin() + 3 * t + 3, vertex, there);
            triangles_[into].push_back(t);
        }
        carried_[into] = std::max(carried_[into], cost);
        ++stamp_[place];
        for (const std::uint32_t p : around_) isDirty_[p] = true; // ranked again when their turn comes
        rank(into);
        return vanished;
    }

    std::vector<std::uint32_t> remaining() const
    {
        std::vector<std::uint32_t> indices;
        for (std::uint32_t t = 0; t < corners_.size() / 3; ++t)
            if (!isGone(t)) indices.insert(indices.end(), corners_.begin() + 3 * t, corners_.begin() + 3 * t + 3);
        return indices;
    }

    std::span<const Vertex> vertices_;
    std::span<const float> metresPerUv_;
    std::vector<std::uint32_t> corners_; ///< vertices, three for each triangle; none first: it is gone
    std::vector<std::uint32_t> place_;   ///< of each vertex
    std::vector<std::vector<std::uint32_t>> triangles_; ///< at each place
    std::vector<std::uint32_t> stamp_;   ///< of a place's latest candidate
    std::vector<char> isDirty_, isLocked_;
    std::vector<float> carried_; ///< the worst that was drawn into a place, m
    std::vector<std::uint32_t> around_, aroundInto_;
    std::priority_queue<Candidate> queue_;
};

} // namespace

Collapsed collapse(std::span<const Vertex> vertices, std::span<const std::uint32_t> indices,
                   std::span<const float> metresPerUv, std::size_t enough, std::size_t target, bool locksBorder)
{
    return Collapser(vertices, indices, metresPerUv, locksBorder).run(enough, target);
}

} // namespace tarn
