// Stands in for the page where it is not built.
#include "lxs/serve/page.h"

namespace lxs::serve {

std::string_view page_text() {
    return {};
}

std::string_view page_policy() {
    return "default-src 'none'";
}

}  // namespace lxs::serve
