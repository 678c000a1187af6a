// Samples of a Bsdf against its density and its values.
//
// Samples (density p if the host is right) and directions of a known density q give the same
// integral of p q / (p + q): the mean of q / (p + q) over the first, of p / (p + q) over the
// second. Both are at most 1, however narrow a lobe is.
#include <array>

#include "bsdf_statistics.h"

namespace aips {
namespace {

constexpr std::array<LobeMask, 3> kBits{kDiffuse, kGlossy, kSpecular};

bool near(double a, double b, double share) {
    return std::abs(a - b) <= share * std::max(std::abs(a), std::abs(b)) + 1e-12;
}

/// One draw with all that has to hold for it alone.
class Asking {
  public:
    Asking(const BsdfPlace& place, RandomStream& random, BsdfStatistics& statistics)
        : place_(place), random_(random), statistics_(statistics) {}

    void density(DensityStatistics& density);
    void energy();
    void albedo();
    void lambertian();
    void specular_choice();

  private:
    bool draw(LobeMask mask, Transport transport, BsdfSample& sample);
    bool sound(LobeMask mask, const BsdfSample& sample);
    void compare(const DensityStatistics& density, Transport transport, const BsdfSample& sample,
                 double p);
    DirectionProposal proposal(LobeMask mask);
    void add(OctantEstimates& estimates, Vec3 wi, double value) const;
    BsdfSample specular(float u_lobe, bool& drawn) const;

    const BsdfPlace& place_;
    RandomStream& random_;
    BsdfStatistics& statistics_;
    Frame frame_{place_.shading_normal};
};

bool Asking::draw(LobeMask mask, Transport transport, BsdfSample& sample) {
    const Vec2 u = random_.next2();
    return place_.bsdf.sample(place_.wo, u, random_.next(), transport, mask, sample) &&
           sound(mask, sample);
}

bool Asking::sound(LobeMask mask, const BsdfSample& s) {
    const bool values = statistics_.values.look(
        is_valid_radiance(s.weight) && std::isfinite(s.pdf) && s.pdf >= 0 && is_finite(s.wi), [&] {
            return "weight (" + figure(s.weight.r) + ", " + figure(s.weight.g) + ", " +
                   figure(s.weight.b) + "), pdf " + figure(s.pdf);
        });
    const bool direction = values && statistics_.directions.look(
                                         std::abs(length_squared(s.wi) - 1) < 1e-3f,
                                         [&] { return "wi of length " + figure(length(s.wi)); });
    const bool one = s.lobe == kDiffuse || s.lobe == kGlossy || s.lobe == kSpecular;
    const bool asked = statistics_.masks.look(one && (s.lobe & mask), [&] {
        return "lobe " + std::to_string(s.lobe) + " when asked for " + std::to_string(mask);
    });
    statistics_.lobes.look((s.lobe & ~place_.bsdf.lobes()) == 0, [&] {
        return "a sample of lobe " + std::to_string(s.lobe) + ", lobes() " +
               std::to_string(place_.bsdf.lobes());
    });
    const bool delta = statistics_.deltas.look((s.lobe == kSpecular) == (s.pdf == 0), [&] {
        return "pdf " + figure(s.pdf) + " of lobe " + std::to_string(s.lobe);
    });
    statistics_.drawn |= s.lobe;
    return values && direction && asked && delta;
}

DirectionProposal Asking::proposal(LobeMask mask) {
    std::vector<Vec3> pilots;
    for (int i = 0; i < 4 * kPilots && pilots.size() < kPilots; ++i) {
        BsdfSample sample;
        if (draw(mask, Transport::Power, sample) && sample.pdf > 0) pilots.push_back(sample.wi);
    }
    return DirectionProposal(std::move(pilots));
}

void Asking::add(OctantEstimates& estimates, Vec3 wi, double value) const {
    aips::add(estimates, value > 0 ? octant(frame_, wi) : -1, value);
}

void Asking::compare(const DensityStatistics& density, Transport transport, const BsdfSample& s,
                     double p) {
    statistics_.pdfs.look(near(p, s.pdf, 0.02),
                          [&] { return "sample's pdf " + figure(s.pdf) + ", pdf() " + figure(p); });
    if (s.component != kAllComponents)
        return;  // what is left of a dispersed weight is one of three
    const Rgb f = place_.bsdf.evaluate(place_.wo, s.wi, transport, density.mask);
    const double cosine = abs_dot(s.wi, place_.shading_normal);
    const double weight = luminance(f) * cosine / s.pdf;
    statistics_.weights.look(near(weight, luminance(s.weight), 0.02), [&] {
        return "weight " + figure(luminance(s.weight)) + ", f cos / pdf " + figure(weight);
    });
}

void Asking::density(DensityStatistics& density) {
    const DirectionProposal q = proposal(density.mask);
    for (std::uint32_t i = 0; i < place_.samples; ++i) {
        const Transport transport = i % 2 ? Transport::Radiance : Transport::Power;
        BsdfSample sample;
        double value = 0;
        if (draw(density.mask, transport, sample) && sample.lobe != kSpecular) {
            const double p = place_.bsdf.pdf(place_.wo, sample.wi, density.mask);
            const double known = q.pdf(sample.wi);
            compare(density, transport, sample, p);
            value = p >= 0 ? known / (p + known) : 0;
        }
        add(density.by_samples, sample.wi, value);
    }
    for (std::uint32_t i = 0; i < place_.samples; ++i) {
        const Vec3 wi = q.sample(random_);
        const double p = place_.bsdf.pdf(place_.wo, wi, density.mask), known = q.pdf(wi);
        const Rgb f = place_.bsdf.evaluate(place_.wo, wi, Transport::Power, density.mask);
        const bool sound = statistics_.values.look(
            p >= 0 && std::isfinite(p) && is_valid_radiance(f),
            [&] { return "pdf() " + figure(p) + ", evaluate() " + figure(luminance(f)); });
        add(density.by_density, wi, sound ? p / (p + known) : 0);
        const double light = luminance(f) * abs_dot(wi, place_.shading_normal);
        if (sound && light > 1e-3) {
            statistics_.unreachable.look(
                p > 0, [&] { return "f cos " + figure(light) + " where pdf() is 0"; });
        }
    }
}

/// Of what arrives along wo, which share leaves again; and which lobes take part.
void Asking::energy() {
    std::array<Estimate, 3> channels, lobes;
    for (std::uint32_t i = 0; i < place_.samples; ++i) {
        BsdfSample s;
        const bool drawn = draw(kAllLobes, Transport::Power, s);
        const Rgb weight = drawn ? s.weight : Rgb{};
        const std::array<float, 3> rgb{weight.r, weight.g, weight.b};
        for (std::size_t c = 0; c < 3; ++c) {
            channels[c].add(double(rgb[c]));
            lobes[c].add(drawn && s.lobe == kBits[c] ? double(luminance(weight)) : 0);
        }
    }
    for (std::size_t c = 0; c < 3; ++c) {
        statistics_.most_energy =
            std::max(statistics_.most_energy, channels[c].mean() - channels[c].error());
        const bool scatters = lobes[c].mean() > lobes[c].error() + 1e-3;
        if (scatters && is_black(place_.bsdf.albedo(place_.wo, kBits[c]))) {
            statistics_.dark_albedo[c] = true;
        }
    }
}

void Asking::albedo() {
    const LobeMask claimed = place_.bsdf.lobes();
    statistics_.claimed |= claimed;
    for (std::size_t i = 0; i < kBits.size(); ++i) {
        const Rgb albedo = place_.bsdf.albedo(place_.wo, kBits[i]);
        statistics_.albedos.look(is_valid_radiance(albedo) && max_component(albedo) <= 1.001f, [&] {
            return "albedo (" + figure(albedo.r) + ", " + figure(albedo.g) + ", " +
                   figure(albedo.b) + ")";
        });
        if (claimed & kBits[i]) {
            statistics_.albedo_of[i] =
                std::max(statistics_.albedo_of[i], double(luminance(albedo)));
            BsdfSample s;
            for (int attempt = 0; attempt < 64; ++attempt)
                draw(kBits[i], Transport::Power, s);
        }
    }
}

void Asking::lambertian() {
    Rgb kd;
    if (!place_.bsdf.lambertian(kd)) return;
    const float side = dot(place_.wo, place_.geometric_normal);
    for (int i = 0; i < 64; ++i) {
        const Vec3 wi = square_to_uniform_sphere(random_.next2());
        const Rgb f = place_.bsdf.evaluate(place_.wo, wi, Transport::Power, kAllLobes);
        const bool same = dot(wi, place_.geometric_normal) * side > 0;
        const double expected = same ? double(luminance(kd)) / double(kPi) : 0;
        statistics_.lambert.look(
            std::abs(luminance(f) - expected) <= 1e-3 * (expected + 1e-3),
            [&] { return "f " + figure(luminance(f)) + " where Kd / pi is " + figure(expected); });
    }
}

BsdfSample Asking::specular(float u_lobe, bool& drawn) const {
    BsdfSample s;
    drawn = place_.bsdf.sample(place_.wo, {0.5f, 0.5f}, u_lobe, Transport::Power, kSpecular, s) &&
            drawn;
    return s;
}

void Asking::specular_choice() {
    const float p = place_.bsdf.first_specular(place_.wo);
    if (!(p > 1e-3f && p < 0.999f)) return;
    bool drawn = true;
    const Vec3 first = specular(0.1f * p, drawn).wi, still_first = specular(0.98f * p, drawn).wi;
    const Vec3 second = specular(p + 0.02f * (1 - p), drawn).wi;
    const Vec3 still_second = specular(p + 0.9f * (1 - p), drawn).wi;
    if (!drawn) return;
    const auto apart = [](Vec3 a, Vec3 b) { return length(a - b) > 1e-3f; };
    statistics_.choices.look(!apart(first, still_first) && !apart(second, still_second),
                             [&] { return "another direction on one side of " + figure(p); });
}

}  // namespace

void ask_bsdf(const BsdfPlace& place, RandomStream& random, BsdfStatistics& statistics) {
    Asking asking(place, random, statistics);
    asking.albedo();
    for (const LobeMask mask : {kAllLobes, kNonSpecular, kDiffuse, kGlossy}) {
        // The first choice of lobes that comes to the same stands for all that do.
        const LobeMask lobes = place.bsdf.lobes();
        if ((mask & lobes & kNonSpecular) == 0) continue;
        if (mask != kAllLobes && (mask & lobes) == lobes) continue;
        if ((mask == kDiffuse || mask == kGlossy) && (mask & lobes) == (kNonSpecular & lobes)) {
            continue;
        }
        auto known = std::find_if(statistics.densities.begin(), statistics.densities.end(),
                                  [&](const DensityStatistics& d) { return d.mask == mask; });
        if (known == statistics.densities.end()) {
            statistics.densities.push_back({.mask = mask, .by_samples = {}, .by_density = {}});
            known = statistics.densities.end() - 1;
        }
        asking.density(*known);
    }
    asking.energy();
    asking.lambertian();
    asking.specular_choice();
}

}  // namespace aips
