#pragma once

#include <array>
#include <filesystem>

struct archive;
struct gzFile_s;

namespace floeplan::ingest {

/// A file that gzip compressed, unpacked for an archive reader with its checksums compared, which libarchive leaves
/// out.
class GzipStream {
 public:
  explicit GzipStream(const std::filesystem::path& file);
  GzipStream(const GzipStream&) = delete;
  GzipStream& operator=(const GzipStream&) = delete;
  ~GzipStream();

  [[nodiscard]] bool is_gzip() const;
  /// Opens the reader on the unpacked bytes; this object outlives it.
  /// Returns  as libarchive's functions do
  int feed(archive* reader);

 private:
  static long read(archive* reader, void* self, const void** block);

  gzFile_s* file_;
  std::array<char, 65536> block_{};
};

}  // namespace floeplan::ingest
