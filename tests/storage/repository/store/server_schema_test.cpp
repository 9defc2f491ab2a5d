#include <gmock/gmock.h>

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include "storage/repository/access/audit_repository.hpp"
#include "storage/repository/store/dataset_tables.hpp"
#include "storage/repository/store/migrations.hpp"
#include "storage/repository/store/schema.hpp"
#include "storage/repository/work/job_repository.hpp"
#include "storage/sql/schema_number.hpp"
#include "storage/sql/statement.hpp"
#include "storage/sql/tables.hpp"
#include "tests/support/empty_store.hpp"

namespace floeplan::repository::server_schema_test {
namespace {

/// "name type" of each column, sorted: which comes first differs where columns were added later.
std::vector<std::string> columns(sql::Connection& db, const std::string& table) {
  static constexpr const char* names[]{"integer", "real", "text", "blob"};
  std::vector<std::string> texts;
  for (const sql::Column& column : sql::columns_of(db, table))
    texts.push_back(column.name + " " + names[static_cast<int>(column.type)]);
  std::ranges::sort(texts);
  return texts;
}

/// Repositories hold one text for both engines, so a store at a server must have the same tables.
TEST(ServerSchema, HasTheTablesAndColumnsOfAStoreInAFolder) {
  sql::Connection here = open_store_in_memory();
  sql::Connection there = support::empty_store();
  const std::vector<std::string> tables = sql::tables_of(here, "main", "");
  EXPECT_GT(tables.size(), 20U);
  for (const std::string& table : tables) {
    EXPECT_TRUE(sql::has_table(there, table)) << table;
    EXPECT_EQ(columns(there, table), columns(here, table)) << table;
    const std::string box = boxes_of(table);
    EXPECT_EQ(sql::has_table(there, box), sql::has_table(here, box)) << box;
  }
}

TEST(ServerSchema, IsLeftAsItIsWhenTheStoreIsOpenedAgain) {
  sql::Connection db = support::empty_store();
  bring_to_newest_schema(db);
  EXPECT_EQ(sql::schema_number(db), newest_schema(db.engine()));
}

/// A store that the first version for database servers made is brought up to date with all its content.
TEST(ServerSchema, IsReachedFromTheFirstOneOfServers) {
  sql::Connection db = support::empty_store();
  if (!sql::is_shared(db)) GTEST_SKIP() << "runs at a database server";
  sql::execute(
      db,
      "DROP TABLE water_level_station; DROP TABLE water_level; DROP TABLE upload_block; DROP TABLE upload; "
      "DROP FUNCTION announce_job CASCADE; "
      "DROP TABLE job_part; DROP FUNCTION remove_parts_of_job CASCADE; DROP FUNCTION announce_parts CASCADE");
  sql::set_schema_number(db, first_server_schema, first_server_schema);
  sql::execute(db, "ALTER TABLE store_schema DROP usable_from");
  AuditRepository{db}.add({.at = core::UtcTime{core::Seconds{1.8e9}},
                           .caller = "ann",
                           .peer = {},
                           .action = "plan",
                           .target = {},
                           .request_id = {}});

  bring_to_newest_schema(db);

  EXPECT_EQ(sql::schema_number(db), newest_schema(db.engine()));
  EXPECT_TRUE(sql::has_table(db, "upload_block"));
  EXPECT_TRUE(sql::has_table(db, "job_part"));
  EXPECT_EQ(AuditRepository{db}.list(0, 10).size(), 1U);
}

TEST(ServerSchema, OfANewerProgramIsRefused) {
  sql::Connection db = support::empty_store();
  sql::set_schema_number(db, newest_schema(db.engine()) + 1, newest_schema(db.engine()) + 1);
  EXPECT_THROW(bring_to_newest_schema(db), std::runtime_error);
}

/// While a new version is rolled out, nodes of the version before work on, and may be started again.
TEST(ServerSchema, OfTheNextProgramServesThisOneIfThatSaysSo) {
  sql::Connection db = support::empty_store();
  if (!sql::is_shared(db)) GTEST_SKIP() << "runs at a database server";
  const std::int64_t next = newest_schema(db.engine()) + 1;
  sql::execute(db, "ALTER TABLE job ADD COLUMN unheard_of BIGINT");
  sql::set_schema_number(db, next, newest_schema(db.engine()));

  bring_to_newest_schema(db);

  EXPECT_EQ(sql::schema_number(db), next);
  JobRepository{db}.submit(
      {.id = {"a"}, .process = "echo", .request_json = "{}", .created = core::UtcTime{}});
  EXPECT_TRUE(JobRepository{db}.claim("worker/1", core::UtcTime{}, core::Seconds{30.0}));
}

}  // namespace
}  // namespace floeplan::repository::server_schema_test
