#pragma once

#include <filesystem>
#include <vector>

namespace floeplan::sandbox {

/// The files that a process needs.
struct FileNeeds {
  std::vector<std::filesystem::path> read;  // files, and folders with everything below them
  std::filesystem::path write;  // the only folder in which it creates, changes and removes files; empty: none
};

/// The Landlock version that the kernel offers.
/// Returns  0 if it offers none
/// Source   docs.kernel.org/userspace-api/landlock.html
[[nodiscard]] int landlock_version();

/// Permanently takes from this thread, and from all that it starts, the access to every file that is not
/// needed; no file can be executed. Links in the paths are resolved now. Paths that do not exist are ignored.
/// As far as the kernel's version supports it, also forbids TCP connections (version 4), control of devices
/// (5), and signals and abstract sockets of other processes (6). Landlock does not restrict changes of a
/// file's owner, mode and times, nor truncation before version 3; the filter of system calls has to forbid
/// these.
/// Returns  the version in force; 0: the kernel offers none, or another filter forbids the calls
/// Errors   std::system_error when the kernel offers Landlock but refuses to use it
int restrict_files(const FileNeeds& needs);

}  // namespace floeplan::sandbox
