#pragma once

#include <filesystem>
#include <string>

#include "storage/sql/connection.hpp"

namespace floeplan::sql {

/// While it lives, the tables of another database file can be read beside the connection's own (`main.table`), as
/// `name.table`.
/// Errors   Failure when the file cannot be opened; inside a transaction
class Attachment {
 public:
  Attachment(Connection& db, const std::filesystem::path& file, std::string name);
  Attachment(const Attachment&) = delete;
  Attachment& operator=(const Attachment&) = delete;
  ~Attachment();

 private:
  Connection& db_;  // borrowed
  std::string name_;
};

}  // namespace floeplan::sql
