#include <memory>

#include "server/cli/program/command.hpp"
#include "storage/ingest/process/reader_main.hpp"

namespace floeplan::cli {

void add_read_files(CLI::App& app, Program& program) {
  struct Arguments {
    std::filesystem::path staging;
    std::vector<std::filesystem::path> files;
  };
  auto arguments = std::make_shared<Arguments>();
  auto* command =
      app.add_subcommand("read-files", "What this program starts itself as to read foreign files");
  command->group("");  // internal, so not shown in the help
  command->add_option("STAGING", arguments->staging)->required();
  command->add_option("FILE", arguments->files);
  command->callback([arguments, &program] {
    program.exit_code = ingest::read_foreign_files(arguments->staging, arguments->files);
  });
}

}  // namespace floeplan::cli
