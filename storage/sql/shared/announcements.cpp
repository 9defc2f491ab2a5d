#include "storage/sql/shared/announcements.hpp"

#include "storage/sql/statement.hpp"

namespace floeplan::sql {

/// Names hold for a whole database, which may have several stores: each adds the name of its schema.
void listen(Connection& db, const std::string& name) {
  if (!is_shared(db)) return;
  Statement query{db, "SELECT format('LISTEN %I', ?1 || '_of_' || current_schema())"};
  query.bind(1, name);
  if (query.step()) db.driver().in_each_session(query.text(0));
}

}  // namespace floeplan::sql
