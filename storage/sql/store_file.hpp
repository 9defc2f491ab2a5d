#pragma once

#include "storage/sql/sqlite/backup.hpp"
#include "storage/sql/sqlite/database_files.hpp"
#include "storage/sql/sqlite/store_use.hpp"

/// The database files of a store: their paths, their header, who uses them, and how they are replaced. A
/// database engine without files in the folder would not need these functions.
namespace floeplan::sql {

using sqlite::damage_of;
using sqlite::database_files_in;
using sqlite::database_in;
using sqlite::DatabaseHeader;
using sqlite::header_of;
using sqlite::put_in_place;
using sqlite::set_aside;
using sqlite::settle;
using sqlite::StoreUse;

}  // namespace floeplan::sql
