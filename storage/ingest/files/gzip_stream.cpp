#include "storage/ingest/files/gzip_stream.hpp"

#include <archive.h>
#include <zlib.h>

#include <cerrno>

namespace floeplan::ingest {

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

}  // namespace floeplan::ingest
