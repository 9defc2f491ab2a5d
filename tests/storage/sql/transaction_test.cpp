#include "storage/sql/transaction.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "storage/sql/schema_number.hpp"
#include "storage/sql/statement.hpp"
#include "tests/support/temporary_folder.hpp"

namespace floeplan::sql::transaction_test {
namespace {

std::int64_t rows(Connection& db) {
  Statement query{db, "SELECT count(*) FROM t"};
  return query.step() ? query.integer(0) : -1;
}

class TransactionTest : public testing::Test {
 protected:
  TransactionTest() {
    execute(db_, "CREATE TABLE t (a INTEGER) STRICT");
    set_schema_number(db_, 1, 1);
  }

  support::TemporaryFolder folder_;
  Connection db_ = Connection::open(folder_.path());
};

TEST_F(TransactionTest, IsUndoneUnlessCommitted) {
  {
    const Transaction transaction{db_};
    execute(db_, "INSERT INTO t VALUES (1)");
  }
  EXPECT_EQ(rows(db_), 0);
}

TEST_F(TransactionTest, KnowsThatItIsFinished) {
  Transaction transaction{db_};
  execute(db_, "INSERT INTO t VALUES (1)");
  EXPECT_FALSE(transaction.is_finished());

  transaction.commit();

  EXPECT_TRUE(transaction.is_finished());
  EXPECT_EQ(rows(db_), 1);
  EXPECT_THROW(transaction.commit(), std::logic_error);
}

TEST_F(TransactionTest, InsideAnotherIsUndoneAlone) {
  Transaction outer{db_};
  execute(db_, "INSERT INTO t VALUES (1)");
  {
    Transaction kept{db_};
    execute(db_, "INSERT INTO t VALUES (2)");
    kept.commit();
    const Transaction undone{db_};
    execute(db_, "INSERT INTO t VALUES (3)");
  }
  outer.commit();

  EXPECT_EQ(rows(db_), 2);
}

TEST_F(TransactionTest, InsideAnotherIsUndoneWithIt) {
  {
    const Transaction outer{db_};
    Transaction inner{db_};
    execute(db_, "INSERT INTO t VALUES (1)");
    inner.commit();
  }
  EXPECT_EQ(rows(db_), 0);
}

TEST_F(TransactionTest, IsSeenByOthersOnlyOnceCommitted) {
  Connection other = Connection::open(folder_.path());
  Transaction transaction{db_};
  execute(db_, "INSERT INTO t VALUES (1)");
  EXPECT_EQ(rows(other), 0);

  transaction.commit();

  EXPECT_EQ(rows(other), 1);
}

}  // namespace
}  // namespace floeplan::sql::transaction_test
