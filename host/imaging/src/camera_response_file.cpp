// Reads curves of cameras and films from text.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <optional>

#include "camera_response.h"

namespace lxs {
namespace {

bool is_space(char c) {
    return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == '\f' || c == '\v';
}

/// Words of a text one by one, with their places.
class Words {
  public:
    explicit Words(const std::shared_ptr<const SourceFile>& file)
        : text_(*file->text), where_{file, 1, 1} {
        skip_spaces();
    }

    bool at_end() const { return text_.empty(); }
    std::uint32_t line() const { return where_.line; }
    const SourceLocation& where() const { return where_; }

    /// The word here; "=" is one of its own.
    std::string_view word() const {
        std::size_t size = text_.starts_with('=') ? 1 : 0;
        while (size < text_.size() && !is_space(text_[size]) && text_[size] != '=')
            ++size;
        return text_.starts_with('=') ? text_.substr(0, 1) : text_.substr(0, size);
    }
    std::string_view take() {
        const std::string_view taken = word();
        advance(taken.size());
        skip_spaces();
        return taken;
    }
    void skip_line() {
        advance(std::min(text_.find('\n'), text_.size()));
        skip_spaces();
    }
    void expect(std::string_view expected, std::string_view what) {
        if (word() != expected) fail(what);
        take();
    }
    [[noreturn]] void fail(std::string_view expected) const {
        const std::string found = at_end() ? "the end of the file" : in_quotes(word());
        throw ResponseFileError(where_, fmt::format("expected {}, found {}", expected, found));
    }

  private:
    void advance(std::size_t bytes) {
        for (std::size_t i = 0; i < bytes; ++i) {
            const bool line_end = text_[i] == '\n';
            where_.line += line_end ? 1 : 0;
            where_.column = line_end ? 1 : where_.column + 1;
        }
        text_.remove_prefix(bytes);
    }
    void skip_spaces() {
        std::size_t size = 0;
        while (size < text_.size() && is_space(text_[size]))
            ++size;
        advance(size);
    }

    std::string_view text_;  ///< what is left
    SourceLocation where_;
};

double read_number(Words& words) {
    const std::string_view text = words.word();
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    constexpr double kMost = 1e6;
    if (error != std::errc() || end != text.data() + text.size() || !(value >= 0 && value <= kMost))
        words.fail("a number from 0 to 1");
    words.take();
    return value;
}

/// "I = 0 0.1 ..." or the same of "B": numbers to the end of the line that the first one is on.
std::vector<double> read_numbers(Words& words, std::string_view letter) {
    words.expect(letter, fmt::format("\"{} =\" and numbers", letter));
    words.expect("=", fmt::format("\"=\" after \"{}\"", letter));
    std::vector<double> values;
    const std::uint32_t line = words.line();
    do
        values.push_back(read_number(words));
    while (!words.at_end() && words.line() == line);
    return values;
}

ResponseCurve read_curve(Words& words) {
    words.expect("graph", "\"graph\" after the name of a curve");
    words.skip_line();
    const SourceLocation where = words.where();
    ResponseCurve curve;
    curve.irradiance = read_numbers(words, "I");
    if (!std::is_sorted(curve.irradiance.begin(), curve.irradiance.end()))
        throw ResponseFileError(where, "the irradiances of a curve must not fall");
    const SourceLocation where_of_brightness = words.where();
    curve.brightness = read_numbers(words, "B");
    if (curve.irradiance.size() != curve.brightness.size()) {
        throw ResponseFileError(where_of_brightness,
                                fmt::format("{} brightnesses for {} irradiances",
                                            curve.brightness.size(), curve.irradiance.size()));
    }
    return curve;
}

/// Messages show the line of a file of curves; what is none may be any file of whoever renders the
/// scene that names it.
void expect_curves(const Words& words) {
    if (words.word() == "graph") return;
    SourceFile unshown = *words.where().file;
    unshown.text = std::make_shared<const std::string>();
    throw ResponseFileError(
        {std::make_shared<const SourceFile>(unshown), words.where().line, words.where().column},
        "it is no file of curves: expected \"graph\" after the name of the first");
}

constexpr std::string_view kChannels[] = {"Red", "Green", "Blue"};

/// Splits "Gold_100CDRed"; a name without a channel is that of a black and white film.
std::size_t take_channel(std::string_view& name) {
    for (std::size_t channel = 0; channel < std::size(kChannels); ++channel) {
        if (!name.ends_with(kChannels[channel])) continue;
        name.remove_suffix(kChannels[channel].size());
        return channel;
    }
    return 0;
}

}  // namespace

CameraResponse read_camera_response(const std::shared_ptr<const SourceFile>& file) {
    Words words(file);
    std::array<std::optional<ResponseCurve>, 3> channels;
    std::optional<std::string_view> film;
    while (!words.at_end()) {
        const SourceLocation where = words.where();
        std::string_view name = words.take();
        if (!film) expect_curves(words);
        const std::size_t channel = take_channel(name);
        ResponseCurve curve = read_curve(words);
        if (film && *film != name) {
            throw ResponseFileError(where, fmt::format("a curve of {} in the file of {}",
                                                       in_quotes(name), in_quotes(*film)));
        }
        film = name;
        if (!channels[channel]) channels[channel] = std::move(curve);
        if (channels[0] && channels[1] && channels[2]) break;  // as in LuxRender, which reads one
    }
    if (!channels[0]) words.fail("a curve whose name ends in Red");
    std::vector<ResponseCurve> curves{std::move(*channels[0])};
    if (channels[1] && channels[2]) {
        curves.push_back(std::move(*channels[1]));
        curves.push_back(std::move(*channels[2]));
    }
    return CameraResponse(std::move(curves));
}

}  // namespace lxs
