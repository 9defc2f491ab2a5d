#include "storage/ingest/formats/hdf5/hdf5_references.hpp"

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "engine/messages/ingest_file_messages.hpp"
#include "engine/messages/ingest_hdf5_messages.hpp"
#include "storage/ingest/files/first_bytes.hpp"
#include "storage/ingest/formats/hdf5/hdf5_library.hpp"

namespace floeplan::ingest {
namespace {

constexpr std::uintmax_t looked_at = 64U << 20U;
constexpr std::string_view heap_signature{"GCOL\x01\0\0\0", 8};  // signature, version 1, three zero bytes
// header of a heap, and of an object in a heap
constexpr std::size_t heap_header_bytes = 16;

/// A little-endian number at byte `at`. All libraries of today write lengths with eight bytes.
template <class Number>
Number heap_number(std::string_view bytes, std::size_t at) {
  Number number{};
  std::memcpy(&number, bytes.data() + at, sizeof number);
  return number;
}

/// Whether all objects fit into their heap. They follow each other, padded to eight bytes; object 0 is the
/// free space.
bool objects_fit(std::string_view heap) {
  std::size_t at = heap_header_bytes;
  while (at + heap_header_bytes <= heap.size()) {
    const auto object = heap_number<std::uint16_t>(heap, at);
    const auto size = heap_number<std::uint64_t>(heap, at + 8);
    if (object == 0) return size <= heap.size() - at;
    if (size > heap.size() - at - heap_header_bytes) return false;
    at += heap_header_bytes + static_cast<std::size_t>((size + 7) / 8 * 8);
  }
  return true;
}

/// Whether the heaps of an HDF5 file are consistent. They hold texts and lists of varying length. HDF5 1.10
/// copies as many bytes as an object claims, even from beyond its heap, and crashes.
/// Accuracy only heaps in the first 64 MB are checked, where nearly all files have theirs; checking more
/// takes longer than reading the values
/// Source   HDF5 file format specification 3.0, section III.E, "Disk Format: Level 1E - Global Heap"
bool hdf5_heaps_are_whole(const std::filesystem::path& file) {
  const std::string bytes = first_bytes(file, looked_at);
  const std::string_view all{bytes};
  for (std::size_t at = all.find(heap_signature); at != std::string_view::npos;
       at = all.find(heap_signature, at + 1)) {
    if (at + heap_header_bytes > all.size()) return true;
    const auto size = heap_number<std::uint64_t>(all, at + 8);
    // the heap continues beyond the checked bytes
    const bool goes_on = all.size() == looked_at && size > all.size() - at;
    if (goes_on) return true;
    if (size > all.size() - at || !objects_fit(all.substr(at, static_cast<std::size_t>(size)))) return false;
  }
  return true;
}

/// The filters that every HDF5 library has. Any other filter is a plugin.
bool is_built_in(H5Z_filter_t filter) {
  return filter >= H5Z_FILTER_DEFLATE && filter <= H5Z_FILTER_SCALEOFFSET;
}

/// Why a dataset needs other files or programs to be read; empty if it does not.
std::optional<std::string> foreign_part_of(hid_t creation) {
  const H5D_layout_t layout = H5Pget_layout(creation);
  if (layout == H5D_VIRTUAL) return "is put together from other files (a virtual dataset)";
  const int files = H5Pget_external_count(creation);
  const int filters = H5Pget_nfilters(creation);
  if (layout < 0 || files < 0 || filters < 0) return "cannot be looked at";
  if (files > 0) return "has its values in another file";
  for (int i = 0; i < filters; ++i) {
    unsigned flags = 0;
    unsigned options = 0;
    std::size_t values = 0;
    const H5Z_filter_t filter =
        H5Pget_filter2(creation, static_cast<unsigned>(i), &flags, &values, nullptr, 0, nullptr, &options);
    if (!is_built_in(filter)) return "is packed by a method that this program does not have";
  }
  return std::nullopt;
}

/// The same for the object with this name in a group.
std::optional<std::string> foreign_part_of(hid_t parent, const char* name) {
  const Hdf5Handle<H5Oclose> object{H5Oopen(parent, name, H5P_DEFAULT)};
  if (!object) return "cannot be opened";
  if (H5Iget_type(object.get()) != H5I_DATASET) return std::nullopt;
  const Hdf5Handle<H5Pclose> creation{H5Dget_create_plist(object.get())};
  if (!creation) return "cannot be looked at";
  return foreign_part_of(creation.get());
}

/// Called for each link of the file; `found` is a Checked<bool>. Stops at the first link that leads out of
/// the file or cannot be followed. A soft link points to another name in this file, which is visited as well.
herr_t visit(hid_t parent, const char* name, const H5L_info_t* link, void* found) {
  std::optional<std::string> reason;
  switch (link->type) {
    case H5L_TYPE_HARD: reason = foreign_part_of(parent, name); break;
    case H5L_TYPE_SOFT: break;
    default: reason = "is a link to another file";
  }
  if (!reason) return 0;
  *static_cast<Checked<bool>*>(found) =
      refuse(messages::ingest_hdf5_message<"hdf-leads-elsewhere">(name, *reason));
  return 1;
}

Checked<bool> cannot_be_walked() { return refuse(messages::ingest_hdf5_message<"hdf-hides-something">()); }

}  // namespace

Checked<bool> check_hdf5_references(const std::filesystem::path& file) {
  const QuietHdf5 quiet;
  if (first_bytes(file, 8) != "\x89HDF\r\n\x1a\n") return true;
  if (!hdf5_heaps_are_whole(file))
    return refuse(messages::ingest_file_message<"file-damaged">("HDF5 file", "a text goes beyond its heap"));
  const Hdf5Handle<H5Fclose> opened{H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT)};
  Checked<bool> found = true;
  if (!opened) return cannot_be_walked();
  const herr_t walked = H5Lvisit(opened.get(), H5_INDEX_NAME, H5_ITER_NATIVE, visit, &found);
  return walked < 0 && found ? cannot_be_walked() : found;
}

}  // namespace floeplan::ingest
