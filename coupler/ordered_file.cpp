#include "coupler/ordered_file.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <limits>
#include <map>
#include <set>
#include <string_view>
#include <vector>

namespace cosurge {
namespace {

using Bytes = std::vector<char>;

/// The beginning of a table of chunks (a node of a B-tree of version 1 in the format specification of HDF5):
/// "TREE", type (1 byte), level (1 byte), number of entries (2 bytes, least first), left and right sibling.
using TableHead = std::array<char, 24>;

bool is_table(const char* bytes, std::size_t size) {
  return size >= sizeof(TableHead) && std::string_view(bytes, 4) == "TREE";
}

int level(const char* table) { return static_cast<unsigned char>(table[5]); }

int entries(const char* table) {
  return static_cast<unsigned char>(table[6]) + 256 * static_cast<unsigned char>(table[7]);
}

/// A part of the index that is kept in memory until commit().
struct Block {
  H5FD_mem_t type;
  Bytes bytes;
};

/// HDF5 handles a driver by a pointer to its first member.
struct Driver {
  H5FD_t base{};
  int file = -1;
  haddr_t end_of_space = 0;  // address of the end of the space that HDF5 has allocated
  haddr_t end_of_file = 0;   // address of the end of the file on the disk
  int failure = 0;           // errno of the first write that failed; 0: none
  std::map<haddr_t, Block> waiting;
  std::set<haddr_t> written;           // addresses of the parts of the index that are on the disk
  std::map<haddr_t, TableHead> split;  // heads that split tables get when the file is closed, by address
};

Driver& of(H5FD_t* base) { return *reinterpret_cast<Driver*>(base); }
const Driver& of(const H5FD_t* base) { return *reinterpret_cast<const Driver*>(base); }

void check(Driver& driver, bool done) {
  if (!done && driver.failure == 0) driver.failure = errno == 0 ? EIO : errno;
}

/// Size of the blocks that the operating system writes as a whole, even if the process is killed.
constexpr haddr_t page = 4096;

/// Writes pages in descending order of their addresses. Changing parts of the index lie within one page
/// (allocate()); chunks only get rows after those that the index refers to.
void put(Driver& driver, haddr_t address, const char* bytes, std::size_t size) {
  haddr_t end = address + size;
  while (driver.failure == 0 && end > address) {
    const haddr_t begin = std::max(address, (end - 1) / page * page);
    const ssize_t written =
        pwrite(driver.file, bytes + (begin - address), end - begin, static_cast<off_t>(begin));
    if (written < 0 && errno == EINTR) continue;
    if (written >= 0 && written < static_cast<ssize_t>(end - begin)) errno = ENOSPC;
    check(driver, written == static_cast<ssize_t>(end - begin));
    end = begin;
  }
  driver.end_of_file = std::max(driver.end_of_file, address + size);
}

/// Flushes to the disk; otherwise a machine that fails may keep a later write and lose an earlier one.
/// EINVAL: not a file on a disk.
void reach_disk(Driver& driver) {
  if (driver.failure == 0) check(driver, fdatasync(driver.file) == 0 || errno == EINVAL);
}

void read_disk(Driver& driver, haddr_t address, std::size_t size, char* to) {
  std::size_t got = 0;
  while (got < size) {
    const ssize_t part = pread(driver.file, to + got, size - got, static_cast<off_t>(address + got));
    if (part < 0 && errno == EINTR) continue;
    if (part < 0) check(driver, false);
    if (part <= 0) break;
    got += static_cast<std::size_t>(part);
  }
  std::memset(to + got, 0, size - got);
}

/// Calls action(bytes of a waiting block, offset in the range, length) for every overlap of a waiting block
/// with the range.
template <typename Action>
void overlaps(Driver& driver, haddr_t address, std::size_t size, Action action) {
  for (auto& [place, block] : driver.waiting) {
    if (place >= address + size) break;
    const haddr_t begin = std::max(place, address);
    const haddr_t end = std::min(place + block.bytes.size(), address + size);
    if (begin < end) action(block.bytes.data() + (begin - place), begin - address, end - begin);
  }
}

/// Whether a table of chunks has lost entries since it was last written. HDF5 splits a full table by moving
/// its last entries to a new table. A reader that has read the parent table before this commit does not know
/// the new table, so the old table keeps its entries on the disk until the file is closed. Every lookup finds
/// the right chunk, because the new parent table refers to the new table for the moved entries.
bool keeps_its_entries(Driver& driver, haddr_t address, const Block& block) {
  if (!driver.written.contains(address) || !is_table(block.bytes.data(), block.bytes.size())) return false;
  TableHead head, on_disk;
  std::copy_n(block.bytes.begin(), head.size(), head.begin());
  read_disk(driver, address, on_disk.size(), on_disk.data());
  if (level(on_disk.data()) != level(head.data()) || entries(on_disk.data()) <= entries(head.data()))
    return false;
  driver.split[address] = head;
  return true;
}

/// Rank of a block in the order in which a commit writes.
int rank(const Driver& driver, haddr_t address, const Block& block) {
  constexpr int levels = 256;
  if (!driver.written.contains(address)) return 0;
  if (block.type == H5FD_MEM_SUPER) return 1;
  if (block.type == H5FD_MEM_OHDR) return 3 + levels;
  if (is_table(block.bytes.data(), block.bytes.size())) return 2 + levels - level(block.bytes.data());
  return 2;
}

void commit(Driver& driver) {
  std::multimap<int, haddr_t> order;
  for (const auto& [address, block] : driver.waiting) order.emplace(rank(driver, address, block), address);
  if (driver.failure == 0 && driver.end_of_space > driver.end_of_file)
    check(driver, ftruncate(driver.file, static_cast<off_t>(driver.end_of_space)) == 0);
  int last = 0;
  for (const auto& [rank, address] : order) {
    if (rank != last) reach_disk(driver);
    last = rank;
    const Block& block = driver.waiting.at(address);
    if (!keeps_its_entries(driver, address, block))
      put(driver, address, block.bytes.data(), block.bytes.size());
  }
  reach_disk(driver);
  if (driver.failure != 0) return;
  for (const auto& [rank, address] : order) driver.written.insert(address);
  driver.waiting.clear();
}

H5FD_t* open_file(const char* name, unsigned flags, hid_t, haddr_t) {
  if ((flags & H5F_ACC_CREAT) == 0) return nullptr;  // new files only
  const int file = open(name, O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (file < 0) return nullptr;
  auto* driver = new Driver;
  driver->file = file;
  return &driver->base;
}

herr_t close_file(H5FD_t* base) {
  Driver& driver = of(base);
  commit(driver);
  for (const auto& [address, head] : driver.split) put(driver, address, head.data(), head.size());
  // HDF5 frees allocated space at the end that it has not used.
  if (driver.failure == 0 && driver.end_of_file > driver.end_of_space)
    check(driver, ftruncate(driver.file, static_cast<off_t>(driver.end_of_space)) == 0);
  close(driver.file);
  delete &driver;
  return 0;
}

int compare(const H5FD_t* first, const H5FD_t* second) {
  return first < second ? -1 : static_cast<int>(first > second);
}

herr_t query(const H5FD_t*, unsigned long* flags) {
  *flags = H5FD_FEAT_AGGREGATE_METADATA | H5FD_FEAT_AGGREGATE_SMALLDATA | H5FD_FEAT_DATA_SIEVE;
  return 0;
}

haddr_t end_of_space(const H5FD_t* base, H5FD_mem_t) { return of(base).end_of_space; }

herr_t set_end_of_space(H5FD_t* base, H5FD_mem_t, haddr_t address) {
  of(base).end_of_space = address;
  return 0;
}

/// Allocates space at the end of the file. No part of the index crosses the border between two pages.
haddr_t allocate(H5FD_t* base, H5FD_mem_t type, hid_t, hsize_t size) {
  Driver& driver = of(base);
  haddr_t begin = driver.end_of_space;
  const bool crosses = begin / page != (begin + size - 1) / page;
  if (type != H5FD_MEM_DRAW && size <= page && crosses) begin = (begin + page - 1) / page * page;
  driver.end_of_space = begin + size;
  return begin;
}

haddr_t end_of_file(const H5FD_t* base, H5FD_mem_t) {
  return std::max(of(base).end_of_file, of(base).end_of_space);
}

herr_t handle(H5FD_t* base, hid_t, void** handle) {
  *handle = &of(base);
  return 0;
}

herr_t read_file(H5FD_t* base, H5FD_mem_t, hid_t, haddr_t address, std::size_t size, void* to) {
  Driver& driver = of(base);
  auto* bytes = static_cast<char*>(to);
  read_disk(driver, address, size, bytes);
  for (auto table = driver.split.lower_bound(address);  // HDF5 always reads complete tables
       table != driver.split.end() && table->first + sizeof(TableHead) <= address + size; ++table)
    std::memcpy(bytes + (table->first - address), table->second.data(), sizeof(TableHead));
  overlaps(driver, address, size, [&](const char* waiting, std::size_t at, std::size_t length) {
    std::memcpy(bytes + at, waiting, length);
  });
  return 0;
}

herr_t write_file(H5FD_t* base, H5FD_mem_t type, hid_t, haddr_t address, std::size_t size, const void* from) {
  Driver& driver = of(base);
  const auto* bytes = static_cast<const char*>(from);
  overlaps(driver, address, size, [&](char* waiting, std::size_t at, std::size_t length) {
    std::memcpy(waiting, bytes + at, length);
  });
  if (type == H5FD_MEM_DRAW) {
    put(driver, address, bytes, size);
  } else if (Block& block = driver.waiting[address]; block.bytes.size() < size) {
    block = {.type = type, .bytes = Bytes(bytes, bytes + size)};
  }
  return 0;
}

const H5FD_class_t& driver_class() {
  static const H5FD_class_t description = [] {
    H5FD_class_t driver{};
    driver.name = "cosurge_ordered";
    driver.maxaddr = static_cast<haddr_t>(std::numeric_limits<off_t>::max());
    driver.fc_degree = H5F_CLOSE_WEAK;
    driver.open = open_file;
    driver.close = close_file;
    driver.cmp = compare;
    driver.query = query;
    driver.alloc = allocate;
    driver.get_eoa = end_of_space;
    driver.set_eoa = set_end_of_space;
    driver.get_eof = end_of_file;
    driver.get_handle = handle;
    driver.read = read_file;
    driver.write = write_file;
    const H5FD_mem_t map[] = H5FD_FLMAP_DEFAULT;
    std::copy(std::begin(map), std::end(map), driver.fl_map);
    return driver;
  }();
  return description;
}

/// Limits HDF5's cache of the index, which would hold 32 MB of it, measured in the file; a node of the index
/// takes 2.6 kB there and 20 kB in memory. The cache holds the last node of each dataset and its parent
/// nodes.
void bound_cache(hid_t access) {
  constexpr std::size_t most = std::size_t{1} << 18;
  H5AC_cache_config_t cache{};
  cache.version = H5AC__CURR_CACHE_CONFIG_VERSION;
  H5Pget_mdc_config(access, &cache);
  cache.set_initial_size = true;
  cache.initial_size = cache.max_size = most;
  cache.min_size = most / 4;
  cache.incr_mode = H5C_incr__off;
  cache.flash_incr_mode = H5C_flash_incr__off;
  cache.decr_mode = H5C_decr__off;
  H5Pset_mdc_config(access, &cache);
}

}  // namespace

H5::FileAccPropList OrderedFile::access() {
  static const hid_t driver = H5FDregister(&driver_class());
  H5::FileAccPropList access;
  H5Pset_driver(access.getId(), driver, nullptr);
  H5Pset_meta_block_size(access.getId(), 0);  // so that each part of the index is allocated by allocate()
  bound_cache(access.getId());
  return access;
}

OrderedFile::OrderedFile(const H5::H5File& file) { file.getVFDHandle(&driver_); }

void OrderedFile::commit() { cosurge::commit(*static_cast<Driver*>(driver_)); }

bool OrderedFile::lies_at(const std::string& path) const {
  struct stat mine {
  }, there{};
  return fstat(static_cast<const Driver*>(driver_)->file, &mine) == 0 && stat(path.c_str(), &there) == 0 &&
         mine.st_dev == there.st_dev && mine.st_ino == there.st_ino;
}

bool OrderedFile::copy_to(const std::string& path) const {
  const Driver& driver = *static_cast<const Driver*>(driver_);
  const int copy = open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (copy < 0) return false;
  Bytes block(std::size_t{1} << 20);
  off_t at = 0;
  ssize_t got = 0;
  bool written = true;
  while (written && (got = pread(driver.file, block.data(), block.size(), at)) > 0) {
    written = pwrite(copy, block.data(), static_cast<std::size_t>(got), at) == got;
    at += got;
  }
  written = written && got == 0 && fsync(copy) == 0;
  close(copy);
  if (!written) unlink(path.c_str());
  return written;
}

int OrderedFile::failure() const { return static_cast<const Driver*>(driver_)->failure; }

}  // namespace cosurge
