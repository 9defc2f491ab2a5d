#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <exception>
#include <filesystem>
#include <string>
#include <thread>

#include "storage/sql/connection.hpp"
#include "storage/sql/schema_number.hpp"
#include "storage/sql/statement.hpp"
#include "tests/support/temporary_folder.hpp"

namespace floeplan::sql::version_test {
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

/// The log begins anew then, with the same number of pages in it as before.
TEST_F(VersionTest, ChangesWithACommitToALogThatWasEmptied) {
  execute(other_, "PRAGMA wal_checkpoint(TRUNCATE); UPDATE t SET a = 5");
  const Version before = version_of(one_);
  execute(other_, "PRAGMA wal_checkpoint(TRUNCATE); UPDATE t SET a = 6");
  EXPECT_NE(version_of(one_), before);
}

/// The law that remembered answers rest on: between two equal versions nothing was committed.
TEST_F(VersionTest, IsTheSameOnlyWhileTheSameIsRead) {
  constexpr int commits = 500;
  std::atomic<bool> done{false};
  std::thread writer{[&] {
    execute(other_, "PRAGMA synchronous = OFF");
    for (int i = 0; i < commits; ++i) execute(other_, "UPDATE t SET a = a + 1");
    done = true;
  }};
  const auto read = [&] {
    Statement query{one_, "SELECT a FROM t"};
    EXPECT_TRUE(query.step());
    return query.integer(0);
  };
  Version known = version_of(one_);
  std::int64_t value = read();
  int equal = 0;
  int changed = 0;
  while (!done || known != version_of(one_)) {
    const Version before = version_of(one_);
    const std::int64_t now = read();
    if (before == known && version_of(one_) == known) {
      ++equal;
      EXPECT_EQ(now, value);
    }
    if (before != known) {
      ++changed;
      known = before;
      value = read();
    }
  }
  writer.join();
  EXPECT_EQ(read(), 1 + commits);
  EXPECT_GT(changed, 0);
  EXPECT_GT(equal, 0);
}

/// The exit code of a process that waits for a byte and then changes the row.
int update_when_told(int told, const std::filesystem::path& store) {
  try {
    char byte = 0;
    if (read(told, &byte, 1) != 1) return 1;
    Connection db = Connection::open(store);
    execute(db, "UPDATE t SET a = 4");
    return 0;
  } catch (const std::exception&) {
    return 2;
  }
}

/// SQLite forbids that a process and its child share a connection: the child is there before the first one.
TEST(VersionBetweenProcessesTest, ChangesWithWhatTheOtherCommits) {
  const support::TemporaryFolder folder;
  std::array<int, 2> go{};
  ASSERT_EQ(pipe(go.data()), 0);
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) _exit(update_when_told(go[0], folder.path()));
  Connection db = Connection::open(folder.path());
  set_schema_number(db, 1, 1);
  execute(db, "CREATE TABLE t (a INTEGER) STRICT; INSERT INTO t VALUES (1)");
  const Version before = version_of(db);
  ASSERT_EQ(write(go[1], "!", 1), 1);
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  ASSERT_EQ(status, 0);
  EXPECT_NE(version_of(db), before);
  close(go[0]);
  close(go[1]);
}

TEST(VersionInMemoryTest, ChangesWithWhatIsWritten) {
  Connection db = Connection::in_memory();
  execute(db, "CREATE TABLE t (a INTEGER) STRICT");
  const Version before = version_of(db);
  EXPECT_EQ(version_of(db), before);
  execute(db, "INSERT INTO t VALUES (1)");
  EXPECT_NE(version_of(db), before);
}

}  // namespace
}  // namespace floeplan::sql::version_test
