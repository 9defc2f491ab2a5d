#pragma once

#include "storage/sql/sqlite/backup.hpp"
#include "storage/sql/sqlite/database_files.hpp"
#include "storage/sql/sqlite/store_use.hpp"

/// The database of a store as files in its folder: where they lie, what their header says, who uses them, and how another one
/// takes their place. An engine that keeps no files in the folder has no part in this.
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
