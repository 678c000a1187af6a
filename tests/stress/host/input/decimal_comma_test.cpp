// Protects: where the locale writes 1,5 for 1.5, scenes and their files are read and images,
// statistics and messages are written with a point, bit for bit as without it.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

#include "bounded_run.h"
#include "stress_case.h"

namespace decimal_comma_test {
namespace {

using stress::BoundedRun;

/// A scene with each kind of file that numbers are read from, all with fractions.
void write_scene(const files::TemporaryFolder& folder) {
    folder.write("lamp.ies",
                 "IESNA:LM-63-1995\nTILT=NONE\n1 1000.5 1.25 3 1 1 2 0.1 0 0 1 1 50\n0 45.5 90\n0\n"
                 "100.5 50.25 0.5\n");
    folder.write("metal.nk", "400.5 1.5 2.5\n550.25 1.25 2.75\n700.5 0.9 3.1\n");
    folder.write("light.spd", "380.5 0.25\n550.5 0.75\n720.5 0.5\n");
    folder.write("mesh.ply",
                 "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                 "property float z\nelement face 1\nproperty list uchar int vertex_indices\n"
                 "end_header\n-1.5 0.25 -1.5\n1.5 0.25 -1.5\n0.5 0.25 1.5\n3 0 1 2\n");
    folder.write(
        "scene.lxs",
        stress::small_scene(
            "SurfaceIntegrator \"aips\" \"float alpha\" [0.75] \"integer photonperpass\" [2000]\n",
            "LightSource \"goniometric\" \"string iesname\" [\"lamp.ies\"] \"point from\" [0.5 "
            "-3.5 2.5]\n"
            "Texture \"s\" \"color\" \"tabulateddata\" \"string filename\" [\"light.spd\"]\n"
            "Material \"metal\" \"string filename\" [\"metal.nk\"]\n"
            "Shape \"plymesh\" \"string filename\" [\"mesh.ply\"] \"float wrong\" [1.5]\n"
            "Material \"matte\" \"texture Kd\" [\"s\"]\nShape \"disk\" \"float radius\" [2.5]"));
}

/// A folder with a locale whose decimal point is a comma; empty if none can be made here.
std::string comma_locale_folder(const files::TemporaryFolder& folder) {
    const std::string command =
        "localedef -i de_DE -f UTF-8 '" + (folder / "de_DE.UTF-8") + "' >/dev/null 2>&1";
    return std::system(command.c_str()) == 0 || folder.has("de_DE.UTF-8/LC_NUMERIC")
               ? folder.path().string()
               : "";
}

/// Without what differs from run to run: times and memory.
std::string lasting_messages(const std::string& text) {
    std::string lasting;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        const bool varies =
            std::regex_search(line, std::regex("^(pass|rendered) |[0-9] (s|MB|MiB)|per second|/s"));
        lasting += varies ? "" : line + '\n';
    }
    return lasting;
}

/// Settings, scene and counts: what is the same in each run.
nlohmann::json lasting_statistics(const std::string& text) {
    nlohmann::json json = nlohmann::json::parse(text);
    for (const char* name : {"seconds", "render CPU seconds", "peak memory bytes", "counts"})
        json.erase(name);
    json["account"].erase("seconds");
    for (auto& [name, value] : json["aips"].items()) {
        if (name.ends_with("_seconds")) value = 0;
    }
    return json;
}

const std::vector<std::string> kArguments{"scene.lxs",
                                          "--passes",
                                          "2",
                                          "--stats",
                                          "s.json",
                                          "--set",
                                          "aips.startradius=2.5",
                                          "--verbose",
                                          "--plugin-path",
                                          COMMA_LOCALE_MODULE};

TEST(StressInput, DecimalCommaChangesNothing) {
    const files::TemporaryFolder locales, plain, comma;
    const std::string path = comma_locale_folder(locales);
    if (path.empty()) GTEST_SKIP() << "localedef can't make the locale de_DE here";
    write_scene(plain);
    write_scene(comma);
    const BoundedRun without =
        stress::run_lxsrender(plain, kArguments, {.environment = {"LC_ALL=C"}});
    const BoundedRun with = stress::run_lxsrender(
        comma, kArguments,
        // glibc keeps LOCPATH's parts for good.
        {.environment = {"LC_ALL=de_DE.UTF-8", "LOCPATH=" + path, "ASAN_OPTIONS=detect_leaks=0"}});
    ASSERT_EQ(without.exit_code, 0) << without.err;
    ASSERT_EQ(with.exit_code, 0) << with.err;
    EXPECT_EQ(plain.read("out.exr"), comma.read("out.exr"));
    EXPECT_EQ(plain.read("out.png"), comma.read("out.png"));
    EXPECT_EQ(lasting_statistics(plain.read("s.json")), lasting_statistics(comma.read("s.json")));
    EXPECT_EQ(lasting_messages(without.err), lasting_messages(with.err));
    EXPECT_NE(with.err.find("alpha = 0.75"), std::string::npos) << with.err;
    stress::record("aips under de_DE.UTF-8, set by the environment and by a plugin module",
                   "EXR, PNG, statistics and messages the same bytes");
}

}  // namespace
}  // namespace decimal_comma_test
