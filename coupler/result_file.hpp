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

/// The first `rows` numbers of a series that has so many. @throws Error where it has more dimensions than
/// one.
std::vector<double> first_rows(const H5::DataSet& series, hsize_t rows);

/// An attribute that is one text. @throws Error where it is something else.
std::string text_of(const H5::Attribute& attribute);

/// A file that grows. What was there at the last flush() can be read by any HDF5 reader at any time: during
/// the run, during a flush, and after it was killed. For that
/// - the writer takes no lock, and writes the oldest format, which knows no mark "open for writing";
/// - the file's index changes on disk in flush() only, in a safe order (ordered_file.hpp). Within it one
/// dataset may be longer than another; what each has is right;
/// - nothing that the index on disk points at is moved: series are not compressed, and frames are written
/// once.
/// All calls throw Error when the file cannot be written, and again from then on; what was flushed before
/// stays readable.
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

  /// A number a row; append() makes it longer.
  void add_series(const std::string& name, const std::string& unit);
  void append(const std::string& name, std::span<const double> rows);

  /// Frames x particles (x components, for vectors), as float32. The first frame sets the lengths.
  void append(const std::string& name, const Array& frame);

  /// Renames it, and replaces an existing file.
  void move(const std::filesystem::path& path);

  /// Afterwards all is on the disk, also where the machine fails. Where somebody has removed the file
  /// meanwhile, it is written again under its name, and the call throws: from then on nothing can be added.
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
  std::string displaced_;  // new state of the file; empty: unchanged
  std::map<std::string, H5::DataSet> growing_;
};

}  // namespace cosurge
