#pragma once

#include "storage/sql/sqlite/foreign_schema.hpp"

/// How a database that somebody else wrote (a GeoPackage) is opened without trusting it.
namespace floeplan::sql {

using sqlite::active_part_of;
using sqlite::active_part_of_statement;
using sqlite::distrust_schemas;

}  // namespace floeplan::sql
