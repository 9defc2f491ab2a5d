#pragma once

#include "server/cli/program/command.hpp"

namespace floeplan::cli {

/// Subcommands of whoever runs a server for others.
void add_token(CLI::App& app, Program& program);
void add_audit(CLI::App& app, Program& program);
void add_backup(CLI::App& app, Program& program);
void add_restore(CLI::App& app, Program& program);
void add_verify(CLI::App& app, Program& program);
void add_repair(CLI::App& app, Program& program);

}  // namespace floeplan::cli
