#include "api/codec/bytes/zip_archive.hpp"

#include <archive.h>
#include <archive_entry.h>

#include <memory>
#include <stdexcept>

namespace floeplan::codec {
namespace {

la_ssize_t append(archive*, void* target, const void* bytes, size_t length) {
  static_cast<std::string*>(target)->append(static_cast<const char*>(bytes), length);
  return static_cast<la_ssize_t>(length);
}

}  // namespace

std::string zip_archive(const std::vector<ArchivedFile>& files, core::UtcTime modified) {
  std::string bytes;
  const std::unique_ptr<archive, int (*)(archive*)> writer{archive_write_new(), archive_write_free};
  const auto require = [&](int status) {
    if (status != ARCHIVE_OK) throw std::runtime_error{"the ZIP archive could not be written"};
  };
  require(archive_write_set_format_zip(writer.get()));
  require(archive_write_set_bytes_in_last_block(writer.get(), 1));
  require(archive_write_open(writer.get(), &bytes, nullptr, append, nullptr));
  const std::unique_ptr<archive_entry, void (*)(archive_entry*)> entry{archive_entry_new(),
                                                                       archive_entry_free};
  for (const auto& file : files) {
    archive_entry_clear(entry.get());
    archive_entry_set_pathname(entry.get(), file.name.c_str());
    archive_entry_set_size(entry.get(), static_cast<la_int64_t>(file.content.size()));
    archive_entry_set_filetype(entry.get(), AE_IFREG);
    archive_entry_set_perm(entry.get(), 0644);
    archive_entry_set_mtime(entry.get(), static_cast<time_t>(core::unix_seconds(modified)), 0);
    require(archive_write_header(writer.get(), entry.get()));
    if (archive_write_data(writer.get(), file.content.data(), file.content.size()) < 0)
      require(ARCHIVE_FATAL);
  }
  require(archive_write_close(writer.get()));
  return bytes;
}

}  // namespace floeplan::codec
