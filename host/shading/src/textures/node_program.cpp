// A graph of Blender's shader nodes as a program. Formulas are those of Cycles' kernel, versions
// 3.4 to 4.3 (Apache License 2.0).
#include "node_program.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>
#include <span>
#include <sstream>
#include <stdexcept>
#include <string_view>

#include "cycles_noise.h"
#include "space_mapping.h"

namespace lxs::shading::nodes {
namespace {

using Words = std::span<const std::string_view>;
using Operand = NodeProgram::Operand;

enum class Name : std::uint8_t {
    Value,
    Position,
    Local,
    Uv,
    Normal,
    LocalNormal,
    Color,
    Alpha,
    Texture,
    TextureAt,
    Affine,
    Luminance,
    Average,
    Channel,
    Combine,
    ToHsv,
    FromHsv,
    Math,
    Vector,
    Mix,
    Clamp,
    Ramp,
    Curves,
    HueSaturation,
    BrightContrast,
    Gamma,
    Invert,
    MapRange,
    Noise,
    Voronoi,
    White,
    Checker,
    Brick,
    Gradient,
    Wave,
    Magic
};

enum class Math : std::uint8_t {
    Add,
    Subtract,
    Multiply,
    Divide,
    MultiplyAdd,
    Power,
    Logarithm,
    Sqrt,
    InverseSqrt,
    Absolute,
    Exponent,
    Minimum,
    Maximum,
    LessThan,
    GreaterThan,
    Sign,
    Compare,
    SmoothMin,
    SmoothMax,
    Round,
    Floor,
    Ceil,
    Trunc,
    Fract,
    Modulo,
    FlooredModulo,
    Wrap,
    Snap,
    PingPong,
    Sine,
    Cosine,
    Tangent,
    ArcSine,
    ArcCosine,
    ArcTangent,
    ArcTan2,
    SinH,
    CosH,
    TanH,
    Radians,
    Degrees
};
constexpr std::array<std::string_view, 41> kMath{
    "add",        "subtract",       "multiply",     "divide",    "multiply_add", "power",
    "logarithm",  "sqrt",           "inverse_sqrt", "absolute",  "exponent",     "minimum",
    "maximum",    "less_than",      "greater_than", "sign",      "compare",      "smooth_min",
    "smooth_max", "round",          "floor",        "ceil",      "trunc",        "fract",
    "modulo",     "floored_modulo", "wrap",         "snap",      "pingpong",     "sine",
    "cosine",     "tangent",        "arcsine",      "arccosine", "arctangent",   "arctan2",
    "sinh",       "cosh",           "tanh",         "radians",   "degrees"};

enum class VectorMath : std::uint8_t {
    Add,
    Subtract,
    Multiply,
    Divide,
    MultiplyAdd,
    CrossProduct,
    Project,
    Reflect,
    DotProduct,
    Distance,
    Length,
    Scale,
    Normalize,
    Absolute,
    Minimum,
    Maximum,
    Floor,
    Ceil,
    Fraction,
    Modulo,
    Wrap,
    Snap,
    Sine,
    Cosine,
    Tangent
};
constexpr std::array<std::string_view, 25> kVectorMath{
    "add",     "subtract",    "multiply", "divide", "multiply_add", "cross_product", "project",
    "reflect", "dot_product", "distance", "length", "scale",        "normalize",     "absolute",
    "minimum", "maximum",     "floor",    "ceil",   "fraction",     "modulo",        "wrap",
    "snap",    "sine",        "cosine",   "tangent"};

enum class Mix : std::uint8_t {
    Mix,
    Darken,
    Multiply,
    Burn,
    Lighten,
    Screen,
    Dodge,
    Add,
    Overlay,
    SoftLight,
    LinearLight,
    Difference,
    Exclusion,
    Subtract,
    Divide,
    Hue,
    Saturation,
    Color,
    Value
};
constexpr std::array<std::string_view, 19> kMix{
    "mix",    "darken",  "multiply",   "burn",         "lighten",    "screen",    "dodge",
    "add",    "overlay", "soft_light", "linear_light", "difference", "exclusion", "subtract",
    "divide", "hue",     "saturation", "color",        "value"};

constexpr std::array<std::string_view, 3> kAxes{"x", "y", "z"};
constexpr std::array<std::string_view, 2> kRamps{"linear", "constant"};
constexpr std::array<std::string_view, 4> kRanges{"linear", "stepped", "smoothstep",
                                                  "smootherstep"};
constexpr std::array<std::string_view, 2> kKinds{"fac", "color"};
constexpr std::array<std::string_view, 2> kCellDimensions{"2d", "3d"};
constexpr std::array<std::string_view, 4> kDimensions{"1d", "2d", "3d", "4d"};
constexpr std::array<std::string_view, 4> kFeatures{"f1", "f2", "smooth_f1", "distance_to_edge"};
constexpr std::array<std::string_view, 4> kMetrics{"euclidean", "manhattan", "chebychev",
                                                   "minkowski"};
constexpr std::array<std::string_view, 3> kCells{"distance", "color", "position"};
constexpr std::array<std::string_view, 7> kGradients{
    "linear", "quadratic", "easing", "diagonal", "radial", "quadratic_sphere", "spherical"};
constexpr std::array<std::string_view, 2> kWaves{"bands", "rings"};
constexpr std::array<std::string_view, 4> kDirections{"x", "y", "z", "diagonal"};
constexpr std::array<std::string_view, 3> kProfiles{"sin", "saw", "tri"};

/// What an instruction is written with.
struct Grammar {
    std::string_view name;
    std::vector<Words> modes;
    std::size_t inputs = 0;
    bool table = false, varies = false;
};

/// In the order of Name.
const std::vector<Grammar>& grammar() {
    static const std::vector<Grammar> all{
        {"value", {}, 3},
        {"position", {}, 0, false, true},
        {"local", {}, 0, false, true},
        {"uv", {}, 0, false, true},
        {"normal", {}, 0, false, true},
        {"localnormal", {}, 0, false, true},
        {"color", {}, 0, false, true},
        {"alpha", {}, 0, false, true},
        {"texture", {}, 1, false, true},
        {"textureat", {}, 2, false, true},
        {"affine", {}, 1, true},
        {"luminance", {}, 1},
        {"average", {}, 1},
        {"channel", {kAxes}, 1},
        {"combine", {}, 3},
        {"tohsv", {}, 1},
        {"fromhsv", {}, 1},
        {"math", {kMath}, 3},
        {"vector", {kVectorMath}, 4},
        {"mix", {kMix}, 3},
        {"clamp", {}, 3},
        {"ramp", {kRamps}, 1, true},
        {"curves", {}, 1, true},
        {"huesaturation", {}, 5},
        {"brightcontrast", {}, 3},
        {"gamma", {}, 2},
        {"invert", {}, 2},
        {"maprange", {kRanges}, 6},
        {"noise", {kKinds, kDimensions}, 7},
        {"voronoi", {kCellDimensions, kFeatures, kMetrics, kCells}, 5},
        {"white", {kKinds}, 1},
        {"checker", {}, 4},
        {"brick", {kKinds}, 14},
        {"gradient", {kGradients}, 1},
        {"wave", {kWaves, kDirections, kProfiles}, 7},
        {"magic", {kKinds}, 4}};
    return all;
}

[[noreturn]] void fail(const std::string& text) {
    throw std::runtime_error(text);
}

float number_of(std::string_view word) {
    float number = 0;
    const auto read = std::from_chars(word.data(), word.data() + word.size(), number);
    if (read.ec != std::errc() || read.ptr != word.data() + word.size() || !std::isfinite(number))
        fail(fmt::format("\"{}\" is no number", word));
    return number;
}

Operand operand_of(std::string_view word, std::size_t instructions) {
    if (!word.starts_with('r')) return {-1, number_of(word)};
    unsigned index = 0;
    const auto read = std::from_chars(word.data() + 1, word.data() + word.size(), index);
    if (read.ec != std::errc() || read.ptr != word.data() + word.size() || index >= instructions)
        fail(fmt::format("\"{}\" names no instruction before this one", word));
    return {static_cast<int>(index), 0};
}

std::uint8_t index_of(std::string_view word, Words choices) {
    const auto found = std::ranges::find(choices, word);
    if (found == choices.end())
        fail(fmt::format("\"{}\" is none of {}", word, fmt::join(choices, ", ")));
    return static_cast<std::uint8_t>(found - choices.begin());
}

NodeProgram::Instruction instruction_of(const std::string& line, std::size_t before) {
    std::istringstream stream(line);
    std::vector<std::string> words;
    for (std::string word; stream >> word;)
        words.push_back(word);
    if (words.empty()) fail("an instruction is empty");
    const auto named = std::ranges::find(grammar(), words[0], &Grammar::name);
    if (named == grammar().end()) fail(fmt::format("there is no instruction \"{}\"", words[0]));
    const std::size_t fixed = 1 + named->modes.size() + named->inputs;
    if (words.size() < fixed || (words.size() > fixed && !named->table)) {
        fail(fmt::format("\"{}\" takes {} words, not {}", words[0], fixed - 1, words.size() - 1));
    }
    NodeProgram::Instruction made;
    made.name = static_cast<std::uint8_t>(named - grammar().begin());
    std::size_t at = 1;
    for (const Words& choices : named->modes)
        made.modes.push_back(index_of(words[at++], choices));
    while (at < fixed)
        made.inputs.push_back(operand_of(words[at++], before));
    while (at < words.size())
        made.table.push_back(number_of(words[at++]));
    return made;
}

/// What else has to hold of an instruction.
void check(const NodeProgram::Instruction& made, std::size_t textures) {
    const std::size_t size = made.table.size();
    switch (static_cast<Name>(made.name)) {
        case Name::Affine:
            if (size != 12) fail("\"affine\" takes 12 numbers: three rows of four");
            break;
        case Name::Ramp: {
            if (size == 0 || size % 4 != 0) fail("\"ramp\" takes four numbers a stop");
            for (std::size_t i = 4; i < size; i += 4) {
                if (made.table[i] < made.table[i - 4]) fail("the stops of \"ramp\" must rise");
            }
            break;
        }
        case Name::Curves:
            if (size < 8 || (size - 2) % 3 != 0 || made.table[0] >= made.table[1])
                fail("\"curves\" takes a range, then at least two points of three numbers");
            break;
        case Name::Texture:
        case Name::TextureAt: {
            const float number = made.inputs[0].number;
            if (made.inputs[0].instruction >= 0 || number < 1 || number != std::floor(number) ||
                number > static_cast<float>(textures))
                fail("\"texture\" takes the number of a texture that is given");
            break;
        }
        default:
            break;
    }
}

// Formulas ------------------------------------------------------------------------------------

Vec3 each(const Vec3& a, auto f) {
    return {f(a.x), f(a.y), f(a.z)};
}
Vec3 each(const Vec3& a, const Vec3& b, auto f) {
    return {f(a.x, b.x), f(a.y, b.y), f(a.z, b.z)};
}
Vec3 each(const Vec3& a, const Vec3& b, const Vec3& c, auto f) {
    return {f(a.x, b.x, c.x), f(a.y, b.y, c.y), f(a.z, b.z, c.z)};
}

float divided(float a, float b) {
    return b == 0 ? 0 : a / b;
}
float fraction(float a) {
    return a - std::floor(a);
}
float wrapped(float a, float most, float least) {
    const float range = most - least;
    return range == 0 ? least : a - range * std::floor((a - least) / range);
}
float saturated(float a) {
    return std::clamp(a, 0.0f, 1.0f);
}
float smooth(float t) {
    return t * t * (3 - 2 * t);
}
float smooth_minimum(float a, float b, float c) {
    if (c == 0) return std::min(a, b);
    const float h = std::max(c - std::abs(a - b), 0.0f) / c;
    return std::min(a, b) - h * h * h * c / 6;
}

float math(Math what, float a, float b, float c) {
    switch (what) {
        case Math::Add:
            return a + b;
        case Math::Subtract:
            return a - b;
        case Math::Multiply:
            return a * b;
        case Math::Divide:
            return divided(a, b);
        case Math::MultiplyAdd:
            return a * b + c;
        case Math::Power:
            return a < 0 && b != std::floor(b) ? 0 : std::pow(a, b);
        case Math::Logarithm:
            return a > 0 && b > 0 ? divided(std::log(a), std::log(b)) : 0;
        case Math::Sqrt:
            return a > 0 ? std::sqrt(a) : 0;
        case Math::InverseSqrt:
            return a > 0 ? 1 / std::sqrt(a) : 0;
        case Math::Absolute:
            return std::abs(a);
        case Math::Exponent:
            return std::exp(a);
        case Math::Minimum:
            return std::min(a, b);
        case Math::Maximum:
            return std::max(a, b);
        case Math::LessThan:
            return a < b;
        case Math::GreaterThan:
            return a > b;
        case Math::Sign:
            return a > 0 ? 1.0f : a < 0 ? -1.0f : 0.0f;
        case Math::Compare:
            return a == b || std::abs(a - b) <= std::max(c, 1.1920929e-7f);
        case Math::SmoothMin:
            return smooth_minimum(a, b, c);
        case Math::SmoothMax:
            return -smooth_minimum(-a, -b, c);
        case Math::Round:
            return std::floor(a + 0.5f);
        case Math::Floor:
            return std::floor(a);
        case Math::Ceil:
            return std::ceil(a);
        case Math::Trunc:
            return std::trunc(a);
        case Math::Fract:
            return fraction(a);
        case Math::Modulo:
            return b == 0 ? 0 : std::fmod(a, b);
        case Math::FlooredModulo:
            return b == 0 ? 0 : a - std::floor(a / b) * b;
        case Math::Wrap:
            return wrapped(a, b, c);
        case Math::Snap:
            return std::floor(divided(a, b)) * b;
        case Math::PingPong:
            return b == 0 ? 0 : std::abs(fraction((a - b) / (b * 2)) * b * 2 - b);
        case Math::Sine:
            return std::sin(a);
        case Math::Cosine:
            return std::cos(a);
        case Math::Tangent:
            return std::tan(a);
        case Math::ArcSine:
            return std::asin(std::clamp(a, -1.0f, 1.0f));
        case Math::ArcCosine:
            return std::acos(std::clamp(a, -1.0f, 1.0f));
        case Math::ArcTangent:
            return std::atan(a);
        case Math::ArcTan2:
            return std::atan2(a, b);
        case Math::SinH:
            return std::sinh(a);
        case Math::CosH:
            return std::cosh(a);
        case Math::TanH:
            return std::tanh(a);
        case Math::Radians:
            return a * std::numbers::pi_v<float> / 180;
        case Math::Degrees:
            return a * 180 / std::numbers::pi_v<float>;
    }
    return 0;
}

Vec3 vector_math(VectorMath what, const Vec3& a, const Vec3& b, const Vec3& c, float scale) {
    switch (what) {
        case VectorMath::Add:
            return a + b;
        case VectorMath::Subtract:
            return a - b;
        case VectorMath::Multiply:
            return a * b;
        case VectorMath::Divide:
            return each(a, b, divided);
        case VectorMath::MultiplyAdd:
            return a * b + c;
        case VectorMath::CrossProduct:
            return a.cross(b);
        case VectorMath::Project:
            return b * divided(a.dot(b), b.dot(b));
        case VectorMath::Reflect: {
            const Vec3 n = b.normalized();
            return a - n * (2 * n.dot(a));
        }
        case VectorMath::DotProduct:
            return Vec3(a.dot(b));
        case VectorMath::Distance:
            return Vec3((a - b).length());
        case VectorMath::Length:
            return Vec3(a.length());
        case VectorMath::Scale:
            return a * scale;
        case VectorMath::Normalize:
            return a.normalized();
        case VectorMath::Absolute:
            return each(a, [](float x) { return std::abs(x); });
        case VectorMath::Minimum:
            return each(a, b, [](float x, float y) { return std::min(x, y); });
        case VectorMath::Maximum:
            return each(a, b, [](float x, float y) { return std::max(x, y); });
        case VectorMath::Floor:
            return each(a, [](float x) { return std::floor(x); });
        case VectorMath::Ceil:
            return each(a, [](float x) { return std::ceil(x); });
        case VectorMath::Fraction:
            return each(a, fraction);
        case VectorMath::Modulo:
            return each(a, b, [](float x, float y) { return y == 0 ? 0 : std::fmod(x, y); });
        case VectorMath::Wrap:
            return each(a, b, c, wrapped);
        case VectorMath::Snap:
            return each(a, b, [](float x, float y) { return std::floor(divided(x, y)) * y; });
        case VectorMath::Sine:
            return each(a, [](float x) { return std::sin(x); });
        case VectorMath::Cosine:
            return each(a, [](float x) { return std::cos(x); });
        case VectorMath::Tangent:
            return each(a, [](float x) { return std::tan(x); });
    }
    return Vec3(0.0f);
}

Vec3 hsv_of(const Vec3& rgb) {
    const float most = std::max({rgb.x, rgb.y, rgb.z}), least = std::min({rgb.x, rgb.y, rgb.z});
    const float range = most - least;
    if (most == 0 || range == 0) return {0, most == 0 ? 0 : range / most, most};
    const Vec3 c = (Vec3(most) - rgb) / range;
    float hue = rgb.x == most ? c.z - c.y : rgb.y == most ? 2 + c.x - c.z : 4 + c.y - c.x;
    hue /= 6;
    return {hue < 0 ? hue + 1 : hue, range / most, most};
}

Vec3 rgb_of(const Vec3& hsv) {
    const float s = hsv.y, v = hsv.z;
    if (s == 0) return Vec3(v);
    const float h = fraction(hsv.x) * 6, i = std::floor(h), f = h - i;
    const float p = v * (1 - s), q = v * (1 - s * f), t = v * (1 - s * (1 - f));
    switch (static_cast<int>(i)) {
        case 0:
            return {v, t, p};
        case 1:
            return {q, v, p};
        case 2:
            return {p, v, t};
        case 3:
            return {p, q, v};
        case 4:
            return {t, p, v};
        default:
            return {v, p, q};
    }
}

float burnt(float a, float b, float t) {
    const float by = 1 - t + t * b;
    return by <= 0 ? 0 : saturated(1 - (1 - a) / by);
}
float dodged(float a, float b, float t) {
    if (a == 0) return 0;
    const float by = 1 - t * b;
    return by <= 0 ? 1 : std::min(a / by, 1.0f);
}
float overlaid(float a, float b, float t) {
    return a < 0.5f ? a * (1 - t + 2 * t * b) : 1 - (1 - t + 2 * t * (1 - b)) * (1 - a);
}
float softly_lit(float a, float b, float t) {
    const float screen = 1 - (1 - b) * (1 - a);
    return (1 - t) * a + t * ((1 - a) * b * a + a * screen);
}

/// Those that take hue, saturation or value of one and the rest of the other.
Vec3 mixed_by_hsv(Mix how, float t, const Vec3& a, const Vec3& b) {
    Vec3 hsv = hsv_of(a);
    const Vec3 other = hsv_of(b);
    if (how == Mix::Saturation) {
        if (hsv.y == 0) return a;
        hsv.y = (1 - t) * hsv.y + t * other.y;
        return rgb_of(hsv);
    }
    if (how == Mix::Value) {
        hsv.z = (1 - t) * hsv.z + t * other.z;
        return rgb_of(hsv);
    }
    if (other.y == 0) return a;
    hsv.x = other.x;
    if (how == Mix::Color) hsv.y = other.y;
    return a * (1 - t) + rgb_of(hsv) * t;
}

Vec3 mixed(Mix how, float t, const Vec3& a, const Vec3& b) {
    const auto towards = [&](const Vec3& whole) { return a * (1 - t) + whole * t; };
    const auto by = [&](auto f) {
        return each(a, b, [&](float x, float y) { return f(x, y, t); });
    };
    switch (how) {
        case Mix::Mix:
            return towards(b);
        case Mix::Darken:
            return towards(each(a, b, [](float x, float y) { return std::min(x, y); }));
        case Mix::Multiply:
            return towards(a * b);
        case Mix::Burn:
            return by(burnt);
        case Mix::Lighten:
            return towards(each(a, b, [](float x, float y) { return std::max(x, y); }));
        case Mix::Screen:
            return by([](float x, float y, float s) { return 1 - (1 - s * y) * (1 - x); });
        case Mix::Dodge:
            return by(dodged);
        case Mix::Add:
            return towards(a + b);
        case Mix::Overlay:
            return by(overlaid);
        case Mix::SoftLight:
            return by(softly_lit);
        case Mix::LinearLight:
            return a + (b * 2 - Vec3(1.0f)) * t;
        case Mix::Difference:
            return towards(each(a, b, [](float x, float y) { return std::abs(x - y); }));
        case Mix::Exclusion:
            return each(towards(a + b - a * b * 2), [](float x) { return std::max(x, 0.0f); });
        case Mix::Subtract:
            return towards(a - b);
        case Mix::Divide:
            return each(a, b,
                        [&](float x, float y) { return y == 0 ? x : (1 - t) * x + t * x / y; });
        case Mix::Hue:
        case Mix::Saturation:
        case Mix::Color:
        case Mix::Value:
            return mixed_by_hsv(how, t, a, b);
    }
    return a;
}

Vec3 on_ramp(bool constant, float at, const std::vector<float>& stops) {
    const auto color = [&](std::size_t i) {
        return Vec3(stops[4 * i + 1], stops[4 * i + 2], stops[4 * i + 3]);
    };
    const std::size_t count = stops.size() / 4;
    std::size_t above = 0;
    while (above < count && stops[4 * above] <= at)
        ++above;
    if (above == 0) return color(0);
    if (above == count || constant) return color(above - 1);
    const float from = stops[4 * above - 4], to = stops[4 * above];
    const float share = (at - from) / (to - from);
    return color(above - 1) * (1 - share) + color(above) * share;
}

/// Points at even distances over a range, a curve for each channel; beyond it lines go on.
Vec3 on_curves(const Vec3& at, const std::vector<float>& table) {
    const std::size_t count = (table.size() - 2) / 3;
    Vec3 found;
    for (int c = 0; c < 3; ++c) {
        const float place =
            (at[c] - table[0]) / (table[1] - table[0]) * static_cast<float>(count - 1);
        const auto i = static_cast<std::size_t>(
            std::clamp(std::floor(place), 0.0f, static_cast<float>(count - 2)));
        const float share = place - static_cast<float>(i);
        const float* points = &table[2 + 3 * i + static_cast<std::size_t>(c)];
        found[c] = points[0] * (1 - share) + points[3] * share;
    }
    return found;
}

float in_range(std::uint8_t how, float x, float from, float to, float least, float most,
               float steps) {
    if (from == to) return 0;
    float t = (x - from) / (to - from);
    if (how == 1) t = steps > 0 ? std::floor(t * (steps + 1)) / steps : 0;
    if (how >= 2) t = saturated(t);
    if (how == 2) t = smooth(t);
    if (how == 3) t = t * t * t * (t * (t * 6 - 15) + 10);
    return least + t * (most - least);
}

Vec3 nudged(const Vec3& p) {
    return (p + Vec3(1e-6f)) * 0.999999f;
}

Vec3 checker(const Vec3& place, const Vec3& first, const Vec3& second) {
    const Vec3 p = nudged(place);
    const auto odd = [](float x) { return std::fmod(std::abs(std::floor(x)), 2.0f) == 1; };
    return (odd(p.x) == odd(p.y)) == odd(p.z) ? first : second;
}

float brick_tint(std::int64_t number) {
    auto n = static_cast<std::uint32_t>(number);
    n = (n + 1013) & 0x7fffffff;
    n = (n >> 13) ^ n;
    const std::uint32_t mixed = (n * (n * n * 60493 + 19990303) + 1376312589) & 0x7fffffff;
    return 0.5f * (static_cast<float>(mixed) / 1073741824.0f);
}

/// Inputs: place, scale, two colours of bricks, that of the mortar, the mortar's size and
/// smoothness, bias, width, height, offset and its frequency, squash and its frequency.
Vec3 brick(bool color, std::span<const Vec3> in) {
    const Vec3 p = in[0] * in[1].x;
    const float mortar_size = in[5].x, smoothness = in[6].x, bias = in[7].x, height = in[9].x;
    float width = in[8].x, offset = 0;
    if (width <= 0 || height <= 0) return Vec3(0.0f);
    const float row = std::floor(p.y / height);
    const auto multiple = [&](float of) { return std::fmod(row, of) == 0; };
    if (in[11].x >= 1 && in[13].x >= 1) {
        if (multiple(std::floor(in[13].x))) width *= in[12].x;
        if (!multiple(std::floor(in[11].x)))
            offset = 0;
        else
            offset = width * in[10].x;
    }
    const float number = std::floor((p.x + offset) / width);
    const float x = p.x + offset - width * number, y = p.y - height * row;
    const auto whole = [](float f) {
        return static_cast<std::int64_t>(std::clamp(f, -1e9f, 1e9f));
    };
    const float tint = saturated(brick_tint((whole(row) << 16) + (whole(number) & 0xffff)) + bias);
    const float edge = std::min({x, y, width - x, height - y});
    float mortar = 0;
    if (edge < mortar_size)
        mortar = smoothness == 0 ? 1 : smooth(saturated((1 - edge / mortar_size) / smoothness));
    if (!color) return Vec3(mortar);
    const Vec3 stone = in[2] * (1 - tint) + in[3] * tint;
    return stone * (1 - mortar) + in[4] * mortar;
}

float gradient(std::uint8_t what, const Vec3& p) {
    const float from_centre = std::max(0.999999f - p.length(), 0.0f);
    switch (what) {
        case 0:
            return saturated(p.x);
        case 1:
            return saturated(std::max(p.x, 0.0f) * std::max(p.x, 0.0f));
        case 2:
            return smooth(saturated(p.x));
        case 3:
            return saturated((p.x + p.y) / 2);
        case 4:
            return saturated(std::atan2(p.y, p.x) / (2 * std::numbers::pi_v<float>)+0.5f);
        case 5:
            return from_centre * from_centre;
        default:
            return from_centre;
    }
}

/// Inputs: place with scale, distortion, detail, its scale and roughness, phase.
float wave(std::span<const std::uint8_t> modes, std::span<const Vec3> in) {
    const Vec3 p = nudged(in[0]);
    const bool rings = modes[0] == 1;
    float n;
    if (modes[1] == 3) {
        n = rings ? p.length() * 20 : (p.x + p.y + p.z) * 10;
    } else if (rings) {
        Vec3 across = p;
        across[modes[1]] = 0;
        n = across.length() * 20;
    } else {
        n = p[modes[1]] * 20;
    }
    n += in[5].x;
    if (in[1].x != 0) {
        n += in[1].x * (cycles::noise({p * in[3].x}, {in[2].x, saturated(in[4].x), 2}) * 2 - 1);
    }
    if (modes[2] == 0) return 0.5f + 0.5f * std::sin(n - std::numbers::pi_v<float> / 2);
    n /= 2 * std::numbers::pi_v<float>;
    return modes[2] == 1 ? n - std::floor(n) : std::abs(n - std::floor(n + 0.5f)) * 2;
}

Vec3 magic(const Vec3& place, int depth, float by) {
    constexpr float kTurn = 2 * std::numbers::pi_v<float>;
    const Vec3 p = each(place, [](float x) { return std::fmod(x, kTurn); });
    float x = std::sin((p.x + p.y + p.z) * 5), y = std::cos((-p.x + p.y - p.z) * 5),
          z = -std::cos((-p.x - p.y + p.z) * 5);
    if (depth > 0) {
        x *= by;
        y *= by;
        z *= by;
        y = -std::cos(x - y + z) * by;
    }
    if (depth > 1) x = std::cos(x - y - z) * by;
    if (depth > 2) z = std::sin(-x - y - z) * by;
    if (depth > 3) x = -std::cos(-x + y - z) * by;
    if (depth > 4) y = -std::sin(-x + y + z) * by;
    if (depth > 5) y = -std::cos(-x + y + z) * by;
    if (depth > 6) x = std::cos(x + y + z) * by;
    if (depth > 7) z = std::sin(x + y - z) * by;
    if (depth > 8) x = -std::cos(-x - y + z) * by;
    if (depth > 9) y = -std::sin(x - y + z) * by;
    Vec3 found(x, y, z);
    if (by != 0) found /= 2 * by;
    return Vec3(0.5f) - found;
}

/// Inputs: place, scale, randomness, smoothness, exponent.
Vec3 voronoi(std::span<const std::uint8_t> modes, std::span<const Vec3> in) {
    const float scale = in[1].x;
    const bool flat = modes[0] == 0;
    const cycles::CellShape shape{saturated(in[2].x), in[4].x, in[3].x,
                                  static_cast<cycles::Metric>(modes[2]), flat};
    Vec3 p = in[0] * scale;
    if (flat) p.z = 0;
    if (modes[1] == 3) return Vec3(cycles::distance_to_edge(p, shape));
    const cycles::Cell cell = modes[1] == 0   ? cycles::nearest_cell(p, shape)
                              : modes[1] == 1 ? cycles::second_cell(p, shape)
                                              : cycles::smooth_cell(p, shape);
    if (modes[3] == 0) return Vec3(cell.distance);
    if (modes[3] == 1) return cell.color;
    return scale == 0 ? Vec3(0.0f) : cell.position / scale;
}

float luminance_of(const Vec3& c) {
    return 0.2126f * c.x + 0.7152f * c.y + 0.0722f * c.z;
}

Vec3 transformed(const Vec3& p, const std::vector<float>& rows) {
    Vec3 found;
    for (int i = 0; i < 3; ++i) {
        const float* row = &rows[std::size_t{4} * static_cast<std::size_t>(i)];
        found[i] = row[0] * p.x + row[1] * p.y + row[2] * p.z + row[3];
    }
    return found;
}

Vec3 hue_saturation(std::span<const Vec3> in) {
    Vec3 hsv = hsv_of(in[4]);
    hsv.x = fraction(hsv.x + in[0].x + 0.5f);
    hsv.y = saturated(hsv.y * in[1].x);
    hsv.z *= in[2].x;
    const Vec3 whole = rgb_of(hsv) * in[3].x + in[4] * (1 - in[3].x);
    return each(whole, [](float x) { return std::max(x, 0.0f); });
}

using Modes = std::span<const std::uint8_t>;

/// Of an instruction that makes a pattern of a place.
Vec3 pattern(Name name, Modes modes, std::span<const Vec3> in) {
    switch (name) {
        case Name::Noise: {
            const cycles::Octaves octaves{in[3].x, in[4].x, in[5].x};
            const cycles::Place place = cycles::Place{in[0], in[1].x, modes[1] + 1} * in[2].x;
            if (modes[0] == 1) return cycles::distorted_noise_color(place, octaves, in[6].x);
            return Vec3(cycles::distorted_noise(place, octaves, in[6].x));
        }
        case Name::Voronoi:
            return voronoi(modes, in);
        case Name::White:
            return modes[0] == 1 ? cycles::hash_color(in[0]) : Vec3(cycles::hash(in[0]));
        case Name::Checker:
            return checker(in[0] * in[1].x, in[2], in[3]);
        case Name::Brick:
            return brick(modes[0] == 1, in);
        case Name::Gradient:
            return Vec3(gradient(modes[0], in[0]));
        case Name::Wave: {
            std::array<Vec3, 6> scaled{in[0] * in[1].x, in[2], in[3], in[4], in[5], in[6]};
            return Vec3(wave(modes, scaled));
        }
        case Name::Magic: {
            const Vec3 found = magic(in[0] * in[1].x, static_cast<int>(in[2].x), in[3].x);
            return modes[0] == 1 ? found : Vec3((found.x + found.y + found.z) / 3);
        }
        default:
            return Vec3(0.0f);
    }
}

/// Of an instruction that has values alone for inputs.
Vec3 computed(Name name, Modes modes, std::span<const Vec3> in, const std::vector<float>& table) {
    switch (name) {
        case Name::Value:
        case Name::Combine:
            return {in[0].x, in[1].x, in[2].x};
        case Name::Affine:
            return transformed(in[0], table);
        case Name::Luminance:
            return Vec3(luminance_of(in[0]));
        case Name::Average:
            return Vec3((in[0].x + in[0].y + in[0].z) / 3);
        case Name::Channel:
            return Vec3(in[0][modes[0]]);
        case Name::ToHsv:
            return hsv_of(in[0]);
        case Name::FromHsv:
            return rgb_of(in[0]);
        case Name::Math:
            return Vec3(math(static_cast<Math>(modes[0]), in[0].x, in[1].x, in[2].x));
        case Name::Vector:
            return vector_math(static_cast<VectorMath>(modes[0]), in[0], in[1], in[2], in[3].x);
        case Name::Mix:
            return mixed(static_cast<Mix>(modes[0]), in[0].x, in[1], in[2]);
        case Name::Clamp:
            return each(in[0], in[1], in[2], [](float x, float least, float most) {
                return std::min(std::max(x, least), most);
            });
        case Name::Ramp:
            return on_ramp(modes[0] == 1, in[0].x, table);
        case Name::Curves:
            return on_curves(in[0], table);
        case Name::HueSaturation:
            return hue_saturation(in);
        case Name::BrightContrast: {
            const float gain = 1 + in[2].x, shift = in[1].x - in[2].x / 2;
            return each(in[0], [&](float x) { return std::max(gain * x + shift, 0.0f); });
        }
        case Name::Gamma:
            return each(in[0], [&](float x) { return x > 0 ? std::pow(x, in[1].x) : x; });
        case Name::Invert:
            return in[1] * (1 - in[0].x) + (Vec3(1.0f) - in[1]) * in[0].x;
        case Name::MapRange:
            return Vec3(in_range(modes[0], in[0].x, in[1].x, in[2].x, in[3].x, in[4].x, in[5].x));
        default:
            return pattern(name, modes, in);
    }
}

}  // namespace

NodeProgram::NodeProgram(const std::vector<std::string>& lines, Inputs textures)
    : textures_(std::move(textures)) {
    if (lines.empty()) fail("there is no instruction");
    if (lines.size() > kMostInstructions)
        fail(fmt::format("it has {} instructions, more than {}", lines.size(), kMostInstructions));
    for (const std::string& line : lines) {
        try {
            Instruction made = instruction_of(line, instructions_.size());
            check(made, textures_.size());
            instructions_.push_back(std::move(made));
        } catch (const std::runtime_error& error) {
            fail(fmt::format("instruction {}: {}", instructions_.size(), error.what()));
        }
        constant_ = constant_ && !grammar()[instructions_.back().name].varies;
    }
}

bool NodeProgram::reads_image() const {
    return std::ranges::any_of(textures_, [](const auto& t) { return t->reads_image(); });
}

float NodeProgram::cell_size() const {
    float smallest = 0;
    for (const auto& texture : textures_)
        smallest = smaller_cell(smallest, texture->cell_size());
    return smallest;
}

Vec3 NodeProgram::evaluate(const TexturePoint& point) const {
    constexpr std::size_t kMostInputs = 14;
    std::array<Vec3, kMostInstructions> values;
    std::array<Vec3, kMostInputs> inputs;
    std::size_t at = 0;
    for (const Instruction& instruction : instructions_) {
        for (std::size_t i = 0; i < instruction.inputs.size(); ++i) {
            const Operand& from = instruction.inputs[i];
            inputs[i] = from.instruction < 0 ? Vec3(from.number)
                                             : values[static_cast<std::size_t>(from.instruction)];
        }
        Vec3& value = values[at++];
        switch (const auto name = static_cast<Name>(instruction.name)) {
            case Name::Position:
                value = point.p;
                break;
            case Name::Local:
                value = local_position(point);
                break;
            case Name::Uv:
                value = {point.uv.x, point.uv.y, 0};
                break;
            case Name::Normal:
                value = point.n;
                break;
            case Name::LocalNormal:
                value = local_normal(point);
                break;
            case Name::Color:
                value = point.color;
                break;
            case Name::Alpha:
                value = Vec3(point.alpha);
                break;
            case Name::Texture:
                value = textures_[static_cast<std::size_t>(inputs[0].x) - 1]->evaluate(point);
                break;
            case Name::TextureAt: {
                TexturePoint moved = point;
                moved.uv = {inputs[1].x, inputs[1].y};
                value = textures_[static_cast<std::size_t>(inputs[0].x) - 1]->evaluate(moved);
                break;
            }
            default:
                value =
                    computed(name, instruction.modes,
                             std::span(inputs).first(instruction.inputs.size()), instruction.table);
        }
        value = each(value, [](float x) { return std::isfinite(x) ? x : 0; });
    }
    return values[at - 1];
}

}  // namespace lxs::shading::nodes
