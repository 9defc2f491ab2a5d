#pragma once

namespace floeplan::sandbox {

/// Permanently restricts this process to the system calls for reading, computing and writing to open files
/// and folders. All others fail with EPERM: among them sockets of any family, starting programs and processes
/// (threads are allowed), signals to other processes, tracing, mounting, changes of owners, modes, times and
/// limits, truncating a file by its name, memory that is both writable and executable, io_uring and
/// namespaces. The filter does not restrict which paths are opened.
/// Returns  whether it is in force; false: the kernel has no filters, or another filter forbids the call
/// Source   libseccomp 2.5; man 2 seccomp
[[nodiscard]] bool restrict_system_calls();

}  // namespace floeplan::sandbox
