#include <iomanip>
#include <iostream>
#include <memory>

#include "server/cli/program/command.hpp"
#include "storage/ingest/data_formats.hpp"
#include "storage/json/json.hpp"

namespace floeplan::cli {
namespace {

std::vector<std::string> kinds_of(const ingest::DataFormat& format) {
  std::vector<std::string> kinds;
  for (const repository::DatasetKind kind : format.kinds) kinds.push_back(repository::kind_name(kind));
  return kinds;
}

int list_formats(bool json_out) {
  if (json_out) {
    nlohmann::json documents = nlohmann::json::array();
    for (const ingest::DataFormat& format : ingest::data_formats())
      documents.push_back({{"name", std::string{format.name}},
                           {"kinds", kinds_of(format)},
                           {"reads", std::string{format.reads}},
                           {"tested_with", std::string{format.tested_with}}});
    std::cout << documents.dump(2) << '\n';
    return done;
  }
  constexpr int indent = 26;  // the longest name has 24 letters
  for (const ingest::DataFormat& format : ingest::data_formats()) {
    std::string kinds;
    for (const std::string& kind : kinds_of(format)) kinds += (kinds.empty() ? "" : ", ") + kind;
    std::cout << std::left << std::setw(indent) << format.name << kinds << '\n'
              << std::string(indent, ' ') << format.reads << '\n'
              << std::string(indent, ' ') << "tested with: " << format.tested_with << '\n';
  }
  return done;
}

}  // namespace

void add_formats(CLI::App& app, Program& program) {
  auto json_out = std::make_shared<bool>(false);
  auto* command = app.add_subcommand(
      "formats", "List the formats of data that ingest reads, and the kinds of data in them");
  command->add_flag("--json", *json_out, "Answer with one JSON document");
  command->callback([json_out, &program] { program.exit_code = list_formats(*json_out); });
}

}  // namespace floeplan::cli
