#pragma once

#include <CLI/CLI.hpp>
#include <functional>

namespace floeplan::manual {

/// Adds the commands help, completion and, for whoever makes a package, write-manual. They look at all commands of `app`
/// when they run, on whose lives they depend.
/// `refuse`  says on stderr what is wrong and has the program end so
void add_manual_commands(CLI::App& app, const std::function<void(const std::string&)>& refuse);

}  // namespace floeplan::manual
