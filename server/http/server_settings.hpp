#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "api/routes/request/message.hpp"
#include "server/http/body_sink.hpp"

namespace floeplan::http {

/// PEM files: the server's certificate with the intermediate certificates, and its key.
struct TlsFiles {
  std::filesystem::path certificate;
  std::filesystem::path key;
};

/// Limits that keep one client from taking what all need.
struct Limits {
  std::uint32_t header_bytes{16 * 1024};
  std::uint64_t body_bytes{1024UL * 1024};
  std::uint64_t held_bytes{256UL * 1024 * 1024};  // bodies and answers of all connections
  std::chrono::seconds first_byte_time{15};       // for the first byte on a new connection, including TLS
  std::chrono::seconds header_time{10};           // from the first byte of a request to the end of its header
  std::chrono::seconds body_time{30};             // for each 64 KiB of a body that is written to disk
  std::chrono::seconds idle_time{60};             // between requests
  std::chrono::seconds write_time{60};
  std::chrono::seconds stop_time{8};  // for running requests when the server stops
  // 10,000 idle connections of 10 KB each (measured), and 2,000 active ones
  std::size_t connections{12'000};
  std::size_t connections_per_address{1024};
  std::size_t streams{200};           // event streams, each on its own connection
  std::size_t streams_of_client{20};  // a browser needs one, a monitoring script another
  std::size_t files_of_client{8};     // uploads of a client that are received at the same time
};

/// An answered request, for the log and the counts.
struct Exchange {
  std::string method;
  std::string route;  // pattern of the operation; empty: no operation matched
  int status{};
  std::chrono::duration<double> taken{};
  std::uint64_t bytes{};  // size of the response body
};

/// The settings that can change while a server runs.
struct Settings {
  Limits limits{};
  std::uint64_t most_upload_bytes{};
  std::optional<TlsFiles> tls{};
  bool https_only{false};         // tell browsers to use only HTTPS from now on (RFC 6797)
  std::string log_level{};        // empty: unchanged
  std::function<void()> taken{};  // called after the settings were applied
};

/// Optional functions and settings of a server.
struct Equipment {
  Streaming streaming{};
  std::optional<TlsFiles> tls{};  // empty: no TLS
  bool https_only{false};         // as in Settings
  /// Returns the present settings. Called on the I/O thread by SIGHUP and reload(). Empty: only the
  /// certificate is read again. If it throws, nothing changes.
  std::function<Settings()> settings{};
  std::function<void(const Exchange&)> observe{};  // called on the I/O thread after each answer
  /// Identifies the client for limits and turns; called on the I/O thread. Empty: the address is the client.
  std::function<std::string(const routes::Request&)> client_of{};
  /// Answers requests that take no longer than handing them to another thread. Called on the I/O thread,
  /// which all connections wait for. nullopt: the handler is called.
  std::function<std::optional<routes::Response>(const routes::Request&)> at_once{};
};

}  // namespace floeplan::http
