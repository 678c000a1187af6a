// Terms of points that have a Bsdf, told by those who have it.
#include "worth/shared_scores.h"

#include <algorithm>
#include <vector>

#include "ranks/shared_work.h"

namespace aips {
namespace {

/// Landings of a job: some hundred microseconds.
constexpr std::size_t kLandingsPerPart = 64;

using LandingOf = std::function<const Landing&(std::size_t)>;

/// What a rank's points with a Bsdf add to scores, landing after landing.
struct RankTerms {
    std::vector<std::uint32_t> counts;  // [landing]
    std::vector<double> terms;
    std::vector<std::size_t> begins;  // [landing] in `terms`

    void index() {
        begins.resize(counts.size());
        std::size_t begin = 0;
        for (std::size_t i = 0; i < counts.size(); ++i) {
            begins[i] = begin;
            begin += counts[i];
        }
    }
};

std::uint32_t parts_of(std::size_t landings) {
    return std::uint32_t((landings + kLandingsPerPart - 1) / kLandingsPerPart);
}

/// Calls visit(landing) for those of a part.
template <class Visit>
void in_part(std::uint32_t part, std::size_t landings, const Visit& visit) {
    const std::size_t first = part * kLandingsPerPart;
    for (std::size_t i = first; i < std::min(landings, first + kLandingsPerPart); ++i)
        visit(i);
}

RankTerms own_terms(const LandingScore& score, const PointOwners& owners, const LandingOf& landing,
                    std::size_t count) {
    const std::size_t points = score.image().visible_points.size();
    const std::size_t first = owners.first(points), last = owners.last(points);
    const auto own = [&](std::size_t point) {
        return point >= first && point < last && score.has_bsdf(point);
    };
    RankTerms all;
    all.counts.resize(count);
    std::vector<std::vector<double>> parts(parts_of(count));
    tbb::parallel_for(0u, parts_of(count), [&](std::uint32_t part) {
        in_part(part, count, [&](std::size_t i) {
            const std::size_t before = parts[part].size();
            score.for_each_term(landing(i), own, [&](std::size_t /*point*/, double term) {
                parts[part].push_back(term);
            });
            all.counts[i] = std::uint32_t(parts[part].size() - before);
        });
    });
    for (const std::vector<double>& part : parts)
        all.terms.insert(all.terms.end(), part.begin(), part.end());
    return all;
}

/// [rank]; empty where no visible point has a Bsdf.
std::vector<RankTerms> terms_of_ranks(const LandingScore& score, const PointOwners& owners,
                                      const LandingOf& landing, std::size_t count) {
    if (!owners.any_bsdf) return {};
    std::vector<RankTerms> ranks(owners.ranks->count());
    SharedWork work = work_on_points(owners, nullptr);
    ranks[owners.ranks->rank()] = own_terms(score, owners, landing, count);
    work.exchange([&](std::uint32_t rank, StateArchive& archive) {
        state_of(archive, ranks[rank].counts, ranks[rank].terms);
    });
    for (RankTerms& rank : ranks)
        rank.index();
    return ranks;
}

}  // namespace

void score_with_ranks(const LandingScore& score, const PointOwners& owners,
                      const LandingOf& landing, std::span<double> scores) {
    const std::vector<RankTerms> ranks = terms_of_ranks(score, owners, landing, scores.size());
    const auto sum_part = [&](std::uint32_t part) {
        std::vector<std::size_t> next(ranks.size());
        in_part(part, scores.size(), [&](std::size_t i) {
            for (std::size_t rank = 0; rank < ranks.size(); ++rank)
                next[rank] = ranks[rank].begins[i];
            scores[i] = score.score_with(landing(i), [&](std::size_t point) {
                const std::uint32_t rank = owners.owner_of(point);
                return ranks[rank].terms[next[rank]++];
            });
        });
    };
    share_out(owners.ranks, parts_of(scores.size()), nullptr, sum_part,
              [&](std::uint32_t part, StateArchive& archive) {
                  const std::size_t first = part * kLandingsPerPart;
                  const std::size_t size = std::min(kLandingsPerPart, scores.size() - first);
                  plain(archive, scores.subspan(first, size));
              });
}

}  // namespace aips
