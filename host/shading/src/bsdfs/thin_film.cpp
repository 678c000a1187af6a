// Interference colours: the spectral mean, tabulated by the optical path.
#include "thin_film.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "lxs/spectrum/colour_matching.h"

namespace lxs::shading {
namespace {

using Imath::V3d;

constexpr double kPi = std::numbers::pi;

double path_length(const ThinFilm& film, double c) {
    const double sin2 = std::max(0.0, 1 - c * c);
    const double n = film.index;
    return 2 * double{film.thickness} * std::sqrt(std::max(0.0, n * n - sin2));
}

/// Means of cos(2 pi path / wavelength) per channel. Beyond kLongest the fringes have averaged out.
class FringeTable {
  public:
    static const FringeTable& table() {
        static const FringeTable table;
        return table;
    }
    Rgb at(double path) const {
        const double x = path / kStep;
        const auto i = static_cast<std::size_t>(x);
        if (!(x < static_cast<double>(means_.size() - 1))) return Rgb(0.0f);
        const auto t = static_cast<float>(x - static_cast<double>(i));
        return means_[i] * (1 - t) + means_[i + 1] * t;
    }

  private:
    static constexpr double kStep = 4, kLongest = 16000;  // nanometres

    FringeTable();
    std::vector<Rgb> means_;
};

FringeTable::FringeTable() {
    std::vector<V3d> responses;
    for (double nm = kFirstVisibleNm; nm <= kLastVisibleNm; ++nm)
        responses.push_back(rgb_response(nm));
    for (double path = 0; path <= kLongest; path += kStep) {
        V3d sum(0.0);
        for (std::size_t i = 0; i < responses.size(); ++i)
            sum += responses[i] *
                   std::cos(2 * kPi * path / (kFirstVisibleNm + static_cast<double>(i)));
        means_.emplace_back(static_cast<float>(sum.x), static_cast<float>(sum.y),
                            static_cast<float>(sum.z));
    }
}

}  // namespace

double film_share(const ThinFilm& film, double c, double wavelength) {
    if (!(film.thickness > 0)) return 1;
    return 0.5 + 0.5 * std::cos(2 * kPi * path_length(film, c) / wavelength);
}

Rgb ThinFilm::filter(float c) const {
    if (!(thickness > 0)) return Rgb(1.0f);
    if (wavelengths) {
        const auto at = [&](std::size_t i) {
            return static_cast<float>(film_share(*this, c, wavelengths->nm[i]));
        };
        return {at(0), at(1), at(2)};
    }
    const Rgb fringes = FringeTable::table().at(path_length(*this, c));
    const auto share = [](float fringe) { return std::clamp(0.5f + 0.5f * fringe, 0.0f, 1.0f); };
    return {share(fringes.x), share(fringes.y), share(fringes.z)};
}

}  // namespace lxs::shading
