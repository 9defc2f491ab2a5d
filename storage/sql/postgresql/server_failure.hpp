#pragma once

#include <libpq-fe.h>

#include <string>

#include "storage/sql/driver/failure.hpp"

namespace floeplan::sql::postgresql {

/// What the server said of a statement that failed, or of a connection that was lost, as a failure of ours.
/// `name`  the database's and its server's, for a person
[[nodiscard]] Failure failure_of(const PGresult* result, const PGconn* connection, const std::string& name);

}  // namespace floeplan::sql::postgresql
