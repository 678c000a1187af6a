// Protects the page of --serve from everybody but who has its link: wrong tokens, other sites'
// pages, names that other sites point here, and what asks for files.
#include "access.h"

#include <gtest/gtest.h>

#include "serve_request.h"

namespace lxs::serve::access_test {
namespace {

const Access kAccess(test::kToken, test::kPort);

TEST(Access, TokensAreLongAndNeverTheSame) {
    const std::string token = random_token();
    EXPECT_EQ(token.size(), 32u);
    EXPECT_EQ(token.find_first_not_of("0123456789abcdef"), std::string::npos);
    EXPECT_NE(token, random_token());
}

TEST(Access, ComparesWholeTexts) {
    EXPECT_TRUE(equal_in_constant_time("abc", "abc"));
    EXPECT_TRUE(equal_in_constant_time("", ""));
    for (const char* other : {"", "ab", "abcd", "xbc", "abx"})
        EXPECT_FALSE(equal_in_constant_time("abc", other)) << other;
}

TEST(Access, TheLinkHasAddressAndToken) {
    EXPECT_EQ(kAccess.link(), std::string("http://127.0.0.1:8080/") + test::kToken + "/");
}

TEST(Access, AdmitsItsOwnPage) {
    EXPECT_EQ(kAccess.admitted(test::get("state")), "state");
    EXPECT_EQ(kAccess.admitted(test::get("")), "");
    EXPECT_EQ(kAccess.admitted(test::get("layer/3")), "layer/3");
    Request by_name = test::get("state");
    by_name.set("Host", "localhost:8080");
    by_name.set("Origin", "http://localhost:8080");
    by_name.set("Sec-Fetch-Site", "same-origin");
    EXPECT_EQ(kAccess.admitted(by_name), "state");
    EXPECT_EQ(kAccess.admitted(test::post("stop")), "stop");
}

TEST(Access, RefusesOtherTokens) {
    std::string almost = test::kToken;
    almost.back() ^= 1;
    for (const std::string& target :
         {"/" + almost + "/", std::string("/"), std::string("//"), std::string("/favicon.ico"),
          std::string("*"), std::string(""), std::string("/") + test::kToken,
          "/" + std::string(test::kToken).substr(1) + "/", "/x/" + std::string(test::kToken) + "/",
          "http://127.0.0.1:8080/" + std::string(test::kToken) + "/"}) {
        Request request = test::get("");
        request.target(target);
        EXPECT_FALSE(kAccess.admitted(request)) << target;
    }
}

TEST(Access, RefusesOtherHosts) {
    for (const char* host : {"", "evil.example", "evil.example:8080", "127.0.0.1", "127.0.0.1:80",
                             "localhost", "127.0.0.1:8080.evil.example", "127.0.0.1:80801"}) {
        Request request = test::get("state");
        request.set("Host", host);
        EXPECT_FALSE(kAccess.admitted(request)) << host;
    }
    Request twice = test::get("state");
    twice.insert("Host", "127.0.0.1:8080");
    EXPECT_FALSE(kAccess.admitted(twice));
    Request none = test::get("state");
    none.erase("Host");
    EXPECT_FALSE(kAccess.admitted(none));
}

TEST(Access, RefusesOtherOrigins) {
    for (const char* origin : {"null", "", "http://evil.example", "https://127.0.0.1:8080",
                               "http://127.0.0.1:8081", "http://127.0.0.1:8080.evil.example"}) {
        Request request = test::post("stop");
        request.set("Origin", origin);
        EXPECT_FALSE(kAccess.admitted(request)) << origin;
        request.method(boost::beast::http::verb::get);
        EXPECT_FALSE(kAccess.admitted(request)) << origin;
    }
    Request twice = test::post("stop");
    twice.insert("Origin", "http://127.0.0.1:8080");
    EXPECT_FALSE(kAccess.admitted(twice));
    Request of_two_sites = test::get("state");
    of_two_sites.set("Sec-Fetch-Site", "same-origin");
    EXPECT_TRUE(kAccess.admitted(of_two_sites));
    of_two_sites.insert("sec-fetch-site", "cross-site");
    EXPECT_FALSE(kAccess.admitted(of_two_sites));
    for (const char* site : {"cross-site", "same-site", ""}) {
        Request request = test::get("state");
        request.set("Sec-Fetch-Site", site);
        EXPECT_FALSE(kAccess.admitted(request)) << site;
    }
}

/// Browsers leave port 80 out.
TEST(Access, PortsOfHttpNeedNotBeSaid) {
    const Access access(test::kToken, 80);
    EXPECT_EQ(access.link(), std::string("http://127.0.0.1:80/") + test::kToken + "/");
    for (const char* host : {"127.0.0.1", "localhost", "127.0.0.1:80", "localhost:80"}) {
        Request request = test::post("stop");
        request.set("Host", host);
        request.set("Origin", std::string("http://") + host);
        EXPECT_TRUE(access.admitted(request)) << host;
    }
    for (const char* host : {"evil.example", "127.0.0.1:8080", ""}) {
        Request request = test::get("state");
        request.set("Host", host);
        EXPECT_FALSE(access.admitted(request)) << host;
    }
}

TEST(Access, AnOrderSaysWhereItComesFrom) {
    Request request = test::post("stop");
    request.erase("Origin");
    EXPECT_FALSE(kAccess.admitted(request));
}

}  // namespace
}  // namespace lxs::serve::access_test
