// Camera samples: Owen-scrambled (0,2)-sequences over the passes, one per pixel and purpose.
// Sources: Burley 2020, "Practical Hash-based Owen Scrambling" (shuffling, scrambling, its hash);
// Kollig & Keller 2002 (the second Sobol' dimension); Steele et al. 2014 (64-bit mixing).
#include <algorithm>
#include <array>
#include <bit>
#include <iterator>
#include <optional>
#include <span>
#include <string_view>

#include "lxs/imaging/imaging.h"
#include "no_effect.h"
#include "option_choice.h"
#include "sampler_parameters.h"

namespace lxs {
namespace {

using enum ParameterType;

std::uint64_t mix(std::uint64_t x) {
    x += 0x9e3779b97f4a7c15u;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

std::uint32_t reverse_bits(std::uint32_t x) {
    x = __builtin_bswap32(x);
    x = ((x & 0x0f0f0f0fu) << 4) | ((x >> 4) & 0x0f0f0f0fu);
    x = ((x & 0x33333333u) << 2) | ((x >> 2) & 0x33333333u);
    return ((x & 0x55555555u) << 1) | ((x >> 1) & 0x55555555u);
}

/// Hash in which each bit depends on lower ones only (Burley 2020, section 3, after Laine &
/// Karras).
std::uint32_t laine_karras(std::uint32_t x, std::uint32_t seed) {
    x += seed;
    x ^= x * 0x6c50b47cu;
    x ^= x * 0xb82f1e52u;
    x ^= x * 0xc7afe638u;
    x ^= x * 0x8d22f6e6u;
    return x;
}

/// Owen scrambling: each bit is flipped by a hash of the higher ones. Of a number with its bits
/// reversed, as laine_karras() takes it.
std::uint32_t nested_scramble_reversed(std::uint32_t reversed, std::uint32_t seed) {
    return reverse_bits(laine_karras(reversed, seed));
}

/// Point `index` of the (0,2)-sequence, bits reversed: van der Corput's and the second Sobol'
/// dimension. The matrix of that is Pascal's triangle modulo 2, which by Lucas' theorem is a
/// product of one factor per bit of the bits' numbers: five steps in place of 32.
std::array<std::uint32_t, 2> reversed_zero_two_sequence(std::uint32_t index) {
    std::uint32_t second = index ^ (index >> 16);
    second ^= (second & 0xff00ff00u) >> 8;
    second ^= (second & 0xf0f0f0f0u) >> 4;
    second ^= (second & 0xccccccccu) >> 2;
    second ^= (second & 0xaaaaaaaau) >> 1;
    return {index, second};
}

float to_unit(std::uint32_t x) {
    return static_cast<float>(x >> 8) * 0x1p-24f;
}

/// Scrambled point of a sequence of its own for every `key`; its order is shuffled too, so that
/// points of several keys can be put together as if they were of higher dimension.
Vec2 scrambled_point(std::uint32_t index, std::uint64_t key) {
    const std::uint64_t first = mix(key), second = mix(first);
    const std::uint32_t shuffled =
        nested_scramble_reversed(reverse_bits(index), static_cast<std::uint32_t>(first));
    const auto point = reversed_zero_two_sequence(shuffled);
    return {to_unit(nested_scramble_reversed(point[0], static_cast<std::uint32_t>(second))),
            to_unit(nested_scramble_reversed(point[1], static_cast<std::uint32_t>(second >> 32)))};
}

class OwenSampler final : public Sampler {
  public:
    OwenSampler(std::uint64_t seed, LensUse lens,
                const std::optional<MetropolisSettings>& metropolis)
        : seed_(mix(seed)), lens_(lens), metropolis_(metropolis) {}

    const MetropolisSettings* metropolis() const override {
        return metropolis_ ? &*metropolis_ : nullptr;
    }

    CameraSample camera_sample(std::uint64_t pass, std::uint32_t x,
                               std::uint32_t y) const override {
        const auto index = static_cast<std::uint32_t>(pass);
        // Passes beyond 2^32 begin new sequences.
        const std::uint64_t pixel = mix(seed_ ^ mix((std::uint64_t{y} << 32) | x)) + (pass >> 32);
        const Vec2 within = scrambled_point(index, mix(pixel));
        CameraSample sample;
        sample.film = Vec2(inside(x, within.x), inside(y, within.y));
        sample.lens = lens_ == LensUse::None ? kLensCentre : scrambled_point(index, mix(~pixel));
        return sample;
    }

  private:
    /// Keeps rounding from lifting the sum into the next pixel.
    static float inside(std::uint32_t pixel, float offset) {
        const auto low = static_cast<float>(pixel);
        // The float below: bits of positive ones are in their order.
        const float last = std::bit_cast<float>(std::bit_cast<std::uint32_t>(low + 1) - 1);
        return std::min(low + offset, last);
    }

    static constexpr Vec2 kLensCentre{0.5f, 0.5f};

    std::uint64_t seed_;
    LensUse lens_;
    std::optional<MetropolisSettings> metropolis_;
};

constexpr std::array<std::string_view, 6> kPixelSamplers{"grid",           "hilbert", "linear",
                                                         "lowdiscrepancy", "tile",    "vegas"};

constexpr ParameterDeclaration kParameters[] = {
    {"pixelsamples", Integer, "4", "Ignored: a pass has one sample per pixel.", 0},
    {"xsamples", Integer, "2", "Ignored: a pass has one sample per pixel."},
    {"ysamples", Integer, "2", "Ignored: a pass has one sample per pixel."},
    {.name = "pixelsampler",
     .type = String,
     .default_text = "vegas",
     .doc = "Ignored: a pass covers the whole image.",
     .choices = kPixelSamplers},
};
constexpr ParameterDeclaration kNoiseAware[] = {
    {"noiseaware", Bool, "false", "Ignored: all pixels get as many samples."},
};

constexpr ParameterDeclaration kMetropolis[] = {
    {"largemutationprob", Float, "0.4", "Probability of drawing all of a sample anew.", 0, 1},
    {"maxconsecrejects", Integer, "0",
     "Rejections in a row after which the next sample that carries light is accepted whatever its "
     "brightness, which biases slightly; 0: never.",
     0, 4294967295.0},
    {"mutationrange", Float, "",
     "Farthest that a small mutation moves a sample, pixels; by default 1/32 of width + height.",
     0.001, 1e6},
    {.name = "usevariance",
     .type = Bool,
     .default_text = "false",
     .doc = "Brightness alone guides the chains.",
     .no_effect = true},
    {.name = "usecooldown",
     .type = Bool,
     .default_text = "true",
     .doc = "Chains start from plain samples chosen by brightness and need no warming up.",
     .no_effect = true},
    {.name = "noiseaware",
     .type = Bool,
     .default_text = "false",
     .doc = "Brightness alone guides the chains.",
     .no_effect = true},
    {.name = "initsamples",
     .type = Integer,
     .doc = "One plain sample a pixel, at least 16384 and at most 262144, starts the chains.",
     .no_effect = true},
};

constexpr ParameterDeclaration kMarkovChain[] = {
    {"maxconsecrejects", Integer, "512", "Ignored: there are no Markov chains."},
    {"largemutationprob", Float, "0.4", "Ignored: there are no Markov chains."},
    {"mutationrange", Float, "", "Ignored: there are no Markov chains."},
    {"usevariance", Bool, "false", "Ignored: there are no Markov chains."},
    {"usecooldown", Bool, "true", "Ignored: there are no Markov chains."},
    {"initsamples", Integer, "", "Ignored: there are no Markov chains."},
    {"chainlength", Integer, "", "Ignored: there are no Markov chains."},
    {"stratawidth", Integer, "", "Ignored: there are no Markov chains."},
};

MetropolisSettings read_metropolis(const ParameterReader& reader) {
    MetropolisSettings settings;
    settings.large_probability = reader.number("largemutationprob", settings.large_probability);
    settings.max_consecutive_rejects = static_cast<std::uint32_t>(
        reader.integer("maxconsecrejects", settings.max_consecutive_rejects));
    settings.film_range = reader.number("mutationrange", settings.film_range);
    return settings;
}

/// What a scene would set for another image, or another order of its pixels.
void warn_of_ignored(const ParameterReader& reader) {
    if (reader.string("pixelsampler", "linear") != "linear")
        warn_of_no_effect(reader, "pixelsampler", "a pass covers the whole image");
    if (reader.boolean("noiseaware", false))
        warn_of_no_effect(reader, "noiseaware", "all pixels get as many samples");
}

}  // namespace

std::span<const ParameterDeclaration> sampler_parameters(std::string_view sampler) {
    if (sampler == "metropolis") return kMetropolis;
    return {};
}

std::vector<ParameterDeclaration> all_sampler_parameters(const std::string& plugin) {
    std::vector<ParameterDeclaration> declared(std::begin(kParameters), std::end(kParameters));
    const std::span<const ParameterDeclaration> own =
        plugin == "metropolis" ? std::span<const ParameterDeclaration>(kMetropolis)
                               : std::span<const ParameterDeclaration>(kNoiseAware);
    declared.insert(declared.end(), own.begin(), own.end());
    if (plugin == "erpt")
        declared.insert(declared.end(), std::begin(kMarkovChain), std::end(kMarkovChain));
    return declared;
}

std::unique_ptr<Sampler> make_sampler(const SceneContents& contents, std::uint64_t seed,
                                      Diagnostics& diagnostics, bool runs_metropolis,
                                      LensUse lens) {
    const OptionChoice choice =
        choose_option(contents, "Sampler", "random",
                      {"erpt", "lowdiscrepancy", "metropolis", "random"}, diagnostics);
    const ParameterSet& set = choice.statement.parameters;
    std::vector<ParameterDeclaration> declared(std::begin(kParameters), std::end(kParameters));
    const auto declare = [&](std::span<const ParameterDeclaration> more) {
        std::copy(more.begin(), more.end(), std::back_inserter(declared));
    };
    if (set.plugin == "metropolis" && runs_metropolis) {
        declare(kMetropolis);
        const ParameterReader reader(set, declared, diagnostics);
        return std::make_unique<OwenSampler>(seed, lens, read_metropolis(reader));
    }
    declare(kNoiseAware);
    const bool has_chains = set.plugin == "metropolis" || set.plugin == "erpt";
    if (has_chains) {
        declare(kMarkovChain);
        diagnostics.warning(set.where,
                            "Sampler \"" + set.plugin +
                                "\" has no effect: every pixel gets the same number of samples");
    }
    const ParameterReader reader(set, declared, diagnostics);
    if (!has_chains) warn_of_ignored(reader);
    return std::make_unique<OwenSampler>(seed, lens, std::nullopt);
}

}  // namespace lxs
