#pragma once

#include <string>

#include "storage/sandbox/landlock.hpp"

namespace floeplan::sandbox {

/// The layers of a confinement that are in force.
struct Layers {
  bool system_calls{false};  // a filter of system calls (seccomp)
  int landlock{};            // version in force; 0: none

  friend bool operator==(const Layers&, const Layers&) = default;
};

/// Whether a process in these layers may be given foreign bytes. It needs the filter, and Landlock in version 2 at least
/// (Linux 5.19; Debian 12 has 6.1). Without Landlock it could read every file of its user; without the filter it could
/// speak to the network.
[[nodiscard]] bool is_enough(const Layers& layers);

/// "seccomp, Landlock 7"; "seccomp, no Landlock"
[[nodiscard]] std::string to_text(const Layers& layers);

/// Confines this process for good to the files that it needs and to harmless system calls, with every layer that the
/// machine has. It gains no privileges afterwards, whatever it starts.
/// Returns  the layers in force
/// Errors   std::runtime_error when a layer is there and cannot be used, or when threads run that Landlock would not
///          reach (never under the thread sanitizer, which has its own)
[[nodiscard]] Layers confine(const FileNeeds& needs);

}  // namespace floeplan::sandbox
