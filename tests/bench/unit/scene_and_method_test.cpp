// Protects the tables: unknown names are errors that say what there is, and a scene's checksum
// follows every file that it names.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "bench_process.h"
#include "checksum.h"
#include "method_table.h"
#include "scene_table.h"
#include "study_file.h"

namespace bench::test::scene_and_method_test {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

const std::string kTables = BENCH_TABLES;

TEST(MethodTable, TheProjectsOwnIsReadAndHasTheBaseline) {
    const MethodTable table = read_method_table(kTables + "/methods.json");
    EXPECT_EQ(find_method(table.methods, "sppm").integrator, "sppm");
    EXPECT_FALSE(find_method(table.methods, "path").has_variants);
    EXPECT_EQ(find_method(table.methods, "metropolis").sampler, "metropolis");
    // References must be at most a quarter of the fixed radius.
    const auto radius = [&](const char* name) {
        return startradius(overrides(table, find_method(table.references, name), kAny, {})).value();
    };
    for (const char* name : {"photons", "photons-chains", "photons-guided", "shared"}) {
        EXPECT_LE(radius(name), table.fixed_startradius / 4) << name;
        EXPECT_EQ(radius("photons-halved"), radius(name) / 2) << name;
    }
}

TEST(MethodTable, UnknownMethodListsTheKnownOnes) {
    const MethodTable table = read_method_table(kTables + "/methods.json");
    EXPECT_THAT([&] { find_method(table.methods, "spmm"); },
                ThrowsMessage<StudyError>(HasSubstr("unknown method \"spmm\"; known: path, ")));
}

TEST(MethodTable, MissingKeyNamesTheFile) {
    const TemporaryFolder folder;
    folder.write("m.json", R"({"methods": [{"name": "a"}], "references": []})");
    EXPECT_THAT([&] { read_method_table(folder.path() / "m.json"); },
                ThrowsMessage<StudyError>(HasSubstr("m.json")));
}

TEST(SceneTable, FindsListedScenesAndFiles) {
    const BenchScene box = find_scene("cornell-box", kTables + "/scenes.json", BENCH_SCENES);
    EXPECT_EQ(box.references[0], "path");
    const BenchScene ball = find_scene("glass-ball", kTables + "/scenes.json", BENCH_SCENES);
    EXPECT_EQ(ball.references[1], "photons");
    // All light of the ball's lamp is found by rays, none of the prism's spotlight behind glass.
    EXPECT_TRUE(ball.misses.empty());
    EXPECT_TRUE(listed_scene("prism", kTables + "/scenes.json").misses.contains("path"));
    const std::string path = std::string(BENCH_SCENES) + "/furnace.lxs";
    EXPECT_EQ(find_scene(path, kTables + "/scenes.json", "nowhere").name, "furnace");
    EXPECT_THAT([] { find_scene("nothing", kTables + "/scenes.json", BENCH_SCENES); },
                ThrowsMessage<StudyError>(HasSubstr("unknown scene \"nothing\"")));
}

/// For the whole image eye paths share the light of one reference, and of one only: the other is to
/// find a fault of theirs.
TEST(SceneTable, OneReferenceOfTheWholeImageIsIndependentOfEyePaths) {
    const MethodTable table = read_method_table(kTables + "/methods.json");
    const std::string scenes = kTables + "/scenes-whole-image.json";
    for (const auto& file : std::filesystem::directory_iterator(BENCH_SCENES)) {
        if (file.path().extension() != ".lxs") continue;
        const std::string name = file.path().stem();
        const auto [first, second] = listed_scene(name, scenes).references;
        EXPECT_TRUE(first == "shared" || first == "path") << name;
        EXPECT_TRUE(second.starts_with("photons")) << name;
        EXPECT_NO_THROW(find_method(table.references, second)) << name;
    }
}

TEST(SceneTable, ChecksumFollowsEveryNamedFile) {
    const TemporaryFolder folder;
    folder.write("a.lxs", "Include \"b.lxm\"\n");
    folder.write("b.lxm", "Texture \"t\" \"color\" \"imagemap\" \"string filename\" [\"c.png\"]\n");
    folder.write("c.png", "1");
    folder.write("d.png", "1");
    const std::string before = scene_checksum(folder.path() / "a.lxs");
    folder.write("d.png", "2");
    EXPECT_EQ(scene_checksum(folder.path() / "a.lxs"), before);
    folder.write("c.png", "2");
    EXPECT_NE(scene_checksum(folder.path() / "a.lxs"), before);
}

TEST(Checksum, IsSha1) {
    EXPECT_EQ(sha1("abc"), "a9993e364706816aba3e25717850c26c9cd0d89d");
}

}  // namespace
}  // namespace bench::test::scene_and_method_test
