#include "storage/sqlite/statement.hpp"

#include <gmock/gmock.h>

#include <array>
#include <cmath>
#include <limits>

#include "storage/sqlite/failure.hpp"

namespace floeplan::sqlite {
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

}  // namespace
}  // namespace floeplan::sqlite
