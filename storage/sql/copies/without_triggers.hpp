#pragma once

#include <string>
#include <vector>

#include "storage/sql/connection.hpp"

namespace floeplan::sql {

/// While an object of this class lives, no trigger of a store runs, so that rows can be written as they were.
/// Precondition  a Transaction that outlives the object: if it is rolled back, the triggers are unchanged
/// Edges         at a database server the user must own the tables
class WithoutTriggers {
 public:
  /// `tables`  all tables with triggers; further ones do no harm
  WithoutTriggers(Connection& db, std::vector<std::string> tables);
  WithoutTriggers(const WithoutTriggers&) = delete;
  WithoutTriggers& operator=(const WithoutTriggers&) = delete;
  ~WithoutTriggers() = default;

  /// Makes the triggers run again.
  void end();

 private:
  Connection& db_;  // borrowed
  std::vector<std::string> tables_;
  std::vector<std::string> definitions_;  // of the triggers of an embedded engine, which are removed meanwhile
};

}  // namespace floeplan::sql
