#include <gtest/gtest.h>

#include <fstream>

#include "storage/sql/connection.hpp"
#include "storage/sql/driver/failure.hpp"
#include "storage/sql/foreign_database.hpp"
#include "storage/sql/statement.hpp"
#include "tests/support/temporary_folder.hpp"

namespace floeplan::sql::foreign_schema_test {
namespace {

TEST(ForeignSchema, IsPlainAsGdalAndQgisWriteIt) {
  for (const char* const sql :
       {"CREATE TABLE gpkg_contents (table_name TEXT NOT NULL PRIMARY KEY, last_change DATETIME NOT NULL "
        "DEFAULT "
        "(strftime('%Y-%m-%dT%H:%M:%fZ','now')))",
        "CREATE TABLE \"as (x)\" (\"as\" TEXT, 'view' TEXT, [virtual] INT, CHECK (CAST(x AS TEXT) <> ''))",
        "create table layer_styles (styleQML XML, useAsDefault BOOLEAN)", "CREATE INDEX i ON t (a)",
        "CREATE UNIQUE INDEX i ON t (a)",
        "CREATE TRIGGER rtree_bergs_geom_insert AFTER INSERT ON bergs WHEN (new.geom NOT NULL) BEGIN INSERT "
        "OR "
        "REPLACE INTO rtree_bergs_geom VALUES (NEW.fid, ST_MinX(NEW.geom)); END",
        "CREATE VIRTUAL TABLE \"rtree_bergs_geom\" USING rtree(id, minx, maxx, miny, maxy)",
        "CREATE VIRTUAL TABLE using_ USING 'RTree' (id, minx, maxx)"})
    EXPECT_FALSE(active_part_of_statement(sql).has_value()) << sql;
}

TEST(ForeignSchema, IsActiveWithViewsComputedColumnsAndOtherModules) {
  for (const char* const sql :
       {"CREATE VIEW v AS SELECT 1", "create/* */view v as select 1", "CREATE --\n VIEW v AS SELECT 1",
        "CREATE TABLE t (a, b GENERATED ALWAYS AS (load_extension('x')))",
        "CREATE TABLE t (a, b as/**/(f(a)))", "CREATE VIRTUAL TABLE t USING fts5(x)",
        "CREATE VIRTUAL TABLE rtree USING VirtualText('/etc/passwd')",
        "CREATE VIRTUAL TABLE \"USING rtree\" USING dbstat",
        "CREATE/**/VIRTUAL TABLE t USING/*rtree*/ csv('x')", "CREATE VIRTUAL TABLE t", "CREATE", "",
        "ATTACH 'x' AS y", "CREATE TEMP VIEW v AS SELECT 1"})
    EXPECT_TRUE(active_part_of_statement(sql).has_value()) << sql;
}

TEST(ForeignSchema, IsReadFromTheFileWithoutChangingAnythingBesideIt) {
  const support::TemporaryFolder folder;
  {
    Connection db = Connection::open_scratch(folder.path());
    execute(db, "CREATE TABLE t (a); CREATE VIRTUAL TABLE r USING rtree(id, low, high)");
  }
  const auto file = folder.path() / "floeplan.sqlite";
  EXPECT_EQ(active_part_of(file), std::nullopt);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "floeplan.sqlite-wal"));
  {
    Connection db = Connection::open_scratch(folder.path());
    execute(db, "CREATE VIEW v AS SELECT a FROM t");
  }
  const auto odd = folder.path() / "a ?mode=rwc#%41.gpkg";
  std::filesystem::copy_file(file, odd);
  EXPECT_EQ(active_part_of(odd), "a view");
}

TEST(ForeignSchema, OfADamagedFileIsAFailure) {
  const support::TemporaryFolder folder;
  std::ofstream{folder.path() / "x.gpkg"} << "SQLite format 3";
  EXPECT_THROW(static_cast<void>(active_part_of(folder.path() / "x.gpkg")), Failure);
  EXPECT_THROW(static_cast<void>(active_part_of(folder.path() / "none.gpkg")), Failure);
}

}  // namespace
}  // namespace floeplan::sql::foreign_schema_test
