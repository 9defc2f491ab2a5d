#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "api/routes/request/job_gateway.hpp"
#include "api/routes/request/remembered.hpp"
#include "api/routes/request/request_counts.hpp"
#include "storage/repository/fields/current_blocks.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::routes {

/// The sandbox of the processes that read files from outside.
struct ReaderLayers {
  std::string layers;  // "seccomp, Landlock 7"
  bool enough{false};
};

/// Limits for each owner of shared resources. Generous: a season of a regional ocean model is 200 GB.
struct Quotas {
  std::uint64_t stored_bytes{500'000'000'000};  // dataset files as sent, plans and simulations
  std::size_t uploads{500};                     // uploads that were not ingested yet
};

/// The quotas, which can be changed while the server runs.
/// Threads  any
class QuotasInForce {
 public:
  explicit QuotasInForce(const Quotas& quotas) { set(quotas); }

  void set(const Quotas& quotas) {
    stored_bytes_ = quotas.stored_bytes;
    uploads_ = quotas.uploads;
  }
  [[nodiscard]] Quotas now() const { return {.stored_bytes = stored_bytes_, .uploads = uploads_}; }

 private:
  std::atomic<std::uint64_t> stored_bytes_{0};
  std::atomic<std::size_t> uploads_{0};
};

/// Properties of the server that are equal for all requests.
struct ServiceInfo {
  std::string public_url;         // beginning of links; without a slash at its end
  std::filesystem::path web;      // folder of the built client; empty: none
  std::filesystem::path uploads;  // folder of uploads that were not ingested yet
  bool secure{false};             // clients use TLS
  std::shared_ptr<QuotasInForce> quotas{std::make_shared<QuotasInForce>(Quotas{})};
  std::filesystem::path store{};                // folder of the database, to report its size
  std::size_t damaged_pages{0};                 // damaged pages of the database when the server started
  std::shared_ptr<RequestCounts> counts{};      // empty: requests are not counted
  std::optional<ReaderLayers> reader_layers{};  // empty: this server reads no files from outside
  std::function<std::size_t()> connections{};   // number of open connections
  /// Cache of blocks for queries of places; empty: no cache.
  std::shared_ptr<repository::CurrentBlocks> current_blocks{};
};

/// The objects that a resource needs to answer a request.
struct Context {
  sql::Connection& db;  // connection of this thread
  JobGateway& jobs;
  const ServiceInfo& service;
  // cache of this thread's connection, refreshed for this request; null: no cache
  Remembered* remembered{nullptr};
};

/// Values of the path's parameters, by their names in the pattern.
using PathParameters = std::map<std::string, std::string>;

}  // namespace floeplan::routes
