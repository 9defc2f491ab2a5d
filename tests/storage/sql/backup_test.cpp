#include <gtest/gtest.h>

#include <fstream>

#include "storage/sql/driver/failure.hpp"
#include "storage/sql/schema_number.hpp"
#include "storage/sql/statement.hpp"
#include "storage/sql/store_file.hpp"
#include "storage/sql/transaction.hpp"
#include "storage/sql/upkeep.hpp"
#include "tests/support/temporary_folder.hpp"

namespace floeplan::sql::backup_test {
namespace {

namespace fs = std::filesystem;

class Backup : public testing::Test {
 protected:
  Backup() {
    set_schema_number(db_, 1, 1);
    execute(db_, "CREATE TABLE number (value INTEGER NOT NULL) STRICT");
    add(1);
  }

  void add(int value) {
    Statement insert{db_, "INSERT INTO number VALUES (?1)"};
    insert.bind(1, value);
    insert.run();
  }
  static std::int64_t count(Connection& db) {
    Statement query{db, "SELECT count(*) FROM number"};
    return query.step() ? query.integer(0) : -1;
  }

  support::TemporaryFolder folder_;
  Connection db_{Connection::open(folder_.path() / "store")};
  fs::path copy_{folder_.path() / "copy" / "floeplan.sqlite"};
};

TEST_F(Backup, HoldsEverythingThatWasCommittedAndNothingElse) {
  fs::create_directory(copy_.parent_path());
  Connection other = Connection::open(folder_.path() / "store");
  {
    Transaction unfinished{other};
    Statement insert{other, "INSERT INTO number VALUES (7)"};
    insert.run();
    back_up(db_, copy_);
  }
  add(2);

  EXPECT_EQ(damage_of(copy_), "");
  Connection restored = Connection::open(copy_.parent_path());
  EXPECT_EQ(count(restored), 1);
  EXPECT_EQ(count(db_), 2);
}

TEST_F(Backup, LeavesAFileAloneThatIsThereAlready) {
  const fs::path taken = folder_.path() / "taken";
  std::ofstream{taken} << "mine";
  EXPECT_THROW(back_up(db_, taken), Failure);
  EXPECT_EQ(fs::file_size(taken), 4U);
}

TEST_F(Backup, LeavesNothingWhereItCannotWrite) {
  EXPECT_THROW(back_up(db_, folder_.path() / "nowhere" / "copy"), Failure);
  EXPECT_FALSE(fs::exists(folder_.path() / "nowhere"));
}

TEST_F(Backup, ThatIsDamagedOrNoStoreIsTold) {
  const fs::path file = folder_.path() / "copy";
  back_up(db_, file);
  std::fstream{file, std::ios::in | std::ios::out | std::ios::binary}.seekp(4096 + 100).write("garbage!", 8);
  fs::resize_file(file, fs::file_size(file) - 2048);
  bool told = false;
  try {
    told = !damage_of(file).empty();
  } catch (const Failure&) {
    told = true;
  }
  EXPECT_TRUE(told);

  Connection foreign = Connection::open(folder_.path() / "foreign");
  execute(foreign, "CREATE TABLE t (a INTEGER) STRICT");
  EXPECT_NE(damage_of(folder_.path() / "foreign" / "floeplan.sqlite"), "");
}

}  // namespace
}  // namespace floeplan::sql::backup_test
