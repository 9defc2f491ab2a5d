#include <iostream>
#include <memory>

#include "engine/core/utc_text.hpp"
#include "server/cli/command.hpp"
#include "storage/demo/write_demo.hpp"

namespace floeplan::cli {
namespace {

struct DemoFlags {
  std::filesystem::path directory;
  std::string scenario{"disko"};
  std::uint64_t seed{1};
  std::string start{"2026-11-22T00:00:00Z"};  // fixed, so that everybody gets the same files
};

int run_demo(const DemoFlags& flags) {
  const auto start = core::parse_iso8601(flags.start);
  if (!start) {
    return complain(wrong_usage,
                    "--start " + flags.start + " is not a time with its zone; as 2026-11-22T00:00:00Z");
  }
  for (const auto& file :
       demo::write_demo(flags.directory, *demo::parse_scenario(flags.scenario), flags.seed, *start)) {
    std::cout << file.string() << '\n';
  }
  std::cerr << "These data are synthetic and not for navigation; README.txt beside them says what is real.\n";
  return done;
}

}  // namespace

void add_demo(CLI::App& app, Program& program) {
  auto flags = std::make_shared<DemoFlags>();
  auto* command = app.add_subcommand("demo", "Write synthetic demonstration data in real file formats");
  command->add_option("DIR", flags->directory, "Folder to write into, made when missing")->required();
  command->add_option("--scenario", flags->scenario, "disko, river or jet")
      ->check(CLI::IsMember({"disko", "river", "jet"}))
      ->capture_default_str();
  command->add_option("--seed", flags->seed, "Same seed, same bytes")->capture_default_str();
  command->add_option("--start", flags->start, "First hour of the currents")->capture_default_str();
  command->callback([flags, &program] { program.exit_code = run_demo(*flags); });
}

}  // namespace floeplan::cli
