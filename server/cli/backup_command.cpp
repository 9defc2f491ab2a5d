#include <cmath>
#include <iostream>
#include <memory>

#include "server/cli/operator_commands.hpp"
#include "storage/repository/migrations.hpp"
#include "storage/repository/store_lock.hpp"
#include "storage/sqlite/backup.hpp"

namespace floeplan::cli {
namespace {

namespace fs = std::filesystem;

int back_up(const fs::path& file, const Program& program) {
  if (!fs::exists(program.store / "floeplan.sqlite"))
    return complain(could_not,
                    "there is no store in " + program.store.string() + "; name its folder with --data");
  auto db = repository::open_store(program.store);
  sqlite::back_up(db, file);
  std::cout << file.string() << '\n';
  return done;
}

/// What was there goes aside under a name of its own, with the log that belongs to it. False when there was nothing.
bool set_aside(const fs::path& store, const fs::path& place) {
  if (!fs::exists(store / "floeplan.sqlite")) return false;
  for (const char* ending : {"", "-wal", "-shm"}) {
    const fs::path file = store / ("floeplan.sqlite" + std::string{ending});
    if (fs::exists(file)) fs::rename(file, place.string() + ending);
  }
  return true;
}

int restore(const fs::path& file, const Program& program) {
  if (!fs::exists(file)) return complain(could_not, "there is no file " + file.string() + "; name a backup");
  const std::string damage = sqlite::damage_of(file);
  if (!damage.empty())
    return complain(bad_data, file.string() + " cannot be restored; " + damage + "; take another backup");
  const repository::StoreLock lock{program.store};
  const fs::path arriving = program.store / "floeplan.sqlite.arriving";
  fs::copy_file(file, arriving, fs::copy_options::overwrite_existing);
  const fs::path aside =
      program.store / ("floeplan.sqlite.before-" + std::to_string(std::llround(core::unix_seconds(now()))));
  const bool was_there = set_aside(program.store, aside);
  fs::rename(arriving, program.store / "floeplan.sqlite");
  auto db = repository::open_store(program.store);  // an older backup comes up to date here
  std::cout << "restored " << file.string();
  if (was_there) std::cout << "; what was there before lies in " << aside.string();
  std::cout << '\n';
  return done;
}

}  // namespace

void add_backup(CLI::App& app, Program& program) {
  auto file = std::make_shared<fs::path>();
  auto* command = app.add_subcommand("backup", "Write the whole store into a file, while it is in use");
  command->add_option("FILE", *file, "A new file; its folder exists")->required();
  command->callback([file, &program] { program.exit_code = back_up(*file, program); });
}

void add_restore(CLI::App& app, Program& program) {
  auto file = std::make_shared<fs::path>();
  auto* command =
      app.add_subcommand("restore", "Put a backup in the place of the store; no server may be running");
  command->add_option("FILE", *file, "As floeplan backup wrote it")->required();
  command->callback([file, &program] { program.exit_code = restore(*file, program); });
}

}  // namespace floeplan::cli
