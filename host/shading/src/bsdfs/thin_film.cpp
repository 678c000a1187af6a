// Interference colours: the spectral mean, tabulated by the optical path.
#include "thin_film.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace lxs::shading {
namespace {

using Imath::V3d;

constexpr double kFirstNm = 380, kLastNm = 780;
constexpr double kPi = std::numbers::pi;

double lobe(double nm, double centre, double left, double right) {
    const double t = (nm - centre) * (nm < centre ? left : right);
    return std::exp(-0.5 * t * t);
}

double path_length(const ThinFilm& film, double c) {
    const double sin2 = std::max(0.0, 1 - c * c);
    const double n = film.index;
    return 4 * double{film.thickness} * std::sqrt(std::max(0.0, n * n - sin2));
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
    V3d total(0.0);
    for (double nm = kFirstNm; nm <= kLastNm; ++nm) {
        responses.push_back(film_colour_response(nm));
        total += responses.back();
    }
    for (double path = 0; path <= kLongest; path += kStep) {
        V3d sum(0.0);
        for (std::size_t i = 0; i < responses.size(); ++i)
            sum += responses[i] * std::cos(2 * kPi * path / (kFirstNm + static_cast<double>(i)));
        means_.emplace_back(static_cast<float>(sum.x / total.x),
                            static_cast<float>(sum.y / total.y),
                            static_cast<float>(sum.z / total.z));
    }
}

}  // namespace

// Wyman, Sloan and Shirley 2013, "Simple analytic approximations to the CIE XYZ color matching
// functions", listing 1; then the primaries of Rec. 709 (ITU-R BT.709-6).
V3d film_colour_response(double nm) {
    const double x = 0.362 * lobe(nm, 442.0, 0.0624, 0.0374) +
                     1.056 * lobe(nm, 599.8, 0.0264, 0.0323) -
                     0.065 * lobe(nm, 501.1, 0.0490, 0.0382);
    const double y =
        0.821 * lobe(nm, 568.8, 0.0213, 0.0247) + 0.286 * lobe(nm, 530.9, 0.0613, 0.0322);
    const double z =
        1.217 * lobe(nm, 437.0, 0.0845, 0.0278) + 0.681 * lobe(nm, 459.0, 0.0385, 0.0725);
    return {3.2404542 * x - 1.5371385 * y - 0.4985314 * z,
            -0.9692660 * x + 1.8760108 * y + 0.0415560 * z,
            0.0556434 * x - 0.2040259 * y + 1.0572252 * z};
}

double film_share(const ThinFilm& film, double c, double wavelength) {
    if (!(film.thickness > 0)) return 1;
    return 0.5 + 0.5 * std::cos(2 * kPi * path_length(film, c) / wavelength);
}

Rgb ThinFilm::filter(float c) const {
    if (!(thickness > 0)) return Rgb(1.0f);
    const Rgb fringes = FringeTable::table().at(path_length(*this, c));
    const auto share = [](float fringe) { return std::clamp(0.5f + 0.5f * fringe, 0.0f, 1.0f); };
    return {share(fringes.x), share(fringes.y), share(fringes.z)};
}

}  // namespace lxs::shading
