#include <iostream>
#include <memory>

#include "server/cli/program/command.hpp"
#include "storage/repository/store/migrations.hpp"
#include "storage/repository/store/replacement.hpp"
#include "storage/repository/store/store_lock.hpp"
#include "storage/sql/driver/failure.hpp"
#include "storage/sql/store_file.hpp"
#include "storage/sql/upkeep.hpp"

namespace floeplan::cli {
namespace {

namespace fs = std::filesystem;

int back_up(const fs::path& file, const Program& program) {
  refuse_store_at_server(program);
  if (!fs::exists(sql::database_in(program.store)))
    return complain<"no-store-to-keep">(could_not, program.store.string());
  auto db = repository::open_store(program.store);
  sql::back_up(db, file);
  std::cout << file.string() << '\n';
  return done;
}

std::string words_for_kept(const fs::path& kept) {
  return kept.empty() ? "" : "; what was there before lies in " + kept.string();
}

int restore(const fs::path& file, const Program& program) {
  refuse_store_at_server(program);
  if (!fs::exists(file)) return complain<"no-backup-file">(could_not, file.string());
  const repository::StoreLock lock{program.store};
  try {
    const auto replacement = repository::restore_store(program.store, file, terminal_progress());
    std::cout << "restored " << file.string() << words_for_kept(replacement.kept) << '\n';
    return done;
  } catch (const sql::Failure&) {
    throw;
  } catch (const std::runtime_error& error) {
    return complain(bad_data, error.what());
  }
}

}  // namespace

void add_backup(CLI::App& app, Program& program) {
  auto file = std::make_shared<fs::path>();
  auto* command = app.add_subcommand("backup", "Write the whole store into a file, while it is in use");
  command->add_option("FILE", *file, "New file in an existing folder")->required();
  command->callback([file, &program] { program.exit_code = back_up(*file, program); });
}

void add_restore(CLI::App& app, Program& program) {
  auto file = std::make_shared<fs::path>();
  auto* command = app.add_subcommand("restore", "Replace the store by a backup; no server may be running");
  command->add_option("FILE", *file, "File written by floeplan backup")->required();
  command->callback([file, &program] { program.exit_code = restore(*file, program); });
}

}  // namespace floeplan::cli
