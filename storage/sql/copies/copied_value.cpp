#include "storage/sql/copies/copied_value.hpp"

namespace floeplan::sql {

void bind_copy(Statement& statement, int parameter, const Row& row, int column, ColumnType type) {
  if (row.is_null(column)) return statement.bind_null(parameter, type);
  switch (type) {
    case ColumnType::integer: return statement.bind(parameter, row.integer(column));
    case ColumnType::real: return statement.bind(parameter, row.real(column));
    case ColumnType::text: return statement.bind(parameter, row.text(column));
    case ColumnType::blob: return statement.bind(parameter, row.blob(column));
  }
}

}  // namespace floeplan::sql
