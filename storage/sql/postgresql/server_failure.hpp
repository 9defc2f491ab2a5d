#pragma once

#include <libpq-fe.h>

#include <string>

#include "storage/sql/driver/failure.hpp"

namespace floeplan::sql::postgresql {

/// The failure for a statement that the server refused, or for a lost connection.
/// `name`  of the database and its server, for a person
[[nodiscard]] Failure failure_of(const PGresult* result, const PGconn* connection, const std::string& name);

}  // namespace floeplan::sql::postgresql
