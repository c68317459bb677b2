// After every single write of a commit, a reader finds nothing wrong.
#include "coupler/ordered_file.hpp"

#include <gtest/gtest.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <functional>

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

}  // namespace
}  // namespace cosurge
