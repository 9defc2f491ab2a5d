#include "storage/sandbox/system_call_filter.hpp"

#include <asm/termbits.h>
#include <fcntl.h>
#include <sched.h>
#include <seccomp.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <cerrno>
#include <initializer_list>
#include <memory>

namespace floeplan::sandbox {
namespace {

struct Release {
  void operator()(void* filter) const { seccomp_release(filter); }
};
using Filter = std::unique_ptr<void, Release>;

/// Calls of libraries and sanitizers that are allowed with any arguments.
constexpr auto harmless = {
    // open files
    "read", "write", "readv", "writev", "pread64", "pwrite64", "preadv", "pwritev", "preadv2", "pwritev2",
    "lseek", "_llseek", "close", "close_range", "dup", "dup2", "dup3", "fsync", "fdatasync", "ftruncate",
    "fallocate", "fadvise64", "flock", "sync_file_range", "copy_file_range", "sendfile",
    // file names
    "fstat", "stat", "lstat", "newfstatat", "fstatat64", "statx", "statfs", "fstatfs", "access", "faccessat",
    "faccessat2", "readlink", "readlinkat", "getcwd", "chdir", "fchdir", "getdents", "getdents64", "mkdir",
    "mkdirat", "rmdir", "unlink", "unlinkat", "rename", "renameat", "renameat2", "umask",
    // memory
    "munmap", "mremap", "brk", "madvise", "msync", "mincore", "membarrier",
    // threads, signals to itself, time
    "futex", "set_robust_list", "get_robust_list", "rseq", "set_tid_address", "sched_yield",
    "sched_getaffinity", "sched_getparam", "sched_getscheduler", "gettid", "getpid", "getppid", "exit",
    "exit_group", "rt_sigaction", "rt_sigprocmask", "rt_sigreturn", "rt_sigpending", "sigaltstack",
    "restart_syscall", "nanosleep", "clock_nanosleep", "clock_gettime", "clock_getres", "gettimeofday",
    "time", "times", "getrusage", "poll", "ppoll", "arch_prctl",
    // user, machine
    "getuid", "geteuid", "getgid", "getegid", "getresuid", "getresgid", "uname", "sysinfo", "getcpu",
    "getrandom", "getrlimit"};

void allow(void* filter, const char* name, std::initializer_list<scmp_arg_cmp> conditions) {
  const int number = seccomp_syscall_resolve_name(name);
  if (number == __NR_SCMP_ERROR) return;  // the call does not exist on this architecture
  seccomp_rule_add_array(filter, SCMP_ACT_ALLOW, number, static_cast<unsigned>(conditions.size()),
                         conditions.begin());
}

scmp_arg_cmp equals(unsigned argument, std::uint64_t value) { return {argument, SCMP_CMP_EQ, value, 0}; }

scmp_arg_cmp masked(unsigned argument, std::uint64_t mask, std::uint64_t value) {
  return {argument, SCMP_CMP_MASKED_EQ, mask, value};
}

/// Allows opening a file, except truncating one that is opened only for reading. Landlock forbids this only
/// since version 3.
void allow_opening(void* filter, const char* name, unsigned flags) {
  allow(filter, name, {masked(flags, O_TRUNC, 0)});
  allow(filter, name, {masked(flags, O_ACCMODE, O_WRONLY)});
  allow(filter, name, {masked(flags, O_ACCMODE, O_RDWR)});
}

/// Allows memory to be writable or executable, not both. Code is only mapped from files (character sets are
/// libraries).
void allow_memory(void* filter) {
  constexpr std::uint64_t both = PROT_WRITE | PROT_EXEC;
  for (const char* name : {"mmap", "mmap2"})
    for (const std::uint64_t one : {0, PROT_WRITE, PROT_EXEC}) allow(filter, name, {masked(2, both, one)});
  allow(filter, "mprotect", {masked(2, PROT_EXEC, 0)});
}

/// Allows threads, but no processes. The flags of clone3 are in memory, which a filter cannot read. So clone3 is
/// answered as if it did not exist, and the C library uses clone instead.
void allow_threads(void* filter) {
  allow(filter, "clone", {masked(0, CLONE_THREAD | CLONE_VM, CLONE_THREAD | CLONE_VM)});
  seccomp_rule_add(filter, SCMP_ACT_ERRNO(ENOSYS), SCMP_SYS(clone3), 0);
}

void allow_parts_of_broad_calls(void* filter) {
  for (const std::uint64_t command :
       {F_DUPFD, F_DUPFD_CLOEXEC, F_GETFD, F_SETFD, F_GETFL, F_SETFL, F_GETLK, F_SETLK, F_SETLKW})
    for (const char* name : {"fcntl", "fcntl64"}) allow(filter, name, {equals(1, command)});
  allow(filter, "ioctl", {equals(1, TCGETS)});       // asks whether the output is a terminal
  constexpr std::uint64_t name_memory = 0x53564d41;  // PR_SET_VMA of Linux 5.17
  for (const std::uint64_t option : {std::uint64_t{PR_SET_NAME}, std::uint64_t{PR_GET_DUMPABLE}, name_memory})
    allow(filter, "prctl", {equals(0, option)});
  allow(filter, "prlimit64", {equals(0, 0), equals(2, 0)});  // only reads its own limits
  const auto own = static_cast<std::uint64_t>(getpid());
  allow(filter, "tgkill", {equals(0, own)});  // for abort()
}

}  // namespace

bool restrict_system_calls() {
  const Filter filter{seccomp_init(SCMP_ACT_ERRNO(EPERM))};
  if (!filter) return false;
  seccomp_attr_set(filter.get(), SCMP_FLTATR_ACT_BADARCH, SCMP_ACT_KILL_PROCESS);
  seccomp_attr_set(filter.get(), SCMP_FLTATR_CTL_TSYNC, 1);     // applies to all threads
  seccomp_attr_set(filter.get(), SCMP_FLTATR_CTL_OPTIMIZE, 2);  // a search tree instead of a list
  for (const char* name : harmless) allow(filter.get(), name, {});
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  // The sanitizers write a byte to a pipe to find out whether memory is readable.
  for (const char* name : {"pipe", "pipe2"}) allow(filter.get(), name, {});
#endif
  allow_opening(filter.get(), "open", 1);
  allow_opening(filter.get(), "openat", 2);
  allow_memory(filter.get());
  allow_threads(filter.get());
  allow_parts_of_broad_calls(filter.get());
  return seccomp_load(filter.get()) == 0;
}

}  // namespace floeplan::sandbox
