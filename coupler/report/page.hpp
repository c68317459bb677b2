// The HTML page that shows runs, in a single file.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace cosurge {

/// The page with its JavaScript (built from coupler/report/page) and its data (page_document()).
std::string page(const nlohmann::ordered_json& document);

/// JSON text that may stand in a script element of HTML.
std::string json_for_html(const nlohmann::ordered_json& document);

}  // namespace cosurge
