#pragma once

#include <filesystem>
#include <vector>

namespace floeplan::sandbox {

/// The files that a process needs.
struct FileNeeds {
  std::vector<std::filesystem::path> read;  // files, and folders with all below them
  std::filesystem::path write;  // the one folder in which it makes, changes and removes files; empty: none
};

/// Which version of Landlock the kernel offers.
/// Returns  0 where it offers none
/// Source   docs.kernel.org/userspace-api/landlock.html
[[nodiscard]] int landlock_version();

/// Takes from this thread, and from all that it starts, every file that is not needed, for good; it can execute none.
/// Links in the paths are followed now. What is not there is left out. As far as the kernel's Landlock knows them, also
/// TCP connections (version 4), control of devices (5), and signals and abstract sockets of other processes (6).
/// Changes of a file's owner, mode and times are no matter of Landlock, nor is cutting a file short before version 3: a
/// filter of system calls has to refuse them.
/// Returns  the version in force; 0: the kernel offers none, or another filter keeps the calls away
/// Errors   std::system_error when the kernel offers Landlock and refuses to use it
int restrict_files(const FileNeeds& needs);

}  // namespace floeplan::sandbox
