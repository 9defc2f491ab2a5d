#include "tests/storage/ingest/support/archive_writer.hpp"

#include <archive.h>
#include <archive_entry.h>

#include <fstream>
#include <iterator>
#include <memory>
#include <stdexcept>

namespace floeplan::ingest {
namespace {

int set_up(archive* writer, Packing packing) {
  switch (packing) {
    case Packing::zip: return archive_write_set_format_zip(writer);
    case Packing::tar_gz:
      archive_write_add_filter_gzip(writer);
      return archive_write_set_format_pax_restricted(writer);
    case Packing::gzip: archive_write_add_filter_gzip(writer); return archive_write_set_format_raw(writer);
    case Packing::bzip2: archive_write_add_filter_bzip2(writer); return archive_write_set_format_raw(writer);
    case Packing::xz: archive_write_add_filter_xz(writer); return archive_write_set_format_raw(writer);
    case Packing::zstd: archive_write_add_filter_zstd(writer); return archive_write_set_format_raw(writer);
  }
  return ARCHIVE_FATAL;
}

void require_written(bool good) {
  if (!good) throw std::runtime_error{"the test's archive cannot be written"};
}

}  // namespace

void write_archive(const std::filesystem::path& file, Packing packing, const ArchiveMembers& members) {
  const std::unique_ptr<archive, int (*)(archive*)> writer{archive_write_new(), archive_write_free};
  require_written(set_up(writer.get(), packing) == ARCHIVE_OK);
  require_written(archive_write_open_filename(writer.get(), file.c_str()) == ARCHIVE_OK);
  for (const auto& [name, content] : members) {
    const std::unique_ptr<archive_entry, void (*)(archive_entry*)> entry{archive_entry_new(),
                                                                         archive_entry_free};
    archive_entry_set_pathname(entry.get(), name.c_str());
    archive_entry_set_size(entry.get(), static_cast<la_int64_t>(content.size()));
    archive_entry_set_filetype(entry.get(), AE_IFREG);
    archive_entry_set_perm(entry.get(), 0644);
    require_written(archive_write_header(writer.get(), entry.get()) == ARCHIVE_OK);
    require_written(archive_write_data(writer.get(), content.data(), content.size()) ==
                    static_cast<la_ssize_t>(content.size()));
  }
  require_written(archive_write_close(writer.get()) == ARCHIVE_OK);
}

ArchiveMembers members_of(const std::vector<std::filesystem::path>& files, const std::string& folder) {
  ArchiveMembers members;
  for (const auto& file : files) {
    std::ifstream in{file, std::ios::binary};
    members.emplace_back(folder + file.filename().string(),
                         std::string{std::istreambuf_iterator<char>{in}, {}});
  }
  return members;
}

}  // namespace floeplan::ingest
