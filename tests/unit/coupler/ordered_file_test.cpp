// Who reads results while they are written gets what is right, or an error.
#include "coupler/ordered_file.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>

#include "coupler/result_file.hpp"
#include "tests/support/scratch_folder.hpp"

namespace cosurge {
namespace {

constexpr int series = 4;
constexpr std::size_t rows_a_flush = 700;  // not a divisor of the rows of a chunk

double value(int which, std::size_t row) { return static_cast<double>(which + 1) + static_cast<double>(row); }

std::string name(int which) { return "/history/s" + std::to_string(which); }

/// Rows and frames, flush after flush, until it is killed: the tables of chunks get several levels.
[[noreturn]] void write_without_end(const std::filesystem::path& path) {
  ResultFile file(path);
  for (int s = 0; s < series; ++s) file.add_series(name(s), "m");
  for (std::size_t flush = 0;; ++flush) {
    for (int s = 0; s < series; ++s) {
      std::vector<double> rows;
      for (std::size_t k = 0; k < rows_a_flush; ++k) rows.push_back(value(s, flush * rows_a_flush + k));
      file.append(name(s), rows);
    }
    file.append("/frames/p", {.name = "p",
                              .unit = "",
                              .components = 1,
                              .values = std::vector<float>(50, static_cast<float>(flush))});
    file.flush();
  }
}

struct Seen {
  std::size_t rows = 0;
  std::size_t wrong = 0;
};

/// The last rows of each series, and the last frames. @throws H5::Exception
Seen look(const std::filesystem::path& path) {
  Seen seen;
  const H5::H5File file(path.string(), H5F_ACC_RDONLY);
  for (int s = 0; s < series; ++s) {
    const H5::DataSet dataset = file.openDataSet(name(s));
    const hsize_t rows = extent(dataset)[0], count = std::min<hsize_t>(rows, 5000), start = rows - count;
    std::vector<double> values(count);
    if (count == 0) continue;
    H5::DataSpace from = dataset.getSpace();
    from.selectHyperslab(H5S_SELECT_SET, &count, &start);
    dataset.read(values.data(), H5::PredType::NATIVE_DOUBLE, H5::DataSpace(1, &count), from);
    for (hsize_t k = 0; k < count; ++k) seen.wrong += values[k] != value(s, start + k);
    seen.rows = std::max<std::size_t>(seen.rows, rows);
  }
  const H5::DataSet frames = file.openDataSet("/frames/p");
  std::vector<hsize_t> size = extent(frames);
  if (size[0] == 0) return seen;
  const hsize_t start[] = {size[0] - 1, 0}, one[] = {1, size[1]};
  std::vector<float> last(size[1]);
  H5::DataSpace from = frames.getSpace();
  from.selectHyperslab(H5S_SELECT_SET, one, start);
  frames.read(last.data(), H5::PredType::NATIVE_FLOAT, H5::DataSpace(2, one), from);
  for (const float x : last) seen.wrong += x != static_cast<float>(size[0] - 1);
  return seen;
}

TEST(OrderedFile, ShowsReadersAndAfterAKillNothingWrong) {
  H5::Exception::dontPrint();
  const testing::ScratchFolder folder;
  const std::filesystem::path path = folder.path() / "results.h5";
  const pid_t writer = fork();
  if (writer == 0) write_without_end(path);
  Seen seen;
  std::size_t right = 0, tries = 0, most_rows = 0;
  const auto start = std::chrono::steady_clock::now();
  constexpr std::size_t many_rows = 200 * 1024;  // as many chunks need tables of two levels
  while (std::chrono::steady_clock::now() - start < std::chrono::seconds(most_rows < many_rows ? 60 : 3)) {
    ++tries;
    try {
      seen = look(path);
      ASSERT_EQ(seen.wrong, 0U) << "of the last of " << seen.rows << " rows";
      most_rows = std::max(most_rows, seen.rows);
      ++right;
    } catch (const H5::Exception&) {
      // It was written just then.
    }
  }
  kill(writer, SIGKILL);
  waitpid(writer, nullptr, 0);
  EXPECT_GT(right, tries / 10);
  EXPECT_GE(most_rows, many_rows);
  seen = look(path);
  EXPECT_EQ(seen.wrong, 0U);
  EXPECT_GE(seen.rows, most_rows);
}

}  // namespace
}  // namespace cosurge
