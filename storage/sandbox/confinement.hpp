#pragma once

#include <string>

#include "storage/sandbox/landlock.hpp"

namespace floeplan::sandbox {

/// The layers of a sandbox that are in force.
struct Layers {
  bool system_calls{false};  // a filter of system calls (seccomp)
  int landlock{};            // Landlock version in force; 0: none

  friend bool operator==(const Layers&, const Layers&) = default;
};

/// Whether a process in these layers may read files from outside. It needs the filter, and at least version 2
/// of Landlock (Linux 5.19; Debian 12 has 6.1). Without Landlock it could read all files of its user; without
/// the filter it could use the network.
[[nodiscard]] bool is_enough(const Layers& layers);

/// The layers as text: "seccomp, Landlock 7"; "seccomp, no Landlock".
[[nodiscard]] std::string to_text(const Layers& layers);

/// Permanently confines this process to the files that it needs and to harmless system calls, with all layers that
/// the machine offers. Neither the process nor programs that it starts can gain privileges afterwards.
/// Returns  the layers in force
/// Errors   std::runtime_error when a layer exists but cannot be used, or when other threads run, which Landlock
///          would not confine (not checked under the thread sanitizer, which has threads of its own)
[[nodiscard]] Layers confine(const FileNeeds& needs);

}  // namespace floeplan::sandbox
