#include "storage/repository/store/store_copy.hpp"

#include <gmock/gmock.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "storage/repository/access/token_repository.hpp"
#include "storage/repository/datasets/dataset_repository.hpp"
#include "storage/repository/features/iceberg_repository.hpp"
#include "storage/repository/store/migrations.hpp"
#include "storage/repository/work/job_repository.hpp"
#include "storage/sql/statement.hpp"
#include "storage/sql/tables.hpp"
#include "tests/support/empty_store.hpp"

namespace floeplan::repository::store_copy_test {
namespace {

using testing::HasSubstr;

const core::UtcTime noon{core::Seconds{1.8e9}};

JobRecord job(const std::string& id) {
  JobRecord record;
  record.id = {id};
  record.process = "echo";
  record.request_json = R"({"text": "Gr\u00f8nland"})";
  record.created = noon;
  record.updated = noon;
  return record;
}

/// A store with rows in tables of each kind: with numbers and boxes, with blobs, with texts and empty values.
void fill(sql::Connection& db) {
  sql::execute(db,
               "INSERT INTO dataset (id, kind, name, west_deg, south_deg, east_deg, north_deg, rows_accepted, "
               "rows_refused, file_name, file_size_bytes, sha256, ingested_s, tool_version) VALUES "
               "('d1', 'icebergs', 'bergs', -54.25, 68.5, -50.125, 70.0, 2, 0, 'b.csv', 99, 'aa', 1.8e9, '1'),"
               "('d2', 'bathymetry', 'bed', -54.0, 68.5, -50.0, 70.0, 4, 0, 'b.asc', 12, 'bb', 1.8e9, '1')");
  sql::Statement sighting{db,
                          "INSERT INTO sighting (dataset_row, berg_id, lon_deg, lat_deg, observed_s, size, length_m, "
                          "shape, method) SELECT row, ?1, ?2, ?3, ?4, 'large', ?5, '', '' FROM dataset WHERE id = 'd1'"};
  for (int i = 0; i < 120; ++i) {
    sighting.bind_all("berg" + std::to_string(i), -53.0 + 0.0123 * i, 69.0 + 0.001 * i, 1.8e9 + i,
                      i % 2 == 0 ? std::optional{55.5 + i} : std::nullopt);
    sighting.run();
  }
  sql::Statement grid{db,
                      "INSERT INTO grid (dataset_row, frame, x_count, y_count, depth_count, time_count, chunk_side, "
                      "x_nodes, y_nodes) SELECT row, 'lonlat', 2, 2, 0, 0, 64, ?1, ?1 FROM dataset WHERE id = 'd2'"};
  const std::vector<std::byte> bytes{std::byte{0}, std::byte{255}, std::byte{39}, std::byte{92}};
  grid.bind(1, std::span<const std::byte>{bytes});
  grid.run();
  JobRepository jobs{db};
  for (const char* id : {"one", "two", "three"}) jobs.submit(job(id));
  ASSERT_TRUE(jobs.claim("w/1", noon, core::Seconds{60.0}).has_value());
  ASSERT_TRUE(jobs.succeed({"one"}, "w/1", R"({"text": "done"})", noon));
  ASSERT_TRUE(jobs.remove({"three"})) << "its number must not be given again";
  ASSERT_TRUE(TokenRepository{db}.add(
      {.name = "anna", .role = Role::pilot, .key = "k", .digest = "d", .created = noon}));
}

/// From a store in a folder to one at a server and back, where the tests run beside a server; else between folders.
TEST(StoreCopy, IsTheSameStoreAtEitherEngine) {
  sql::Connection first = open_store_in_memory();
  sql::Connection second = support::empty_store();
  sql::Connection third = open_store_in_memory();
  ASSERT_NO_FATAL_FAILURE(fill(first));

  const CopiedStore there = copy_store(first, second, {});
  const CopiedStore back = copy_store(second, third, {});

  EXPECT_EQ(there.datasets, 2);
  EXPECT_EQ(there.jobs, 2);
  EXPECT_EQ(back.rows, there.rows);
  for (sql::Connection* copy : {&second, &third}) {
    EXPECT_EQ(JobRepository{*copy}.find({"one"})->result_json, R"({"text": "done"})");
    EXPECT_EQ(JobRepository{*copy}.find({"one"})->change, JobRepository{first}.find({"one"})->change);
    EXPECT_EQ(JobRepository{*copy}.last_change(), JobRepository{first}.last_change());
    EXPECT_TRUE(TokenRepository{*copy}.ever_any());
    sql::Statement boxes{*copy, "SELECT count(*) FROM sighting_box"};
    ASSERT_TRUE(boxes.step());
    EXPECT_EQ(boxes.integer(0), 120);
    JobRepository{*copy}.submit(job("four"));
    EXPECT_EQ(JobRepository{*copy}.find({"four"})->row, 4) << "numbers go on from the highest ever given";
    EXPECT_EQ(JobRepository{*copy}.find({"four"})->change, JobRepository{first}.last_change() + 1)
        << "triggers run again";
  }
}

TEST(StoreCopy, GoesIntoAnEmptyStoreAlone) {
  sql::Connection from = open_store_in_memory();
  sql::Connection to = support::empty_store();
  ASSERT_NO_FATAL_FAILURE(fill(from));
  JobRepository{to}.submit(job("other"));

  EXPECT_THAT([&] { static_cast<void>(copy_store(from, to, {})); },
              testing::ThrowsMessage<std::runtime_error>(HasSubstr("job")));

  EXPECT_TRUE(JobRepository{to}.find({"other"}).has_value());
  EXPECT_TRUE(DatasetRepository{to}.list().empty()) << "nothing by halves";
}

TEST(StoreCopy, TellsHowFarItIs) {
  sql::Connection from = open_store_in_memory();
  sql::Connection to = support::empty_store();
  double last = -1.0;
  int stages = 0;
  static_cast<void>(copy_store(from, to, [&](std::string_view, double share) {
    EXPECT_GE(share, last);
    EXPECT_LT(share, 1.0);
    last = share;
    ++stages;
  }));
  EXPECT_GT(stages, 40);
}

}  // namespace
}  // namespace floeplan::repository::store_copy_test
