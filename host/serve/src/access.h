// Who may ask: those who know the link, from a page of this server.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "request.h"

namespace lxs::serve {

/// 128 bits of the system's randomness, as 32 hexadecimal digits.
std::string random_token();

/// Whether two texts are equal, in a time that tells nothing of where they differ.
bool equal_in_constant_time(std::string_view a, std::string_view b);

class Access {
  public:
    Access(std::string token, std::uint16_t port);

    /// What follows "/TOKEN/" in the request's target. Nothing, if the request is to be refused:
    /// - the token is wrong;
    /// - Host is not this server's: a name of another site was made to point here (DNS rebinding);
    /// - Origin, or Sec-Fetch-Site, says that a page of another site asks;
    /// - it orders something (POST) and does not say where it comes from;
    /// - one of these stands twice: different readers would heed different ones.
    std::optional<std::string_view> admitted(const Request& request) const;
    /// The page's address.
    std::string link() const;

  private:
    bool own_host(std::string_view host) const;
    bool own_origin(std::string_view origin) const;

    std::string token_;
    std::vector<std::string> hosts_;  ///< what Host may say: address or name, and port
};

}  // namespace lxs::serve
