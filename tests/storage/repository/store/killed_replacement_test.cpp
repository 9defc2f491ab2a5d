#include <gmock/gmock.h>

#include <fstream>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "storage/repository/store/damage.hpp"
#include "storage/repository/store/migrations.hpp"
#include "storage/repository/store/replacement.hpp"
#include "storage/repository/work/job_repository.hpp"
#include "storage/repository/work/plan_repository.hpp"
#include "storage/sql/statement.hpp"
#include "storage/sql/store_file.hpp"
#include "storage/sql/upkeep.hpp"
#include "tests/storage/repository/store/older_stores.hpp"
#include "tests/support/killed_before.hpp"
#include "tests/support/temporary_folder.hpp"

namespace floeplan::repository::killed_replacement_test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using Contents = std::vector<std::string>;

constexpr int plans = 12;
constexpr std::size_t writes = 12;

PlanId id_of(int number) { return {"plan-" + std::to_string(number)}; }

void fill(const fs::path& store, const std::string& mark) {
  auto db = open_store(store);
  for (int i = 0; i < plans; ++i) {
    PlanRecord plan;
    plan.id = id_of(i);
    plan.name = mark;
    plan.request_json = "{}";
    plan.document_json = "{\"legs\":\"" + std::string(6000, 'x') + mark + "\"}";
    (void)PlanRepository{db}.insert(plan);
  }
}

/// What each plan of a store says, and the number of the last change of a job; "damaged" or "gone" for one that does not, and nothing of a store that is not opened.
Contents contents_of(const fs::path& store) {
  Contents contents;
  std::optional<sql::Connection> opened;
  try {
    opened = open_store(store);
  } catch (const sql::Failure&) {
    return contents;
  }
  sql::Connection& db = *opened;
  for (int i = 0; i < plans; ++i) {
    const bool whole = sql::meets_no_damage([&] {
      const auto plan = PlanRepository{db}.find(id_of(i));
      contents.push_back(plan ? plan->name + plan->document_json : "gone");
    });
    if (!whole) contents.emplace_back("damaged");
  }
  contents.push_back("change " + std::to_string(JobRepository{db}.last_change()));
  return contents;
}

/// Kills `change` of a copy of `store` in front of each thing it does to files. The copy has to say what it said before, or
/// what it says after the change, and the change has to come to its end when it is made once more.
void expect_whole_whenever_killed(const fs::path& store, const std::function<void(const fs::path&)>& change) {
  const support::TemporaryFolder folder;
  const auto fresh_copy = [&] {
    const fs::path copy = folder.path() / "copy";
    fs::remove_all(copy);
    fs::copy(store, copy, fs::copy_options::recursive);
    return copy;
  };
  const fs::path changed = fresh_copy();
  const auto change_copy = [&] { change(changed); };
  const std::vector<std::size_t> instants = support::instants_of(change_copy, writes);
  ASSERT_GT(instants.size(), writes);
  const Contents after = contents_of(changed);
  const Contents before = contents_of(fresh_copy());

  for (const std::size_t instant : instants) {
    const testing::ScopedTrace trace{__FILE__, __LINE__, "killed before change " + std::to_string(instant)};
    (void)fresh_copy();

    ASSERT_LE(support::killed_before(instant, change_copy).size(), instant);

    ASSERT_THAT(contents_of(changed), testing::AnyOf(before, after));
    change(changed);
    ASSERT_EQ(contents_of(changed), after);
  }
}

class KilledReplacement : public testing::Test {
 protected:
  void SetUp() override { fill(store_, "as it was"); }

  [[nodiscard]] fs::path backup_of_another() const {
    const fs::path other = folder_.path() / "other";
    fill(other, "from the backup");
    auto db = open_store(other);
    sql::back_up(db, folder_.path() / "backup");
    return folder_.path() / "backup";
  }

  const support::TemporaryFolder folder_;
  const fs::path store_ = folder_.path() / "store";
};

TEST_F(KilledReplacement, OfARestoredStoreLeavesTheOldOneOrTheBackup) {
  const fs::path backup = backup_of_another();

  expect_whole_whenever_killed(store_, [&](const fs::path& store) { (void)restore_store(store, backup); });
}

/// Where the database cannot be read, its log cannot be moved into it: neither may pass for a store without the other, nor
/// may the log ever meet the backup.
TEST_F(KilledReplacement, OfAStoreThatCannotBeReadLeavesNoneOrTheBackup) {
  const fs::path backup = backup_of_another();
  const fs::path kept = folder_.path() / "kept";
  {
    auto db = open_store(store_);  // its log is there while it is open
    sql::execute(db, "UPDATE job_clock SET change = 1000");
    fs::copy(store_, kept);
  }
  for (const bool is_gone : {false, true}) {
    const auto spoil = [&](const fs::path& store) {
      fs::remove_all(store);
      fs::copy(kept, store);
      ASSERT_GT(fs::file_size(sql::database_in(store).string() + "-wal"), 0U);
      if (is_gone)
        fs::remove(sql::database_in(store));
      else
        std::fstream{sql::database_in(store), std::ios::in | std::ios::out | std::ios::binary}
            << "unreadable";
    };
    spoil(store_);
    ASSERT_TRUE(contents_of(store_).empty());
    spoil(store_);

    expect_whole_whenever_killed(store_, [&](const fs::path& store) { (void)restore_store(store, backup); });

    (void)restore_store(store_, backup);
    EXPECT_EQ(contents_of(store_), contents_of(folder_.path() / "other"));
  }
}

TEST_F(KilledReplacement, OfAnOlderStoreLeavesAllItHeld) {
  {
    auto db = open_store(store_);
    sql::execute(db, "PRAGMA user_version = 12" + before_classes_of_jobs);
  }

  expect_whole_whenever_killed(store_, [](const fs::path& store) { const auto db = open_store(store); });
  EXPECT_THAT(contents_of(store_), testing::Contains(HasSubstr("as it was")).Times(plans));
}

TEST_F(KilledReplacement, OfARepairedStoreLeavesTheDamagedOneOrWhatIsWhole) {
  {
    std::fstream io{sql::database_in(store_), std::ios::in | std::ios::out | std::ios::binary};
    const std::string text{std::istreambuf_iterator<char>{io}, {}};
    io.clear();
    io.seekp(static_cast<std::streamoff>(text.find(std::string(3000, 'x')) + 100));
    io.put('y');
  }
  ASSERT_THAT(contents_of(store_), testing::Contains("damaged"));

  expect_whole_whenever_killed(store_, [](const fs::path& store) { (void)repair_store(store); });
}

}  // namespace
}  // namespace floeplan::repository::killed_replacement_test
