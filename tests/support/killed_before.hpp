#pragma once

#include <sys/ptrace.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstddef>
#include <exception>
#include <limits>
#include <stdexcept>
#include <vector>

namespace floeplan::support {

/// The system calls with which a program changes files, and flushes them.
inline constexpr std::array changes_of_files{SYS_write,     SYS_pwrite64, SYS_pwritev,  SYS_ftruncate,
                                             SYS_fallocate, SYS_rename,   SYS_renameat, SYS_renameat2,
                                             SYS_link,      SYS_linkat,   SYS_unlink,   SYS_unlinkat,
                                             SYS_mkdir,     SYS_rmdir,    SYS_fsync,    SYS_fdatasync};

/// Runs `work` in a separate process, and kills it before its change of files number `n`, counted from 0.
/// Returns  the changes that it made: `n` of them if it was killed, fewer if it ended by itself
/// Errors   std::runtime_error when the work threw, or the process cannot be watched
template <class Work>
std::vector<long> killed_before(std::size_t n, const Work& work) {
  const pid_t child = fork();
  if (child == 0) {
    try {
      ptrace(PTRACE_TRACEME, 0, nullptr, nullptr);
      raise(SIGSTOP);
      work();
      _exit(0);
    } catch (const std::exception&) {
      _exit(1);
    }
  }
  int status = 0;
  waitpid(child, &status, 0);
  const auto options = PTRACE_O_TRACESYSGOOD | PTRACE_O_EXITKILL;
  if (ptrace(PTRACE_SETOPTIONS, child, nullptr, options) != 0)
    throw std::runtime_error{"the process cannot be watched"};

  std::vector<long> changes;
  int signal = 0;
  while (ptrace(PTRACE_SYSCALL, child, nullptr, signal) == 0 && waitpid(child, &status, 0) == child &&
         WIFSTOPPED(status)) {
    const bool at_system_call = WSTOPSIG(status) == (SIGTRAP | 0x80);
    signal = at_system_call ? 0 : WSTOPSIG(status);
    if (!at_system_call) continue;
    __ptrace_syscall_info info{};
    ptrace(PTRACE_GET_SYSCALL_INFO, child, sizeof info, &info);
    if (info.op != PTRACE_SYSCALL_INFO_ENTRY) continue;
    const auto call = static_cast<long>(info.entry.nr);
    if (std::ranges::find(changes_of_files, call) == changes_of_files.end()) continue;
    if (changes.size() == n) {
      kill(child, SIGKILL);
      waitpid(child, &status, 0);
      return changes;
    }
    changes.push_back(call);
  }
  if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) throw std::runtime_error{"the work failed"};
  return changes;
}

/// The instants at which to kill `work`: before every change of files except writes, of which only about
/// `writes` are chosen; and one after the end.
template <class Work>
std::vector<std::size_t> instants_of(const Work& work, std::size_t writes) {
  const std::vector<long> changes = killed_before(std::numeric_limits<std::size_t>::max(), work);
  const std::size_t stride = changes.size() / writes + 1;
  std::vector<std::size_t> instants;
  for (std::size_t i = 0; i < changes.size(); ++i) {
    const bool is_write = changes[i] == SYS_write || changes[i] == SYS_pwrite64;
    if (!is_write || i % stride == 0) instants.push_back(i);
  }
  instants.push_back(changes.size());
  return instants;
}

}  // namespace floeplan::support
