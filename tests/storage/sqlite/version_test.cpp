#include "storage/sqlite/version.hpp"

#include <gtest/gtest.h>

#include "storage/sqlite/statement.hpp"
#include "tests/support/temporary_folder.hpp"

namespace floeplan::sqlite {
namespace {

/// Two connections to one database with a row.
class VersionTest : public testing::Test {
 protected:
  VersionTest() { execute(one_, "CREATE TABLE t (a INTEGER) STRICT; INSERT INTO t VALUES (1)"); }

  support::TemporaryFolder folder_;
  Connection one_{Connection::open(folder_.path())};
  Connection other_{Connection::open(folder_.path())};
};

TEST_F(VersionTest, StaysWhileNobodyChangesAnything) {
  const Version before = version_of(one_);
  EXPECT_TRUE((Statement{other_, "SELECT a FROM t"}.step()));
  EXPECT_TRUE((Statement{one_, "SELECT a FROM t"}.step()));
  EXPECT_EQ(version_of(one_), before);
}

TEST_F(VersionTest, ChangesWithWhatAnotherConnectionCommits) {
  const Version before = version_of(one_);
  execute(other_, "UPDATE t SET a = 2");
  EXPECT_NE(version_of(one_), before);
}

TEST_F(VersionTest, ChangesWithWhatTheConnectionItselfWrites) {
  const Version before = version_of(one_);
  execute(one_, "UPDATE t SET a = 2");
  const Version updated = version_of(one_);
  EXPECT_NE(updated, before);
  execute(one_, "DELETE FROM t");
  EXPECT_NE(version_of(one_), updated);
}

/// Whoever keeps what was read after the version was asked for must be told of this.
TEST_F(VersionTest, ChangesWhenAnotherConnectionCommitsBeforeTheNextRead) {
  const Version before = version_of(one_);
  execute(other_, "UPDATE t SET a = 3");
  Statement query{one_, "SELECT a FROM t"};
  ASSERT_TRUE(query.step());
  EXPECT_EQ(query.integer(0), 3);
  query.reset();
  EXPECT_NE(version_of(one_), before);
}

}  // namespace
}  // namespace floeplan::sqlite
