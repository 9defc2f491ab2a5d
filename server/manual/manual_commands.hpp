#pragma once

#include <CLI/CLI.hpp>
#include <functional>

namespace floeplan::manual {

/// Adds the commands help, completion and, for packagers, write-manual. They read all commands of `app` when
/// they run, so `app` must still exist then.
/// `refuse`  prints a fault on stderr and sets the exit code
void add_manual_commands(CLI::App& app, const std::function<void(const std::string&)>& refuse);

}  // namespace floeplan::manual
