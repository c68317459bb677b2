#include "coupler/report/page.hpp"

#include "common/error.hpp"
#include "coupler/report/page_asset.hpp"

namespace cosurge {

std::string json_for_html(const nlohmann::ordered_json& document) {
  const std::string text = document.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
  std::string safe;
  safe.reserve(text.size());
  for (const char letter : text) {
    if (letter == '<')
      safe += "\\u003c";  // "</script>" would end the element
    else
      safe += letter;
  }
  return safe;
}

std::string page(const nlohmann::ordered_json& document) {
  const std::string_view asset = page_asset();
  constexpr std::string_view place = "@COSURGE_DOCUMENT@";
  const std::size_t at = asset.find(place);
  require(at != std::string_view::npos, "the page in this program has no place for its document");
  std::string out(asset.substr(0, at));
  out += json_for_html(document);
  out += asset.substr(at + place.size());
  return out;
}

}  // namespace cosurge
