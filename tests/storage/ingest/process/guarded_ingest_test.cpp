#include "storage/ingest/process/guarded_ingest.hpp"

#include <gmock/gmock.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <fstream>
#include <set>
#include <stdexcept>

#include "engine/messages/ingest_file_messages.hpp"
#include "storage/repository/datasets/dataset_repository.hpp"
#include "storage/sql/statement.hpp"
#include "tests/storage/ingest/support/netcdf_writer.hpp"
#include "tests/storage/ingest/support/store_fixture.hpp"
#include "tests/support/places.hpp"
#include "tests/support/property.hpp"

namespace floeplan::ingest::guarded_ingest_test {
namespace {

using testing::HasSubstr;

/// Every row of every table with data of datasets, as text, without the numbers that rows got in their own store.
std::multiset<std::string> rows_of_data(sql::Connection& db) {
  std::multiset<std::string> rows;
  sql::Statement tables{db,
                        "SELECT t.name, group_concat('quote(' || c.name || ')', ' || ') FROM sqlite_schema t "
                        "JOIN pragma_table_info(t.name) c WHERE t.type = 'table' AND c.name NOT IN ('row', "
                        "'dataset_row') AND EXISTS (SELECT 1 FROM pragma_table_info(t.name) d WHERE d.name = "
                        "'dataset_row') GROUP BY t.name"};
  while (tables.step()) {
    const std::string table = tables.text(0);
    sql::Statement of_table{db,
                            "SELECT d.id || " + tables.text(1) + " FROM " + table +
                                " JOIN (SELECT row AS number, id FROM dataset) d ON number = dataset_row"};
    while (of_table.step()) rows.insert(table + ": " + of_table.text(0));
  }
  return rows;
}

std::set<std::string> names_in(const std::filesystem::path& folder) {
  std::set<std::string> names;
  if (std::filesystem::exists(folder))
    for (const auto& entry : std::filesystem::directory_iterator{folder})
      names.insert(entry.path().filename());
  return names;
}

/// Kills the processes that this thread has started and that still run.
void kill_children() {
  std::ifstream children{"/proc/self/task/" + std::to_string(syscall(SYS_gettid)) + "/children"};
  for (pid_t child = 0; children >> child;) kill(child, SIGKILL);
}

/// A process of its own reads for this one.
class GuardedIngest : public StoreFixture {
 protected:
  std::vector<IngestReport> guarded(const std::vector<std::filesystem::path>& files,
                                    const core::ProgressCallback& progress = {},
                                    const std::stop_token& stop = {}) {
    return guarded_ingest(db_, guard_, files, options_, core::from_unix_seconds(1.8e9), stop, progress, {});
  }

  /// Files of every kind that this folder can write.
  std::vector<std::filesystem::path> good_files() {
    CurrentFile{}.write(path("currents.nc"));
    CurrentFile u_alone;
    u_alone.with_north = false;
    u_alone.times = {100.0, 106.0};
    u_alone.write(path("u.nc"));
    return {
        path("currents.nc"),
        write_file("bed.asc",
                   "ncols 3\nnrows 2\nxllcorner 0\nyllcorner 50\ncellsize 0.5\n-900 -800 70\n-600 -5 4\n"),
        write_file("bergs.geojson", point_),
        write_file("zone.geojson", polygon(R"({"name": "Range", "kind": "no_go"})")),
        write_file("coast.geojson", polygon(R"({"kind": "land"})")),
        write_file("notes.txt", "a letter"),
        path("u.nc")};
  }

  static std::string polygon(const std::string& properties) {
    return R"({"type": "FeatureCollection", "features": [{"type": "Feature", "properties": )" + properties +
           R"(, "geometry": {"type": "Polygon", "coordinates": [[[-53.1, 68.9], [-52.8, 68.9], [-52.8, 69.1],
              [-53.1, 68.9]]]}}]})";
  }

  const std::string point_{R"({"type": "FeatureCollection", "features": [{"type": "Feature",
      "properties": {"id": "a", "observed": "2026-11-20T06:00:00Z", "length_m": 120},
      "geometry": {"type": "Point", "coordinates": [-52.0, 69.0]}}]})"};
  const IngestOptions options_{.positive = "up"};
  const Guard guard_{.program = support::program_folder() + "/ingest_reader", .staging = path("incoming")};
};

TEST_F(GuardedIngest, TellsWithCodesAndValuesWhyAFileIsRefused) {
  const auto reports = guarded({write_file("late.nc", "<html>502 Bad Gateway</html>\n")});

  ASSERT_EQ(reports.size(), 1U);
  ASSERT_EQ(reports.front().errors.size(), 1U) << words(reports.front());
  EXPECT_EQ(reports.front().errors.front(), messages::ingest_file_message<"text-named-as-netcdf">(
                                                std::string{"<html>502 Bad Gateway</html>"}));
}

TEST_F(GuardedIngest, KeepsTheExceptionOfAReaderOutOfWhatAPilotReads) {
  const auto program = write_file("reader.sh",
                                  "#!/bin/sh\n"
                                  "echo '{\"confined\": [true, 3]}'\n"
                                  "echo '{\"failed\": [1, \"vector::_M_default_append\"]}'\n");
  std::filesystem::permissions(program, std::filesystem::perms::owner_all);
  const Guard guard{.program = program, .staging = path("incoming"), .allow_weak_sandbox = true};

  const auto reports = guarded_ingest(db_, guard, {write_file("a.nc", "x")}, options_,
                                      core::from_unix_seconds(1.8e9), {}, {}, {});

  ASSERT_EQ(reports.size(), 1U);
  EXPECT_EQ(reports.front().errors, Messages{messages::ingest_file_message<"reader-failed">()});
  EXPECT_EQ(reports.front().technical_cause, "vector::_M_default_append");
}

TEST_F(GuardedIngest, StoresWhatReadingInThisProcessStores) {
  const auto files = good_files();
  auto here = repository::open_store_in_memory();
  const auto expected = ingest_files(here, files, options_, core::from_unix_seconds(1.8e9), {}, {});

  const auto found = guarded(files);

  ASSERT_EQ(found.size(), expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_EQ(found[i].file, expected[i].file);
    EXPECT_EQ(found[i].status, expected[i].status) << words(found[i]);
    EXPECT_EQ(found[i].warnings, expected[i].warnings);
    EXPECT_EQ(found[i].errors, expected[i].errors);
    ASSERT_EQ(found[i].dataset.has_value(), expected[i].dataset.has_value());
    if (!found[i].dataset) continue;
    EXPECT_EQ(found[i].dataset->id, expected[i].dataset->id);
    EXPECT_EQ(found[i].dataset->rows_accepted, expected[i].dataset->rows_accepted);
    EXPECT_EQ(found[i].dataset->provenance.sha256, expected[i].dataset->provenance.sha256);
  }
  EXPECT_GE(stored_datasets(), 4U);
  EXPECT_EQ(rows_of_data(db_), rows_of_data(here));
  EXPECT_EQ(names_in(guard_.staging), std::set<std::string>{});
}

TEST_F(GuardedIngest, SaysThatTheSameFileIsStoredAlready) {
  CurrentFile{}.write(path("currents.nc"));
  ASSERT_EQ(guarded({path("currents.nc")}).front().status, IngestStatus::stored);
  const auto before = rows_of_data(db_);

  const auto again = guarded({path("currents.nc")});

  EXPECT_EQ(again.front().status, IngestStatus::unchanged);
  EXPECT_EQ(again.front().dataset->kind, repository::DatasetKind::currents);
  EXPECT_EQ(rows_of_data(db_), before);
}

TEST_F(GuardedIngest, ReadsAFileAgainThatAnEarlierProgramMisread) {
  CurrentFile{}.write(path("currents.nc"));
  ASSERT_EQ(guarded({path("currents.nc")}).front().status, IngestStatus::stored);
  const auto before = rows_of_data(db_);
  sql::execute(db_, "UPDATE dataset SET outdated = 1; DELETE FROM field_chunk");

  const auto again = guarded({path("currents.nc")});

  EXPECT_EQ(again.front().status, IngestStatus::stored) << words(again.front());
  EXPECT_EQ(rows_of_data(db_), before);
  EXPECT_EQ(stored_datasets(), 1U);
  EXPECT_EQ(guarded({path("currents.nc")}).front().status, IngestStatus::unchanged);
}

TEST_F(GuardedIngest, RefusesTheOneFileWhoseReaderIsKilledAndKeepsTheOthers) {
  const auto files = good_files();
  ASSERT_EQ(guarded({path("zone.geojson")}).front().status, IngestStatus::stored);
  const auto before = rows_of_data(db_);

  CurrentFile long_one;  // which a reader is still reading when it is killed because of its first event
  for (int hour = 1; hour < 3000; ++hour) long_one.times.push_back(6.0 + hour);
  long_one.value = [](char, std::size_t t, std::size_t, std::size_t y, std::size_t x) {
    return 0.001 * static_cast<double>(t % 100 + 10 * y + x);
  };
  long_one.write(path("long.nc"));

  const auto reports = guarded({path("long.nc")}, [](std::string_view, double) { kill_children(); });

  ASSERT_EQ(reports.size(), 1U);
  EXPECT_EQ(reports.front().status, IngestStatus::refused);
  EXPECT_EQ(reports.front().errors.size(), 1U);
  EXPECT_EQ(rows_of_data(db_), before);
  EXPECT_EQ(names_in(guard_.staging), std::set<std::string>{});
  EXPECT_EQ(guarded(files).size(), files.size());
}

TEST_F(GuardedIngest, EndsAtOnceWhenItIsStoppedAndStoresNothing) {
  CurrentFile{}.write(path("currents.nc"));
  std::stop_source source;

  const auto reports = guarded(
      {path("currents.nc")}, [&](std::string_view, double) { source.request_stop(); }, source.get_token());

  EXPECT_TRUE(reports.empty());
  EXPECT_EQ(stored_datasets(), 0U);
  EXPECT_EQ(names_in(guard_.staging), std::set<std::string>{});
}

TEST_F(GuardedIngest, RemovesWhatAKilledProcessLeftBehind) {
  std::filesystem::create_directories(guard_.staging / "left-behind");
  std::ofstream{guard_.staging / "left-behind" / "floeplan.sqlite"} << "half a dataset";
  CurrentFile{}.write(path("currents.nc"));

  EXPECT_EQ(guarded({path("currents.nc")}).front().status, IngestStatus::stored);

  EXPECT_EQ(names_in(guard_.staging), std::set<std::string>{});
}

TEST_F(GuardedIngest, SaysThatTheMachineFailedWhenItsProgramIsNotThere) {
  CurrentFile{}.write(path("currents.nc"));
  const Guard broken{.program = path("no-program"), .staging = path("incoming")};
  EXPECT_THROW(static_cast<void>(guarded_ingest(db_, broken, {path("currents.nc")}, {},
                                                core::from_unix_seconds(1.8e9), {}, {}, {})),
               std::runtime_error);
}

TEST_F(GuardedIngest, ConfinesTheProcessThatReads) {
  const auto layers = layers_in_force(guard_);
  ASSERT_TRUE(layers.has_value());
  EXPECT_TRUE(sandbox::is_enough(*layers)) << sandbox::to_text(*layers);
}

TEST_F(GuardedIngest, RefusesEveryFileWhereTheReaderCannotBeConfinedUnlessThatIsAllowed) {
  const Guard weak{.program = support::program_folder() + "/reader_on_old_kernel",
                   .staging = guard_.staging,
                   .allow_weak_sandbox = false};
  Guard allowed = weak;
  allowed.allow_weak_sandbox = true;
  CurrentFile{}.write(path("currents.nc"));
  const auto read = [&](const Guard& guard) {
    return guarded_ingest(db_, guard, {path("currents.nc"), write_file("bergs.geojson", point_)}, options_,
                          core::from_unix_seconds(1.8e9), {}, {}, {});
  };

  EXPECT_EQ(layers_in_force(weak), (sandbox::Layers{.system_calls = true, .landlock = 0}));
  const auto refused = read(weak);
  ASSERT_EQ(refused.size(), 2U);
  for (const IngestReport& report : refused) {
    EXPECT_EQ(report.status, IngestStatus::refused);
    EXPECT_THAT(words(report), HasSubstr("--allow-weak-sandbox"));
  }
  EXPECT_EQ(stored_datasets(), 0U);

  for (const IngestReport& report : read(allowed))
    EXPECT_EQ(report.status, IngestStatus::stored) << words(report);
}

/// Bytes that make libhdf5 crash or run without end are found by trying; which of them do differs between its versions.
TEST_F(GuardedIngest, OutlivesNetcdfFilesWithBytesChanged) {
  CurrentFile{}.write(path("good.nc"));
  std::ifstream in{path("good.nc"), std::ios::binary};
  const std::string whole{std::istreambuf_iterator<char>{in}, {}};
  ASSERT_EQ(guarded({write_file("bergs.geojson", point_)}).front().status, IngestStatus::stored);
  const auto before = rows_of_data(db_);
  support::for_each_seed(12, [&](std::mt19937_64& rng) {
    std::string bytes = whole;
    for (int flips = support::uniform_int(rng, 1, 8); flips > 0; --flips)
      bytes[std::uniform_int_distribution<std::size_t>{0, bytes.size() - 1}(rng)] =
          static_cast<char>(support::uniform_int(rng, 0, 255));
    for (const IngestReport& report : guarded({write_file("damaged.nc", bytes)}))
      if (report.dataset) repository::DatasetRepository{db_}.remove(report.dataset->id);
    EXPECT_EQ(rows_of_data(db_), before);
  });
}

}  // namespace
}  // namespace floeplan::ingest::guarded_ingest_test
