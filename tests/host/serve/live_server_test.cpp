// Protects the server of --serve from slow and silent clients: whoever reads slowly gets all of an
// image, whoever reads nothing is left, and strangers do not take the places of those who watch.
#include "lxs/serve/live_server.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/read.hpp>
#include <boost/asio/write.hpp>
#include <string>
#include <thread>
#include <vector>

namespace lxs::serve::live_server_test {
namespace {

using boost::asio::ip::tcp;
using std::chrono::milliseconds;
using Clock = std::chrono::steady_clock;

constexpr milliseconds kShort{400};
constexpr std::size_t kImageBytes = std::size_t{24} << 20;  // more than the system's buffers take

/// A client that hardly reads ahead.
class Client {
  public:
    explicit Client(const LiveServer& server) : socket_(context_) {
        const std::string link = server.link();
        const std::size_t at = link.rfind(':') + 1;
        const std::size_t slash = link.find('/', at);
        host_ = link.substr(7, slash - 7);
        root_ = link.substr(slash);
        socket_.open(tcp::v4());
        socket_.set_option(boost::asio::socket_base::receive_buffer_size(64 << 10));
        const auto port = static_cast<std::uint16_t>(std::stoi(link.substr(at)));
        socket_.connect({boost::asio::ip::address_v4::loopback(), port});
    }

    void ask(const std::string& what, const std::string& more = "") {
        const std::string request =
            "GET " + root_ + what + " HTTP/1.1\r\nHost: " + host_ + "\r\n" + more + "\r\n";
        boost::asio::write(socket_, boost::asio::buffer(request));
    }

    /// What is there by now, or comes first; nothing at the end.
    std::string read_some() {
        std::array<char, 65536> some{};
        boost::system::error_code end;
        const std::size_t size = socket_.read_some(boost::asio::buffer(some), end);
        return {some.data(), size};
    }

    /// All that comes, `pause` between the reads.
    std::size_t read_slowly(milliseconds pause) {
        std::size_t size = 0;
        for (std::string some = read_some(); !some.empty(); some = read_some()) {
            size += some.size();
            std::this_thread::sleep_for(pause);
        }
        return size;
    }

  private:
    boost::asio::io_context context_;
    tcp::socket socket_;
    std::string host_, root_;
};

class LiveServerTest : public testing::Test {
  protected:
    LiveServerTest() { board_.put_image(std::make_shared<std::string>(kImageBytes, 'x'), 1); }
    std::string state() {
        Client client(server_);
        client.ask("state");
        return client.read_some();
    }

    Board board_;
    LiveServer server_{board_, 0, kShort};
};

TEST_F(LiveServerTest, WhoeverReadsSlowlyGetsAll) {
    Client client(server_);
    client.ask("image", "Connection: close\r\n");
    const auto start = Clock::now();
    EXPECT_GT(client.read_slowly(milliseconds(5)), kImageBytes);
    EXPECT_GT(Clock::now() - start, 3 * kShort) << "too fast to tell anything";
}

TEST_F(LiveServerTest, WhoeverReadsNothingIsLeft) {
    Client client(server_);
    client.ask("image", "Connection: close\r\n");
    std::this_thread::sleep_for(3 * kShort);
    EXPECT_LT(client.read_slowly(milliseconds(0)), kImageBytes);
}

TEST_F(LiveServerTest, WhoeverSendsNothingIsLeft) {
    Client silent(server_), slow(server_);
    slow.ask("state", "X-Not-Ended: \r\nX");
    const auto start = Clock::now();
    while (!silent.read_some().empty()) {
    }
    EXPECT_LT(Clock::now() - start, 10 * kShort);
    EXPECT_GT(Clock::now() - start, kShort / 2);
}

/// Those with the token keep their places, and get new ones.
TEST_F(LiveServerTest, StrangersDoNotLockWatchersOut) {
    const LiveServer patient(board_, 0, std::chrono::seconds(60));
    Client watcher(patient);
    watcher.ask("state");
    EXPECT_THAT(watcher.read_some(), testing::StartsWith("HTTP/1.1 200"));
    std::vector<std::unique_ptr<Client>> strangers;
    for (int i = 0; i < 100; ++i)
        strangers.push_back(std::make_unique<Client>(patient));
    Client late(patient);
    late.ask("state");
    EXPECT_THAT(late.read_some(), testing::StartsWith("HTTP/1.1 200"));
    watcher.ask("state");
    EXPECT_THAT(watcher.read_some(), testing::StartsWith("HTTP/1.1 200"));
    EXPECT_EQ(strangers.front()->read_some(), "") << "the first to go";
}

TEST_F(LiveServerTest, WhoeverIsRefusedIsLeft) {
    Client client(server_);
    client.ask("state", "Sec-Fetch-Site: cross-site\r\n");
    std::string said, some;
    while (!(some = client.read_some()).empty())
        said += some;
    EXPECT_THAT(said, testing::StartsWith("HTTP/1.1 403"));
    EXPECT_THAT(said, testing::HasSubstr("Connection: close"));
}

TEST(BlockedPorts, AreThoseOfOtherServices) {
    for (const std::uint16_t port : {1, 22, 25, 6000, 6667, 10080})
        EXPECT_FALSE(browsers_open(port)) << port;
    for (const std::uint16_t port : {0, 80, 443, 8000, 8080, 6001, 40000, 65535})
        EXPECT_TRUE(browsers_open(port)) << port;
}

}  // namespace
}  // namespace lxs::serve::live_server_test
