#include "coupler/build_id.hpp"

#include <fmt/format.h>
#include <link.h>

#include <cstring>

namespace cosurge {
namespace {

/// The build ID (a note of the GNU linker) in a segment of notes; empty if there is none.
std::string note_in(const char* bytes, std::size_t size) {
  const auto padded = [](std::size_t length) { return (length + 3) / 4 * 4; };
  while (size >= sizeof(ElfW(Nhdr))) {
    ElfW(Nhdr) note{};
    std::memcpy(&note, bytes, sizeof note);
    const std::size_t name = sizeof note, text = name + padded(note.n_namesz);
    const std::size_t end = text + padded(note.n_descsz);
    if (end > size) break;
    if (note.n_type == NT_GNU_BUILD_ID && note.n_namesz == 4 && std::memcmp(bytes + name, "GNU", 4) == 0) {
      std::string id;
      for (std::size_t k = 0; k < note.n_descsz; ++k)
        id += fmt::format("{:02x}", static_cast<unsigned char>(bytes[text + k]));
      return id;
    }
    bytes += end;
    size -= end;
  }
  return {};
}

/// Whether an object contains this function in one of its segments.
bool holds_this_code(const dl_phdr_info& object) {
  const auto here = reinterpret_cast<ElfW(Addr)>(&holds_this_code);
  for (int k = 0; k < object.dlpi_phnum; ++k) {
    const auto& segment = object.dlpi_phdr[k];
    const ElfW(Addr) begin = object.dlpi_addr + segment.p_vaddr;
    if (segment.p_type == PT_LOAD && begin <= here && here < begin + segment.p_memsz) return true;
  }
  return false;
}

/// The object with this code: the shared library, otherwise the program.
int look(dl_phdr_info* object, std::size_t, void* result) {
  if (!holds_this_code(*object)) return 0;
  for (int k = 0; k < object->dlpi_phnum; ++k) {
    const auto& segment = object->dlpi_phdr[k];
    if (segment.p_type != PT_NOTE) continue;
    // NOLINTNEXTLINE(performance-no-int-to-ptr): the system gives the address as a number
    const auto* bytes = reinterpret_cast<const char*>(object->dlpi_addr + segment.p_vaddr);
    const std::string id = note_in(bytes, segment.p_memsz);
    if (!id.empty()) *static_cast<std::string*>(result) = id;
  }
  return 1;
}

}  // namespace

std::string build_id() {
  std::string id;
  dl_iterate_phdr(look, &id);
  return id;
}

}  // namespace cosurge
