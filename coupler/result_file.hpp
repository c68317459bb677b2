// The HDF5 file of a run.
#pragma once

#include <H5Cpp.h>

#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "common/participant.hpp"
#include "coupler/ordered_file.hpp"

namespace cosurge {

/// Lengths of a dataset's dimensions.
std::vector<hsize_t> extent(const H5::DataSet& dataset);

/// The first `rows` numbers of a series, which must have as many. @throws Error if it has more than one
/// dimension.
std::vector<double> first_rows(const H5::DataSet& series, hsize_t rows);

/// An attribute that is one text. @throws Error where it is something else.
std::string text_of(const H5::Attribute& attribute);

/// The HDF5 file of a run, which grows. Its content at the last flush() can be read by any HDF5 reader at any
/// time: during the run, during a flush, and after the process was killed. For this purpose
/// - the writer takes no lock, and uses the oldest format, which has no mark "open for writing";
/// - the index of the file changes on the disk only in flush(), in a safe order (ordered_file.hpp); during a
/// flush some datasets may be longer than others, but all their values are valid;
/// - nothing that the index on the disk refers to is moved: series are not compressed, and frames are written
/// once.
/// After a failed write all calls throw Error; what was flushed before stays readable.
class ResultFile {
 public:
  /// @throws Error when `path` exists.
  explicit ResultFile(const std::filesystem::path& path);

  /// An attribute of the root.
  void describe(const std::string& name, const std::string& text);
  void describe(const std::string& name, int number);

  /// Numbers that stay: one row a column of `field`.
  void put(const std::string& name, const std::string& unit, const Field& field);
  void put(const std::string& name, const std::vector<int>& numbers);
  /// The same in rows of `columns` numbers.
  void put(const std::string& name, const std::vector<int>& numbers, int columns);

  /// A series with one number per row; append() extends it.
  void add_series(const std::string& name, const std::string& unit);
  void append(const std::string& name, std::span<const double> rows);

  /// Frames x particles (x components, for vectors), as float32. The first frame sets the lengths.
  void append(const std::string& name, const Array& frame);

  /// Renames it, and replaces an existing file.
  void move(const std::filesystem::path& path);

  /// Afterwards everything is on the disk, even if the machine fails. If somebody has removed the file, it is
  /// written again under its name and the call throws Error: nothing can be added to it.
  void flush();

 private:
  void require_place();
  template <typename Action>
  void attempt(const std::string& doing, Action action);
  H5::DataSet create(const std::string& name, const std::string& unit, const H5::DataType& type,
                     const H5::DataSpace& space, const H5::DSetCreatPropList& layout);
  H5::DataSet& frames(const std::string& name, const Array& like);

  std::string path_;
  H5::H5File file_;
  std::optional<OrderedFile> order_;
  std::string displaced_;  // copy of the state under the new name; empty: unchanged
  std::map<std::string, H5::DataSet> growing_;
};

}  // namespace cosurge
