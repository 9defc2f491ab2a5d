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

/// Files in PEM format: the server's certificate with those between it and the authority's, and its key.
struct TlsFiles {
  std::filesystem::path certificate;
  std::filesystem::path key;
};

/// Limits that keep one client from taking what all need.
struct Limits {
  std::uint32_t header_bytes{16 * 1024};
  std::uint64_t body_bytes{1024UL * 1024};
  std::uint64_t held_bytes{256UL * 1024 * 1024};  // of bodies and answers of all connections together
  std::chrono::seconds first_byte_time{15};       // of a new connection, TLS included
  std::chrono::seconds header_time{10};           // from the first byte of a request to the end of its header
  std::chrono::seconds body_time{30};             // of one that goes to disk: for each 64 KiB
  std::chrono::seconds idle_time{60};             // between requests
  std::chrono::seconds write_time{60};
  std::chrono::seconds stop_time{8};  // for open requests, when the server stops
  std::size_t connections{12'000};    // 10,000 idle ones of 10 KB each, as measured, and 2,000 active ones
  std::size_t connections_per_address{1024};
  std::size_t streams{200};           // of events, each on a connection of its own
  std::size_t streams_of_client{20};  // a browser needs one, a watching script another
  std::size_t files_of_client{8};     // on their way to disk at once
};

/// A request that was answered, as logs and counts see it.
struct Exchange {
  std::string method;
  std::string route;  // pattern of the operation; empty: no operation matched
  int status{};
  std::chrono::duration<double> taken{};
  std::uint64_t bytes{};  // of the response body
};

/// What may change while a server runs.
struct Settings {
  Limits limits{};
  std::uint64_t most_upload_bytes{};
  std::optional<TlsFiles> tls{};
  bool https_only{false};         // browsers are told to come by HTTPS alone from then on (RFC 6797)
  std::string log_level{};        // empty: as it is
  std::function<void()> taken{};  // called once these are in force, for what others keep of them
};

/// What a server does beside answering.
struct Equipment {
  Streaming streaming{};
  std::optional<TlsFiles> tls{};  // none: in the clear
  bool https_only{false};         // as in Settings
  /// What the settings are by now; asked on the I/O thread by SIGHUP and by reload(). Empty: the certificate alone is read
  /// again. An exception leaves everything as it was.
  std::function<Settings()> settings{};
  std::function<void(const Exchange&)> observe{};  // called on the I/O thread after every answer
  /// Who shares the limits of one client and takes turns with others, asked on the I/O thread; nothing: an address.
  std::function<std::string(const routes::Request&)> client_of{};
  /// Answers requests so small that to hand them to another thread takes as long as to answer them. It is called on the
  /// I/O thread, and everybody else waits meanwhile; nothing: the handler is asked.
  std::function<std::optional<routes::Response>(const routes::Request&)> at_once{};
};

}  // namespace floeplan::http
