#include "storage/sql/copies/row_stream.hpp"

namespace floeplan::sql {
namespace {

/// Calls `take` for each row of the statement. Returns the number of rows.
int rows_of_one(Statement& statement, const std::function<void(const Row&)>& take) {
  int rows = 0;
  for (; statement.step(); ++rows) take(statement);
  return rows;
}

}  // namespace

void for_each_row(Connection& db, const std::string& name, const std::string& query,
                  const std::function<void(const Row&)>& take) {
  if (db.engine() != Engine::server) {
    Statement all{db, query};
    (void)rows_of_one(all, take);
    return;
  }
  // a block of samples has up to 100 KB, so that a portion needs a few megabytes
  execute(db, "DECLARE " + name + " NO SCROLL CURSOR FOR " + query);
  Statement portion{db, "FETCH FORWARD 50 FROM " + name};
  while (rows_of_one(portion, take) > 0) portion.reset();
  execute(db, "CLOSE " + name);
}

}  // namespace floeplan::sql
