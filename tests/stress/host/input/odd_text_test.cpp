// Protects: bytes that editors, exporters and other systems leave in scenes: control characters,
// line ends, byte-order marks, names in UTF-8 and names that are none.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "bounded_run.h"
#include "lxs/imaging/exr_image.h"
#include "stress_case.h"

namespace odd_text_test {
namespace {

using stress::BoundedRun;
using stress::run_lxsrender;
using stress::small_scene;

class StressOddText : public testing::Test {
  protected:
    BoundedRun render(const std::string& scene) {
        folder_.write("scene.lxs", scene);
        return run_lxsrender(folder_, {"scene.lxs", "--passes", "1", "--stats", "s.json"});
    }
    /// The image's; its header tells the scenes' texts apart.
    auto channels() const { return lxs::read_exr((folder_.path() / "out.exr").string()).channels; }
    files::TemporaryFolder folder_;
};

/// No message may steer a terminal.
void expect_printable(const std::string& text) {
    for (const char c : text)
        EXPECT_TRUE(static_cast<unsigned char>(c) >= 0x20 || c == '\n' || c == '\t') << int(c);
    EXPECT_EQ(text.find('\x7f'), std::string::npos);
}

TEST_F(StressOddText, ControlCharacters) {
    int refused = 0, tried = 0;
    for (int c = 0; c < 0x20; c += stress::sized(5, 1)) {
        if (c >= '\t' && c <= '\r') continue;
        const std::string odd(1, static_cast<char>(c));
        const std::string inside = small_scene("", "Shape \"sp" + odd + "here\"");
        const std::string outside = small_scene("", "Shape " + odd + " \"sphere\"");
        const std::string value =
            small_scene("", "Material \"metal\" \"string name\" \"" + odd + "\"");
        for (const std::string& scene : {inside, outside, value}) {
            const BoundedRun run = render(scene);
            stress::expect_refused(run, "scene.lxs:7:");
            expect_printable(run.err);
            refused += run.exit_code == 3 ? 1 : 0;
            ++tried;
        }
    }
    stress::record(std::to_string(tried) +
                       " control characters in plugins' names, between words and in a value",
                   std::to_string(refused) + " refused at their place");
}

TEST_F(StressOddText, LineEndsAndByteOrderMark) {
    const std::string unix_text = small_scene("", "Shape \"disk\" \"float radius\" [2]");
    std::string windows = "\xef\xbb\xbf";
    for (const char c : unix_text)
        windows += c == '\n' ? std::string("\r\n") : std::string(1, c);
    ASSERT_EQ(render(unix_text).exit_code, 0);
    const auto image = channels();
    const BoundedRun run = render(windows);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_EQ(channels(), image);
    const BoundedRun wrong = render(windows + "Shpae\r\n");
    EXPECT_EQ(wrong.exit_code, 0) << "what follows WorldEnd is not read";
    const BoundedRun early = render("\xef\xbb\xbf\r\nShpae \"x\"\r\n");
    stress::expect_refused(early, "scene.lxs:2:1: error: unknown statement \"Shpae\"");
    EXPECT_EQ(early.err.find('\r'), std::string::npos);
    stress::record("CRLF and a byte-order mark", "the same image, messages at the same lines");
}

TEST_F(StressOddText, NamesInUtf8) {
    folder_.write("größe/teil-日本.lxo", "Shape \"disk\" \"float radius\" [2]\n");
    folder_.write("szene-é.lxs",
                  small_scene("",
                              "LightGroup \"Küche ☀\"\nLightSource \"point\"\n"
                              "MakeNamedMaterial \"Glas·ß\" \"string type\" [\"matte\"]\n"
                              "NamedMaterial \"Glas·ß\"\nInclude \"größe/teil-日本.lxo\""));
    const BoundedRun run = run_lxsrender(
        folder_, {"szene-é.lxs", "--passes", "1", "-o", "bild-ß.exr", "--stats", "zahlen-ø.json"});
    ASSERT_EQ(run.exit_code, 0) << run.err;
    EXPECT_TRUE(folder_.has("bild-ß.exr"));
    EXPECT_TRUE(folder_.has("bild-ß.png"));
    const auto json = nlohmann::json::parse(folder_.read("zahlen-ø.json"));
    EXPECT_EQ(json["settings"]["scene"], "szene-é.lxs");
    EXPECT_EQ(json["scene"]["light groups"][1], "Küche ☀");
    stress::record("scene, include, light group, material and outputs named in UTF-8",
                   stress::figure_of(run));
}

/// Latin-1 names are bytes like others to the file system, but no JSON.
TEST_F(StressOddText, NamesThatAreNotUtf8) {
    const BoundedRun run = render(small_scene("",
                                              "LightGroup \"K\xfc"
                                              "che\xff\"\nLightSource \"point\"\nShape \"disk\""));
    ASSERT_EQ(run.exit_code, 0) << run.err;
    const auto json = nlohmann::json::parse(folder_.read("s.json"));
    EXPECT_EQ(json["scene"]["light groups"][1],
              "K\xef\xbf\xbd"
              "che\xef\xbf\xbd");
    stress::record("a light group named in Latin-1", "in the statistics as U+FFFD, exit code 0");
}

}  // namespace
}  // namespace odd_text_test
