#pragma once

#include <string>

namespace floeplan::sql {

/// Condition in a query of sqlite_schema, as t, for tables with this program's own rows: not those of SQLite,
/// not R*Trees, and not the tables in which an R*Tree stores its data.
inline const std::string own_tables =
    "t.type = 'table' AND t.name NOT LIKE 'sqlite_%' AND t.sql NOT LIKE 'CREATE VIRTUAL TABLE%' AND "
    "t.name NOT LIKE '%\\_box\\__%' ESCAPE '\\'";

}  // namespace floeplan::sql
