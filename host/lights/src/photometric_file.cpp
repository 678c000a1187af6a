// Photometric files of luminaires: IESNA LM-63 (1986 to 2002).
#include "photometric_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <locale>
#include <sstream>

namespace lxs {
namespace {

constexpr double kMostCandela = 1e30;  // single precision holds what is made of it

/// Reads the numbers behind the TILT line; commas count as blanks.
class Numbers {
  public:
    Numbers(std::string text, const std::string& name, const SourceLocation& where)
        : name_(name), where_(where) {
        std::replace(text.begin(), text.end(), ',', ' ');
        stream_.str(std::move(text));
        stream_.imbue(std::locale::classic());
    }
    double next(const char* what) {
        double value = 0;
        if (!(stream_ >> value) || !std::isfinite(value)) fail(fmt::format("{} is missing", what));
        return value;
    }
    std::vector<double> next(const char* what, std::size_t count) {
        std::vector<double> values;  // grows with what is there, not with what is announced
        while (values.size() < count)
            values.push_back(next(what));
        return values;
    }
    std::size_t count(const char* what) {
        constexpr double kMost = 10000;
        const double value = next(what);
        if (!(value >= 1 && value <= kMost && value == std::floor(value)))
            fail(fmt::format("{} is {}", what, value));
        return static_cast<std::size_t>(value);
    }
    [[noreturn]] void fail(const std::string& cause) const {
        throw InputError(where_, fmt::format("photometric file \"{}\": {}", name_, cause));
    }

  private:
    std::istringstream stream_;
    const std::string& name_;
    const SourceLocation& where_;
};

/// What follows the line TILT=...; `included` tells that a tilt table comes first.
std::string after_tilt(const std::string& text, bool& included) {
    const auto tilt = text.find("TILT=");
    if (tilt == std::string::npos) return "";
    const auto end = std::min(text.find_first_of("\r\n", tilt), text.size());
    included = text.compare(tilt, 12, "TILT=INCLUDE") == 0;
    return text.substr(end);
}

void skip_tilt(Numbers& numbers) {
    numbers.next("the lamp's geometry");
    const std::size_t pairs = numbers.count("the number of tilt angles");
    numbers.next("a tilt angle or factor", 2 * pairs);
}

bool rising(const std::vector<double>& values) {
    return std::adjacent_find(values.begin(), values.end(), std::greater_equal<>()) == values.end();
}

/// Interval of `angles` that holds `angle`, within their range, and the share of its upper end.
struct Interval {
    std::size_t below, above;
    double share;
};

Interval interval(const std::vector<double>& angles, double angle) {
    const auto above = std::upper_bound(angles.begin(), angles.end(), angle);
    if (above == angles.begin()) return {0, 0, 0};
    const auto i = static_cast<std::size_t>(above - angles.begin());
    if (i == angles.size()) return {i - 1, i - 1, 0};
    return {i - 1, i, (angle - angles[i - 1]) / (angles[i] - angles[i - 1])};
}

/// The measured horizontal angle that stands for `angle`.
double mirrored(const std::vector<double>& measured, double angle) {
    double h = std::fmod(angle, 360.0);
    if (h < 0) h += 360;
    const double first = measured.front(), last = measured.back();
    constexpr double kSlack = 1e-6;
    if (first >= 90 - kSlack && last <= 270 + kSlack && last > 180)
        return h < 90 ? 180 - h : (h > 270 ? 540 - h : h);
    if (last > 180 + kSlack) return h;
    if (h > 180) h = 360 - h;
    if (last <= 90 + kSlack && h > 90) h = 180 - h;
    return h;
}

}  // namespace

double PhotometricWeb::intensity(double vertical, double horizontal) const {
    if (vertical < vertical_deg.front() || vertical > vertical_deg.back()) return 0;
    const Interval v = interval(vertical_deg, vertical);
    const Interval h = interval(horizontal_deg, mirrored(horizontal_deg, horizontal));
    const auto at = [&](std::size_t i) {
        const double* row = &candela[i * vertical_deg.size()];
        return std::lerp(row[v.below], row[v.above], v.share);
    };
    return std::lerp(at(h.below), at(h.above), h.share);
}

double PhotometricWeb::largest() const {
    return *std::max_element(candela.begin(), candela.end());
}

PhotometricWeb parse_photometric_text(const std::string& text, const std::string& name,
                                      const SourceLocation& where) {
    bool tilt = false;
    Numbers numbers(after_tilt(text, tilt), name, where);
    if (text.find("TILT=") == std::string::npos) numbers.fail("it has no line TILT=");
    if (tilt) skip_tilt(numbers);
    numbers.next("the number of lamps");
    numbers.next("the lamps' flux");
    const double multiplier = numbers.next("the candela multiplier");
    PhotometricWeb web;
    const std::size_t verticals = numbers.count("the number of vertical angles");
    const std::size_t horizontals = numbers.count("the number of horizontal angles");
    const double type = numbers.next("the photometric type");
    if (type != 1) numbers.fail(fmt::format("photometric type {}; only type C (1) is read", type));
    numbers.next("a dimension or factor", 7);  // units, three dimensions, two factors, watts
    web.vertical_deg = numbers.next("a vertical angle", verticals);
    web.horizontal_deg = numbers.next("a horizontal angle", horizontals);
    if (!rising(web.vertical_deg) || !rising(web.horizontal_deg))
        numbers.fail("its angles don't rise");
    web.candela = numbers.next("a candela value", verticals * horizontals);
    for (double& c : web.candela) {
        c = std::max(0.0, c * multiplier);
        if (!(c <= kMostCandela)) numbers.fail(fmt::format("a candela value is {}", c));
    }
    return web;
}

PhotometricWeb read_photometric_file(const std::string& path, const SourceLocation& where) {
    std::ifstream file(path, std::ios::binary);
    std::ostringstream text;
    if (!file || !(text << file.rdbuf()))
        throw InputError(where, fmt::format("cannot read photometric file \"{}\"", path));
    return parse_photometric_text(text.str(), path, where);
}

}  // namespace lxs
