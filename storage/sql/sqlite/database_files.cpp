#include "storage/sql/sqlite/database_files.hpp"

#include <SQLiteCpp/Database.h>
#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cstddef>
#include <fstream>
#include <span>
#include <system_error>

#include "engine/messages/store_messages.hpp"
#include "storage/sql/sqlite/library_failure.hpp"
#include "storage/sql/sqlite/page_checksums.hpp"

namespace floeplan::sql::sqlite {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t whole_header = 100;
constexpr std::size_t schema_at = 60;
constexpr std::size_t application_id_at = 68;

std::int32_t big_endian(std::span<const unsigned char> bytes) {
  std::uint32_t value = 0;
  for (const unsigned char byte : bytes.first(4)) value = value << 8U | byte;
  return static_cast<std::int32_t>(value);
}

fs::path log_of(const fs::path& database) { return database.string() + "-wal"; }

/// An unused name: "floeplan.sqlite.before-repair", "floeplan.sqlite.before-repair-2", ...
fs::path free_name(const fs::path& place, const std::string& why) {
  fs::path name = place.string() + ".before-" + why;
  for (int i = 2; fs::exists(name); ++i) name = place.string() + ".before-" + why + "-" + std::to_string(i);
  return name;
}

}  // namespace

fs::path database_in(const fs::path& store) { return store / "floeplan.sqlite"; }

std::vector<fs::path> database_files_in(const fs::path& store) {
  return {database_in(store), log_of(database_in(store))};
}

DatabaseHeader header_of(const fs::path& database) {
  std::ifstream in{database, std::ios::binary};
  std::array<unsigned char, whole_header> header{};
  in.read(reinterpret_cast<char*>(header.data()), header.size());
  if (in.gcount() < static_cast<std::streamsize>(header.size())) return {};
  const std::span bytes{header};
  return {.is_store = big_endian(bytes.subspan(application_id_at)) == application_id,
          .schema = big_endian(bytes.subspan(schema_at)),
          .has_checksums = has_page_checksums(database)};
}

void flush(const fs::path& path) {
  const int descriptor = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  const bool flushed = descriptor >= 0 && fsync(descriptor) == 0;
  if (descriptor >= 0) close(descriptor);
  if (!flushed) throw Failure{messages::store_text<"file-not-flushed">(path.string()), Trouble::not_writable};
}

void settle(const fs::path& database) {
  constexpr int busy_timeout_ms = 10'000;
  try {
    SQLite::Database db{database.string(), SQLite::OPEN_READWRITE, busy_timeout_ms, checked_files()};
    if (db.execAndGet("PRAGMA journal_mode = DELETE").getString() != "delete")
      throw Failure{messages::store_text<"database-in-use">(database.string()), Trouble::held_by_another};
  } catch (const SQLite::Exception& cause) {
    throw failure_of(cause, database.string());
  }
}

fs::path set_aside(const fs::path& database, const std::string& why) {
  const fs::path log = log_of(database);
  try {
    fs::path kept;
    if (fs::exists(database)) {
      kept = free_name(database, why);
      fs::rename(database, kept);
      flush(database.parent_path());
    }
    if (fs::exists(log)) fs::rename(log, free_name(log, why));
    fs::remove(database.string() + "-shm");
    flush(database.parent_path());
    return kept;
  } catch (const fs::filesystem_error& error) {
    throw Failure{messages::store_text<"not-set-aside">(std::string{error.what()}), Trouble::not_writable};
  }
}

fs::path put_in_place(const fs::path& finished, const fs::path& place, const std::string& why) {
  try {
    flush(finished);
    fs::path kept;
    if (fs::exists(place)) {
      kept = free_name(place, why);
      std::error_code no_links;  // some file systems have no hard links
      fs::create_hard_link(place, kept, no_links);
      if (no_links) fs::copy_file(place, kept);
      flush(kept);
    }
    fs::rename(finished, place);
    flush(place.parent_path());
    return kept;
  } catch (const fs::filesystem_error& error) {
    throw Failure{messages::store_text<"not-put-in-place">(std::string{error.what()}), Trouble::not_writable};
  }
}

}  // namespace floeplan::sql::sqlite
