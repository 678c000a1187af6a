// Directions from tables on the cosine square.
#include "guides/adaptive/bounce_guide.h"

#include <new>

namespace aips {
namespace {

BounceTableSettings table_settings(double memory_paths) {
    BounceTableSettings settings;
    settings.places.memory_paths = memory_paths;
    return settings;
}

/// Surfaces whose directions are learned and guided.
bool guidable(LobeMask lobes) {
    return lobes & kDiffuse;
}

class TableDirections final : public GuidedDirections {
  public:
    TableDirections(const BounceTable& table, Vec3 normal)
        : GuidedDirections(table.share),
          table_(*table.table),
          frame_(Frame::world_aligned(normal)) {}

    Vec3 sample(Vec2 u) const override {
        return cosine_square_direction(frame_, table_.sample(u).point);
    }
    float pdf(Vec3 direction) const override {
        const float cosine = dot(direction, frame_.n);
        if (!(cosine > 0)) return 0;
        return table_.pdf(cosine_square_point(frame_, direction)) * cosine * kInvPi;
    }

  private:
    const DirectionalTable& table_;
    Frame frame_;
};

}  // namespace

BounceGuide::BounceGuide(const Bounds& scene, double memory_paths)
    : tables_(scene, table_settings(memory_paths)) {}

const GuidedDirections* BounceGuide::directions(const GuideVertex& vertex,
                                                std::pmr::memory_resource& memory) const {
    if (!guidable(vertex.bsdf->lobes())) return nullptr;
    const BounceTable table = tables_.at(vertex.position, vertex.normal);
    if (!table.table) return nullptr;
    return new (memory.allocate(sizeof(TableDirections), alignof(TableDirections)))
        TableDirections(table, vertex.normal);
}

void BounceGuide::add(const PathVertex& vertex, double score, double cost) {
    if (!guidable(vertex.lobes) || !(vertex.pdf > 0)) return;
    BounceScore s;
    s.position = vertex.position;
    s.normal = vertex.normal;
    s.direction = vertex.direction;
    s.power = double(vertex.power);
    s.score = score;
    s.cost = cost;
    s.drawn = double(vertex.pdf);
    s.plain = double(vertex.plain_pdf);
    tables_.add(s);
}

std::size_t BounceGuide::memory_bound_bytes(double memory_paths) {
    return BounceTables::memory_bound_bytes(table_settings(memory_paths));
}

}  // namespace aips
