#include <gtest/gtest.h>
#include <signal.h>  // NOLINT: kill is POSIX, not in <csignal>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdint>

#include "storage/repository/datasets/dataset_repository.hpp"
#include "storage/repository/fields/field_repository.hpp"
#include "storage/repository/store/migrations.hpp"
#include "storage/repository/work/job_repository.hpp"
#include "storage/sql/transaction.hpp"
#include "storage/sql/upkeep.hpp"
#include "tests/storage/repository/datasets/sample_data.hpp"
#include "tests/support/property.hpp"
#include "tests/support/temporary_folder.hpp"

namespace floeplan::repository::kill_test {
namespace {

constexpr std::size_t nodes = 100;

std::string name_of(std::uint32_t round) { return "round-" + std::to_string(round); }

/// One ingestion and one job; both are on disk when it returns.
void commit_round(sql::Connection& db, std::uint32_t round) {
  JobRecord job;
  job.id = {name_of(round)};
  job.process = "plan-route";
  JobRepository{db}.submit(job);

  sql::Transaction ingestion{db};
  const DatasetId id{name_of(round)};
  DatasetRepository{db}.insert(sample_dataset(id.value, DatasetKind::currents));
  FieldRepository fields{db};
  std::vector<double> axis(nodes);
  for (std::size_t i = 0; i < nodes; ++i) axis[i] = 0.1 * static_cast<double>(i);
  fields.create(id, {{geo::GeographicFrame{}, ocean::Axis{axis}, ocean::Axis{axis}}, {}, {}});
  const std::vector<float> slice(nodes * nodes, static_cast<float>(round));
  for (const char* variable : {"u_m_s", "v_m_s"}) fields.write_slice(id, variable, 0, 0, slice);
  ingestion.commit();
}

/// Commits rounds without end and reports each through the pipe after its commit has returned.
[[noreturn]] void write_until_killed(const std::filesystem::path& store, int acknowledgements) {
  try {
    sql::Connection db = open_store(store);
    for (std::uint32_t round = 1;; ++round) {
      commit_round(db, round);
      if (write(acknowledgements, &round, sizeof round) != sizeof round) _exit(2);
    }
  } catch (const std::exception&) {
    _exit(1);
  }
}

/// The last round that was acknowledged by a writer which was killed some microseconds after its first rounds; with
/// none to wait for, that is while it creates the store.
std::uint32_t last_round_of_killed_writer(const std::filesystem::path& store, std::uint32_t rounds_first,
                                          int then_us) {
  int ends[2];
  if (pipe(ends) != 0) throw std::runtime_error{"no pipe"};
  const pid_t child = fork();
  if (child == 0) {
    close(ends[0]);
    write_until_killed(store, ends[1]);
  }
  close(ends[1]);
  std::uint32_t last = 0;
  const auto read_round = [&] { return read(ends[0], &last, sizeof last) == sizeof last; };
  while (last < rounds_first && read_round()) continue;
  usleep(static_cast<useconds_t>(then_us));
  kill(child, SIGKILL);

  while (read_round()) continue;
  close(ends[0]);
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_TRUE(WIFSIGNALED(status)) << "the writer stopped by itself, with " << status;
  return last;
}

bool is_whole(sql::Connection& db, const DatasetId& id, std::uint32_t round) {
  const auto currents =
      FieldRepository{db}.load_currents(id, {-180.0, -90.0, 180.0, 90.0}, std::nullopt, std::nullopt);
  const std::vector<float> expected(nodes * nodes, static_cast<float>(round));
  return currents && currents->samples().u == expected && currents->samples().v == expected;
}

TEST(KilledWriter, LosesNothingThatWasAcknowledgedAndLeavesNothingHalfDone) {
  support::for_each_seed(12, [&](std::mt19937_64& rng) {
    const support::TemporaryFolder folder;
    const auto rounds_first = static_cast<std::uint32_t>(rng() % 4);
    const std::uint32_t last =
        last_round_of_killed_writer(folder.path(), rounds_first, support::uniform_int(rng, 0, 30'000));
    ASSERT_GE(last, rounds_first);

    sql::Connection db = open_store(folder.path());

    ASSERT_EQ(sql::damage_of_structure(db), "");
    for (std::uint32_t round = 1; round <= last; ++round) {
      ASSERT_TRUE(JobRepository{db}.find({name_of(round)})) << round;
      ASSERT_TRUE(is_whole(db, {name_of(round)}, round)) << round;
    }
    // At most the round that was under way may be there as well, and then all of it.
    ASSERT_FALSE(DatasetRepository{db}.find({name_of(last + 2)}));
    if (DatasetRepository{db}.find({name_of(last + 1)})) {
      ASSERT_TRUE(is_whole(db, {name_of(last + 1)}, last + 1));
    }
  });
}

}  // namespace
}  // namespace floeplan::repository::kill_test
