#include "common/case/case_text.hpp"

#include <fmt/ranges.h>

#include <optional>

#include "common/case/toml_bounds.hpp"
#include "common/error.hpp"
#include "common/text_file.hpp"
#include "common/version.hpp"
#include "proto/case.pb.h"

namespace cosurge {

std::string case_text(const std::filesystem::path& file) {
  constexpr std::uintmax_t most_bytes = 1 << 20;
  std::error_code unknown;
  const std::uintmax_t size = std::filesystem::file_size(file, unknown);
  require(unknown || size <= most_bytes,
          "{}: the file has {:.3g} MB; the limit for a case is 1 MB: put outlines and tables into separate "
          "files beside the case",
          file.string(), 1e-6 * static_cast<double>(size));
  return without_byte_order_mark(file_contents(file), file);
}

toml::table case_tree(const std::string& text, const std::string& name) {
  const std::string lines = fmt::format("{}", fmt::join(lines_of(text), "\n")) + "\n";
  require_short_keys(lines, name);
  require_ascii(lines, name);
  try {
    return toml::parse(lines, name);
  } catch (const toml::parse_error& error) {
    throw Error(fmt::format("{}:{}: {}", name, error.source().begin.line, error.description()));
  }
}

void require_known_schema(const toml::table& root) {
  const std::int64_t newest = v1::Case::default_instance().schema();
  const toml::node* node = root.get("schema");
  const std::optional<std::int64_t> asked = node ? node->value<std::int64_t>() : std::nullopt;
  if (!asked || *asked <= newest) return;
  const toml::source_region& source = node->source();
  const std::string path = source.path ? *source.path : "";
  throw Error(fmt::format(
      "{}: schema: {} is newer than Cosurge {}, which knows schemas up to {}: install a newer Cosurge, or "
      "write the case for schema {}",
      path.starts_with("--set") ? path : fmt::format("{}:{}", path, source.begin.line), *asked, version,
      newest, newest));
}

}  // namespace cosurge
