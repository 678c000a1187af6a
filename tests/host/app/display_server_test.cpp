// Protects the image in the viewer tev: it is the render's, it comes to a viewer that comes late,
// and a viewer that is not there costs a warning.
#include "lxs/host/display_server.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <boost/asio/ip/tcp.hpp>
#include <chrono>
#include <future>
#include <thread>

#include "lxs/imaging/exr_image.h"
#include "lxsrender_process.h"
#include "tev_viewer.h"

namespace lxs::display_server_test {
namespace {

using test::TevViewer;
using testing::HasSubstr;

// The filter has no lobes, whose rings would not be shown.
TEST(DisplayServer, ShowsTheImageAsItIsInTheFile) {
    const test::TemporaryFolder folder;
    TevViewer viewer;
    const test::RunResult result = test::run_lxsrender(
        folder, {"-", "--passes", "8", "-o", "x.exr", "--display-server", viewer.address()},
        test::small_scene("PixelFilter \"box\""));
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const auto images = viewer.images();
    ASSERT_EQ(images.size(), 1u);
    const test::ShownImage& shown = images.at("-");
    EXPECT_EQ(shown.created, 1);
    EXPECT_GE(shown.updates, 1);
    const ExrImage written = read_exr((folder.path() / "x.exr").string());
    ASSERT_EQ(shown.width, std::int32_t(written.frame.width));
    ASSERT_EQ(shown.channels, (std::vector<std::string>{"R", "G", "B"}));
    for (std::size_t c = 0; c < 3; ++c)
        EXPECT_EQ(shown.values[c], written.channels.at(shown.channels[c]));
}

TEST(DisplayServer, AViewerThatCloses) {
    TevViewer viewer(2);
    DisplayServer server(ViewerAddress::parse(viewer.address()), "late");
    const std::vector<Rgb> pixels(6, Rgb(0.5f));
    server.show(3, 2, pixels);
    // The system may take a packet or two before it tells that nobody reads.
    for (int attempt = 0; attempt < 2000 && viewer.connections() < 2; ++attempt) {
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
        try {
            server.show(3, 2, pixels);
        } catch (const std::runtime_error& error) {
            EXPECT_THAT(error.what(), HasSubstr("cannot show the image at 127.0.0.1:"));
        }
    }
    ASSERT_EQ(viewer.connections(), 2);
    server.show(3, 2, pixels);
    server = DisplayServer(ViewerAddress::parse("127.0.0.1"), "hangs up");
    EXPECT_EQ(viewer.images().at("late").created, 2);
}

/// More than the system takes in for one that reads nothing.
TEST(DisplayServer, AViewerThatHangsIsGivenUp) {
    boost::asio::io_context context;
    const boost::asio::ip::tcp::acceptor nobody_reads(context,
                                                      {boost::asio::ip::address_v4::loopback(), 0});
    const std::string port = std::to_string(nobody_reads.local_endpoint().port());
    DisplayServer server(ViewerAddress::parse("127.0.0.1:" + port), "hangs");
    const std::vector<Rgb> pixels(std::size_t{4000} * 1000, Rgb(0.5f));
    const auto start = std::chrono::steady_clock::now();
    EXPECT_THAT([&] { server.show(4000, 1000, pixels); },
                testing::ThrowsMessage<std::runtime_error>(HasSubstr("it does not answer")));
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(30));
}

/// A name server that does not answer takes as long as the system's patience, 10 s by default.
TEST(DisplayServer, ASearchForItsNameThatHangsIsGivenUpAndUsedLater) {
    TevViewer viewer;
    const std::string port = viewer.address().substr(viewer.address().find(':') + 1);
    std::promise<void> answer;
    std::atomic<int> searches = 0;
    DisplayServer server(ViewerAddress::parse("viewer.example:" + port), "late",
                         [&, answered = answer.get_future().share()](const std::string& host) {
                             EXPECT_EQ(host, "viewer.example");
                             ++searches;
                             answered.wait();
                             return std::vector<std::string>{"127.0.0.1"};
                         });
    const std::vector<Rgb> pixels(6, Rgb(0.5f));
    const auto start = std::chrono::steady_clock::now();
    EXPECT_THAT(
        [&] { server.show(3, 2, pixels); },
        testing::ThrowsMessage<std::runtime_error>(HasSubstr(
            "cannot show the image at viewer.example:" + port + ": no name server answers")));
    const auto took = std::chrono::steady_clock::now() - start;
    EXPECT_GT(took, std::chrono::seconds(1));
    EXPECT_LT(took, std::chrono::seconds(5));
    answer.set_value();
    server.show(3, 2, pixels);
    EXPECT_EQ(searches, 1);
    server = DisplayServer(ViewerAddress::parse("127.0.0.1"), "hangs up");
    EXPECT_EQ(viewer.images().at("late").created, 1);
}

TEST(DisplayServer, NoViewerIsAWarning) {
    std::string address;
    {
        const TevViewer viewer;
        address = viewer.address();
    }
    const test::TemporaryFolder folder;
    const test::RunResult result = test::run_lxsrender(
        folder, {"-", "--passes", "8", "--display-server", address}, test::small_scene());
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_THAT(result.err, HasSubstr("cannot show the image at " + address +
                                      ": Connection refused; rendering goes on"));
    EXPECT_EQ(result.err.find("cannot show"), result.err.rfind("cannot show"));
}

TEST(DisplayServer, Addresses) {
    const auto text = [](const char* given) { return ViewerAddress::parse(given).text(); };
    EXPECT_EQ(text("viewer"), "viewer:14158");
    EXPECT_EQ(text("viewer:80"), "viewer:80");
    EXPECT_EQ(text("[::1]:80"), "[::1]:80");
    EXPECT_EQ(text("[::1]"), "[::1]:14158");
    for (const char* wrong : {"", ":80", "viewer:", "viewer:0", "viewer:65536", "viewer:8x", "[::1",
                              "[]:80", "[::1]80", "a:b:c"}) {
        EXPECT_THROW((void)ViewerAddress::parse(wrong), std::invalid_argument) << wrong;
    }
}

}  // namespace
}  // namespace lxs::display_server_test
