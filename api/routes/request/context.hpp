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

/// How the processes that read foreign files are confined.
struct ReaderLayers {
  std::string layers;  // "seccomp, Landlock 7"
  bool enough{false};
};

/// The most that one owner may have of what others have to share. Generous: a season of a regional ocean model is 200 GB.
struct Quotas {
  std::uint64_t stored_bytes{500'000'000'000};  // of files as they were sent, of plans and of simulations
  std::size_t uploads{500};                     // that wait to be ingested
};

/// The quotas of a server that may be told others while it runs.
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

/// What is the same for every request of a server.
struct ServiceInfo {
  std::string public_url;         // links begin with it; no slash at its end
  std::filesystem::path web;      // folder of the built client; empty: none
  std::filesystem::path uploads;  // folder of what was sent and waits to be ingested
  bool secure{false};             // clients come by TLS
  std::shared_ptr<QuotasInForce> quotas{std::make_shared<QuotasInForce>(Quotas{})};
  std::filesystem::path store{};                // folder of the database, to tell its size
  std::size_t damaged_pages{0};                 // of the database, when the server began
  std::shared_ptr<RequestCounts> counts{};      // empty: nobody counts
  std::optional<ReaderLayers> reader_layers{};  // empty: nobody reads files here
  std::function<std::size_t()> connections{};   // open now
  /// What queries of places read last; empty: nothing is kept.
  std::shared_ptr<repository::CurrentBlocks> current_blocks{};
};

/// What a resource answers from.
struct Context {
  sql::Connection& db;  // of this thread
  JobGateway& jobs;
  const ServiceInfo& service;
  Remembered* remembered{nullptr};  // of the connection, refreshed for this request; null: nothing is kept
};

/// The parts of the path that stand for the pattern's names.
using PathParameters = std::map<std::string, std::string>;

}  // namespace floeplan::routes
