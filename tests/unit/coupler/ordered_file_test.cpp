// A reader finds nothing wrong after any single write of a commit, nor if it reads on both sides of a commit.
#include "coupler/ordered_file.hpp"

#include <gtest/gtest.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <fstream>
#include <functional>
#include <iterator>

#include "coupler/result_file.hpp"
#include "tests/support/scratch_folder.hpp"

namespace {

/// Called after every write of this program, while it is set.
std::function<void()> after_write;

}  // namespace

/// In place of the system library's.
extern "C" ssize_t pwrite(int file, const void* bytes, size_t size, off_t at) {
  const ssize_t written = syscall(SYS_pwrite64, file, bytes, size, at);
  if (after_write) after_write();
  return written;
}

namespace cosurge {
namespace {

constexpr int series = 3;
constexpr hsize_t rows_a_chunk = 16;
constexpr hsize_t rows_a_commit = 16 * 37 + 5;  // several chunks, the last one not full

double value(int which, hsize_t row) { return static_cast<double>(which + 1) + static_cast<double>(row); }

std::string name(int which) { return "s" + std::to_string(which); }

/// Rows of some datasets of chunks.
class Growing {
 public:
  explicit Growing(const std::filesystem::path& path)
      : file_(path.string(), H5F_ACC_EXCL, H5::FileCreatPropList::DEFAULT, OrderedFile::access()),
        order_(file_) {
    const hsize_t none = 0, endless = H5S_UNLIMITED;
    H5::DSetCreatPropList layout;
    layout.setChunk(1, &rows_a_chunk);
    for (int s = 0; s < series; ++s)
      datasets_.push_back(file_.createDataSet(name(s), H5::PredType::NATIVE_DOUBLE,
                                              H5::DataSpace(1, &none, &endless), layout));
    file_.flush(H5F_SCOPE_GLOBAL);
    order_.commit();
  }

  /// As far as HDF5 is concerned.
  void append() {
    const hsize_t size = rows_ + rows_a_commit;
    for (int s = 0; s < series; ++s) {
      std::vector<double> values;
      for (hsize_t row = rows_; row < size; ++row) values.push_back(value(s, row));
      H5::DataSet& dataset = datasets_[static_cast<std::size_t>(s)];
      dataset.extend(&size);
      H5::DataSpace target = dataset.getSpace();
      target.selectHyperslab(H5S_SELECT_SET, &rows_a_commit, &rows_);
      dataset.write(values.data(), H5::PredType::NATIVE_DOUBLE, H5::DataSpace(1, &rows_a_commit), target);
    }
    rows_ = size;
    file_.flush(H5F_SCOPE_GLOBAL);
  }

  void commit() { order_.commit(); }
  hsize_t rows() const { return rows_; }

 private:
  H5::H5File file_;
  OrderedFile order_;
  std::vector<H5::DataSet> datasets_;
  hsize_t rows_ = 0;
};

/// Rows of the longest series that a reader of the file finds. All of all series must be right.
hsize_t look(const std::filesystem::path& path) {
  hsize_t most = 0;
  const H5::H5File file(path.string(), H5F_ACC_RDONLY);
  for (int s = 0; s < series; ++s) {
    const H5::DataSet dataset = file.openDataSet(name(s));
    std::vector<double> values(extent(dataset)[0]);
    if (!values.empty()) dataset.read(values.data(), H5::PredType::NATIVE_DOUBLE);
    std::size_t wrong = 0;
    for (hsize_t row = 0; row < values.size(); ++row) wrong += values[row] != value(s, row);
    EXPECT_EQ(wrong, 0U) << "of " << values.size() << " rows of " << name(s);
    most = std::max<hsize_t>(most, values.size());
  }
  return most;
}

TEST(OrderedFile, IsRightAfterEveryWriteOfACommit) {
  H5::Exception::dontPrint();
  const testing::ScratchFolder folder;
  const std::filesystem::path path = folder.path() / "file.h5";
  Growing file(path);
  constexpr int commits = 40;  // tables of chunks get three levels
  int looks = 0;
  for (int k = 0; k < commits && !HasFailure(); ++k) {
    const hsize_t before = file.rows();
    file.append();
    ASSERT_EQ(look(path), before) << "nothing is to be seen before the commit";
    hsize_t seen = before;
    after_write = [&] {
      ++looks;
      const hsize_t rows = look(path);
      EXPECT_TRUE(rows == before || rows == file.rows()) << rows;
      EXPECT_GE(rows, seen);
      seen = rows;
    };
    EXPECT_NO_THROW(file.commit()) << "a reader got an error";
    after_write = nullptr;
    EXPECT_EQ(look(path), file.rows());
  }
  EXPECT_GT(looks, 10 * commits);
}

using Bytes = std::string;

Bytes bytes_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// What a reader sees that reads the headers of the datasets and the tables of chunks above `level` before a
/// commit, and the lower ones and the numbers after it. It takes the length of the file from after the
/// commit: with that from before, HDF5 gives an error instead of numbers in new tables.
Bytes read_on_both_sides(const Bytes& before, const Bytes& after, int level) {
  constexpr std::size_t keys = 65, children = 64;
  constexpr std::size_t table = 24 + keys * 24 + children * 8;  // format of HDF5, datasets of one dimension
  constexpr std::size_t superblock = 96;
  Bytes seen = after.substr(0, superblock) + before.substr(superblock) + after.substr(before.size());
  for (std::size_t at = after.find("TREE"); at != Bytes::npos; at = after.find("TREE", at + table)) {
    const bool of_chunks = after[at + 4] == 1;
    if (of_chunks && after[at + 5] <= level) seen.replace(at, table, after, at, table);
  }
  return seen;
}

TEST(OrderedFile, IsRightForAReaderThatReadsOnBothSidesOfACommit) {
  H5::Exception::dontPrint();
  const testing::ScratchFolder folder;
  const std::filesystem::path path = folder.path() / "file.h5", hybrid = folder.path() / "hybrid.h5";
  hsize_t rows = 0;
  {
    Growing file(path);
    for (int k = 0; k < 40 && !HasFailure(); ++k) {  // tables of chunks get three levels
      const hsize_t seen = file.rows();
      const Bytes before = bytes_of(path);
      file.append();
      file.commit();
      const Bytes after = bytes_of(path);
      for (const int level : {0, 1}) {
        std::ofstream(hybrid, std::ios::binary) << read_on_both_sides(before, after, level);
        EXPECT_EQ(look(hybrid), seen) << "commit " << k << ", new tables up to level " << level;
      }
    }
    rows = file.rows();
  }
  EXPECT_EQ(look(path), rows);
  const H5::H5File file(path.string(), H5F_ACC_RDONLY);
  const H5::DataSet dataset = file.openDataSet(name(0));
  hsize_t chunks = 0;
  ASSERT_GE(H5Dget_num_chunks(dataset.getId(), dataset.getSpace().getId(), &chunks), 0);
  EXPECT_EQ(chunks, (rows + rows_a_chunk - 1) / rows_a_chunk)
      << "a closed file has each chunk in one table only";
}

}  // namespace
}  // namespace cosurge
