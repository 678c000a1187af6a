// Who may ask: those who know the link, from a page of this server.
#include "access.h"

#include <sys/random.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <system_error>

namespace lxs::serve {
namespace {

std::string_view text_of(boost::beast::string_view text) {
    return {text.data(), text.size()};
}

constexpr const char* kFetchSite = "Sec-Fetch-Site";

/// Browsers leave it out of Host and Origin.
constexpr std::uint16_t kPortOfHttp = 80;

}  // namespace

std::string random_token() {
    std::array<unsigned char, 16> bytes{};
    if (::getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size()))
        throw std::system_error(errno, std::generic_category());
    constexpr std::string_view kDigits = "0123456789abcdef";
    std::string token;
    for (const unsigned char byte : bytes) {
        token += kDigits[byte >> 4];
        token += kDigits[byte & 15];
    }
    return token;
}

bool equal_in_constant_time(std::string_view a, std::string_view b) {
    if (a.size() != b.size()) return false;  // the length is no secret
    unsigned difference = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        difference |= static_cast<unsigned char>(a[i]) ^ static_cast<unsigned char>(b[i]);
    return difference == 0;
}

Access::Access(std::string token, std::uint16_t port) : token_(std::move(token)) {
    const std::string behind = ":" + std::to_string(port);
    for (const char* host : {"127.0.0.1", "localhost"}) {
        hosts_.push_back(host + behind);
        if (port == kPortOfHttp) hosts_.emplace_back(host);
    }
}

bool Access::own_host(std::string_view host) const {
    return std::ranges::find(hosts_, host) != hosts_.end();
}

bool Access::own_origin(std::string_view origin) const {
    constexpr std::string_view kScheme = "http://";
    return origin.starts_with(kScheme) && own_host(origin.substr(kScheme.size()));
}

std::optional<std::string_view> Access::admitted(const Request& request) const {
    using boost::beast::http::field;
    for (const char* name : {"Host", "Origin", kFetchSite}) {
        if (request.count(name) > 1) return std::nullopt;
    }
    if (!own_host(text_of(request[field::host]))) return std::nullopt;
    const auto origin = request.find(field::origin);
    if (origin != request.end() && !own_origin(text_of(origin->value()))) return std::nullopt;
    const bool orders = request.method() != boost::beast::http::verb::get;
    if (orders && origin == request.end()) return std::nullopt;
    const auto site = request.find(kFetchSite);
    if (site != request.end() && site->value() != "same-origin" && site->value() != "none")
        return std::nullopt;
    std::string_view target = text_of(request.target());
    if (!target.starts_with('/')) return std::nullopt;
    target.remove_prefix(1);
    const std::size_t slash = target.find('/');
    if (slash == std::string_view::npos) return std::nullopt;
    if (!equal_in_constant_time(target.substr(0, slash), token_)) return std::nullopt;
    return target.substr(slash + 1);
}

std::string Access::link() const {
    return "http://" + hosts_.front() + "/" + token_ + "/";
}

}  // namespace lxs::serve
