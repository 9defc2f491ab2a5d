#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/core/units.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::repository {

/// An action of a user that is recorded for accountability.
struct AuditEntry {
  std::int64_t row{};  // given by the store, ascending in time
  core::UtcTime at;
  std::string caller;  // name of the token used
  std::string peer;    // network address of the request
  std::string action;  // "plan-route", "export", "upload", "remove", ...
  std::string target;  // object of the action: a path, or the id of a job
  std::string request_id;
};

/// The log of actions. Entries are added and read; an entry with a count can be updated. Only the newest
/// `most_entries` are kept.
/// Threads  as the connection: one thread at a time
class AuditRepository {
 public:
  explicit AuditRepository(sql::Connection& db) : db_{db} {}

  static constexpr std::int64_t most_entries = 1'000'000;  // some 150 MB: years of a busy station

  /// Adds an entry. Returns its row.
  std::int64_t add(const AuditEntry& entry);
  /// Replaces the target of an entry that contains a count.
  void restate(std::int64_t row, const std::string& target);
  /// At most `limit` entries with a row below `before`, newest first; 0: from the newest.
  [[nodiscard]] std::vector<AuditEntry> list(std::int64_t before, int limit) const;

 private:
  sql::Connection& db_;  // borrowed
};

}  // namespace floeplan::repository
