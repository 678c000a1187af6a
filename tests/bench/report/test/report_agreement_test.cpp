// Protects what a report takes over from agreement.json: every figure as it is, nothing where there
// is no file, older files, and damaged ones named.
#include "report_agreement.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bench_process.h"
#include "synthetic_agreement.h"
#include "synthetic_study.h"

namespace bench::test::report_agreement_test {
namespace {

class ReportAgreementTest : public testing::Test {
  protected:
    Json report() const { return report_agreement(folder_.path() / "study", summary_); }
    std::string file() const { return (folder_.path() / "study/agreement.json").string(); }

    TemporaryFolder folder_;
    Json summary_{{"created", "2026-01-01T00:00:00Z"}, {"study", Json::object()}};
};

TEST_F(ReportAgreementTest, IsNothingWhereNothingWasTested) {
    EXPECT_TRUE(report().is_null());
}

TEST_F(ReportAgreementTest, HasTheFilesFigures) {
    write_synthetic_agreement(folder_.path(), summary_);
    const Json found = report();
    EXPECT_EQ(found["decisive"], 0.05);
    EXPECT_EQ(found["significance"], 1e-4);
    EXPECT_TRUE(found["claims_bias"]);
    const Json written = read_json(file())["tests"];
    ASSERT_EQ(found["tests"].size(), written.size());
    for (std::size_t i = 0; i < written.size(); ++i) {
        for (const auto& [key, value] : found["tests"][i].items())
            EXPECT_EQ(value, written[i].at(key)) << key;
    }
    EXPECT_EQ(found["tests"][0]["weighted_low"], kSyntheticRatio - kSyntheticHalfInterval);
    EXPECT_EQ(found["tests"][3]["smallest_at"]["column"], 5);
    EXPECT_EQ(found["tests"].back()["misses"], kNastyScene);
}

TEST_F(ReportAgreementTest, SaysWhetherTheStudyHasRunSince) {
    write_synthetic_agreement(folder_.path(), summary_);
    EXPECT_FALSE(report()["is_older"]);
    summary_["created"] = "2026-01-01T00:00:01Z";
    EXPECT_TRUE(report()["is_older"]);
}

TEST_F(ReportAgreementTest, FilesFromBeforeThereWereIntervalsHaveNone) {
    write_synthetic_agreement(folder_.path(), summary_);
    Json older = read_json(file());
    for (Json& test : older["tests"]) {
        test.erase("weighted_low");
        test.erase("weighted_high");
    }
    older["smaller_radius"] = "";
    write_json(file(), older);
    const Json found = report();
    EXPECT_TRUE(found["tests"][0]["weighted_low"].is_null());
    EXPECT_FALSE(found["claims_bias"]);
}

TEST_F(ReportAgreementTest, DamageIsNamed) {
    const auto message = [&] {
        try {
            report();
        } catch (const StudyError& error) {
            return std::string(error.what());
        }
        return std::string("no error");
    };
    write_json(file(), {{"schema", "aips-bench-agreement-1"}, {"created", 7}});
    EXPECT_THAT(message(), testing::HasSubstr("agreement.json' is damaged"));
    write_json(file(), {{"schema", "another"}});
    EXPECT_THAT(message(), testing::HasSubstr("is no file of schema"));
}

}  // namespace
}  // namespace bench::test::report_agreement_test
