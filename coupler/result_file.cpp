#include "coupler/result_file.hpp"

#include <algorithm>
#include <cerrno>
#include <system_error>
#include <vector>

#include "common/error.hpp"

namespace cosurge {
namespace {

constexpr hsize_t rows_a_chunk = 1024;
constexpr hsize_t particles_a_chunk = 65536;
constexpr int deflate_level = 4;
constexpr std::size_t cached_slots = 3;
constexpr std::size_t cached_bytes = 2 * rows_a_chunk * sizeof(double);

H5::StrType text_type() {
  H5::StrType type(H5::PredType::C_S1, H5T_VARIABLE);
  type.setCset(H5T_CSET_UTF8);
  return type;
}

/// Appends `rows` entries of the first dimension.
void extend(H5::DataSet& dataset, hsize_t rows, const void* values, const H5::DataType& type) {
  std::vector<hsize_t> size = extent(dataset);
  std::vector<hsize_t> start(size.size(), 0);
  start[0] = size[0];
  size[0] += rows;
  dataset.extend(size.data());
  size[0] = rows;
  H5::DataSpace target = dataset.getSpace();
  target.selectHyperslab(H5S_SELECT_SET, size.data(), start.data());
  dataset.write(values, type, H5::DataSpace(static_cast<int>(size.size()), size.data()), target);
}

}  // namespace

std::vector<hsize_t> extent(const H5::DataSet& dataset) {
  const H5::DataSpace space = dataset.getSpace();
  std::vector<hsize_t> size(static_cast<std::size_t>(space.getSimpleExtentNdims()));
  space.getSimpleExtentDims(size.data());
  return size;
}

std::vector<double> first_rows(const H5::DataSet& series, hsize_t rows) {
  const H5::DataSpace source = series.getSpace();
  require(source.getSimpleExtentNdims() == 1,
          "{} has {} dimensions instead of 1: it is not a history of Cosurge", series.getObjName(),
          source.getSimpleExtentNdims());
  std::vector<double> values(rows);
  if (rows == 0) return values;
  const hsize_t start = 0;
  source.selectHyperslab(H5S_SELECT_SET, &rows, &start);
  series.read(values.data(), H5::PredType::NATIVE_DOUBLE, H5::DataSpace(1, &rows), source);
  return values;
}

std::string text_of(const H5::Attribute& attribute) {
  const bool one =
      attribute.getTypeClass() == H5T_STRING && attribute.getSpace().getSimpleExtentNpoints() == 1;
  require(one, "the attribute {} is not one text", attribute.getName());  // HDF5 would read beyond its end
  std::string text;
  attribute.read(attribute.getStrType(), text);
  return text;
}

template <typename Action>
void ResultFile::attempt(const std::string& doing, Action action) {
  errno = 0;
  try {
    action();
  } catch (const H5::Exception& exception) {  // not a std::exception
    const int cause = errno;
    throw Error(fmt::format("{}: {}: {}", path_, doing,
                            cause != 0 ? std::generic_category().message(cause) : exception.getDetailMsg()));
  }
  if (order_ && order_->failure() != 0)
    throw Error(fmt::format("{}: {}: {}", path_, doing, std::generic_category().message(order_->failure())));
}

ResultFile::ResultFile(const std::filesystem::path& path) : path_(path.string()) {
  H5::Exception::dontPrint();
  require(!std::filesystem::exists(path), "{}: exists already; results are never overwritten", path_);
  attempt("cannot be created", [&] {
    H5::FileAccPropList access = OrderedFile::access();
    access.setLibverBounds(H5F_LIBVER_EARLIEST, H5F_LIBVER_LATEST);
    file_ = H5::H5File(path_, H5F_ACC_EXCL, H5::FileCreatPropList::DEFAULT, access);
    order_.emplace(file_);
  });
}

void ResultFile::describe(const std::string& name, const std::string& text) {
  attempt("cannot write attribute " + name,
          [&] { file_.createAttribute(name, text_type(), H5::DataSpace()).write(text_type(), text); });
}

void ResultFile::describe(const std::string& name, int number) {
  attempt("cannot write attribute " + name, [&] {
    file_.createAttribute(name, H5::PredType::NATIVE_INT, H5::DataSpace())
        .write(H5::PredType::NATIVE_INT, &number);
  });
}

H5::DataSet ResultFile::create(const std::string& name, const std::string& unit, const H5::DataType& type,
                               const H5::DataSpace& space, const H5::DSetCreatPropList& layout) {
  H5::LinkCreatPropList link;
  link.setCreateIntermediateGroup(true);
  // Rows are added to the last chunk, frames to new ones: no old chunks are cached (HDF5 would keep 1 MB for
  // each dataset).
  H5::DSetAccPropList access;
  access.setChunkCache(cached_slots, cached_bytes, 1);
  H5::DataSet dataset = file_.createDataSet(name, type, space, layout, access, link);
  if (!unit.empty()) dataset.createAttribute("unit", text_type(), H5::DataSpace()).write(text_type(), unit);
  return dataset;
}

void ResultFile::put(const std::string& name, const std::string& unit, const Field& field) {
  attempt("cannot write " + name, [&] {
    const hsize_t size[] = {static_cast<hsize_t>(field.cols()), static_cast<hsize_t>(field.rows())};
    create(name, unit, H5::PredType::NATIVE_DOUBLE, H5::DataSpace(2, size), H5::DSetCreatPropList::DEFAULT)
        .write(field.data(), H5::PredType::NATIVE_DOUBLE);
  });
}

void ResultFile::put(const std::string& name, const std::vector<int>& numbers) {
  attempt("cannot write " + name, [&] {
    const hsize_t size = numbers.size();
    create(name, "", H5::PredType::NATIVE_INT, H5::DataSpace(1, &size), H5::DSetCreatPropList::DEFAULT)
        .write(numbers.data(), H5::PredType::NATIVE_INT);
  });
}

void ResultFile::put(const std::string& name, const std::vector<int>& numbers, int columns) {
  attempt("cannot write " + name, [&] {
    const hsize_t size[] = {numbers.size() / static_cast<hsize_t>(columns), static_cast<hsize_t>(columns)};
    create(name, "", H5::PredType::NATIVE_INT, H5::DataSpace(2, size), H5::DSetCreatPropList::DEFAULT)
        .write(numbers.data(), H5::PredType::NATIVE_INT);
  });
}

void ResultFile::add_series(const std::string& name, const std::string& unit) {
  attempt("cannot make " + name, [&] {
    const hsize_t none = 0, endless = H5S_UNLIMITED, chunk = rows_a_chunk;
    H5::DSetCreatPropList layout;
    layout.setChunk(1, &chunk);
    growing_[name] =
        create(name, unit, H5::PredType::NATIVE_DOUBLE, H5::DataSpace(1, &none, &endless), layout);
  });
}

void ResultFile::append(const std::string& name, std::span<const double> rows) {
  if (rows.empty()) return;
  attempt("cannot write " + name,
          [&] { extend(growing_.at(name), rows.size(), rows.data(), H5::PredType::NATIVE_DOUBLE); });
}

H5::DataSet& ResultFile::frames(const std::string& name, const Array& like) {
  const auto found = growing_.find(name);
  if (found != growing_.end()) return found->second;
  const auto components = static_cast<hsize_t>(like.components);
  const hsize_t particles = like.values.size() / components;
  const int rank = components == 1 ? 2 : 3;
  const hsize_t none[] = {0, particles, components};
  const hsize_t endless[] = {H5S_UNLIMITED, std::max<hsize_t>(particles, 1), components};
  const hsize_t chunk[] = {1, std::clamp<hsize_t>(particles, 1, particles_a_chunk), components};
  H5::DSetCreatPropList layout;
  layout.setChunk(rank, chunk);
  layout.setShuffle();
  layout.setDeflate(deflate_level);
  return growing_[name] =
             create(name, like.unit, H5::PredType::NATIVE_FLOAT, H5::DataSpace(rank, none, endless), layout);
}

void ResultFile::append(const std::string& name, const Array& frame) {
  attempt("cannot write " + name, [&] {
    H5::DataSet& dataset = frames(name, frame);
    std::vector<hsize_t> size = extent(dataset);
    size[0] = 1;
    hsize_t values = 1;
    for (const hsize_t side : size) values *= side;
    require(frame.values.size() == values, "{}: a frame of {} values after frames of {}", name,
            frame.values.size(), values);
    extend(dataset, 1, frame.values.data(), H5::PredType::NATIVE_FLOAT);
  });
}

void ResultFile::move(const std::filesystem::path& path) {
  std::error_code failed;
  std::filesystem::rename(path_, path, failed);
  require(!failed, "{}: cannot be renamed to {}: {}", path_, path.string(), failed.message());
  path_ = path.string();
}

void ResultFile::flush() {
  attempt("cannot be flushed", [&] {
    file_.flush(H5F_SCOPE_GLOBAL);
    order_->commit();
  });
  require_place();
}

/// Writes the file under a new name if it was removed; a file without a name is lost at the end of the
/// program.
void ResultFile::require_place() {
  if (displaced_.empty() && !order_->lies_at(path_)) {
    displaced_ = order_->copy_to(path_)
                     ? fmt::format(
                           "{}: was removed during the run; it has been written again in full, and the run "
                           "can be resumed",
                           path_)
                     : fmt::format(
                           "{}: was removed or replaced during the run, and cannot be written again: the "
                           "recorded data are lost; run the case again with another --out",
                           path_);
  }
  require(displaced_.empty(), "{}", displaced_);
}

}  // namespace cosurge
