#include "storage/repository/store/damage.hpp"

#include <gmock/gmock.h>

#include <fstream>
#include <map>
#include <set>

#include "storage/repository/datasets/dataset_repository.hpp"
#include "storage/repository/features/coastline_repository.hpp"
#include "storage/repository/features/iceberg_repository.hpp"
#include "storage/repository/fields/field_repository.hpp"
#include "storage/repository/store/migrations.hpp"
#include "storage/repository/store/replacement.hpp"
#include "storage/repository/work/job_repository.hpp"
#include "storage/repository/work/plan_repository.hpp"
#include "storage/sql/statement.hpp"
#include "storage/sql/store_file.hpp"
#include "storage/sql/upkeep.hpp"
#include "tests/storage/repository/datasets/sample_data.hpp"
#include "tests/support/property.hpp"
#include "tests/support/temporary_folder.hpp"

namespace floeplan::repository::damage_test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

constexpr int plans = 40;
constexpr std::size_t page_size = 4096;

PlanRecord plan_of(int number) {
  PlanRecord plan;
  plan.id = {"plan-" + std::to_string(number)};
  plan.name = "Plan " + std::to_string(number);
  plan.request_json = R"({"from":[)" + std::to_string(number) + ",69.2]}";
  plan.document_json =
      "{\"legs\":\"" + std::string(static_cast<std::size_t>(500 * (number % 20)), 'x') + "\"}";
  return plan;
}

JobRecord job_of(int number) {
  JobRecord job;
  job.id = {"job-" + std::to_string(number)};
  job.process = "plan-route";
  job.request_json = "{\"via\":\"" + std::string(static_cast<std::size_t>(300 * (number % 30)), 'y') + "\"}";
  return job;
}

/// A store with plans and jobs of 0.1 to 10 KB and icebergs, closed again.
void fill(const fs::path& store) {
  auto db = open_store(store);
  for (int i = 0; i < plans; ++i) (void)PlanRepository{db}.insert(plan_of(i));
  for (int i = 0; i < plans; ++i) JobRepository{db}.submit(job_of(i));
  for (const char* const id : {"bergs-a", "bergs-b"}) {
    DatasetRepository{db}.insert(sample_dataset(id, DatasetKind::icebergs));
    std::vector<ocean::Iceberg> bergs;
    for (int i = 0; i < 300; ++i)
      bergs.push_back(sample_berg(std::string{id} + std::to_string(i), {-52.0 - 0.001 * i, 69.0}));
    IcebergRepository{db}.insert({id}, bergs);
  }
}

void flip_bit(const fs::path& file, std::uint64_t at, int bit) {
  std::fstream io{file, std::ios::in | std::ios::out | std::ios::binary};
  io.seekg(static_cast<std::streamoff>(at));
  const int byte = io.get();
  io.seekp(static_cast<std::streamoff>(at));
  io.put(static_cast<char>(byte ^ (1 << bit)));
}

/// The content of every plan and every iceberg of a store; "damaged" if it cannot be read.
std::map<std::string, std::string> contents_of(sql::Connection& db) {
  std::map<std::string, std::string> contents;
  for (int i = 0; i < plans; ++i) {
    const PlanId id = plan_of(i).id;
    const bool whole = sql::meets_no_damage([&] {
      const auto plan = PlanRepository{db}.find(id);
      contents[id.value] = plan ? plan->name + plan->request_json + plan->document_json : "gone";
    });
    if (!whole) contents[id.value] = "damaged";
  }
  for (const char* const id : {"bergs-a", "bergs-b"}) {
    const bool whole = sql::meets_no_damage([&] {
      std::string text;
      sql::Statement rows{
          db,
          "SELECT s.* FROM sighting AS s JOIN dataset AS d ON d.row = s.dataset_row WHERE d.id = ?1 "
          "ORDER BY s.row"};
      rows.bind(1, std::string{id});
      while (rows.step()) text += rows.text(2) + rows.text(3) + rows.text(4) + rows.text(5) + "\n";
      contents[id] = text.empty() ? "gone" : text;
    });
    if (!whole) contents[id] = "damaged";
  }
  return contents;
}

/// The content of a list that is read page by page.
struct Listed {
  std::vector<std::string> whole;  // ids, in the list's order
  std::set<std::string> named;     // as damaged
  bool has_nameless{false};
};

/// `list_from(key)` is the part of the list behind a row.
template <class ListFrom>
Listed page_through(const ListFrom& list_from) {
  Listed listed;
  std::int64_t key = 0;
  while (true) {
    const auto page = list_from(key);
    for (const auto& record : page.whole) listed.whole.push_back(record.id.value);
    for (const StoredThing& thing : page.damaged) {
      listed.has_nameless = listed.has_nameless || thing.id.empty();
      if (!thing.id.empty()) listed.named.insert(thing.id);
    }
    if (page.whole.size() < 7) return listed;
    key = page.whole.back().row;
  }
}

/// Each of these things is in the list, in this order, or named; the latter where any of it cannot be read.
void expect_all(const Listed& listed, const std::vector<std::string>& ids) {
  auto next = listed.whole.begin();
  for (const std::string& id : ids) {
    const bool is_listed = next != listed.whole.end() && *next == id;
    if (is_listed) ++next;
    EXPECT_TRUE(is_listed != listed.named.contains(id) || (!is_listed && listed.has_nameless)) << id;
  }
  EXPECT_EQ(next, listed.whole.end()) << "another thing, or in another order";
}

class DamagedStore : public testing::Test {
 protected:
  void SetUp() override {
    fill(folder_.path());
    auto db = open_store(folder_.path());
    before_ = contents_of(db);
  }
  [[nodiscard]] fs::path database() const { return sql::database_in(folder_.path()); }

  const support::TemporaryFolder folder_;
  std::map<std::string, std::string> before_;
};

TEST_F(DamagedStore, IsWholeAsItWasWritten) {
  auto db = open_store(folder_.path());

  EXPECT_TRUE(find_damage(db).is_none());
  EXPECT_TRUE(sql::has_page_checksums(db));
}

/// Wherever a bit is flipped: never another answer, always noticed, and what cannot be read is named and left out. A store
/// whose schema is damaged, on some of the first pages, is not opened.
TEST_F(DamagedStore, AnswersNothingElseThanWasWrittenAndNamesWhatItCannotAnswer) {
  const std::uint64_t pages = fs::file_size(database()) / page_size;
  const fs::path whole = folder_.path() / "whole";
  fs::copy_file(database(), whole);
  int unopened = 0;
  support::for_each_seed(100, [&](std::mt19937_64& rng) {
    fs::copy_file(whole, database(), fs::copy_options::overwrite_existing);
    const auto page = static_cast<std::uint64_t>(support::uniform_int(rng, 1, static_cast<int>(pages) - 1));
    const auto byte =
        static_cast<std::uint64_t>(support::uniform_int(rng, 0, static_cast<int>(page_size) - 1));
    flip_bit(database(), page * page_size + byte, support::uniform_int(rng, 0, 7));

    if (!sql::meets_no_damage([&] { const auto db = open_store(folder_.path()); })) {
      ++unopened;
      EXPECT_FALSE(sql::meets_no_damage([&] { (void)repair_store(folder_.path()); }))
          << "with a schema that is whole";
      return;
    }
    std::set<std::string> unreadable;
    std::map<std::string, std::string> found;
    {
      auto db = open_store(folder_.path());
      const Damage damage = find_damage(db);
      EXPECT_THAT(damage.pages, testing::ElementsAre(page + 1));
      for (const StoredThing& thing : damage.things) unreadable.insert(thing.id);
      found = contents_of(db);
      for (const auto& [id, text] : found) {
        EXPECT_TRUE(text == before_[id] || text == "damaged") << id << " of page " << page << ": " << text;
      }
    }
    const Replacement repaired = repair_store(folder_.path());
    std::set<std::string> lost;
    for (const StoredThing& thing : repaired.lost) lost.insert(thing.id);
    auto db = open_store(folder_.path());
    EXPECT_TRUE(find_damage(db).is_none());
    for (const auto& [id, text] : contents_of(db)) {
      const bool is_lost = lost.contains(id);
      EXPECT_EQ(text, is_lost ? "gone" : before_[id]) << id;
      if (is_lost) {
        EXPECT_TRUE(unreadable.contains(id)) << id << " was lost, but not named before";
        if (id.starts_with("plan-")) {
          EXPECT_EQ(found[id], "damaged") << id << " was lost, and could be read";
        }
      }
    }
    fs::remove(repaired.kept);
  });
  EXPECT_LT(unopened, 20);
}

/// Wherever a bit is flipped, a list gives what is whole of it and names the rest.
TEST_F(DamagedStore, IsListedPastWhatCannotBeRead) {
  const std::uint64_t pages = fs::file_size(database()) / page_size;
  const fs::path whole = folder_.path() / "whole";
  fs::copy_file(database(), whole);
  std::vector<std::string> all_plans;
  std::vector<std::string> all_jobs;
  for (int i = 0; i < plans; ++i) all_plans.push_back(plan_of(i).id.value);
  for (int i = plans; i > 0; --i) all_jobs.push_back(job_of(i - 1).id.value);
  std::size_t named = 0;
  support::for_each_seed(60, [&](std::mt19937_64& rng) {
    fs::copy_file(whole, database(), fs::copy_options::overwrite_existing);
    const auto page = static_cast<std::uint64_t>(support::uniform_int(rng, 1, static_cast<int>(pages) - 1));
    const auto byte =
        static_cast<std::uint64_t>(support::uniform_int(rng, 0, static_cast<int>(page_size) - 1));
    flip_bit(database(), page * page_size + byte, support::uniform_int(rng, 0, 7));
    if (!sql::meets_no_damage([&] { const auto db = open_store(folder_.path()); })) return;  // its schema

    auto db = open_store(folder_.path());
    const Listed plan_list =
        page_through([&](std::int64_t key) { return PlanRepository{db}.list_past_damage({}, key, 7); });
    const Listed job_list =
        page_through([&](std::int64_t key) { return JobRepository{db}.list_past_damage(key, 7); });

    expect_all(plan_list, all_plans);
    expect_all(job_list, all_jobs);
    const auto contents = contents_of(db);
    for (const std::string& id : plan_list.named) EXPECT_EQ(contents.at(id), "damaged") << id;
    named += plan_list.named.size() + job_list.named.size();
  });
  EXPECT_GT(named, 10U);
}

/// Wherever a bit of the jobs themselves is flipped: workers get the jobs that can be read.
TEST_F(DamagedStore, HandsOutEveryJobThatIsWhole) {
  std::vector<std::uint64_t> job_pages;
  {
    auto db = open_store(folder_.path());
    sql::Statement query{db, "SELECT pageno FROM dbstat WHERE name = 'job'"};
    while (query.step()) job_pages.push_back(static_cast<std::uint64_t>(query.integer(0)) - 1);
  }
  const fs::path whole = folder_.path() / "whole";
  fs::copy_file(database(), whole);
  std::size_t handed_out = 0;
  std::size_t passed_over = 0;
  std::size_t not_ended = 0;
  support::for_each_seed(30, [&](std::mt19937_64& rng) {
    fs::copy_file(whole, database(), fs::copy_options::overwrite_existing);
    const auto page =
        static_cast<std::size_t>(support::uniform_int(rng, 0, static_cast<int>(job_pages.size()) - 1));
    const auto byte =
        static_cast<std::uint64_t>(support::uniform_int(rng, 0, static_cast<int>(page_size) - 1));
    flip_bit(database(), job_pages[page] * page_size + byte, support::uniform_int(rng, 0, 7));
    auto db = open_store(folder_.path());
    JobRepository jobs{db};
    std::set<std::string> readable;
    for (const JobRecord& job : jobs.list_past_damage(0, plans).whole) readable.insert(job.id.value);

    const core::UtcTime now = core::from_unix_seconds(1.0e9);
    std::set<std::string> claimed;
    jobs.release_all_leases(now);
    while (const auto job = jobs.claim("w", now, core::Seconds{60.0})) {
      EXPECT_TRUE(claimed.insert(job->id.value).second) << job->id.value << " was handed out twice";
      if (!sql::meets_no_damage([&] { jobs.succeed(job->id, "w", "{}", now); })) ++not_ended;
    }
    jobs.hand_back("w", now);

    EXPECT_THAT(readable, testing::IsSupersetOf(claimed));
    handed_out += claimed.size();
    passed_over += readable.size() - claimed.size();
  });
  EXPECT_GT(handed_out, 30U * plans / 2);
  // To write a row that grows SQLite may need the pages beside its own.
  EXPECT_LT(passed_over + not_ended, handed_out / 20) << passed_over << " and " << not_ended;
}

TEST_F(DamagedStore, WithAChangedHeaderIsNotOpened) {
  for (const std::uint64_t byte : {0U, 18U, 20U, 30U, 60U, 63U, 70U, 99U}) {
    flip_bit(database(), byte, 3);
    bool opened = false;
    std::string reason;
    try {
      auto db = open_store(folder_.path());
      opened = true;
    } catch (const std::runtime_error& error) {
      reason = error.what();
    }
    EXPECT_FALSE(opened) << byte;
    EXPECT_FALSE(reason.empty());
    flip_bit(database(), byte, 3);
    auto db = open_store(folder_.path());
    EXPECT_EQ(contents_of(db), before_) << byte << " " << reason;
  }
}

TEST_F(DamagedStore, OfASampleBlockIsNoticedEvenWhereItsPageIsNot) {
  auto db = open_store(folder_.path());
  DatasetRepository{db}.insert(sample_dataset("field", DatasetKind::currents));
  FieldRepository fields{db};
  const ocean::Axis nodes{{0.0, 1.0, 2.0}};
  fields.create({"field"},
                {ocean::HorizontalGrid{geo::GridFrame{}, nodes, nodes}, std::nullopt, ocean::Axis{{0.0}}});
  const std::vector<float> samples(9, 0.25F);
  fields.write_slice({"field"}, "u_m_s", 0, 0, samples);
  ASSERT_TRUE(find_damage(db).is_none());

  sql::execute(
      db, "UPDATE field_chunk SET samples = CAST(substr(samples, 1, length(samples) - 1) || x'00' AS BLOB)");

  const Damage damage = find_damage(db);
  ASSERT_EQ(damage.things.size(), 1U);
  EXPECT_EQ(damage.things.front().id, "field");
}

TEST_F(DamagedStore, IsRestoredFromABackupAndKept) {
  const fs::path backup = folder_.path() / "backup";
  {
    auto db = open_store(folder_.path());
    sql::back_up(db, backup);
  }
  EXPECT_EQ(sql::damage_of(backup), "");
  flip_bit(database(), 0, 0);

  const Replacement restored = restore_store(folder_.path(), backup);

  auto db = open_store(folder_.path());
  EXPECT_EQ(contents_of(db), before_);
  EXPECT_TRUE(fs::exists(restored.kept));
  flip_bit(backup, 3 * page_size + 100, 1);
  EXPECT_THAT([&] { (void)restore_store(folder_.path() / "elsewhere", backup); },
              testing::Throws<std::runtime_error>());
  EXPECT_FALSE(fs::exists(sql::database_in(folder_.path() / "elsewhere")));
}

TEST(StoreFolder, WhoseDatabaseIsGoneIsNoNewStore) {
  const support::TemporaryFolder folder;
  {
    const auto db = open_store(folder.path());
  }
  fs::remove(sql::database_in(folder.path()));

  EXPECT_THAT([&] { const auto db = open_store(folder.path()); },
              testing::Throws<std::runtime_error>(testing::Property(
                  &std::runtime_error::what, HasSubstr("held a store, but its floeplan.sqlite is gone"))));
}

TEST(StoreFolder, IsNotReplacedWhileItIsUsed) {
  const support::TemporaryFolder folder;
  const auto db = open_store(folder.path());

  EXPECT_THAT([&] { (void)repair_store(folder.path()); },
              testing::Throws<sql::Failure>(
                  testing::Property(&sql::Failure::trouble, sql::Trouble::held_by_another)));
}

}  // namespace
}  // namespace floeplan::repository::damage_test
