#include "tests/storage/sandbox/attempts.hpp"

#include <arpa/inet.h>
#include <fcntl.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/mount.h>
#include <sys/prctl.h>
#include <sys/ptrace.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/un.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>

namespace floeplan::sandbox {
namespace {

int error_of(long result) { return result < 0 ? errno : 0; }

int open_for(const std::filesystem::path& file, int flags) {
  return error_of(open(file.c_str(), flags | O_CLOEXEC, 0600));
}

int connect_by_tcp(const Scene& scene) {
  const int socket = ::socket(AF_INET, SOCK_STREAM, 0);
  if (socket < 0) return errno;
  sockaddr_in place{.sin_family = AF_INET, .sin_port = htons(scene.port), .sin_addr = {}, .sin_zero = {}};
  place.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  return error_of(connect(socket, reinterpret_cast<const sockaddr*>(&place), sizeof place));
}

int run_a_program(const Scene&) {
  std::array<char*, 2> words{const_cast<char*>("true"), nullptr};
  return error_of(execv("/bin/true", words.data()));  // exit code 0 where it starts
}

int fork_a_process(const Scene&) {
  const pid_t child = fork();
  if (child < 0) return errno;
  if (child == 0) _exit(0);
  waitpid(child, nullptr, 0);
  return 0;
}

int map_code_that_can_be_written(const Scene&) {
  const void* const memory =
      mmap(nullptr, 4096, PROT_READ | PROT_WRITE | PROT_EXEC, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  return memory == MAP_FAILED ? errno : 0;
}

int raise_a_limit(const Scene&) {
  const rlimit limit{16, 16};
  return error_of(setrlimit(RLIMIT_NOFILE, &limit));
}

}  // namespace

const std::vector<Attempt>& attempts() {
  static const std::vector<Attempt> all{
      {"connect by TCP", connect_by_tcp, 4, true},
      {"open a UDP socket", [](const Scene&) { return error_of(socket(AF_INET, SOCK_DGRAM, 0)); }, 0, true},
      {"open a Unix socket", [](const Scene&) { return error_of(socket(AF_UNIX, SOCK_STREAM, 0)); }, 0, true},
      {"read /etc/passwd", [](const Scene&) { return open_for("/etc/passwd", O_RDONLY); }, 1, false},
      {"read the store", [](const Scene& scene) { return open_for(scene.store(), O_RDONLY); }, 1, false},
      {"read its parent's memory",
       [](const Scene&) { return open_for("/proc/" + std::to_string(getppid()) + "/maps", O_RDONLY); }, 1,
       false},
      {"list the store's folder",
       [](const Scene& scene) { return open_for(scene.folder, O_RDONLY | O_DIRECTORY); }, 1, false},
      {"write to the store", [](const Scene& scene) { return open_for(scene.store(), O_RDWR); }, 1, false},
      {"empty the store", [](const Scene& scene) { return open_for(scene.store(), O_WRONLY | O_TRUNC); }, 1,
       false},
      {"make a file outside",
       [](const Scene& scene) { return open_for(scene.folder / "new", O_WRONLY | O_CREAT); }, 1, false},
      {"change the file that it reads", [](const Scene& scene) { return open_for(scene.given(), O_RDWR); }, 1,
       false},
      {"cut the file short that it reads",
       [](const Scene& scene) { return open_for(scene.given(), O_RDONLY | O_TRUNC); }, 3, true},
      {"cut the store short by its name",
       [](const Scene& scene) { return error_of(truncate(scene.store().c_str(), 1)); }, 3, true},
      {"remove the store", [](const Scene& scene) { return error_of(unlink(scene.store().c_str())); }, 1,
       false},
      {"move the store",
       [](const Scene& scene) {
         return error_of(rename(scene.store().c_str(), (scene.staging() / "moved").c_str()));
       },
       1, false},
      {"link the store into its folder",
       [](const Scene& scene) {
         return error_of(link(scene.store().c_str(), (scene.staging() / "link").c_str()));
       },
       1, true},
      {"make a symbolic link",
       [](const Scene& scene) { return error_of(symlink("/", (scene.staging() / "root").c_str())); }, 1,
       true},
      {"change the mode of the store",
       [](const Scene& scene) { return error_of(chmod(scene.store().c_str(), 0644)); }, 0, true},
      {"change the time of the store",
       [](const Scene& scene) { return error_of(utimensat(AT_FDCWD, scene.store().c_str(), nullptr, 0)); }, 0,
       true},
      {"start a program", run_a_program, 1, true},
      {"start a process", fork_a_process, 0, true},
      {"start a process by clone3",
       [](const Scene&) {
         std::array<std::uint64_t, 11> arguments{};
         arguments[4] = SIGCHLD;
         const long child = syscall(SYS_clone3, arguments.data(), sizeof arguments);
         if (child == 0) _exit(0);
         return error_of(child);
       },
       0, true},
      {"trace its parent",
       [](const Scene&) { return error_of(ptrace(PTRACE_ATTACH, getppid(), nullptr, nullptr)); }, 1, true},
      {"signal its parent", [](const Scene&) { return error_of(kill(getppid(), 0)); }, 6, true},
      {"mount a file system",
       [](const Scene& scene) { return error_of(mount("none", scene.staging().c_str(), "tmpfs", 0, "")); }, 1,
       true},
      {"enter a new namespace", [](const Scene&) { return error_of(unshare(CLONE_NEWUSER)); }, 0, true},
      {"use io_uring",
       [](const Scene&) {
         std::array<char, 120> parameters{};
         return error_of(syscall(SYS_io_uring_setup, 1, parameters.data()));
       },
       0, true},
      {"change a limit", raise_a_limit, 0, true},
      {"map code that can be written", map_code_that_can_be_written, 0, true}};
  return all;
}

int outcome_of(const Attempt& attempt, const Scene& scene, const std::function<void()>& confine) {
  const pid_t child = fork();
  if (child == 0) {
    try {
      confine();
      _exit(attempt.make(scene));
    } catch (...) {
      _exit(199);
    }
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WIFSIGNALED(status) ? 200 + WTERMSIG(status) : WEXITSTATUS(status);
}

}  // namespace floeplan::sandbox
