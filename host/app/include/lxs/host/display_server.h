// Shows the image so far in the viewer tev, over its protocol.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "lxs/sdk/types.h"

namespace lxs {

/// Where a viewer listens.
struct ViewerAddress {
    std::string host;  ///< name or number; IPv6 without brackets
    std::string port = "14158";

    /// From HOST, HOST:PORT or [IPV6]:PORT; throws std::invalid_argument, saying what is wrong.
    static ViewerAddress parse(const std::string& text);
    std::string text() const;
};

/// An image in the viewer, made there when it is shown first. A viewer that is gone, or was never
/// there, is looked for again whenever the image is shown.
///
/// The protocol is tev's (https://github.com/Tom94/tev), packets CreateImage and UpdateImageV3.
class DisplayServer {
  public:
    /// The addresses of a host, as numbers; throws std::runtime_error if there are none.
    using FindAddresses = std::function<std::vector<std::string>(const std::string& host)>;

    /// `name`: of the image, in the viewer. `find`: the system's if empty; it may take its time.
    DisplayServer(ViewerAddress address, std::string name, FindAddresses find = {});
    ~DisplayServer();
    DisplayServer(DisplayServer&&) noexcept;
    DisplayServer& operator=(DisplayServer&&) noexcept;

    /// Sends all pixels, row by row: width * height values of linear radiance. Throws
    /// std::runtime_error if that is not done within two seconds.
    void show(std::uint32_t width, std::uint32_t height, std::span<const Rgb> pixels);

  private:
    using Clock = std::chrono::steady_clock;
    class Connection;
    class Search;
    void connect(std::uint32_t width, std::uint32_t height, Clock::time_point deadline);

    ViewerAddress address_;
    std::string name_;
    FindAddresses find_;
    std::unique_ptr<Search> search_;          ///< null: none is under way
    std::unique_ptr<Connection> connection_;  ///< null: none now
};

}  // namespace lxs
