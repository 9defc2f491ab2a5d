#include "storage/sql/connection.hpp"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "storage/sql/driver/failure.hpp"
#include "storage/sql/statement.hpp"
#include "tests/support/temporary_folder.hpp"

namespace floeplan::sql::connection_test {
namespace {

std::string pragma(Connection& db, const std::string& name) {
  Statement query{db, "PRAGMA " + name};
  return query.step() ? query.text(0) : "";
}

std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream in{file, std::ios::binary};
  return {std::istreambuf_iterator<char>{in}, {}};
}

std::string reason_why_not_opened(const std::filesystem::path& store) {
  try {
    const Connection db = Connection::open(store);
    return "";
  } catch (const std::runtime_error& error) {
    return error.what();
  }
}

TEST(Connection, KeepsANewStoreFromOtherUsersOfTheMachine) {
  const support::TemporaryFolder folder;
  auto db = Connection::open(folder.path() / "store");
  execute(db, "CREATE TABLE t (a)");
  using std::filesystem::perms;
  for (const char* const name :
       {"store", "store/floeplan.sqlite", "store/floeplan.sqlite-wal", "store/floeplan.use"})
    EXPECT_EQ(
        std::filesystem::status(folder.path() / name).permissions() & (perms::group_all | perms::others_all),
        perms::none)
        << name;
}

TEST(Connection, KeepsACommittedTransactionThroughAPowerCut) {
  const support::TemporaryFolder folder;

  Connection db = Connection::open(folder.path());

  EXPECT_EQ(pragma(db, "journal_mode"), "wal");
  EXPECT_EQ(pragma(db, "synchronous"), "2");
  EXPECT_EQ(pragma(db, "foreign_keys"), "1");
  EXPECT_EQ(pragma(db, "busy_timeout"), "10000");
}

TEST(Connection, CreatesTheStoresFolder) {
  const support::TemporaryFolder folder;

  const Connection db = Connection::open(folder.path() / "a" / "b");

  EXPECT_TRUE(std::filesystem::exists(folder.path() / "a" / "b" / "floeplan.sqlite"));
}

TEST(Connection, RefusesAFileThatIsNoDatabaseAndLeavesItAlone) {
  const support::TemporaryFolder folder;
  const auto file = folder.path() / "floeplan.sqlite";
  std::ofstream{file} << std::string(5000, 'x');

  EXPECT_THAT(reason_why_not_opened(folder.path()),
              testing::AllOf(testing::HasSubstr("damaged"), testing::HasSubstr(file.string())));
  EXPECT_EQ(bytes_of(file), std::string(5000, 'x'));
}

TEST(Connection, RefusesTheDatabaseOfAnotherProgramAndLeavesItAlone) {
  const support::TemporaryFolder folder;
  const auto file = folder.path() / "floeplan.sqlite";
  {
    Connection db = Connection::open(folder.path());
    execute(db, "PRAGMA journal_mode = DELETE; CREATE TABLE bookmark (url TEXT)");
  }
  const std::string before = bytes_of(file);

  EXPECT_THAT(reason_why_not_opened(folder.path()), testing::HasSubstr("another program"));
  EXPECT_EQ(bytes_of(file), before);
}

TEST(Connection, SaysWhenAFolderCannotBeCreated) {
  const support::TemporaryFolder folder;
  std::ofstream{folder.path() / "file"} << "in the way";

  EXPECT_THAT(reason_why_not_opened(folder.path() / "file" / "store"),
              testing::HasSubstr("cannot be created"));
}

}  // namespace
}  // namespace floeplan::sql::connection_test
