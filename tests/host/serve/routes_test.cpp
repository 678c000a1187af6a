// Protects what the page of --serve gets: its state, its pictures bit for bit, orders that reach
// the render, and nothing else.
#include "routes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <thread>

#include "lxs/serve/page.h"
#include "serve_request.h"

namespace lxs::serve::routes_test {
namespace {

using boost::beast::http::status;
using std::chrono::milliseconds;
using testing::HasSubstr;

class Routes : public testing::Test {
  protected:
    Reply get(const std::string& what) { return answer(test::get(what), access_, board_); }
    Reply post(const std::string& what) { return answer(test::post(what), access_, board_); }

    Board board_;
    Access access_{test::kToken, test::kPort};
};

TEST_F(Routes, ThePageNamesNothingOutsideOfIt) {
    const Reply reply = get("");
    EXPECT_EQ(reply.status, status::ok);
    EXPECT_EQ(*reply.body, page_text());
    EXPECT_THAT(std::string(page_policy()), HasSubstr("default-src 'none'"));
    EXPECT_THAT(*reply.body, testing::Not(HasSubstr("src=\"")));
}

TEST_F(Routes, AskingForTheStateIsWatching) {
    EXPECT_FALSE(board_.watched());
    board_.put_state("{\"passes\":3}");
    const Reply reply = get("state");
    EXPECT_EQ(reply.type, "application/json");
    EXPECT_EQ(*reply.body,
              "{\"pause\":false,\"stop\":false,\"image\":0,\"layer\":0,\"layer image\":0,"
              "\"render\":{\"passes\":3}}");
    EXPECT_TRUE(board_.watched());
}

TEST_F(Routes, PicturesHaveTheFloatsOfTheRender) {
    EXPECT_EQ(get("image").status, status::no_content);
    const std::array values{0.5f, 1e-30f, 3.0f, 4.0f, 5.0f, 6.0f};
    board_.put_image(picture_bytes(2, 1, 3, 7, values), 7);
    const Reply reply = get("image");
    ASSERT_EQ(reply.body->size(), 16 + sizeof values);
    std::array<std::uint32_t, 4> head{};
    std::memcpy(head.data(), reply.body->data(), sizeof head);
    EXPECT_THAT(head, testing::ElementsAre(2, 1, 3, 7));
    EXPECT_EQ(std::memcmp(reply.body->data() + 16, values.data(), sizeof values), 0);
    EXPECT_THAT(*get("state").body, HasSubstr("\"image\":7"));
}

TEST_F(Routes, ALayerIsMadeForWhoWantsIt) {
    EXPECT_FALSE(board_.wanted_layer());
    EXPECT_EQ(get("layer/2").status, status::no_content);
    EXPECT_FALSE(board_.wanted_layer()) << "nobody watches";
    get("state");
    EXPECT_EQ(board_.wanted_layer(), 2u);
    board_.put_layer(2, picture_bytes(1, 1, 1, 9, std::array{0.25f}), 9);
    EXPECT_EQ(get("layer/2").status, status::ok);
    EXPECT_EQ(get("layer/1").status, status::no_content) << "that is another";
    EXPECT_EQ(get("layer/none").status, status::no_content);
    EXPECT_FALSE(board_.wanted_layer());
}

TEST_F(Routes, OrdersReachTheRender) {
    EXPECT_EQ(post("pause").status, status::ok);
    EXPECT_TRUE(board_.orders().pause);
    EXPECT_EQ(post("resume").status, status::ok);
    EXPECT_FALSE(board_.orders().pause);
    post("pause");
    EXPECT_THAT(*post("stop").body, HasSubstr("\"pause\":false,\"stop\":true"));
    post("resume");
    EXPECT_TRUE(board_.orders().stop) << "it is stopping for good";
}

TEST_F(Routes, AnOrderWakesARenderThatIsPaused) {
    const auto start = std::chrono::steady_clock::now();
    std::thread page([this] {
        std::this_thread::sleep_for(milliseconds(20));
        post("resume");
    });
    board_.wait_for_wishes(milliseconds(20'000));
    page.join();
    EXPECT_LT(std::chrono::steady_clock::now() - start, milliseconds(10'000));
}

TEST_F(Routes, TheEndWaitsForWhoWatchesAlone) {
    const auto start = std::chrono::steady_clock::now();
    board_.wait_until_seen(milliseconds(20'000));
    get("state");
    board_.wait_until_seen(milliseconds(20'000));
    EXPECT_LT(std::chrono::steady_clock::now() - start, milliseconds(10'000));
    board_.put_state("1");
    board_.wait_until_seen(milliseconds(5));
}

TEST_F(Routes, ThereIsNothingElse) {
    for (const char* what : {"x", "../", "state/", "state?", "image2", "layer/", "layer/x",
                             "layer/-1", "layer/99999999999999999999", "stop", "%2e%2e/etc/passwd"})
        EXPECT_EQ(get(what).status, status::not_found) << what;
    for (const char* what : {"", "state", "image", "Stop", "stop?"})
        EXPECT_EQ(post(what).status, status::not_found) << what;
    EXPECT_FALSE(board_.orders().stop);
    Request request = test::post("stop");
    for (const auto verb : {boost::beast::http::verb::put, boost::beast::http::verb::head,
                            boost::beast::http::verb::options}) {
        request.method(verb);
        EXPECT_EQ(answer(request, access_, board_).status, status::method_not_allowed);
    }
}

TEST_F(Routes, WhoIsNotAdmittedLearnsAndChangesNothing) {
    Request request = test::post("stop");
    request.set("Host", "evil.example");
    const Reply reply = answer(request, access_, board_);
    EXPECT_EQ(reply.status, status::forbidden);
    EXPECT_EQ(*reply.body, "Forbidden\n");
    EXPECT_FALSE(board_.orders().stop);
    EXPECT_FALSE(board_.watched());
}

}  // namespace
}  // namespace lxs::serve::routes_test
