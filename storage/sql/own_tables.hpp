#pragma once

#include <string>

namespace floeplan::sql {

/// Tells in a query on sqlite_schema, as t, tables that hold rows of ours: not those of SQLite, nor those in which an R*Tree
/// keeps itself, nor R*Trees.
inline const std::string own_tables =
    "t.type = 'table' AND t.name NOT LIKE 'sqlite_%' AND t.sql NOT LIKE 'CREATE VIRTUAL TABLE%' AND "
    "t.name NOT LIKE '%\\_box\\__%' ESCAPE '\\'";

}  // namespace floeplan::sql
