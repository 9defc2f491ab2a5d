#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace floeplan::support {

/// An answer over HTTP.
struct Answer {
  int status{};
  std::string body;
  std::string head{};  // status line and fields

  [[nodiscard]] nlohmann::json json() const { return nlohmann::json::parse(body, nullptr, false); }
};

/// A node of a store that several nodes share. Used where the tests run with a database server.
struct Node {
  std::filesystem::path store;   // the store of this folder, see `store_words`
  std::filesystem::path folder;  // the node's own
  std::string command{"serve"};  // or worker
};

/// The real program serving a store on a free port of the loopback address, until the end of the test.
class ServedProgram {
 public:
  /// `flags`   of the command serve
  /// `before`  flags of the program that come before it
  /// `log`     file for its output on stderr once it serves; empty: the output is discarded
  explicit ServedProgram(const std::filesystem::path& store, const std::vector<std::string>& flags = {},
                         const std::vector<std::string>& before = {}, const std::filesystem::path& log = {});
  explicit ServedProgram(const Node& node, const std::vector<std::string>& flags = {},
                         const std::filesystem::path& log = {});
  ~ServedProgram();
  ServedProgram(const ServedProgram&) = delete;
  ServedProgram& operator=(const ServedProgram&) = delete;

  /// Ends the program by this signal, and waits for its end.
  void end(int signal);
  /// Waits for the program to end by itself, no longer than that.
  [[nodiscard]] bool ends_within(std::chrono::milliseconds time) const;
  /// Sends SIGHUP.
  void hang_up() const;
  [[nodiscard]] std::uint16_t port() const { return port_; }
  [[nodiscard]] std::string address() const { return "http://127.0.0.1:" + std::to_string(port_); }
  [[nodiscard]] Answer get(const std::string& target) const { return request("GET", target, "", ""); }
  [[nodiscard]] Answer remove(const std::string& target) const { return request("DELETE", target, "", ""); }
  /// Sends a file; `query` begins with "?" unless it is empty.
  [[nodiscard]] Answer upload(const std::string& content, const std::string& query) const {
    return request("POST", "/uploads" + query, "", content);
  }
  /// Executes a process at once (`Prefer: respond-sync`).
  [[nodiscard]] Answer execute(const std::string& process, const nlohmann::json& inputs) const {
    return request("POST", "/processes/" + process + "/execution", "Prefer: respond-sync\r\n",
                   nlohmann::json{{"inputs", inputs}}.dump());
  }
  /// Queues a process as a job (`Prefer: respond-async`).
  [[nodiscard]] Answer submit(const std::string& process, const nlohmann::json& inputs) const {
    return request("POST", "/processes/" + process + "/execution", "Prefer: respond-async\r\n",
                   nlohmann::json{{"inputs", inputs}}.dump());
  }
  /// Any request; each of the headers ends with CR and LF.
  [[nodiscard]] Answer ask(const std::string& method, const std::string& target, const std::string& headers,
                           const std::string& body = "") const {
    return request(method, target, headers, body);
  }

 private:
  void start(std::vector<std::string> words, const std::filesystem::path& log);
  [[nodiscard]] Answer request(const std::string& method, const std::string& target,
                               const std::string& headers, const std::string& body) const;

  pid_t pid_{};     // 0: it has ended
  pid_t reader_{};  // of its output on stderr
  std::uint16_t port_{};
};

}  // namespace floeplan::support
