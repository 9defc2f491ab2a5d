#include <chrono>
#include <iostream>
#include <memory>
#include <optional>

#include "engine/core/utc_text.hpp"
#include "server/cli/program/command.hpp"
#include "server/cli/program/flag_values.hpp"
#include "server/manual/completion.hpp"
#include "storage/demo/write_demo.hpp"
#include "storage/json/json.hpp"

namespace floeplan::cli {
namespace {

struct DemoFlags {
  std::filesystem::path directory;
  std::string scenario{"disko"};
  std::uint64_t seed{1};
  std::optional<std::string> start;
  bool json_out{};
};

/// 00:00 UTC of this day, so that the data are valid now.
core::UtcTime today() { return std::chrono::floor<std::chrono::days>(now()); }

/// A path as a word of a command, in quotes only if it needs them.
std::string word_of(const std::filesystem::path& path) {
  constexpr auto plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789/._-";
  const std::string text = path.string();
  return text.find_first_not_of(plain) == std::string::npos ? text : manual::quoted(text);
}

/// Prints the commands that read the data into a store and plan with them, to be copied as they are.
void show_commands(const DemoFlags& flags, const std::vector<std::string>& example, const Program& program) {
  const std::filesystem::path store = program.store == default_store() ? "store" : program.store;
  const std::string begin = "  floeplan --data " + word_of(store);
  std::cerr << "Read them into a store and plan:\n"
            << begin << " ingest " << word_of(flags.directory / (flags.scenario + "-")) << "*\n"
            << begin;
  for (const std::string& word : example) std::cerr << ' ' << word;
  std::cerr << '\n';
  if (flags.scenario == "disko")
    std::cerr << "For a plan under ice:\n  floeplan demo ice/ --scenario pack-ice\n";
}

int run_demo(const DemoFlags& flags, const Program& program) {
  const auto start = flags.start ? core::parse_iso8601(*flags.start) : today();
  if (!start) {
    throw flag_fault<"no-date-and-no-moment">("--start", *flags.start);
  }
  const demo::Scenario scenario = *demo::parse_scenario(flags.scenario);
  const auto files = demo::write_demo(flags.directory, scenario, flags.seed, *start);
  const std::vector<std::string> example = demo::example_request(scenario, *start);
  if (flags.json_out) {
    nlohmann::ordered_json names = nlohmann::ordered_json::array();
    for (const auto& file : files) names.push_back(file.string());
    std::cout << nlohmann::ordered_json{{"scenario", flags.scenario},
                                        {"seed", flags.seed},
                                        {"start", core::iso8601(*start)},
                                        {"files", names},
                                        {"example", example}}
                     .dump(2)
              << '\n';
  } else {
    for (const auto& file : files) std::cout << file.string() << '\n';
  }
  std::cerr << "caution: " << messages::command_text<"data-synthetic">() << '\n';
  show_commands(flags, example, program);
  return done;
}

}  // namespace

void add_demo(CLI::App& app, Program& program) {
  auto flags = std::make_shared<DemoFlags>();
  auto* command = app.add_subcommand("demo", "Write synthetic demonstration data in real file formats");
  command->add_option("DIR", flags->directory, "Folder to write into, made when missing")->required();
  command
      ->add_option("--scenario", flags->scenario,
                   "disko: Disko Bay; strait: a tide stronger than a glider; pack-ice: ice with leads; "
                   "river, jet: of Eichhorn 2009")
      ->check(CLI::IsMember(demo::scenario_names()))
      ->capture_default_str();
  command->add_option("--seed", flags->seed, "Same seed and start, same bytes")->capture_default_str();
  command->add_option("--start", flags->start,
                      "First hour of the data, ISO 8601 with zone or a date; default: today, 00:00 UTC");
  command->add_flag("--json", flags->json_out, "Answer with one JSON document");
  command->callback([flags, &program] { program.exit_code = run_demo(*flags, program); });
}

}  // namespace floeplan::cli
