#include "scene/mesh_collapse.h"

#include "scene/mesh_links.h"
#include "scene/nearest_point.h"
#include "scene/vertex_shift.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>
#include <utility>

namespace tarn {

namespace {

constexpr float between =
    1.5f; // what lies between the points that are looked at is farther off, by a third as measured
constexpr float impossible = std::numeric_limits<float>::infinity();

class Collapser {
public:
    Collapser(std::span<const Vertex> vertices, std::span<const std::uint32_t> indices,
              std::span<const float> metresPerUv, bool locksBorder)
        : vertices_(vertices), metresPerUv_(metresPerUv), links_(vertices, indices, locksBorder),
          chart_(chartsOf(indices, vertices.size())), isOriginal_(indices.size(), 1), known_(indices.size() / 3, none),
          nextKnown_(vertices.size(), none), stamp_(links_.places()), isDirty_(links_.places()),
          isLocked_(links_.places()), isQueued_(links_.places()), seen_(links_.places()), isAround_(links_.places())
    {
        if (locksBorder) lockBorders();
    }

    Collapsed run(std::size_t enough, std::size_t target)
    {
        constexpr float farWorse = 2.0f;
        float worst = 0.0f, sufficed = impossible; // until there is enough
        std::size_t left = links_.triangles();
        for (std::uint32_t place = 0; place < links_.places(); ++place) rank(place);
        while (left > target && !queue_.empty()) {
            const Candidate next = queue_.top();
            queue_.pop();
            if (next.stamp != stamp_[next.place]) continue;
            isQueued_[next.place] = false;
            const float cost = isDirty_[next.place] ? impossible : costNow(next);
            if (cost > std::max(next.cost, ignored_)) { // what is around it has changed since it was ranked
                rank(next.place);
                continue;
            }
            if (cost > farWorse * sufficed) break;
            worst = std::max(worst, cost);
            ignored_ = 0.5f * worst;
            left -= removeGathered(next.place, next.into);
            if (left <= enough && sufficed == impossible) sufficed = worst;
        }
        return result(worst);
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

    /// One triangle at the place that is looked at: its corner there and the other two.
    struct Spoke {
        std::uint32_t corner, vertex, b, c, placeB, placeC;
        vec3 atB, atC;
        vec3 across; ///< cross product of its edges
        float size2; ///< of that, squared
        bool vanishes = false;
        std::uint32_t standIn = none; ///< what becomes of the vertex
        vec3 atStandIn{0.0f};
        vec3 turned{0.0f}; ///< cross product as it is then
        float turned2 = 0.0f;

        std::uint32_t triangle() const { return corner / 3; }
    };

    /// Something of the original surface that must be near what takes its place.
    struct Witness {
        vec3 place;
        std::uint32_t id; ///< a vertex, or after these the middle of an edge; none: a middle that has no number yet
        std::uint32_t chart;
        bool isHere;         ///< a vertex of the place that was gathered
        std::uint32_t spoke; ///< where to look first
    };

    const vec3& at(std::uint32_t vertex) const { return vertices_[vertex].position; }
    bool isMiddle(std::uint32_t id) const { return id >= vertices_.size(); }
    const vec3& placeOf(std::uint32_t id) const { return isMiddle(id) ? middles_[id - vertices_.size()] : at(id); }

    /// And with borders whatever is not a surface: edges of three triangles and more.
    void lockBorders()
    {
        for (std::uint32_t place = 0; place < links_.places(); ++place) {
            gather(place);
            for (const std::uint32_t other : around_) {
                const auto isOn = [&](const Spoke& s) { return s.placeB == other || s.placeC == other; };
                if (std::count_if(ring_.begin(), ring_.end(), isOn) != 2) isLocked_[place] = true;
            }
        }
    }

    void remember(std::uint32_t id, std::uint32_t triangle) { nextKnown_[id] = std::exchange(known_[triangle], id); }

    /// Lists the triangles at a place, its neighbours, and what must be near these.
    void gather(std::uint32_t place)
    {
        ring_.clear();
        around_.clear();
        witnesses_.clear();
        ++turn_;
        for (std::uint32_t corner = links_.first(place); corner != none; corner = links_.next(corner)) {
            const Spoke spoke = spokeAt(corner);
            const auto isIt = [&](const Spoke& s) { return s.vertex == spoke.vertex; };
            if (std::none_of(ring_.begin(), ring_.end(), isIt))
                witnesses_.push_back(
                    {at(spoke.vertex), spoke.vertex, none, true, static_cast<std::uint32_t>(ring_.size())});
            meet(spoke.placeB);
            meet(spoke.placeC);
            ring_.push_back(spoke);
        }
        ++glance_;
        hasSeam_ = witnesses_.size() > 1;
        for (std::uint32_t i = 0; i < ring_.size(); ++i) {
            const Spoke& spoke = ring_[i];
            if (isOriginal_[spoke.corner]) witnessMiddle(i, spoke.placeB, spoke.atB);
            if (isOriginal_[MeshLinks::before(spoke.corner)]) witnessMiddle(i, spoke.placeC, spoke.atC);
            for (std::uint32_t id = known_[spoke.triangle()]; id != none; id = nextKnown_[id])
                witnesses_.push_back({placeOf(id), id, chart_[spoke.triangle()], false, i});
        }
    }

    Spoke spokeAt(std::uint32_t corner) const
    {
        Spoke spoke;
        spoke.corner = corner;
        spoke.vertex = links_.vertexAt(corner);
        spoke.b = links_.vertexAt(MeshLinks::after(corner));
        spoke.c = links_.vertexAt(MeshLinks::before(corner));
        spoke.placeB = links_.placeOf(spoke.b);
        spoke.placeC = links_.placeOf(spoke.c);
        spoke.atB = at(spoke.b);
        spoke.atC = at(spoke.c);
        spoke.across = glm::cross(spoke.atB - at(spoke.vertex), spoke.atC - at(spoke.vertex));
        spoke.size2 = glm::dot(spoke.across, spoke.across);
        return spoke;
    }

    void meet(std::uint32_t other)
    {
        if (std::exchange(isAround_[other], turn_) != turn_) around_.push_back(other);
    }

    /// The middle of an edge of the place that was gathered, once.
    void witnessMiddle(std::uint32_t spoke, std::uint32_t end, const vec3& atEnd)
    {
        if (std::exchange(seen_[end], glance_) == glance_) return;
        witnesses_.push_back({0.5f * (at(ring_[spoke].vertex) + atEnd), none, none, false, spoke});
    }

    /// Finds the neighbour that a place is best drawn into, and queues it.
    void rank(std::uint32_t place)
    {
        isDirty_[place] = false;
        ++stamp_[place];
        if (isLocked_[place] || links_.count(place) == 0) return;
        Candidate best{impossible, place, none, stamp_[place]};
        gather(place);
        sortByPromise();
        int tries = 3; // the best is nearly always among the first
        for (const std::uint32_t into : around_) {
            const float cost = costOf(into, best.cost);
            if (cost < best.cost) best.cost = cost, best.into = into;
            if (best.cost <= ignored_ || (best.into != none && --tries == 0)) break;
        }
        if (best.into == none) return;
        if (hasSeam_) best.cost = costOf(best.into, impossible); // the same but for rounding, and when asked for again
        queue_.push(best);
        isQueued_[place] = true;
    }

    /// Neighbours first that lie near the planes of the triangles that were gathered.
    void sortByPromise()
    {
        promises_.clear();
        for (const std::uint32_t into : around_) {
            const auto isOn = [&](const Spoke& s) { return s.placeB == into || s.placeC == into; };
            const Spoke& toIt = *std::find_if(ring_.begin(), ring_.end(), isOn);
            const vec3 along = (toIt.placeB == into ? toIt.atB : toIt.atC) - at(toIt.vertex);
            float off2 = 0.0f;
            for (const Spoke& spoke : ring_) {
                const float height = glm::dot(spoke.across, along);
                if (height * height > off2 * spoke.size2) off2 = height * height / spoke.size2;
            }
            promises_.emplace_back(off2, into);
        }
        std::sort(promises_.begin(), promises_.end());
        for (std::size_t i = 0; i < around_.size(); ++i) around_[i] = promises_[i].second;
    }

    /// What a candidate costs that was ranked with the same triangles around it. Where the place is one vertex, only
    /// what it is drawn into may have changed, and that matters to the topology alone.
    float costNow(const Candidate& candidate)
    {
        gather(candidate.place);
        if (hasSeam_) return costOf(candidate.into, impossible);
        return keepsTopology(candidate.into) && turnTo(candidate.into) ? candidate.cost : impossible;
    }

    /// Which vertex of the place `into` stands in for a vertex of the place that was gathered: the one across their
    /// common edge, else the most alike of those there.
    std::uint32_t standIn(std::uint32_t vertex, std::uint32_t into) const
    {
        for (const Spoke& spoke : ring_)
            if (spoke.vertex == vertex && (spoke.placeB == into || spoke.placeC == into))
                return spoke.placeB == into ? spoke.b : spoke.c;
        std::uint32_t best = none;
        float least = impossible;
        for (std::uint32_t corner = links_.first(into); corner != none; corner = links_.next(corner)) {
            const std::uint32_t there = links_.vertexAt(corner);
            const float unlike = glm::distance(vertices_[there].normal, vertices_[vertex].normal) +
                                 metresPerUv_[vertex] * glm::distance(vertices_[there].uv, vertices_[vertex].uv);
            if (unlike < least) least = unlike, best = there;
        }
        return best;
    }

    /// What becomes of the triangles that were gathered. False when the surface would fold.
    bool turnTo(std::uint32_t into)
    {
        for (Spoke& spoke : ring_) {
            spoke.vanishes = spoke.placeB == into || spoke.placeC == into;
            if (spoke.vanishes) continue;
            const auto same = std::find_if(ring_.data(), &spoke,
                                           [&](const Spoke& s) { return !s.vanishes && s.vertex == spoke.vertex; });
            spoke.standIn = same != &spoke ? same->standIn : standIn(spoke.vertex, into);
            spoke.atStandIn = at(spoke.standIn);
            spoke.turned = glm::cross(spoke.atB - spoke.atStandIn, spoke.atC - spoke.atStandIn);
            spoke.turned2 = glm::dot(spoke.turned, spoke.turned);
            constexpr float most = 0.25f; // cosine of how far a triangle may turn
            const float along = glm::dot(spoke.across, spoke.turned), size2 = spoke.size2 * spoke.turned2;
            if (size2 <= 0.0f || along <= 0.0f || along * along < most * most * size2) return false;
        }
        return true;
    }

    bool mayShow(const Witness& witness, const Spoke& spoke) const
    {
        if (spoke.vanishes || isMiddle(witness.id)) return !spoke.vanishes;
        return witness.isHere ? spoke.vertex == witness.id : chart_[spoke.triangle()] == witness.chart;
    }

    /// By how much a witness is missed where a triangle, turned, shows it, m.
    /// @param most what is too much anyway
    float missed(const Witness& witness, const Spoke& spoke, float most) const
    {
        const vec3 &a = spoke.atStandIn, &b = spoke.atB, &c = spoke.atC;
        const float height = glm::dot(witness.place - a, spoke.turned); // over its plane, as it were
        const float reach2 = most * most / (between * between);
        if (0.999f * height * height >= reach2 * spoke.turned2) return impossible;
        const vec3 w = nearestWeights(witness.place, a, b, c);
        const vec3 away = witness.place - (w.x * a + w.y * b + w.z * c);
        const float distance2 = glm::dot(away, away);
        if (distance2 >= reach2) return impossible;
        const float distance = between * std::sqrt(distance2);
        if (isMiddle(witness.id)) return distance;
        const std::array<const Vertex*, 3> shown{&vertices_[spoke.standIn], &vertices_[spoke.b], &vertices_[spoke.c]};
        return std::max(distance, seemingShift(vertices_[witness.id], shown, w, metresPerUv_[witness.id]));
    }

    /// How much is missed when the place that was gathered is drawn into another, m; infinite when the surface would
    /// fold.
    /// @param most what is too much anyway
    float costOf(std::uint32_t into, float most)
    {
        if (!keepsTopology(into) || !turnTo(into)) return impossible;
        float cost = ignored_;
        for (Witness& witness : witnesses_) {
            const float least = leastMissed(witness, cost, most);
            if (least >= most) {                        // also where nothing is left
                std::swap(witness, witnesses_.front()); // what rules out one neighbour may well rule out the next
                return impossible;
            }
            cost = std::max(cost, least);
        }
        return cost;
    }

    /// @param enough how near will do
    float leastMissed(const Witness& witness, float enough, float most) const
    {
        float least = most;
        bool isShown = mayShow(witness, ring_[witness.spoke]);
        if (isShown) least = std::min(least, missed(witness, ring_[witness.spoke], least));
        for (std::uint32_t i = 0; i < ring_.size() && least > enough; ++i) {
            if (i == witness.spoke || !mayShow(witness, ring_[i])) continue;
            isShown = true;
            least = std::min(least, missed(witness, ring_[i], least));
        }
        if (isShown) return least;
        for (const Spoke& spoke : ring_) // nothing of its chart is left: what else is there stands for it
            if (!spoke.vanishes) least = std::min(least, missed(witness, spoke, least));
        return least;
    }

    /// Two places may become one only when all they have in common are the triangles between them (the link condition,
    /// Dey et al. 1999), and when no third place hangs on one of these alone.
    bool keepsTopology(std::uint32_t into)
    {
        std::size_t shared = 0, common = 0;
        for (const Spoke& spoke : ring_) {
            if (spoke.placeB != into && spoke.placeC != into) continue;
            ++shared;
            if (links_.count(spoke.placeB == into ? spoke.placeC : spoke.placeB) == 1) return false;
        }
        ++glance_;
        const auto meet = [&](std::uint32_t other) {
            if (isAround_[other] == turn_ && std::exchange(seen_[other], glance_) != glance_) ++common;
        };
        for (std::uint32_t corner = links_.first(into); corner != none; corner = links_.next(corner)) {
            meet(links_.placeAt(MeshLinks::after(corner)));
            meet(links_.placeAt(MeshLinks::before(corner)));
        }
        return common == shared;
    }

    /// After costOf. @return how many triangles vanish
    std::size_t removeGathered(std::uint32_t place, std::uint32_t into)
    {
        for (const Spoke& spoke : ring_) known_[spoke.triangle()] = none;
        for (const Witness& witness : witnesses_)
            remember(witness.id != none ? witness.id : numbered(witness.place), showing(witness).triangle());
        std::size_t vanished = 0;
        for (const Spoke& spoke : ring_) {
            isOriginal_[spoke.corner] = isOriginal_[MeshLinks::before(spoke.corner)] = 0;
            if (spoke.vanishes)
                links_.drop(spoke.triangle()), ++vanished;
            else
                links_.setVertex(spoke.corner, spoke.standIn);
        }
        links_.append(place, into);
        ++stamp_[place];
        for (const std::uint32_t p : around_) isDirty_[p] = true; // ranked again when their turn comes
        if (!isQueued_[into]) rank(into);
        return vanished;
    }

    /// Where a witness is missed least.
    const Spoke& showing(const Witness& witness) const
    {
        const bool isShown =
            std::any_of(ring_.begin(), ring_.end(), [&](const Spoke& s) { return mayShow(witness, s); });
        const Spoke* nearest = nullptr;
        float least = impossible;
        for (const Spoke& spoke : ring_) {
            if (isShown ? !mayShow(witness, spoke) : spoke.vanishes) continue;
            if (const float here = missed(witness, spoke, least); here < least) least = here, nearest = &spoke;
        }
        return *nearest;
    }

    std::uint32_t numbered(const vec3& middle)
    {
        middles_.push_back(middle);
        nextKnown_.push_back(none);
        return static_cast<std::uint32_t>(nextKnown_.size() - 1);
    }

    Collapsed result(float worst) const
    {
        Collapsed result{{}, worst};
        for (std::uint32_t t = 0; t < links_.triangles(); ++t)
            for (std::uint32_t corner = 3 * t; corner < 3 * t + 3 && !links_.isGone(t); ++corner)
                result.indices.push_back(links_.vertexAt(corner));
        return result;
    }

    std::span<const Vertex> vertices_;
    std::span<const float> metresPerUv_;
    MeshLinks links_;
    std::vector<std::uint32_t> chart_;             ///< of each triangle
    std::vector<vec3> middles_;                    ///< of edges that are no more
    std::vector<char> isOriginal_;                 ///< the edge from a corner to the next
    std::vector<std::uint32_t> known_, nextKnown_; ///< what of the original lies at a triangle: chains of witnesses
    std::vector<std::uint32_t> stamp_;             ///< of a place's latest candidate
    std::vector<char> isDirty_, isLocked_, isQueued_;
    std::vector<std::uint32_t> seen_, isAround_; ///< in which glance, in which turn
    std::uint32_t turn_ = 0, glance_ = 0;
    std::vector<Spoke> ring_; ///< of the place that was gathered
    std::vector<std::uint32_t> around_;
    std::vector<std::pair<float, std::uint32_t>> promises_;
    std::vector<Witness> witnesses_;
    bool hasSeam_ = false; ///< there are several vertices
    float ignored_ = 0.0f; ///< what is missed by less counts as this, m
    std::priority_queue<Candidate> queue_;
};

} // namespace

Collapsed collapse(std::span<const Vertex> vertices, std::span<const std::uint32_t> indices,
                   std::span<const float> metresPerUv, std::size_t enough, std::size_t target, bool locksBorder)
{
    return Collapser(vertices, indices, metresPerUv, locksBorder).run(enough, target);
}

} // namespace tarn
