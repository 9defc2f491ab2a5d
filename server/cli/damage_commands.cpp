#include <iostream>
#include <memory>

#include "server/cli/program/command.hpp"
#include "storage/json/json.hpp"
#include "storage/repository/store/damage.hpp"
#include "storage/repository/store/replacement.hpp"
#include "storage/repository/store/store_lock.hpp"
#include "storage/sql/store_file.hpp"

namespace floeplan::cli {
namespace {

std::string in_words(const repository::StoredThing& thing) {
  return thing.kind + " " +
         (thing.id.empty() ? "(name unknown, row " + std::to_string(thing.row) + ")" : thing.id);
}

nlohmann::json to_json(const std::vector<repository::StoredThing>& things) {
  auto list = nlohmann::json::array();
  for (const auto& thing : things)
    list.push_back(
        {{"kind", thing.kind}, {"id", thing.id.empty() ? nlohmann::json{} : nlohmann::json{thing.id}}});
  return list;
}

nlohmann::json to_json(const repository::Damage& damage) {
  return {{"status", damage.is_none() ? "whole" : "damaged"},
          {"things", to_json(damage.things)},
          {"tables", damage.tables},
          {"pages", damage.pages},
          {"structure", damage.structure}};
}

void print_damage(const repository::Damage& damage) {
  if (damage.is_none()) {
    std::cout << "whole: every page, dataset, plan, simulation, job and token is as it was written\n";
    return;
  }
  for (const auto& thing : damage.things) std::cout << "damaged  " << in_words(thing) << '\n';
  for (const std::string& table : damage.tables)
    std::cout << "damaged  a part of the table " << table << '\n';
  if (!damage.structure.empty()) std::cout << "damaged  " << damage.structure << '\n';
  std::cout << damage.pages.size() << " changed pages";
  if (damage.things.empty() && damage.tables.empty() && damage.structure.empty())
    std::cout << " hold an index or nothing: no dataset, plan, simulation, job or token is lost";
  std::cout << "\nfloeplan repair keeps everything undamaged and drops the rest; floeplan restore FILE "
               "brings back a backup\n";
}

int verify(bool as_json, const Program& program) {
  refuse_store_at_server(program);
  auto db = open_existing_store(program);
  const auto damage = repository::find_damage(db, terminal_progress());
  if (as_json)
    std::cout << to_json(damage).dump(2) << '\n';
  else
    print_damage(damage);
  return damage.is_none() ? done : bad_data;
}

int repair(bool as_json, const Program& program) {
  refuse_store_at_server(program);
  if (!std::filesystem::exists(sql::database_in(program.store)))
    return complain<"no-store-to-keep">(could_not, program.store.string());
  const repository::StoreLock lock{program.store};
  const auto replacement = repository::repair_store(program.store, terminal_progress());
  if (as_json) {
    std::cout
        << nlohmann::json{{"lost", to_json(replacement.lost)}, {"kept", replacement.kept.string()}}.dump(2)
        << '\n';
    return done;
  }
  for (const auto& thing : replacement.lost) std::cout << "lost     " << in_words(thing) << '\n';
  std::cout << (replacement.lost.empty() ? "nothing was lost" : "everything undamaged was kept")
            << "; the store as it was lies in " << replacement.kept.string() << '\n';
  return done;
}

}  // namespace

void add_verify(CLI::App& app, Program& program) {
  auto as_json = std::make_shared<bool>(false);
  auto* command =
      app.add_subcommand("verify", "Check the whole store and list damage; a server may be running");
  command->add_flag("--json", *as_json, "Answer with one JSON document");
  command->callback([as_json, &program] { program.exit_code = verify(*as_json, program); });
}

void add_repair(CLI::App& app, Program& program) {
  auto as_json = std::make_shared<bool>(false);
  auto* command = app.add_subcommand(
      "repair", "Save the undamaged part of a store and list what is lost; no server may be running");
  command->add_flag("--json", *as_json, "Answer with one JSON document");
  command->callback([as_json, &program] { program.exit_code = repair(*as_json, program); });
}

}  // namespace floeplan::cli
