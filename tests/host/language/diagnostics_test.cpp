// Texts of located messages, and suggestions for misspelt names.
#include "lxs/sdk/diagnostics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace lxs::diagnostics_test {
namespace {

SourceLocation place(const std::string& text, std::uint32_t line, std::uint32_t column) {
    auto file = std::make_shared<SourceFile>();
    file->name = "a.lxs";
    file->text = std::make_shared<const std::string>(text);
    return {file, line, column};
}

TEST(FormatMessage, ShowsPositionSourceLineAndCaret) {
    EXPECT_EQ(format_message(place("WorldBegin\nShpe \"box\"\n", 2, 6), "error", "bad"),
              "a.lxs:2:6: error: bad\n"
              "  Shpe \"box\"\n"
              "       ^");
}

TEST(FormatMessage, WithoutFileIsTheBareMessage) {
    EXPECT_EQ(format_message({}, "warning", "text"), "warning: text");
}

TEST(FormatMessage, CommandLineHasNoExcerpt) {
    auto file = std::make_shared<SourceFile>();
    file->name = "--set a.b=c";
    EXPECT_EQ(format_message({file, 0, 0}, "error", "bad"), "--set a.b=c: error: bad");
}

TEST(FormatMessage, ATextThatWasGivenUpHasNoExcerpt) {
    EXPECT_EQ(format_message(place("", 7, 3), "error", "bad"), "a.lxs:7:3: error: bad");
}

TEST(FormatMessage, ShowsTheIncludeChainInnermostFirst) {
    auto main = std::make_shared<SourceFile>();
    main->name = "main.lxs";
    auto middle = std::make_shared<SourceFile>();
    middle->name = "b.lxo";
    middle->included_by = main;
    middle->include_line = 7;
    auto inner = std::make_shared<SourceFile>();
    inner->name = "c.lxm";
    inner->text = std::make_shared<const std::string>("x");
    inner->included_by = middle;
    inner->include_line = 3;
    EXPECT_EQ(format_message({inner, 1, 1}, "error", "bad"),
              "c.lxm:1:1: error: bad\n  x\n  ^\n"
              "included from b.lxo:3\n"
              "included from main.lxs:7");
}

TEST(FormatMessage, CaretFollowsTabsAndUtf8AndDropsCarriageReturn) {
    EXPECT_EQ(format_message(place("\t\"\xC3\xA4\" x\r\n", 1, 7), "error", "bad"),
              "a.lxs:1:7: error: bad\n"
              "  \t\"\xC3\xA4\" x\n"
              "  \t    ^");
}

TEST(FormatMessage, CutsLongLinesAroundTheCaret) {
    const std::string line = std::string(5000, 'a') + "X" + std::string(5000, 'b');
    const std::string message = format_message(place(line, 1, 5001), "error", "bad");
    const std::string expected = "a.lxs:1:5001: error: bad\n  ..." + std::string(40, 'a') + "X" +
                                 std::string(55, 'b') + "...\n" + std::string(45, ' ') + "^";
    EXPECT_EQ(message, expected);
}

TEST(FormatMessage, ShowsNoControlCharacters) {
    const std::string message = format_message(place("a\x1b[2J\x07", 1, 1), "error", "bad");
    EXPECT_EQ(message.find('\x1b'), std::string::npos);
    EXPECT_EQ(message.find('\x07'), std::string::npos);
}

TEST(FormatMessage, TheCaretStandsBelowWhatIsShown) {
    EXPECT_EQ(format_message(place("\xFF\x80\xE2\x80\xAE\"x\" y", 1, 10), "error", "bad"),
              "a.lxs:1:10: error: bad\n"
              "  ???\"x\" y\n"
              "         ^");
}

/// Control characters, what is no UTF-8, and what turns the direction of text.
TEST(Printable, CommandsNoTerminal) {
    const std::pair<const char*, const char*> cases[] = {
        {"plain\ttext\n", "plain\ttext\n"},
        {"\xC3\xA4 \xE6\x97\xA5 \xF0\x9F\x8E\xA8", "\xC3\xA4 \xE6\x97\xA5 \xF0\x9F\x8E\xA8"},
        {"\x1b[31m\x07\r\x7f", "?[31m???"},
        {"a\xC2\x9B"
         "31m",
         "a?31m"},
        {"\xC2\x80\xC2\x9F\xC2\xA0", "??\xC2\xA0"},
        {"\xFF\xFE\x80", "???"},
        {"\xC3", "?"},
        {"\xE2\x80", "??"},
        {"\xC0\x9B", "??"},            // longer than it need be
        {"\xED\xA0\x80", "???"},       // half of a surrogate pair
        {"\xF4\x90\x80\x80", "????"},  // beyond Unicode
        {"\xD8\x9C\xE2\x80\x8E\xE2\x80\x8F", "???"},
        {"\xE2\x80\xAA\xE2\x80\xAB\xE2\x80\xAC\xE2\x80\xAD\xE2\x80\xAE", "?????"},
        {"\xE2\x81\xA6\xE2\x81\xA7\xE2\x81\xA8\xE2\x81\xA9", "????"},
        {"\xE2\x80\xA8\xE2\x80\xA9\xEF\xBF\xB9", "???"},
        {"\xD7\xA9\xD7\x9C\xD7\x95\xD7\x9D", "\xD7\xA9\xD7\x9C\xD7\x95\xD7\x9D"},
    };
    for (const auto& [text, shown] : cases)
        EXPECT_EQ(printable(text), shown);
    EXPECT_EQ(in_quotes("\t\n\xE2\x80\xAE\xFF"), "\"????\"");
}

TEST(FormatMessage, SurvivesPositionsBeyondTheText) {
    EXPECT_EQ(format_message(place("a\n", 9, 9), "error", "bad"), "a.lxs:9:9: error: bad\n  \n  ^");
    EXPECT_EQ(format_message(place("\n", 1, 1), "error", "bad"), "a.lxs:1:1: error: bad\n  \n  ^");
}

TEST(NearestName, FindsMisspellings) {
    const std::vector<std::string> known{"tonemapkernel", "matte", "mirror", "radius"};
    EXPECT_EQ(nearest_name("tonemappkernal", known), "tonemapkernel");
    EXPECT_EQ(nearest_name("Matte", known), "matte");
    EXPECT_EQ(nearest_name("raduis", known), "radius");
}

TEST(NearestName, IsEmptyWhenNothingIsNear) {
    EXPECT_EQ(nearest_name("cloth", {"matte", "mirror"}), "");
    EXPECT_EQ(nearest_name("", {"a"}), "");
    EXPECT_EQ(nearest_name(std::string(1000000, 'x'), {"a"}), "");
}

/// Optimal string alignment distance by its definition.
std::size_t distance(const std::string& a, const std::string& b) {
    std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
    for (std::size_t i = 0; i <= a.size(); ++i) {
        for (std::size_t j = 0; j <= b.size(); ++j) {
            d[i][j] = std::max(i, j);
            if (i == 0 || j == 0) continue;
            const std::size_t other = a[i - 1] == b[j - 1] ? 0 : 1;
            d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + other});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
        }
    }
    return d[a.size()][b.size()];
}

TEST(NearestName, IsTheFirstOfTheLeastDistance) {
    std::mt19937 random(7);
    const auto word = [&](std::size_t longest) {
        std::string text(1 + random() % longest, ' ');
        for (char& c : text)
            c = static_cast<char>('a' + random() % 3);
        return text;
    };
    int found = 0;
    for (int i = 0; i < 3000; ++i) {
        const std::size_t longest = i % 3 == 0 ? 64 : 9;
        const std::string name = word(longest);
        std::vector<std::string> known(1 + random() % 12);
        for (std::string& other : known)
            other = word(longest);
        std::string nearest;
        std::size_t least = std::max<std::size_t>(1, name.size() / 3) + 1;
        for (const std::string& other : known) {
            if (distance(name, other) >= least) continue;
            least = distance(name, other);
            nearest = other;
        }
        EXPECT_EQ(nearest_name(name, known), nearest) << name;
        found += nearest.empty() ? 0 : 1;
    }
    EXPECT_GT(found, 500);
    EXPECT_LT(found, 2500);
}

TEST(UnknownNameMessage, ListsTheNearestFirst) {
    EXPECT_EQ(unknown_name_message("material", "mirorr", {"glass", "matte", "mirror"}),
              "unknown material \"mirorr\"; did you mean \"mirror\"? Known: mirror, glass, matte");
    EXPECT_EQ(unknown_name_message("material", "zzzz", {"glass", "matte"}),
              "unknown material \"zzzz\"; known: glass, matte");
    EXPECT_EQ(unknown_name_message("object", "a", {}), "unknown object \"a\"; none is known");
}

TEST(UnknownNameMessage, CutsALongList) {
    std::vector<std::string> known;
    known.reserve(50);
    for (int i = 0; i < 50; ++i)
        known.push_back("m" + std::to_string(i));
    const std::string message = unknown_name_message("material", "zzzz", known);
    EXPECT_TRUE(message.ends_with("m38, m39, ... (10 more)")) << message;
    const std::string near = unknown_name_message("material", "m49x", known);
    EXPECT_TRUE(near.ends_with("m38, ... (10 more)")) << near;
}

/// Copies of an error are told alike, however often and wherever they are asked.
TEST(InputError, IsFormattedWithItsPlace) {
    const InputError error(place("a b\n", 1, 3), "bad");
    // NOLINTNEXTLINE(performance-unnecessary-copy-initialization): it is the copy that is tested
    const InputError copy = error;
    EXPECT_STREQ(copy.what(), "a.lxs:1:3: error: bad\n  a b\n    ^");
    EXPECT_EQ(copy.what(), error.what());
    EXPECT_EQ(copy.message(), "bad");
}

TEST(InQuotes, CutsLongTextAndHidesControlCharacters) {
    EXPECT_EQ(in_quotes("a\nb"), "\"a?b\"");
    EXPECT_EQ(in_quotes(std::string(200, 'x')), '"' + std::string(120, 'x') + "...\"");
}

}  // namespace
}  // namespace lxs::diagnostics_test
