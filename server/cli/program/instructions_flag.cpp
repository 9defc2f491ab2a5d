#include "server/cli/program/instructions_flag.hpp"

#include <map>
#include <string>

#include "engine/motion/edge_fan.hpp"

namespace floeplan::cli {
namespace {

/// By name, those that this processor can take.
std::map<std::string, motion::FanPath> instruction_sets() {
  std::map<std::string, motion::FanPath> sets;
  for (const motion::FanPath path : motion::fan_paths()) {
    switch (path) {
      case motion::FanPath::reference: sets["reference"] = path; break;
      case motion::FanPath::baseline: sets["baseline"] = path; break;
      case motion::FanPath::avx2: sets["avx2"] = path; break;
      case motion::FanPath::avx512: sets["avx512"] = path; break;
    }
  }
  return sets;
}

}  // namespace

void add_instructions(CLI::App& app) {
  const std::map<std::string, motion::FanPath> sets = instruction_sets();
  app.add_option_function<std::string>(
         "--instructions", [sets](const std::string& name) { motion::limit_fan_paths(sets.at(name)); })
      ->check(CLI::IsMember(sets))
      ->group("");
}

}  // namespace floeplan::cli
