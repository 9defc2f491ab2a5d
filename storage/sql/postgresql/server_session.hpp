#pragma once

#include <libpq-fe.h>

#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "storage/sql/driver/driver.hpp"
#include "storage/sql/postgresql/wire_values.hpp"

namespace floeplan::sql::postgresql {

struct ClearResult {
  void operator()(PGresult* result) const { PQclear(result); }
};
using Result = std::unique_ptr<PGresult, ClearResult>;

/// One session at a server, and the statements that the server has parsed for it.
/// Threads  one thread at a time
/// Errors   Failure when the server refuses, or is out of reach
class ServerSession {
 public:
  /// `address`   a connection string or URL of libpq
  /// `settings`  a script that each session begins with
  ServerSession(const std::string& address, std::string settings);

  /// Runs a script of statements without values.
  void run_script(const std::string& script);
  /// Begins a transaction by this statement.
  void begin(const std::string& statement);
  /// Errors   Failure also when the transaction has failed or was lost: the server takes a COMMIT for a ROLLBACK then
  void commit();
  void roll_back();
  /// Runs one statement to its end and takes all of its rows, in binary form. A statement that was run before
  /// with values of the same types is not parsed again.
  [[nodiscard]] Result run(const std::string& sql, const std::vector<WireValue>& values);

  /// Runs a statement here and in each session that takes the place of this one.
  void run_in_each(const std::string& statement);
  /// Waits until something is announced, at most this long.
  [[nodiscard]] Announced announced(std::chrono::milliseconds at_most);

  [[nodiscard]] bool is_in_transaction() const { return has_begun_; }
  /// The name of the database and of its server, for a person.
  [[nodiscard]] const std::string& name() const { return name_; }

 private:
  struct EndSession {
    void operator()(PGconn* connection) const { PQfinish(connection); }
  };
  /// A new session takes the place of one that was lost, but never within a transaction: the rest of the
  /// transaction must not be stored without its beginning.
  void reconnect_if_lost();
  /// Notices that were received and not yet returned.
  [[nodiscard]] std::vector<std::string> received();
  /// The name of a statement that the server has parsed.
  [[nodiscard]] std::string parsed(const std::string& sql, const std::vector<Oid>& types);

  std::unique_ptr<PGconn, EndSession> connection_;
  std::string settings_;
  std::string name_;
  std::map<std::pair<std::string, std::vector<Oid>>, std::string> parsed_;
  std::int64_t names_given_{0};
  bool has_missed_{false};  // announcements, because the session was lost
  bool has_begun_{false};  // a transaction that is neither committed nor undone yet
};

}  // namespace floeplan::sql::postgresql
