#pragma once

#include "storage/sql/statement.hpp"

namespace floeplan::sql {

/// Binds the value that a row has in a column, which may be NULL, to a parameter of a statement, perhaps of another engine.
void bind_copy(Statement& statement, int parameter, const Row& row, int column, ColumnType type);

}  // namespace floeplan::sql
