// Protects sums of statistics files: what is summed, what is a mean, what is left out, and that a
// file that does not belong changes nothing.
#include "lxs/merge/statistics_sums.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lxs/merge/merger.h"

namespace lxs::statistics_sums_test {
namespace {

constexpr const char* kFirst = R"({"version": "1", "settings": {"seed": 5},
  "seconds": {"render": 2.5}, "render CPU seconds": 2, "peak memory bytes": 100,
  "counts": {"passes": 4, "samples per pixel": 4.0, "rays": 10, "rays per CPU second": 5},
  "refused": {"not a number": {"glass": 3}},
  "account": {"lights": [{"name": "sun", "photon paths": 8, "luminance seen": 1.0}],
              "materials": {"wall": {"hits": 2}}, "left out": ["media"]},
  "advice": [{"rule": "x"}], "aips": {"eye_paths": 4}})";
constexpr const char* kSecond = R"({"version": "2", "settings": {"seed": 6},
  "seconds": {"render": 1.5, "load": 1}, "render CPU seconds": 3, "peak memory bytes": 70,
  "counts": {"passes": 12, "samples per pixel": 12.0, "rays": 40, "rays per CPU second": 13},
  "refused": {},
  "account": {"lights": [{"name": "sun", "photon paths": 24, "luminance seen": 3.0}],
              "materials": {"wall": {"hits": 5}}, "left out": ["media", "motion"]}})";

nlohmann::ordered_json expected() {
    return nlohmann::ordered_json::parse(R"({"seeds": [5, 6],
  "seconds": {"render": 4.0, "load": 1}, "render CPU seconds": 5, "peak memory bytes": 100.0,
  "counts": {"passes": 16, "samples per pixel": 16.0, "rays": 50, "rays per CPU second": 10.0},
  "refused": {"not a number": {"glass": 3}},
  "account": {"lights": [{"name": "sun", "photon paths": 32, "luminance seen": 2.5}],
              "materials": {"wall": {"hits": 7}}, "left out": ["media", "motion"]}})");
}

TEST(StatisticsSums, CountsAreSumsAndLuminancesMeans) {
    StatisticsSums sums;
    sums.add(kFirst, "a.json", {5, 6});
    sums.add(kSecond, "b.json", {5, 6});
    EXPECT_EQ(nlohmann::json(sums.merged()), nlohmann::json(expected()));
}

TEST(StatisticsSums, WhatIsMergedMayBeMergedAgain) {
    StatisticsSums sums, again;
    sums.add(kFirst, "a.json", {5, 6});
    again.add(R"({"seeds": [5], "renders": )" + sums.merged().dump() + "}", "c.json", {5, 6});
    again.add(kSecond, "b.json", {5, 6});
    EXPECT_EQ(nlohmann::json(again.merged()), nlohmann::json(expected()));
}

TEST(StatisticsSums, WhatDoesNotBelongChangesNothing) {
    StatisticsSums sums;
    sums.add(kFirst, "a.json", {5, 6});
    const auto before = sums.merged();
    const std::string counts = R"("counts": {"samples per pixel": 2})";
    const std::string deep(100000, '[');
    for (const std::string& wrong :
         {std::string(kFirst), std::string(kSecond).replace(0, 1, ""), std::string("[]"),
          std::string(), "{\"settings\": {\"seed\": 7}, " + counts + "}",
          "{\"settings\": {\"seed\": -1}, " + counts + "}",
          std::string("{\"settings\": {\"seed\": 6}, \"counts\": 5}"), deep,
          "{\"settings\": {\"seed\": 6}, \"seconds\": 1, " + counts + "}",
          "{\"settings\": {\"seed\": 6}, \"account\": {\"lights\": []}, " + counts + "}"}) {
        EXPECT_THROW(sums.add(wrong, "b.json", {5, 6}), MergeRefusal) << wrong.substr(0, 200);
        EXPECT_EQ(sums.merged(), before);
    }
}

}  // namespace
}  // namespace lxs::statistics_sums_test
