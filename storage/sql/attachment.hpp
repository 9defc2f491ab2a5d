#pragma once

#include <filesystem>
#include <string>

#include "storage/sql/connection.hpp"

namespace floeplan::sql {

/// While an object of this class lives, the connection can also read the tables of another database file, as
/// `name.table`; its own are `main.table`.
/// Errors   Failure when the file cannot be opened, or inside a transaction
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
