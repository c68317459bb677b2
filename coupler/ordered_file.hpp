// An HDF5 file that can be read at every instant: a driver for HDF5 that changes the file in a safe order.
#pragma once

#include <H5Cpp.h>

namespace cosurge {

/// HDF5 writes its index (tables of chunks, lengths of datasets) in any order. A reader between two of these
/// writes, or any reader after the process was killed between them, would see lengths without numbers. This
/// driver keeps changes of the index in memory until commit(), and then writes
///   1. numbers, and parts of the index that nothing refers to yet,
///   2. how far the file reaches,
///   3. tables of chunks, those of higher levels first,
///   4. headers of datasets, with their lengths,
/// and each on the disk before the next. A table of chunks that HDF5 splits keeps the entries that have moved
/// to the new table until the file is closed: a reader may know only the old one. A table lies within one
/// page of 4096 bytes, which the system writes in one go: datasets may have three dimensions. It holds for
/// files that grow: nothing is moved or removed.
///
/// After a failed write nothing more is written to the file. HDF5 is not told, because it could not close the
/// file otherwise; failure() returns the reason.
class OrderedFile {
 public:
  /// Access properties of a new file with this driver.
  static H5::FileAccPropList access();

  /// `file`: with these properties.
  explicit OrderedFile(const H5::H5File& file);

  /// Writes to the disk everything that HDF5 has flushed since the last call.
  void commit();

  /// errno of the first write that failed; 0 if none has failed.
  int failure() const;

  /// Whether `path` still leads to this file: somebody may have removed or replaced it.
  bool lies_at(const std::string& path) const;

  /// Copies the content of the file to a new one, `path`. False if that fails, or it exists already.
  bool copy_to(const std::string& path) const;

 private:
  void* driver_ = nullptr;
};

}  // namespace cosurge
