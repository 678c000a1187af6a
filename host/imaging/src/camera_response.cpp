// The response of a camera or film to light.
#include "camera_response.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "lxs/sdk/types.h"

namespace lxs {
namespace {

constexpr std::string_view kBuiltin[] = {"Advantix_100CD",
                                         "Advantix_200CD",
                                         "Advantix_400CD",
                                         "Agfachrome_ctpecisa_200CD",
                                         "Agfachrome_ctprecisa_100CD",
                                         "Agfachrome_rsx2_050CD",
                                         "Agfachrome_rsx2_100CD",
                                         "Agfachrome_rsx2_200CD",
                                         "Agfacolor_futura_100CD",
                                         "Agfacolor_futura_200CD",
                                         "Agfacolor_futura_400CD",
                                         "Agfacolor_futuraII_100CD",
                                         "Agfacolor_futuraII_200CD",
                                         "Agfacolor_futuraII_400CD",
                                         "Agfacolor_hdc_100_plusCD",
                                         "Agfacolor_hdc_200_plusCD",
                                         "Agfacolor_hdc_400_plusCD",
                                         "Agfacolor_optimaII_100CD",
                                         "Agfacolor_optimaII_200CD",
                                         "Agfacolor_ultra_050_CD",
                                         "Agfacolor_vista_100CD",
                                         "Agfacolor_vista_200CD",
                                         "Agfacolor_vista_400CD",
                                         "Agfacolor_vista_800CD",
                                         "Agfapan_apx_025CD",
                                         "Agfapan_apx_100CD",
                                         "Agfapan_apx_400CD",
                                         "Ektachrome_100_plusCD",
                                         "Ektachrome_100CD",
                                         "Ektachrome_320TCD",
                                         "Ektachrome_400XCD",
                                         "Ektachrome_64CD",
                                         "Ektachrome_64TCD",
                                         "Ektachrome_E100SCD",
                                         "F125CD",
                                         "F250CD",
                                         "F400CD",
                                         "FCICD",
                                         "Gold_100CD",
                                         "Gold_200CD",
                                         "Kodachrome_200CD",
                                         "Kodachrome_25CD",
                                         "Kodachrome_64CD",
                                         "Max_Zoom_800CD",
                                         "Portra_100TCD",
                                         "Portra_160NCCD",
                                         "Portra_160VCCD",
                                         "Portra_400NCCD",
                                         "Portra_400VCCD",
                                         "Portra_800CD"};

/// The exponent of x^gamma that fits y best, by Gauss-Newton steps from 1 with LuxRender's end: it
/// takes no better one.
double fitted_gamma(const std::vector<double>& x, const std::vector<double>& y) {
    constexpr int kMostSteps = 100;
    constexpr double kDark = 1e-12;  // where the logarithm says nothing
    double gamma = 1, last_squares = std::numeric_limits<double>::infinity();
    for (int step = 0; step < kMostSteps; ++step) {
        double squares = 0, slope = 0, curvature = 0;
        for (std::size_t i = 0; i < x.size(); ++i) {
            if (x[i] < kDark) continue;
            const double logarithm = std::log(x[i]);
            const double power = std::exp(gamma * logarithm);
            const double residual = y[i] - power;
            const double derivative = logarithm * power;
            squares += residual * residual;
            slope += derivative * residual;
            curvature += derivative * derivative;
        }
        if (std::abs(squares - last_squares) < 1e-6) break;
        const double change = slope / curvature;
        if (!std::isfinite(change) || std::abs(change) < 1e-9) break;
        gamma += change;
        last_squares = squares;
    }
    return gamma;
}

}  // namespace

bool is_builtin_response(std::string_view name) {
    return std::find(std::begin(kBuiltin), std::end(kBuiltin), name) != std::end(kBuiltin);
}

double ResponseCurve::at(double value) const {
    if (!(value > irradiance.front())) return brightness.front();
    if (value >= irradiance.back()) return brightness.back();
    const auto above = std::upper_bound(irradiance.begin(), irradiance.end(), value);
    const auto i = static_cast<std::size_t>(above - irradiance.begin());
    const double t = (value - irradiance[i - 1]) / (irradiance[i] - irradiance[i - 1]);
    return brightness[i - 1] + t * (brightness[i] - brightness[i - 1]);
}

CameraResponse::CameraResponse(std::vector<ResponseCurve> curves) : curves_(std::move(curves)) {
    std::vector<double> irradiances;
    for (const ResponseCurve& curve : curves_)
        irradiances.insert(irradiances.end(), curve.irradiance.begin(), curve.irradiance.end());
    std::sort(irradiances.begin(), irradiances.end());
    irradiances.erase(std::unique(irradiances.begin(), irradiances.end()), irradiances.end());
    std::vector<double> brightnesses;
    for (const double value : irradiances) {
        const auto [r, g, b] = map({value, value, value});
        brightnesses.push_back(
            luminance(Rgb(static_cast<float>(r), static_cast<float>(g), static_cast<float>(b))));
    }
    const double fitted = fitted_gamma(irradiances, brightnesses);
    if (!(fitted > 0)) return;
    gamma_ = fitted;
    for (ResponseCurve& curve : curves_) {
        for (double& value : curve.brightness)
            value = std::pow(value, 1 / gamma_);
    }
}

std::array<double, 3> CameraResponse::map(const std::array<double, 3>& rgb) const {
    if (curves_.size() == 3)
        return {curves_[0].at(rgb[0]), curves_[1].at(rgb[1]), curves_[2].at(rgb[2])};
    const Rgb color(static_cast<float>(rgb[0]), static_cast<float>(rgb[1]),
                    static_cast<float>(rgb[2]));
    const double grey = curves_[0].at(luminance(color));
    return {grey, grey, grey};
}

}  // namespace lxs
