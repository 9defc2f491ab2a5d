#include "tests/server/cli/served_program.hpp"

#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <stdexcept>
#include <system_error>

#include "tests/support/empty_store.hpp"
#include "tests/support/places.hpp"

namespace floeplan::support {
namespace {

/// The port in the line "floeplan: serving http://127.0.0.1:PORT", or in that of a worker.
std::uint16_t read_port(int descriptor) {
  const std::string before_port = " http://127.0.0.1:";
  std::string text;
  char byte = 0;
  while (read(descriptor, &byte, 1) == 1) {
    text += byte;
    const auto found = text.find(before_port);
    if (byte == '\n' && found != std::string::npos) {
      return static_cast<std::uint16_t>(std::stoi(text.substr(found + before_port.size())));
    }
  }
  throw std::runtime_error{"the server ended before it listened: " + text};
}

/// Reads the output, so that the pipe does not fill up while the server runs. The log file exists when this
/// returns.
/// Returns  the process that reads
pid_t drain_in_background(int descriptor, const std::filesystem::path& log) {
  const int file = log.empty() ? -1 : open(log.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0600);
  if (const pid_t reader = fork(); reader != 0) {
    if (file >= 0) close(file);
    return reader;
  }
  char bytes[4096];
  for (ssize_t count = 0; (count = read(descriptor, bytes, sizeof bytes)) > 0;) {
    if (file >= 0 && write(file, bytes, static_cast<std::size_t>(count)) != count) break;
  }
  _exit(0);
}

}  // namespace

ServedProgram::ServedProgram(const std::filesystem::path& store, const std::vector<std::string>& flags,
                             const std::vector<std::string>& before, const std::filesystem::path& log) {
  std::vector<std::string> words = store_words(store);
  words.insert(words.end(), before.begin(), before.end());
  words.emplace_back("serve");
  words.insert(words.end(), flags.begin(), flags.end());
  start(std::move(words), log);
}

ServedProgram::ServedProgram(const Node& node, const std::vector<std::string>& flags,
                             const std::filesystem::path& log) {
  std::vector<std::string> words = store_words(node.store);
  words.at(1) = node.folder.string();  // behind --data
  words.push_back(node.command);
  words.insert(words.end(), flags.begin(), flags.end());
  start(std::move(words), log);
}

void ServedProgram::start(std::vector<std::string> words, const std::filesystem::path& log) {
  words.emplace(words.begin(), "floeplan");
  for (const char* word : {"--listen", "127.0.0.1:0"}) words.emplace_back(word);
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error{"no pipe"};
  const std::string program = program_folder() + "/floeplan";
  pid_ = fork();
  if (pid_ == 0) {
    dup2(ends[1], STDERR_FILENO);
    execv(program.c_str(), argv.data());
    _exit(127);
  }
  close(ends[1]);
  port_ = read_port(ends[0]);
  reader_ = drain_in_background(ends[0], log);
  close(ends[0]);
}

ServedProgram::~ServedProgram() { end(SIGTERM); }

void ServedProgram::end(int signal) {
  if (pid_ == 0) return;
  kill(pid_, signal);
  waitpid(pid_, nullptr, 0);
  waitpid(reader_, nullptr, 0);
  pid_ = 0;
}

bool ServedProgram::ends_within(std::chrono::milliseconds time) const {
  const int process = static_cast<int>(syscall(SYS_pidfd_open, pid_, 0));
  if (process < 0) throw std::system_error{errno, std::generic_category(), "pidfd_open"};
  pollfd end{process, POLLIN, 0};
  const bool ended = poll(&end, 1, static_cast<int>(time.count())) > 0;
  close(process);
  return ended;
}

void ServedProgram::hang_up() const { kill(pid_, SIGHUP); }

Answer ServedProgram::request(const std::string& method, const std::string& target,
                              const std::string& headers, const std::string& body) const {
  const int connection = socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(port_);
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  if (connect(connection, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
    throw std::runtime_error{"the server does not answer"};
  }
  const std::string text =
      method + ' ' + target + " HTTP/1.1\r\nHost: 127.0.0.1\r\nConnection: close\r\n" + headers +
      "Content-Type: application/json\r\nContent-Length: " + std::to_string(body.size()) + "\r\n\r\n" + body;
  for (std::size_t sent = 0; sent < text.size();) {
    const ssize_t count = send(connection, text.data() + sent, text.size() - sent, MSG_NOSIGNAL);
    if (count <= 0) break;  // the server may refuse before it has read everything
    sent += static_cast<std::size_t>(count);
  }
  std::string reply;
  char bytes[65536];
  for (ssize_t count = 0; (count = read(connection, bytes, sizeof bytes)) > 0;) {
    reply.append(bytes, static_cast<std::size_t>(count));
  }
  close(connection);
  const auto body_begin = reply.find("\r\n\r\n");
  if (reply.size() < 12 || body_begin == std::string::npos)
    throw std::runtime_error{"no HTTP answer: " + reply};
  return {std::stoi(reply.substr(9, 3)), reply.substr(body_begin + 4), reply.substr(0, body_begin)};
}

}  // namespace floeplan::support
