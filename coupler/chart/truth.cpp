#include "coupler/chart/truth.hpp"

#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>

#include "common/case/table.hpp"
#include "common/error.hpp"
#include "coupler/study/words.hpp"

namespace cosurge {
namespace {

Curve read_curve(const std::string& file) {
  const Table table = read_table(file, {{.name = "t", .unit = "s"}, {.name = "value", .unit = ""}});
  Curve curve;
  for (std::size_t row = 0; row < table.lines.size(); ++row) {
    const double time = table.values[2 * row];
    require(curve.time.empty() || time > curve.time.back(), "{}:{}: time {} must be later than {}", file,
            table.lines[row], time, curve.time.empty() ? 0 : curve.time.back());
    curve.time.push_back(time);
    curve.values.push_back(table.values[2 * row + 1]);
  }
  require(curve.time.size() >= 2, "{}: a curve needs two rows", file);
  return curve;
}

/// @throws Error where the curve leaves a part of the range without a value.
void require_covered(const Quantity& quantity, const Truth& truth, double end) {
  const Curve& curve = *truth.curve;
  if (quantity.range())
    require(curve.time.front() <= quantity.range()->from && curve.time.back() >= quantity.range()->to,
            "{}: has values from {:g} to {:g} s only; {} needs them from {:g} to {:g} s", truth.name,
            curve.time.front(), curve.time.back(), quantity.text(), quantity.range()->from,
            quantity.range()->to);
  else
    require(curve.time.front() < end && curve.time.back() > 0, "{}: has no values between 0 and {:g} s",
            truth.name, end);
}

Truth read_truth(const std::string& word, const Quantity& quantity, double end) {
  Truth truth{.name = word, .number = number_of(word), .curve = std::nullopt};
  if (truth.number) {
    require(quantity.kind() != Quantity::Kind::rms,
            "--truth {}={}: rms compares with a history, not with a number", quantity.text(), word);
    return truth;
  }
  require(std::filesystem::exists(word), "--truth {}: is neither a number nor a file", word);
  truth.curve = read_curve(word);
  require_covered(quantity, truth, end);
  return truth;
}

/// One word. @throws Error.
void add_truth(const std::string& word, const std::vector<Quantity>& quantities, double end, Truths& truths) {
  if (word == "finest") return;
  const auto equals = word.find('=');
  if (equals == std::string::npos) {
    require(word.ends_with(".csv"),
            "--truth {}: must be finest, FILE.csv, QUANTITY=NUMBER, QUANTITY=FILE.csv or KEY=VALUE", word);
    for (std::size_t q = 0; q < quantities.size(); ++q) {
      require(
          quantities[q].history() == quantities.front().history(),
          "--truth {}: one curve cannot be true of {} and of {}; write --truth QUANTITY=FILE.csv for each",
          word, quantities.front().text(), quantities[q].text());
      truths.of_quantity[q] = read_truth(word, quantities[q], end);
    }
    return;
  }
  const std::string left = word.substr(0, equals), right = word.substr(equals + 1);
  const std::string plain = without_blanks(left);
  const auto named = std::find_if(quantities.begin(), quantities.end(),
                                  [&](const Quantity& quantity) { return quantity.text() == plain; });
  if (named != quantities.end()) {
    truths.of_quantity[static_cast<std::size_t>(named - quantities.begin())] = read_truth(right, *named, end);
    return;
  }
  require(left.find('(') == std::string::npos, "--truth {}: {} is not among the quantities", word, left);
  truths.settings.push_back(word);
}

}  // namespace

bool Truths::needs_run() const {
  return std::any_of(of_quantity.begin(), of_quantity.end(),
                     [](const Truth& truth) { return !truth.number && !truth.curve; });
}

Truths read_truths(const std::vector<std::string>& words, const std::vector<Quantity>& quantities,
                   double end) {
  Truths truths;
  truths.of_quantity.resize(quantities.size());
  std::vector<std::string> wrong;
  for (const std::string& word : words) note_errors(wrong, [&] { add_truth(word, quantities, end, truths); });
  if (wrong.empty() && !truths.settings.empty() && !truths.needs_run())
    wrong.push_back(fmt::format("--truth {}: no quantity is compared with a run, each has its own truth",
                                fmt::join(truths.settings, " ")));
  require(wrong.empty(), "{}", fmt::join(wrong, "\n"));
  return truths;
}

TimeRange common_range(const Quantity& quantity, const Curve& history, const Curve& truth) {
  if (quantity.range()) return *quantity.range();
  return {.from = std::max(history.time.front(), truth.time.front()),
          .to = std::min(history.time.back(), truth.time.back())};
}

Comparison compare(const Quantity& quantity, const Curve& history, const Truth& truth, const Curve& run) {
  if (truth.number) {
    const double value = quantity.value(history);
    return {.value = value, .truth = *truth.number, .error = std::abs(value - *truth.number)};
  }
  const Curve& exact = truth.curve ? *truth.curve : run;
  const TimeRange range = common_range(quantity, history, exact);
  const double true_value = quantity.value(cut(exact, range));
  if (quantity.kind() == Quantity::Kind::rms) {
    const double rms = rms_of(difference_of(cut(history, range), exact));
    return {.value = rms, .truth = true_value, .error = rms};
  }
  const double value = quantity.value(cut(history, range));
  return {.value = value, .truth = true_value, .error = std::abs(value - true_value)};
}

}  // namespace cosurge
