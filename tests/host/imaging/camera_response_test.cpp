// Protects curves of cameras and films: the file format, LuxRender's meaning of the curves, and
// that what is wrong with a file is said at its place and leaves the render going.
#include "camera_response.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "film_samples.h"
#include "tone_map.h"

namespace lxs::test::camera_response_test {
namespace {

std::shared_ptr<const SourceFile> file_of(const std::string& text) {
    return std::make_shared<const SourceFile>(
        SourceFile{"film.crf", std::make_shared<const std::string>(text), nullptr, 0});
}

/// B = I^exponent at `points` places, evenly spaced.
std::string power_curve(const std::string& name, double exponent, int points = 256) {
    std::string in, out;
    for (int i = 0; i < points; ++i) {
        const double x = i / (points - 1.0);
        in += fmt::format("{:.9f} ", x);
        out += fmt::format("{:.9f} ", std::pow(x, exponent));
    }
    return name + "\ngraph positive\nI =\n" + in + "\nB =\n" + out + "\n";
}

TEST(CameraResponse, StraightLinesBetweenPointsAndTheEndsBeyond) {
    const ResponseCurve curve{{0.1, 0.3, 0.5}, {0, 0.6, 1}};
    EXPECT_EQ(curve.at(0), 0);
    EXPECT_NEAR(curve.at(0.2), 0.3, 1e-12);
    EXPECT_NEAR(curve.at(0.4), 0.8, 1e-12);
    EXPECT_EQ(curve.at(0.5), 1);
    EXPECT_EQ(curve.at(9), 1);
    EXPECT_EQ(curve.at(std::nan("")), 0);
}

/// The display undoes a gamma, and so does LuxRender with what it finds in the curves: one that is
/// nothing but a gamma changes nothing.
TEST(CameraResponse, TheCurvesOwnGammaIsTakenOut) {
    const CameraResponse response = read_camera_response(file_of(power_curve("FilmRed", 1 / 2.2) +
                                                                 power_curve("FilmGreen", 1 / 2.2) +
                                                                 power_curve("FilmBlue", 1 / 2.2)));
    EXPECT_NEAR(response.gamma(), 1 / 2.2, 1e-3);
    const auto mapped = response.map({0.1, 0.4, 0.9});
    EXPECT_NEAR(mapped[0], 0.1, 3e-3);
    EXPECT_NEAR(mapped[1], 0.4, 3e-3);
    EXPECT_NEAR(mapped[2], 0.9, 3e-3);
}

/// What is left is the channels' difference from the gamma that fits their luminance.
TEST(CameraResponse, ChannelsKeepTheirDifferences) {
    const CameraResponse response = read_camera_response(
        file_of(power_curve("FRed", 0.5) + power_curve("FGreen", 0.4) + power_curve("FBlue", 0.3)));
    EXPECT_NEAR(response.gamma(), 0.2126 * 0.5 + 0.7152 * 0.4 + 0.0722 * 0.3, 0.01);
    const auto mapped = response.map({0.5, 0.5, 0.5});
    EXPECT_NEAR(mapped[0], std::pow(0.5, 0.5 / response.gamma()), 2e-3);
    EXPECT_NEAR(mapped[1], std::pow(0.5, 0.4 / response.gamma()), 2e-3);
    EXPECT_NEAR(mapped[2], std::pow(0.5, 0.3 / response.gamma()), 2e-3);
}

TEST(CameraResponse, OneCurveMakesGrey) {
    for (const char* name : {"agfapan", "agfapanRed"}) {
        const CameraResponse response = read_camera_response(file_of(power_curve(name, 0.5)));
        const auto mapped = response.map({1, 0, 0});
        EXPECT_NEAR(mapped[0], 0.2126, 2e-3);
        EXPECT_EQ(mapped[1], mapped[0]);
        EXPECT_EQ(mapped[2], mapped[0]);
    }
}

TEST(CameraResponse, WhatFollowsThreeChannelsIsNotRead) {
    const std::string film =
        power_curve("ARed", 1) + power_curve("AGreen", 1) + power_curve("ABlue", 1);
    EXPECT_NO_THROW(read_camera_response(file_of(film + "B graph\nnonsense")));
}

TEST(CameraResponse, ErrorsNameTheirPlace) {
    const std::pair<std::string, std::string> cases[] = {
        {"", "1:1: expected a curve whose name ends in Red, found the end of the file"},
        {"a\nI = 0 1\n",
         "2:1: it is no file of curves: expected \"graph\" after the name of the first"},
        {"a\ngraph x\nI = 0 1\nB = 0 1\nb\nI = 0",
         "6:1: expected \"graph\" after the name of a curve, found \"I\""},
        {"a\ngraph x\nI = 0 x\n", "3:7: expected a number from 0 to 1, found \"x\""},
        {"a\ngraph x\nI = 0 1\nB 0 1", "4:3: expected \"=\" after \"B\", found \"0\""},
        {"a\ngraph x\nI = 0 1\nB = 0 -1", "4:7: expected a number from 0 to 1, found \"-1\""},
        {"a\ngraph x\nI = 0 1\nB = 0\n", "4:1: 1 brightnesses for 2 irradiances"},
        {"a\ngraph x\nI = 1 0\nB = 0 1", "3:1: the irradiances of a curve must not fall"},
        {"a\ngraph x\nI = 0 1\n",
         "4:1: expected \"B =\" and numbers, found the end of the "
         "file"},
        {power_curve("ARed", 1, 2) + power_curve("BGreen", 1, 2),
         "7:1: a curve of \"B\" in the file of \"A\""},
        {power_curve("ABlue", 1, 2),
         "7:1: expected a curve whose name ends in Red, found the end of the file"},
    };
    for (const auto& [text, message] : cases) {
        try {
            read_camera_response(file_of(text));
            ADD_FAILURE() << text;
        } catch (const ResponseFileError& error) {
            EXPECT_EQ(
                fmt::format("{}:{}: {}", error.where().line, error.where().column, error.what()),
                message);
        }
    }
}

/// A scene may name any file of whoever renders it.
TEST(CameraResponse, MessagesShowNothingOfAnotherFile) {
    try {
        read_camera_response(file_of("root:x:0:0 secret\n"));
        ADD_FAILURE();
    } catch (const ResponseFileError& error) {
        const std::string told = format_message(error.where(), "warning", error.what());
        EXPECT_EQ(told.find("secret"), std::string::npos) << told;
        EXPECT_EQ(told.find("root"), std::string::npos) << told;
    }
}

TEST(CameraResponse, IsAppliedAfterTheKernel) {
    ToneMapSettings settings;
    settings.kernel = ToneMapSettings::Kernel::MaxWhite;
    settings.gamma = 1;
    settings.response = std::make_shared<const CameraResponse>(
        std::vector<ResponseCurve>{{{0, 1}, {0, 1}}, {{0, 0.5, 1}, {0, 1, 1}}, {{0, 1}, {0, 1}}});
    const auto bytes = tone_map(std::vector<Rgb>{Rgb(4.0f), Rgb(1.0f)}, settings);
    EXPECT_EQ(bytes[0], 255);
    EXPECT_EQ(bytes[3], 64);
    EXPECT_EQ(bytes[4], 128);
}

struct Chosen {
    RecordedDiagnostics diagnostics;
    std::vector<std::uint8_t> bytes;

    explicit Chosen(const std::string& response) : Chosen(text("cameraresponse", response)) {}
    explicit Chosen(const ParameterValue& response) {
        diagnostics.lenient = true;
        SceneContents contents = scene_of_size(2, 1);
        contents.options["Film"].parameters.values.push_back(response);
        const auto film = make_film(contents, diagnostics,
                                    [](const std::string& name, const SourceLocation& where) {
                                        if (!std::filesystem::exists(name))
                                            throw InputError(where, "no such file");
                                        return name;
                                    });
        Samples samples = pixel_centres(*film, Rgb(1.0f, 0.1f, 0.1f));
        film->add_pass(samples.pass());
        bytes = film->tone_mapped();
    }
};

TEST(CameraResponse, IsReadFromTheFileThatTheFilmNames) {
    const TemporaryFolder folder;
    folder.write("grey.crf", power_curve("grey", 0.45));
    const Chosen chosen(folder / "grey.crf");
    EXPECT_TRUE(chosen.diagnostics.warnings.empty());
    EXPECT_EQ(chosen.bytes[0], chosen.bytes[1]);
    EXPECT_EQ(chosen.bytes[0], chosen.bytes[2]);
    const Chosen none("");
    EXPECT_NE(none.bytes[0], none.bytes[1]);
}

TEST(CameraResponse, GoesOnWithoutWhatCannotBeRead) {
    const TemporaryFolder folder;
    folder.write("bad.crf", "film\ngraph x\nI = 0 oops\n");
    using Lines = std::vector<std::string>;
    EXPECT_EQ(
        Chosen("Gold_100CD").diagnostics.warnings,
        Lines{"scene.lxs:2:5: warning: the measured response of film \"Gold_100CD\" is not at "
              "hand, name a file with its curves; no film response is applied"});
    EXPECT_EQ(Chosen("nowhere.crf").diagnostics.warnings,
              Lines{"scene.lxs:2:5: warning: no file \"nowhere.crf\" can be read; no film response "
                    "is applied"});
    const Chosen mistyped(real("cameraresponse", 1));
    ASSERT_EQ(mistyped.diagnostics.warnings.size(), 1u);
    EXPECT_EQ(mistyped.bytes, Chosen("").bytes);
    const Chosen bad(folder / "bad.crf");
    ASSERT_EQ(bad.diagnostics.warnings.size(), 1u);
    EXPECT_NE(bad.diagnostics.warnings[0].find(
                  "bad.crf:3:7: warning: expected a number from 0 to 1, found \"oops\"; no film "
                  "response is applied"),
              std::string::npos)
        << bad.diagnostics.warnings[0];
}

}  // namespace
}  // namespace lxs::test::camera_response_test
