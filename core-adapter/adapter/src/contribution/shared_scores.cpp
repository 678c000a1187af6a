// Terms of points that have a Bsdf, told by those who have it.
#include "contribution/shared_scores.h"

#include <algorithm>
#include <vector>

#include "ranks/shared_work.h"

namespace aips {
namespace {

/// Photons of a job: some hundred microseconds.
constexpr std::size_t kPhotonsPerPart = 64;

using PhotonOf = std::function<const Photon&(std::size_t)>;

/// What a rank's points with a Bsdf add to scores, photon after photon.
struct RankTerms {
    std::vector<std::uint32_t> counts;  // [photon]
    std::vector<double> terms;
    std::vector<std::size_t> begins;  // [photon] in `terms`

    void index() {
        begins.resize(counts.size());
        std::size_t begin = 0;
        for (std::size_t i = 0; i < counts.size(); ++i) {
            begins[i] = begin;
            begin += counts[i];
        }
    }
};

std::uint32_t parts_of(std::size_t photons) {
    return std::uint32_t((photons + kPhotonsPerPart - 1) / kPhotonsPerPart);
}

/// Calls visit(photon) for those of a part.
template <class Visit>
void in_part(std::uint32_t part, std::size_t photons, const Visit& visit) {
    const std::size_t first = part * kPhotonsPerPart;
    for (std::size_t i = first; i < std::min(photons, first + kPhotonsPerPart); ++i)
        visit(i);
}

RankTerms own_terms(const PhotonScore& score, const PointOwners& owners, const PhotonOf& photon,
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
            score.for_each_term(photon(i), own, [&](std::size_t /*point*/, double term) {
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
std::vector<RankTerms> terms_of_ranks(const PhotonScore& score, const PointOwners& owners,
                                      const PhotonOf& photon, std::size_t count) {
    if (!owners.any_bsdf) return {};
    std::vector<RankTerms> ranks(owners.ranks->count());
    SharedWork work = work_on_points(owners, nullptr);
    ranks[owners.ranks->rank()] = own_terms(score, owners, photon, count);
    work.exchange([&](std::uint32_t rank, StateArchive& archive) {
        state_of(archive, ranks[rank].counts, ranks[rank].terms);
    });
    for (RankTerms& rank : ranks)
        rank.index();
    return ranks;
}

}  // namespace

void score_with_ranks(const PhotonScore& score, const PointOwners& owners, const PhotonOf& photon,
                      std::span<double> scores) {
    const std::vector<RankTerms> ranks = terms_of_ranks(score, owners, photon, scores.size());
    const auto sum_part = [&](std::uint32_t part) {
        std::vector<std::size_t> next(ranks.size());
        in_part(part, scores.size(), [&](std::size_t i) {
            for (std::size_t rank = 0; rank < ranks.size(); ++rank)
                next[rank] = ranks[rank].begins[i];
            scores[i] = score.score_with(photon(i), [&](std::size_t point) {
                const std::uint32_t rank = owners.owner_of(point);
                return ranks[rank].terms[next[rank]++];
            });
        });
    };
    share_out(owners.ranks, parts_of(scores.size()), nullptr, sum_part,
              [&](std::uint32_t part, StateArchive& archive) {
                  const std::size_t first = part * kPhotonsPerPart;
                  const std::size_t size = std::min(kPhotonsPerPart, scores.size() - first);
                  plain(archive, scores.subspan(first, size));
              });
}

}  // namespace aips
