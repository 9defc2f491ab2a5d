#pragma once

#include "server/cli/program/command.hpp"

namespace floeplan::cli {

// What can be asked of plans that are stored.
void add_recheck(CLI::App& app, Program& program);
void add_compare(CLI::App& app, Program& program);

}  // namespace floeplan::cli
