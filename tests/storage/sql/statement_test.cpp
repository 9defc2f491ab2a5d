#include "storage/sql/statement.hpp"

#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <limits>

#include "storage/sql/driver/failure.hpp"

namespace floeplan::sql::statement_test {
namespace {

class StatementTest : public testing::Test {
 protected:
  StatementTest() { execute(db_, "CREATE TABLE t (a TEXT, b INTEGER, c REAL, d BLOB) STRICT"); }

  Connection db_ = Connection::in_memory();
};

TEST_F(StatementTest, GivesBackWhatWasBound) {
  const std::string text{"a\0b'; DROP TABLE t; --", 22};
  const std::array blob{std::byte{0}, std::byte{255}};
  const core::UtcTime time = core::from_unix_seconds(1.7e9 + 0.1);

  Statement insert{db_, "INSERT INTO t VALUES (?1, ?2, ?3, ?4)"};
  insert.bind_all(text, std::numeric_limits<std::int64_t>::min(), time, std::span<const std::byte>{blob});
  EXPECT_EQ(insert.run(), 1);

  Statement query{db_, "SELECT a, b, c, d FROM t"};
  ASSERT_TRUE(query.step());
  EXPECT_EQ(query.text(0), text);
  EXPECT_EQ(query.integer(1), std::numeric_limits<std::int64_t>::min());
  EXPECT_EQ(query.time(2), time);
  EXPECT_THAT(query.blob(3), testing::ElementsAreArray(blob));
  EXPECT_FALSE(query.step());
}

TEST_F(StatementTest, TakesAnEmptyOptionalForNull) {
  Statement insert{db_, "INSERT INTO t VALUES (?1, NULL, ?2, NULL)"};
  insert.bind_all(std::optional<std::string>{}, std::optional<double>{});
  insert.run();

  Statement query{db_, "SELECT a, c FROM t"};
  ASSERT_TRUE(query.step());
  EXPECT_EQ(query.optional_text(0), std::nullopt);
  EXPECT_EQ(query.optional_real(1), std::nullopt);
  EXPECT_EQ(query.optional_time(1), std::nullopt);
}

TEST_F(StatementTest, RefusesANumberThatIsNone) {
  Statement insert{db_, "INSERT INTO t (c) VALUES (?1)"};
  EXPECT_THROW(insert.bind(1, std::nan("")), std::invalid_argument);
}

TEST_F(StatementTest, RunsAgainWithOtherValues) {
  Statement insert{db_, "INSERT INTO t (b) VALUES (?1)"};
  for (int i = 0; i < 3; ++i) {
    insert.bind_all(i);
    insert.run();
  }

  Statement sum{db_, "SELECT count(*), sum(b) FROM t"};
  ASSERT_TRUE(sum.step());
  EXPECT_EQ(sum.integer(0), 3);
  EXPECT_EQ(sum.integer(1), 3);
}

TEST_F(StatementTest, CountsTheRowsItChanged) {
  execute(db_, "INSERT INTO t (b) VALUES (1), (2), (3)");
  Statement remove{db_, "DELETE FROM t WHERE b >= ?1"};

  remove.bind(1, 2);
  EXPECT_EQ(remove.run(), 2);
  EXPECT_EQ(remove.run(), 0);
}

TEST_F(StatementTest, FailsWithTheDatabasesReason) {
  EXPECT_THROW((Statement{db_, "SELECT nothing FROM nowhere"}), Failure);

  Statement insert{db_, "INSERT INTO t (b) VALUES (?1)"};
  insert.bind(1, std::string{"not a number"});
  EXPECT_THROW(insert.run(), Failure);
}

TEST_F(StatementTest, RemembersNothingOfTheOneBeforeThatHadTheSameText) {
  const std::string sql = "SELECT ?1 IS NULL";
  {
    Statement first{db_, sql};
    first.bind(1, 7);
    ASSERT_TRUE(first.step());
    EXPECT_EQ(first.integer(0), 0);
  }
  Statement second{db_, sql};
  ASSERT_TRUE(second.step());
  EXPECT_EQ(second.integer(0), 1);
}

TEST_F(StatementTest, RunsBesideAnotherOfTheSameText) {
  execute(db_, "INSERT INTO t (b) VALUES (1), (2)");
  const std::string sql = "SELECT b FROM t ORDER BY b";
  Statement outer{db_, sql};
  int pairs = 0;
  while (outer.step()) {
    Statement inner{db_, sql};
    while (inner.step()) ++pairs;
  }
  EXPECT_EQ(pairs, 4);
}

TEST_F(StatementTest, LetsGoOfTheTableWhenItIsLeftHalfway) {
  execute(db_, "INSERT INTO t (b) VALUES (1), (2)");
  {
    Statement query{db_, "SELECT b FROM t"};
    ASSERT_TRUE(query.step());
  }
  EXPECT_NO_THROW(execute(db_, "DROP TABLE t"));
}

TEST_F(StatementTest, SeesTheColumnsOfToday) {
  const std::string sql = "SELECT * FROM t";
  {
    EXPECT_FALSE(Statement(db_, sql).step());
  }
  execute(db_, "DROP TABLE t; CREATE TABLE t (only INTEGER); INSERT INTO t VALUES (5)");
  Statement query{db_, sql};
  ASSERT_TRUE(query.step());
  EXPECT_EQ(query.integer(0), 5);
}

TEST_F(StatementTest, WorksAgainAfterAFailure) {
  execute(db_, "CREATE UNIQUE INDEX one ON t (b)");
  const std::string sql = "INSERT INTO t (b) VALUES (?1)";
  const auto insert = [&](int value) {
    Statement statement{db_, sql};
    statement.bind(1, value);
    return statement.run();
  };
  EXPECT_EQ(insert(1), 1);
  EXPECT_THROW(insert(1), Failure);
  EXPECT_EQ(insert(2), 1);
}

TEST_F(StatementTest, StaysRightWhenThereAreMoreTextsThanAreKept) {
  for (int round = 0; round < 2; ++round) {
    for (int i = 0; i < 200; ++i) {
      Statement query{db_, "SELECT " + std::to_string(i)};
      ASSERT_TRUE(query.step());
      EXPECT_EQ(query.integer(0), i);
    }
  }
}

}  // namespace
}  // namespace floeplan::sql::statement_test
