#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/core/units.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::repository {

/// Something that somebody did and may have to answer for.
struct AuditEntry {
  std::int64_t row{};  // given by the store, ascending in time
  core::UtcTime at;
  std::string caller;  // name of a token
  std::string peer;    // address it came from
  std::string action;  // "plan-route", "export", "upload", "remove", ...
  std::string target;  // what it was done to: the path, or the id of the job
  std::string request_id;
};

/// Entries are added and read; one that counts may count further. Those beyond the newest `most_entries` go.
/// Threads  as the connection: one thread at a time
class AuditRepository {
 public:
  explicit AuditRepository(sql::Connection& db) : db_{db} {}

  static constexpr std::int64_t most_entries = 1'000'000;  // some 150 MB: years of a busy station

  /// Returns  its row
  std::int64_t add(const AuditEntry& entry);
  /// Gives an entry that counts its new count.
  void restate(std::int64_t row, const std::string& target);
  /// Newest first, at most `limit` with a row below `before` (0: from the newest).
  [[nodiscard]] std::vector<AuditEntry> list(std::int64_t before, int limit) const;

 private:
  sql::Connection& db_;  // borrowed
};

}  // namespace floeplan::repository
