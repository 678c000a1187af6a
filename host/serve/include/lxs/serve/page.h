// The page, bundled when the program is built.
#pragma once

#include <string_view>

namespace lxs::serve {

/// HTML with its scripts and styles inside; empty if the program was built without npm.
std::string_view page_text();
/// Content-Security-Policy of the page: its own scripts and styles by their checksums, and
/// questions to its own server alone.
std::string_view page_policy();

}  // namespace lxs::serve
