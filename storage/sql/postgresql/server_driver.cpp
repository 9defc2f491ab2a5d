#include "storage/sql/postgresql/server_driver.hpp"

#include <xxhash.h>

#include "engine/messages/store_messages.hpp"
#include "storage/sql/driver/failure.hpp"
#include "storage/sql/postgresql/server_statement.hpp"

namespace floeplan::sql::postgresql {
namespace {

/// A statement waits at most ten seconds for a lock. A committed change survives a power cut.
constexpr const char* session_settings =
    "SET lock_timeout = '10s'; SET synchronous_commit = on; SET client_min_messages = warning; "
    "SET default_transaction_isolation = 'read committed'";

/// The lock of one store: the first number stands for Floeplan ("FLOE"), the second for the schema of the
/// store.
constexpr const char* take_right_to_write =
    "SELECT pg_advisory_xact_lock(1179406149, hashtext(current_schema()))";

[[noreturn]] void refuse_files(const ServerSession& session) {
  throw Failure{messages::store_text<"server-keeps-files">(session.name())};
}

}  // namespace

ServerDriver::ServerDriver(const std::string& address) : session_{address, session_settings} {}

std::unique_ptr<Driver> ServerDriver::open(const std::string& address) {
  return std::unique_ptr<Driver>{new ServerDriver{address}};
}

std::unique_ptr<PreparedStatement> ServerDriver::prepare(const std::string& sql) {
  return std::make_unique<ServerStatement>(session_, sql);
}

void ServerDriver::begin_writing(WriteTurn turn) {
  session_.begin("BEGIN");
  if (turn == WriteTurn::beside_others) return;
  try {
    session_.run_script(take_right_to_write);
  } catch (const Failure&) {
    session_.roll_back();
    throw;
  }
}

void ServerDriver::begin_reading() { session_.begin("BEGIN ISOLATION LEVEL REPEATABLE READ READ ONLY"); }

/// Two reads that see the same transactions see the same rows. So the version is the set of transactions that
/// a read sees.
Version ServerDriver::version() {
  const Result result = session_.run("SELECT pg_current_snapshot()::text", {});
  const std::string seen = text_at(result.get(), 0, 0);
  const XXH128_hash_t digest = XXH3_128bits(seen.data(), seen.size());
  Version version;
  version.numbers = {
      static_cast<std::uint32_t>(digest.low64), static_cast<std::uint32_t>(digest.low64 >> 32U),
      static_cast<std::uint32_t>(digest.high64), static_cast<std::uint32_t>(digest.high64 >> 32U)};
  return version;
}

/// `now()` would stand still within a transaction.
double ServerDriver::time_s() {
  const Result result = session_.run("SELECT extract(epoch FROM clock_timestamp())::float8", {});
  return real_at(result.get(), 0, 0);
}

void ServerDriver::back_up(const std::filesystem::path&) { refuse_files(session_); }

bool ServerDriver::has_page_checksums() { refuse_files(session_); }

std::vector<std::uint32_t> ServerDriver::damaged_pages() { refuse_files(session_); }

}  // namespace floeplan::sql::postgresql
