#pragma once

namespace floeplan::sandbox {

/// Leaves to this process the system calls that reading, computing and writing to open files and folders take, for
/// good. Refused with EPERM are all others, among them sockets of any family, starting programs and processes (threads
/// stay), signals to others, tracing, mounting, changes of owners, modes, times and limits, cutting a file short by its
/// name, memory that can be written and executed, io_uring and namespaces.
/// Which paths are opened is no matter of this filter.
/// Returns  whether it is in force; false: the kernel has no filters, or another one keeps the call away
/// Source   libseccomp 2.5; man 2 seccomp
[[nodiscard]] bool restrict_system_calls();

}  // namespace floeplan::sandbox
