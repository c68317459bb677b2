// The built page, embedded in the program.
#pragma once

#include <string_view>

namespace cosurge {

/// coupler/report/page/page.html, as scripts/build_page has made it.
std::string_view page_asset();

}  // namespace cosurge
