#include <iomanip>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "api/codec/dataset_document.hpp"
#include "engine/core/utc_text.hpp"
#include "server/cli/command.hpp"
#include "storage/repository/dataset_repository.hpp"
#include "storage/repository/migrations.hpp"

namespace floeplan::cli {
namespace {

using nlohmann::json;

struct Flags {
  bool json_out{false};
  std::string remove_id;
};

int list(const Flags& flags, const Program& program) {
  auto db = repository::open_store(program.store);
  const auto datasets = repository::DatasetRepository{db}.list();
  if (flags.json_out) {
    json documents = json::array();
    for (const auto& dataset : datasets) documents.push_back(codec::dataset_document(dataset));
    std::cout << json{{"datasets", documents}}.dump(2) << '\n';
    return done;
  }
  for (const auto& dataset : datasets) {
    std::cout << std::left << std::setw(22) << dataset.id.value << ' ' << std::fixed << std::setprecision(2)
              << dataset.bounds.west_deg << ',' << dataset.bounds.south_deg << ',' << dataset.bounds.east_deg
              << ',' << dataset.bounds.north_deg;
    if (dataset.time_start) std::cout << "  " << core::iso8601(*dataset.time_start);
    if (dataset.time_end) std::cout << " to " << core::iso8601(*dataset.time_end);
    std::cout << "  " << dataset.name << '\n';
  }
  if (datasets.empty()) std::cout << "The store is empty: floeplan ingest FILE... reads data into it.\n";
  return done;
}

int remove(const Flags& flags, const Program& program) {
  auto db = repository::open_store(program.store);
  if (repository::DatasetRepository{db}.remove({flags.remove_id})) return done;
  return complain(could_not, "no dataset has the id " + flags.remove_id + "; floeplan datasets lists them");
}

}  // namespace

void add_datasets(CLI::App& app, Program& program) {
  auto flags = std::make_shared<Flags>();
  auto* command = app.add_subcommand("datasets", "List and remove what the store holds");
  command->add_flag("--json", flags->json_out, "Answer with one JSON document");
  auto* removal = command->add_subcommand("remove", "Remove a dataset and everything that belongs to it");
  removal->add_option("ID", flags->remove_id, "As the list shows it")->required();
  command->callback([flags, removal, &program] {
    program.exit_code = removal->parsed() ? remove(*flags, program) : list(*flags, program);
  });
}

}  // namespace floeplan::cli
