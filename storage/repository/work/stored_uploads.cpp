#include "storage/repository/work/stored_uploads.hpp"

#include <cerrno>
#include <cstddef>
#include <fstream>
#include <span>

#include "engine/messages/store_messages.hpp"
#include "storage/sql/statement.hpp"
#include "storage/sql/transaction.hpp"

namespace floeplan::repository {
namespace {

namespace fs = std::filesystem;

/// Bytes of a block: few statements for a large file, and little memory.
constexpr std::size_t block_bytes = std::size_t{1} << 20;

const std::string columns = "id, name, bytes, sha256, owner, created_s, expires_s ";

Upload read_upload(const sql::Row& row) {
  return {.id = row.text(0),
          .name = row.text(1),
          .bytes = static_cast<std::uint64_t>(row.integer(2)),
          .sha256 = row.text(3),
          .owner = row.text(4),
          .created = row.time(5),
          .expires = row.time(6)};
}

/// Writes the content of a file as blocks. Returns how many bytes it has.
std::uint64_t insert_blocks(sql::Connection& db, const std::string& id, const fs::path& file) {
  std::ifstream in{file, std::ios::binary};
  std::vector<std::byte> block(block_bytes);
  std::uint64_t bytes = 0;
  for (std::int64_t position = 0; in; ++position) {
    in.read(reinterpret_cast<char*>(block.data()), static_cast<std::streamsize>(block.size()));
    const auto count = static_cast<std::size_t>(in.gcount());
    if (count == 0) break;
    sql::Statement insert{db,
                          "INSERT INTO upload_block (upload_id, position, content) VALUES (?1, ?2, ?3)"};
    insert.bind_all(id, position, std::span<const std::byte>{block.data(), count});
    insert.run();
    bytes += count;
  }
  if (!in.eof()) throw std::runtime_error{messages::store_text<"upload-not-written">()};
  return bytes;
}

}  // namespace

Upload StoredUploads::add(const fs::path& file, const std::string& name, const std::string& sha256,
                          const std::string& owner, core::UtcTime now) {
  const Upload upload = new_upload(file, name, sha256, owner, now);
  sql::Transaction transaction{db_, sql::WriteTurn::beside_others};
  sql::Statement insert{db_,
                        "INSERT INTO upload (" + columns + ") VALUES (?1, ?2, ?3, ?4, ?5, ?6, ?7)"};
  insert.bind_all(upload.id, upload.name, static_cast<std::int64_t>(upload.bytes), upload.sha256, upload.owner,
                  upload.created, upload.expires);
  insert.run();
  if (insert_blocks(db_, upload.id, file) != upload.bytes)
    throw std::runtime_error{messages::store_text<"upload-not-written">()};
  transaction.commit();
  fs::remove(file);
  return upload;
}

std::optional<Upload> StoredUploads::find(const std::string& id) const {
  sql::Statement query{db_, "SELECT " + columns + "FROM upload WHERE id = ?1"};
  query.bind(1, id);
  return query.step() ? std::optional{read_upload(query)} : std::nullopt;
}

std::vector<Upload> StoredUploads::list() const {
  sql::Statement query{db_, "SELECT " + columns + "FROM upload ORDER BY created_s DESC, id"};
  std::vector<Upload> uploads;
  while (query.step()) uploads.push_back(read_upload(query));
  return uploads;
}

std::error_code StoredUploads::lay_out(const Upload& upload, const fs::path& file) const {
  std::ofstream out{file, std::ios::binary};
  sql::Statement query{db_, "SELECT content FROM upload_block WHERE upload_id = ?1 AND position = ?2"};
  const auto blocks = static_cast<std::int64_t>((upload.bytes + block_bytes - 1) / block_bytes);
  for (std::int64_t position = 0; position < blocks && out; ++position) {
    query.reset();
    query.bind_all(upload.id, position);
    if (!query.step()) return std::make_error_code(std::errc::no_such_file_or_directory);
    const std::span<const std::byte> content = query.blob(0);
    out.write(reinterpret_cast<const char*>(content.data()), static_cast<std::streamsize>(content.size()));
  }
  out.close();
  return out ? std::error_code{} : std::error_code{errno, std::generic_category()};
}

bool StoredUploads::remove(const std::string& id) {
  sql::Statement remove{db_, "DELETE FROM upload WHERE id = ?1"};
  remove.bind(1, id);
  return remove.run() > 0;
}

void StoredUploads::remove_expired(core::UtcTime now) {
  sql::Statement remove{db_, "DELETE FROM upload WHERE expires_s <= ?1"};
  remove.bind(1, now);
  remove.run();
}

}  // namespace floeplan::repository
