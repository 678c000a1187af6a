// Messages of a render that belong to no line of a file.
#pragma once

#include <string_view>

namespace lxs {

class Log {
  public:
    virtual ~Log() = default;
    virtual void info(std::string_view message) = 0;
    virtual void warning(std::string_view message) = 0;
    virtual void debug(std::string_view message) = 0;  ///< shown with --verbose
};

}  // namespace lxs
