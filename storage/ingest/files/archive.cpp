#include "storage/ingest/files/archive.hpp"

#include <archive.h>
#include <archive_entry.h>
#include <zlib.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <string_view>

#include "engine/messages/ingest_file_messages.hpp"
#include "storage/ingest/files/first_bytes.hpp"
#include "storage/ingest/files/sidecar.hpp"
#include "storage/ingest/notation/text.hpp"

namespace floeplan::ingest {
namespace {

/// Unpacks a gzip file for a libarchive reader and compares its checksums, which libarchive itself does not.
class GzipStream {
 public:
  explicit GzipStream(const std::filesystem::path& file);
  GzipStream(const GzipStream&) = delete;
  GzipStream& operator=(const GzipStream&) = delete;
  ~GzipStream();

  [[nodiscard]] bool is_gzip() const;
  /// Opens the reader on the unpacked bytes. This object must outlive the reader.
  /// Returns  ARCHIVE_OK or an error code of libarchive
  int feed(archive* reader);

 private:
  static long read(archive* reader, void* self, const void** block);

  gzFile_s* file_;
  std::array<char, 65536> block_{};
};

GzipStream::GzipStream(const std::filesystem::path& file) : file_{gzopen(file.c_str(), "rb")} {}

GzipStream::~GzipStream() { gzclose(file_); }

bool GzipStream::is_gzip() const { return file_ != nullptr && gzdirect(file_) == 0; }

int GzipStream::feed(archive* reader) {
  return archive_read_open(
      reader, this, nullptr,
      [](archive* opened, void* self, const void** block) -> la_ssize_t { return read(opened, self, block); },
      nullptr);
}

long GzipStream::read(archive* reader, void* self, const void** block) {
  auto& stream = *static_cast<GzipStream*>(self);
  *block = stream.block_.data();
  const int got = gzread(stream.file_, stream.block_.data(), static_cast<unsigned>(stream.block_.size()));
  int fault = Z_OK;
  const char* const reason = gzerror(stream.file_, &fault);
  if (got >= 0 && fault == Z_OK) return got;
  archive_set_error(reader, EILSEQ, "%s", reason);
  return ARCHIVE_FATAL;
}

namespace fs = std::filesystem;
using namespace std::string_view_literals;

constexpr std::size_t most_entries = 100'000;  // a Zarr store of one year has about as many chunks
constexpr std::size_t most_folders_deep = 16;
constexpr std::size_t longest_name = 200;  // bytes
constexpr std::size_t through_magic_of_tar = 512;

struct Close {
  void operator()(struct archive* opened) const { archive_read_free(opened); }
};
using Archive = std::unique_ptr<struct archive, Close>;

messages::Message damaged(struct archive* opened) {
  const char* const reason = archive_error_string(opened);
  return messages::ingest_file_message<"archive-damaged">(reason != nullptr ? reason : "no reason given");
}

/// Opens the formats and compressions that agencies use. Those that start other programs stay off.
Archive new_reader() {
  Archive opened{archive_read_new()};
  for (const auto support :
       {archive_read_support_format_zip, archive_read_support_format_tar, archive_read_support_format_raw,
        archive_read_support_filter_bzip2, archive_read_support_filter_xz, archive_read_support_filter_zstd,
        archive_read_support_filter_compress})
    support(opened.get());
  return opened;
}

/// The path of an entry below the folder; empty if its name leads out of the folder.
std::optional<fs::path> safe_name(std::string name) {
  std::ranges::replace(name, '\\', '/');  // archives made on Windows
  if (name.empty() || name.front() == '/' || (name.size() > 1 && name[1] == ':')) return std::nullopt;
  fs::path result;
  std::size_t depth = 0;
  for (const fs::path& part : fs::path{name}) {
    std::string word = part.string();
    if (word.empty() || word == ".") continue;
    if (word == ".." || word.size() > longest_name || ++depth > most_folders_deep) return std::nullopt;
    std::ranges::replace_if(word, [](unsigned char c) { return c < 32 || c == 127; }, '_');
    result /= word;
  }
  return result.empty() ? std::nullopt : std::optional{result};
}

/// Whether an entry was added by an operating system: "__MACOSX/._ice.shp", "Thumbs.db".
bool is_litter(const fs::path& name) {
  const std::string file = name.filename();
  return *name.begin() == "__MACOSX" || file.starts_with("._") || file == ".DS_Store" ||
         file == "Thumbs.db" || file == "desktop.ini";
}

/// An entry's name. A single compressed file has none; it gets the archive's name without the ending.
std::string name_of(struct archive* opened, archive_entry* entry, const fs::path& archive) {
  if (archive_format(opened) == ARCHIVE_FORMAT_RAW) return archive.stem();
  const char* name = archive_entry_pathname_utf8(entry);
  if (name == nullptr) name = archive_entry_pathname(entry);
  return name != nullptr ? name : "";
}

/// How much more may be unpacked.
struct Room {
  std::uint64_t left_bytes{};
  std::size_t left_entries{most_entries};
};

Checked<void> write_entry(struct archive* opened, const fs::path& target, Room& room) {
  std::error_code error;
  fs::create_directories(target.parent_path(), error);
  if (error || fs::exists(target))
    return refuse(messages::ingest_file_message<"archive-name-twice">(target.filename().string()));
  std::ofstream out{target, std::ios::binary};
  const void* block = nullptr;
  std::size_t size = 0;
  la_int64_t offset = 0;
  std::uint64_t written = 0;
  while (true) {
    const int got = archive_read_data_block(opened, &block, &size, &offset);
    if (got == ARCHIVE_EOF) break;
    if (got != ARCHIVE_OK) return refuse(damaged(opened));
    if (static_cast<std::uint64_t>(offset) != written)
      return refuse(messages::ingest_file_message<"archive-with-gaps">());
    if (size > room.left_bytes) return refuse(messages::ingest_file_message<"archive-unpacks-to-too-much">());
    room.left_bytes -= size;
    written += size;
    out.write(static_cast<const char*>(block), static_cast<std::streamsize>(size));
    if (!out) return refuse(messages::ingest_file_message<"archive-disk-full">());
  }
  return {};
}

Checked<void> lay_out(struct archive* opened, archive_entry* entry, const fs::path& archive,
                      const fs::path& folder, Room& room) {
  const std::string name = name_of(opened, entry, archive);
  const auto type = archive_entry_filetype(entry);
  if (room.left_entries-- == 0) return refuse(messages::ingest_file_message<"archive-with-too-many-files">());
  if (type == AE_IFDIR) return {};
  const auto place = safe_name(name);
  if (!place || type != AE_IFREG || archive_entry_hardlink(entry) != nullptr)
    return refuse(messages::ingest_file_message<"archive-leads-out">(name.substr(0, longest_name)));
  if (is_litter(*place)) return {};
  if (archive_entry_is_encrypted(entry) != 0)
    return refuse(messages::ingest_file_message<"archive-with-password">());
  return write_entry(opened, folder / *place, room);
}

/// Whether the ending is that of a document. Its content may still be data.
bool is_document(const fs::path& file) {
  constexpr std::array endings{".txt", ".xml", ".html", ".htm", ".pdf", ".md",   ".doc", ".docx", ".png",
                               ".jpg", ".gif", ".svg",  ".qml", ".sld", ".lyr",  ".url", ".css",  ".md5",
                               ".sum", ".bmp", ".qmd",  ".qgs", ".log", ".json", ".csv", ".031"};
  const std::string ending = lower(file.extension().string());
  return std::ranges::find(endings, ending) != endings.end();
}

bool is_zarr_store(const fs::path& folder) {
  return fs::exists(folder / ".zgroup") || fs::exists(folder / "zarr.json");
}

/// Every file below a folder, and every Zarr store as a whole.
void gather_files(const fs::path& folder, std::vector<fs::path>& found) {
  if (is_zarr_store(folder)) return found.push_back(folder);
  for (const auto& entry : fs::directory_iterator{folder}) {
    if (entry.is_directory()) {
      gather_files(entry.path(), found);
    } else {
      found.push_back(entry.path());
    }
  }
}

Checked<Unpacked> sorted_out(const fs::path& folder, const std::function<bool(const fs::path&)>& is_data) {
  std::vector<fs::path> all;
  gather_files(folder, all);
  std::ranges::sort(all);
  Unpacked unpacked;
  for (const fs::path& file : all) {
    if (std::ranges::any_of(all, [&](const fs::path& other) { return is_sidecar_of(file, other); })) continue;
    if (!fs::is_directory(file) && is_document(file) && !is_data(file)) {
      unpacked.left_out.push_back(file.lexically_relative(folder).generic_string());
    } else {
      unpacked.data.push_back(file);
    }
  }
  if (unpacked.data.empty())
    return refuse(messages::ingest_file_message<"archive-without-data">(
        unpacked.left_out.empty() ? "" : ", but only " + enumeration(unpacked.left_out)));
  return unpacked;
}

}  // namespace

bool is_archive(const fs::path& file) {
  std::error_code error;
  if (!fs::is_regular_file(file, error)) return false;
  const std::string head = first_bytes(file, through_magic_of_tar);
  const auto starts = [&](std::string_view magic) { return head.starts_with(magic); };
  constexpr std::size_t magic_of_tar = 257;
  return starts("PK\x03\x04") || starts("\x1f\x8b") || starts("\x1f\x9d") || starts("BZh") ||
         starts(
             "\xfd"
             "7zXZ"sv) ||
         starts("\x28\xb5\x2f\xfd") ||
         (head.size() > magic_of_tar + 5 && head.substr(magic_of_tar, 5) == "ustar");
}

std::uint64_t most_unpacked_bytes(std::uint64_t packed_bytes) { return 128'000'000 + 50 * packed_bytes; }

Checked<Unpacked> unpack(const fs::path& archive, const fs::path& folder,
                         const std::function<bool(const fs::path&)>& is_data) {
  const Archive opened = new_reader();
  GzipStream gzip{archive};
  constexpr std::size_t block_bytes = 1 << 16;
  const int status = gzip.is_gzip() ? gzip.feed(opened.get())
                                    : archive_read_open_filename(opened.get(), archive.c_str(), block_bytes);
  if (status != ARCHIVE_OK) return refuse(damaged(opened.get()));
  Room room{.left_bytes = most_unpacked_bytes(fs::file_size(archive))};
  archive_entry* entry = nullptr;
  while (true) {
    const int got = archive_read_next_header(opened.get(), &entry);
    if (got == ARCHIVE_EOF) break;
    if (got < ARCHIVE_WARN) return refuse(damaged(opened.get()));
    if (const auto laid = lay_out(opened.get(), entry, archive, folder, room); !laid)
      return refuse(laid.error());
  }
  return sorted_out(folder, is_data);
}

}  // namespace floeplan::ingest
