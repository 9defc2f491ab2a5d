#pragma once

#include <filesystem>
#include <map>
#include <string>

#include "api/routes/job_gateway.hpp"
#include "storage/sqlite/connection.hpp"

namespace floeplan::routes {

/// What is the same for every request of a server.
struct ServiceInfo {
  std::string public_url;         // links begin with it; no slash at its end
  std::filesystem::path web;      // folder of the built client; empty: none
  std::filesystem::path uploads;  // folder of what was sent and waits to be ingested
};

/// What a resource answers from.
struct Context {
  sqlite::Connection& db;  // of this thread
  JobGateway& jobs;
  const ServiceInfo& service;
};

/// The parts of the path that stand for the pattern's names.
using PathParameters = std::map<std::string, std::string>;

}  // namespace floeplan::routes
