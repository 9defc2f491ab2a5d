#include <iomanip>
#include <iostream>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "api/codec/documents/dataset_document.hpp"
#include "api/codec/inputs/retention_inputs.hpp"
#include "engine/core/utc_text.hpp"
#include "server/cli/program/command.hpp"
#include "server/cli/program/flag_values.hpp"
#include "storage/json/json.hpp"
#include "storage/repository/datasets/dataset_repository.hpp"
#include "storage/repository/datasets/retention.hpp"

namespace floeplan::cli {
namespace {

using nlohmann::json;

struct DatasetsFlags {
  bool json_out{false};
  std::string remove_id;
  std::optional<std::string> older_than;
  std::optional<std::uint64_t> max_bytes;
  std::string kind{"all"};
  bool dry_run{false};
};

std::string area_cell(const geo::BoundingBox& bounds) {
  std::ostringstream cell;
  cell << std::fixed << std::setprecision(2) << bounds.west_deg << ',' << bounds.south_deg << ','
       << bounds.east_deg << ',' << bounds.north_deg;
  return cell.str();
}

/// From the first to the last time; "-" for data without times.
std::string period_cell(const repository::Dataset& dataset) {
  if (!dataset.time_start) return "-";
  const std::string from = core::iso8601(*dataset.time_start);
  return dataset.time_end ? from + " to " + core::iso8601(*dataset.time_end) : from;
}

int list_datasets(const DatasetsFlags& flags, const Program& program) {
  auto db = open_existing_store(program);
  const auto datasets = repository::DatasetRepository{db}.list();
  if (flags.json_out) {
    json documents = json::array();
    for (const auto& dataset : datasets) documents.push_back(codec::dataset_document(dataset, {}, datasets));
    std::cout << json{{"datasets", documents}}.dump(2) << '\n';
    return done;
  }
  const auto line = [](const std::string& id, const std::string& area, const std::string& period,
                       const std::string& name) {
    std::cout << std::left << std::setw(22) << id << "  " << std::setw(28) << area << "  " << std::setw(44)
              << period << "  " << name << '\n';
  };
  if (!datasets.empty()) line("id", "west,south,east,north", "period", "name");
  for (const auto& dataset : datasets) {
    line(dataset.id.value, area_cell(dataset.bounds), period_cell(dataset), dataset.name);
    if (const auto mark = repository::stale_mark(dataset, datasets)) std::cout << "  " << mark->text << '\n';
  }
  if (datasets.empty()) std::cout << "The store is empty: floeplan ingest FILE... reads data into it.\n";
  return done;
}

int remove_datasets(const DatasetsFlags& flags, const Program& program) {
  auto db = open_existing_store(program);
  if (repository::DatasetRepository{db}.remove({flags.remove_id})) return done;
  return complain<"no-stored-dataset">(could_not, flags.remove_id);
}

int prune_datasets(const DatasetsFlags& flags, const Program& program) {
  repository::RetentionRules rules;
  if (flags.older_than) {
    rules.max_age = core::parse_iso8601_duration(*flags.older_than);
    if (!rules.max_age) throw flag_fault<"no-length-of-time">("--older-than", *flags.older_than);
  }
  if (flags.max_bytes) rules.max_bytes = static_cast<std::int64_t>(*flags.max_bytes);
  if (flags.kind != "all") rules.kind = repository::parse_kind(flags.kind);
  if (!rules.max_age && !rules.max_bytes) return complain<"nothing-to-prune">(wrong_usage);

  auto db = open_existing_store(program);
  const auto gone = flags.dry_run ? repository::beyond_retention(repository::stored_sizes(db), rules, now())
                                  : repository::remove_beyond_retention(db, rules, now());
  if (flags.json_out) {
    std::cout << codec::retention_document(gone, flags.dry_run).dump(2) << '\n';
    return done;
  }
  for (const auto& each : gone)
    std::cout << (flags.dry_run ? "would remove  " : "removed  ") << each.dataset.id.value << "  "
              << each.bytes << " bytes  " << each.dataset.name << '\n';
  if (gone.empty()) std::cout << "Nothing is beyond these rules.\n";
  return done;
}

}  // namespace

void add_datasets(CLI::App& app, Program& program) {
  auto flags = std::make_shared<DatasetsFlags>();
  auto* command = app.add_subcommand("datasets", "List and remove what the store holds");
  command->add_flag("--json", flags->json_out, "Answer with one JSON document");
  auto* removal = command->add_subcommand("remove", "Remove a dataset and everything that belongs to it");
  removal->add_option("ID", flags->remove_id, "As the list shows it")->required();
  auto* pruning = command->add_subcommand("prune",
                                          "Remove old data by rules. Data without time (depths, coasts, "
                                          "tides, zones) and the last dataset of each kind "
                                          "always stay");
  pruning->add_option("--older-than", flags->older_than,
                      "Data that ended (or were ingested, if later) longer ago than this, for example P30D");
  pruning
      ->add_option("--max-size", flags->max_bytes,
                   "The oldest data, until the samples of the rest take no more; for example 20GB")
      ->transform(CLI::AsSizeValue(true));
  pruning->add_option("--kind", flags->kind, "Data of this kind only")
      ->check(CLI::IsMember({"all", "currents", "wind", "ice", "water-levels", "icebergs", "glider-tracks"}))
      ->capture_default_str();
  pruning->add_flag("--dry-run", flags->dry_run, "List the datasets that would go, and remove nothing");
  pruning->add_flag("--json", flags->json_out, "Answer with one JSON document");
  command->callback([flags, removal, pruning, &program] {
    program.exit_code = removal->parsed()   ? remove_datasets(*flags, program)
                        : pruning->parsed() ? prune_datasets(*flags, program)
                                            : list_datasets(*flags, program);
  });
}

}  // namespace floeplan::cli
