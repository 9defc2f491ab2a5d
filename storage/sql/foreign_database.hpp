#pragma once

#include "storage/sql/sqlite/foreign_schema.hpp"

/// Functions to open a database that another program wrote (a GeoPackage) safely.
namespace floeplan::sql {

using sqlite::active_part_of;
using sqlite::active_part_of_statement;
using sqlite::distrust_schemas;

}  // namespace floeplan::sql
