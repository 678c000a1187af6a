// Protects docs/reference/errors: every exit code has the meaning that --help gives, and every row
// of its pages' tables is caused here and gives that message with that exit code. tests/host/app/
// documented_messages_test.py looks for the sources' messages in them.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <regex>

#include "error_rows.h"
#include "lxs/host/exit_code.h"

namespace lxs::test::documented_errors_test {
namespace {

namespace fs = std::filesystem;

TEST(ErrorPages, ListEveryExitCode) {
    const std::string page = error_index();
    for (const auto& [code, meaning] : kExitCodes) {
        const std::string row = fmt::format("| {} | {} |", static_cast<int>(code), meaning);
        EXPECT_THAT(page, testing::HasSubstr(row));
    }
}

using Options = std::vector<std::string>;

RunResult with_modules(const TemporaryFolder& folder, const std::string& module,
                       const std::string& integrator, const Options& more = {}) {
    folder.write("scene.lxs", small_scene());
    Options options{"scene.lxs",
                    "--passes",
                    "3",
                    "--integrator",
                    integrator,
                    "--plugin-path",
                    TEST_MODULES "/" + module};
    options.insert(options.end(), more.begin(), more.end());
    return run_lxsrender(folder, options);
}

RunResult sabotaged(const TemporaryFolder& folder, const std::string& deed,
                    const Options& more = {}) {
    Options options{"--set", "saboteur.deed=" + deed};
    options.insert(options.end(), more.begin(), more.end());
    return with_modules(folder, "saboteur", "saboteur", options);
}

/// Causes that take more than a scene or an option, by the words of their rows.
using Cause = std::function<RunResult(const TemporaryFolder&)>;
const std::map<std::string, Cause>& described_causes() {
    const auto module = [](const char* name, const char* integrator) -> Cause {
        return
            [=](const TemporaryFolder& folder) { return with_modules(folder, name, integrator); };
    };
    const auto deed = [](const char* name) -> Cause {
        return [=](const TemporaryFolder& folder) { return sabotaged(folder, name); };
    };
    static const std::map<std::string, Cause> causes{
        {"no scene is named", [](auto& folder) { return run_lxsrender(folder, {}); }},
        {"the scene file is missing",
         [](auto& folder) { return run_lxsrender(folder, {"no.lxs"}); }},
        {"the output's folder is missing",
         [](auto& folder) {
             folder.write("scene.lxs", small_scene());
             return run_lxsrender(folder, {"scene.lxs", "-o", "no/a.exr"});
         }},
        {"a file that is no shared library",
         [](auto& folder) {
             folder.write("broken.so", "no shared library");
             return run_lxsrender(folder, {"--list-plugins", "--plugin-path", "."});
         }},
        {"a module without entry function", module("no_entry", "path")},
        {"a module built for another version of the SDK", module("wrong_abi", "path")},
        {"a module whose entry function throws", module("throwing_entry", "path")},
        {"a module that offers a name that is taken", module("duplicate_name", "path")},
        {"an integrator that throws when it is made", module("troublesome", "throwing")},
        {"an integrator that is not made", module("troublesome", "absent")},
        {"an integrator that refuses the scene", module("troublesome", "refuser")},
        {"an integrator that throws in a pass", deed("throw")},
        {"an integrator that throws what is no std::exception", deed("foreign exception")},
        {"an integrator that gives the film too few values", deed("too few values")},
        {"an integrator that gives a pass no weight", deed("weight of 0")},
        {"an integrator that gives a layer of the wrong size", deed("wrong layer size")},
        {"an integrator that gives a layer a name without end", deed("layer without end")},
        {"an integrator that gives the film what is no number", deed("NaN")},
        {"a pass finds no memory", deed("no memory")},
        {"the output's folder is deleted during the render",
         [](auto& folder) {
             fs::create_directory(folder / "deep");
             return sabotaged(folder, "remove",
                              {"--set", "saboteur.victim=deep", "-o", "deep/a.exr"});
         }},
        {"an image file is cut short between two passes",
         [](auto& folder) { return render_with_vanishing_texture(folder); }},
    };
    return causes;
}

/// The row's message as a regular expression: "..." is any text within a line.
std::regex pattern(const ErrorRow& row) {
    std::string text =
        std::regex_replace(row.message, std::regex(R"([.^$|()\[\]{}*+?\\])"), "\\$&");
    text = std::regex_replace(text, std::regex(R"(\\\.\\\.\\\.)"), "[^\\n]*");
    const std::string severity = row.exit_code == 0   ? "warning: "
                                 : row.exit_code == 2 ? ""
                                                      : "(error|warning): ";
    return std::regex(severity + "[^\\n]*" + text);
}

TEST(ErrorPages, EveryRowIsTrue) {
    std::size_t caused = 0;
    for (const ErrorRow& row : error_rows()) {
        SCOPED_TRACE(row.cause);
        if (row.cause.starts_with('*')) continue;  // not at will
        TemporaryFolder folder;
        RunResult result;
        if (row.cause.find('`') != std::string::npos) {
            result = run_written_cause(row.cause, folder);
        } else {
            const auto cause = described_causes().find(row.cause);
            ASSERT_NE(cause, described_causes().end()) << "nothing here causes this row";
            result = cause->second(folder);
        }
        ++caused;
        EXPECT_EQ(result.exit_code, row.exit_code) << result.err;
        EXPECT_TRUE(std::regex_search(result.err, pattern(row)))
            << "expected: " << row.message << "\nfound: " << result.err;
    }
    EXPECT_GE(caused, 250u);
}

}  // namespace
}  // namespace lxs::test::documented_errors_test
