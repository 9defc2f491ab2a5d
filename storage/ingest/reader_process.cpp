#include "storage/ingest/reader_process.hpp"

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/eventfd.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <stdexcept>
#include <system_error>

namespace floeplan::ingest {
namespace {

constexpr std::size_t longest_line = 4'000'000;  // a report with thousands of refused rows

std::system_error failure(int number, const char* what) { return {number, std::generic_category(), what}; }

/// Where libraries find their own data, and the options of sanitizers. Nothing that could make GDAL load a plugin,
/// speak to the network or change how it reads a file.
std::vector<std::string> environment() {
  std::vector<std::string> kept{"LC_ALL=C.UTF-8"};
  for (const char* name : {"PATH", "TMPDIR", "GDAL_DATA", "PROJ_LIB", "PROJ_DATA", "LD_LIBRARY_PATH",
                           "ASAN_OPTIONS", "LSAN_OPTIONS", "UBSAN_OPTIONS", "TSAN_OPTIONS"})
    if (const char* value = std::getenv(name)) kept.push_back(std::string{name} + "=" + value);
  return kept;
}

std::vector<char*> pointers(std::vector<std::string>& words) {
  std::vector<char*> result;
  result.reserve(words.size() + 1);
  for (std::string& word : words) result.push_back(word.data());
  result.push_back(nullptr);
  return result;
}

/// What a new process begins with: nothing to read, `output` to write to, nothing else open.
class FileActions {
 public:
  explicit FileActions(int output) {
    posix_spawn_file_actions_init(&actions_);
    posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_adddup2(&actions_, output, STDOUT_FILENO);
    posix_spawn_file_actions_addclosefrom_np(&actions_, STDERR_FILENO + 1);
  }
  FileActions(const FileActions&) = delete;
  FileActions& operator=(const FileActions&) = delete;
  ~FileActions() { posix_spawn_file_actions_destroy(&actions_); }

  [[nodiscard]] const posix_spawn_file_actions_t* get() const { return &actions_; }

 private:
  posix_spawn_file_actions_t actions_{};
};

/// Becomes readable when a stop is requested.
class StopSignal {
 public:
  explicit StopSignal(const std::stop_token& stop)
      : descriptor_{eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)}, callback_{stop, Raise{descriptor_}} {}
  StopSignal(const StopSignal&) = delete;
  StopSignal& operator=(const StopSignal&) = delete;
  ~StopSignal() { close(descriptor_); }

  [[nodiscard]] int descriptor() const { return descriptor_; }

 private:
  struct Raise {
    int descriptor;
    void operator()() const { static_cast<void>(eventfd_write(descriptor, 1)); }
  };

  int descriptor_;
  std::stop_callback<Raise> callback_;
};

int milliseconds_until(std::chrono::steady_clock::time_point deadline) {
  const auto left =
      std::chrono::duration_cast<std::chrono::milliseconds>(deadline - std::chrono::steady_clock::now());
  return static_cast<int>(std::clamp<std::chrono::milliseconds::rep>(left.count() + 1, 0, 60'000));
}

}  // namespace

ReaderProcess::ReaderProcess(const std::filesystem::path& program,
                             const std::vector<std::string>& arguments) {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) throw failure(errno, "no pipe to a process that reads files");
  std::vector<std::string> words{"floeplan"};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<std::string> variables = environment();
  const FileActions actions{ends[1]};
  const int error = posix_spawn(&pid_, program.c_str(), actions.get(), nullptr, pointers(words).data(),
                                pointers(variables).data());
  close(ends[1]);
  output_ = ends[0];
  if (error == 0) return;
  close(output_);
  throw failure(error, "the process that reads files cannot be started");
}

ReaderProcess::~ReaderProcess() {
  if (pid_ > 0) {
    ::kill(pid_, SIGKILL);
    collect();
  }
  close(output_);
}

ReaderProcess::Reading ReaderProcess::read_line(const std::stop_token& stop,
                                                std::chrono::steady_clock::time_point deadline) {
  const StopSignal stop_signal{stop};
  while (true) {
    if (stop.stop_requested()) return Reading::stopped;
    if (const auto end = buffer_.find('\n'); end != std::string::npos) {
      line_ = buffer_.substr(0, end);
      buffer_.erase(0, end + 1);
      return Reading::line;
    }
    if (std::chrono::steady_clock::now() >= deadline) return Reading::too_late;
    std::array<pollfd, 2> waited{{{output_, POLLIN, 0}, {stop_signal.descriptor(), POLLIN, 0}}};
    if (poll(waited.data(), waited.size(), milliseconds_until(deadline)) <= 0 || waited[0].revents == 0)
      continue;
    std::array<char, 65536> bytes{};
    const ssize_t count = read(output_, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0 || buffer_.size() > longest_line) return Reading::ended;
    buffer_.append(bytes.data(), static_cast<std::size_t>(count));
  }
}

int ReaderProcess::kill() {
  // To the system -1 means every process there is.
  if (pid_ <= 0) throw std::logic_error{"ReaderProcess: its process has ended before"};
  ::kill(pid_, SIGKILL);
  return collect();
}

int ReaderProcess::wait() { return collect(); }

int ReaderProcess::collect() {
  int status = 0;
  while (waitpid(pid_, &status, 0) < 0 && errno == EINTR) {
  }
  pid_ = -1;
  return status;
}

}  // namespace floeplan::ingest
