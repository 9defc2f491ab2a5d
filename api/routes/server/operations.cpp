#include <fstream>
#include <sstream>
#include <system_error>

#include "api/routes/request/reply.hpp"
#include "api/routes/request/request_counts.hpp"
#include "api/routes/request/resources.hpp"
#include "engine/core/version.hpp"
#include "storage/repository/work/job_repository.hpp"
#include "storage/sql/store_file.hpp"

namespace floeplan::routes {
namespace {

using repository::JobStatus;

constexpr std::uintmax_t least_free_bytes =
    64UL * 1024 * 1024;  // space for a plan and its log, with time to notice the warning

/// Resident memory of this process, bytes; nullopt if the system does not state it.
std::optional<std::uint64_t> resident_bytes() {
  std::ifstream in{"/proc/self/status"};
  for (std::string word; in >> word;) {
    std::uint64_t kilobytes = 0;
    if (word == "VmRSS:" && in >> kilobytes) return kilobytes * 1024;
  }
  return std::nullopt;
}

std::uintmax_t store_bytes(const std::filesystem::path& store) {
  std::uintmax_t total = 0;
  for (const auto& file : sql::database_files_in(store)) {
    std::error_code absent;
    const auto size = std::filesystem::file_size(file, absent);
    if (!absent) total += size;
  }
  return total;
}

void write_gauge(std::ostream& out, const std::string& name, const std::string& help, std::uint64_t value) {
  out << "# HELP " << name << ' ' << help << "\n# TYPE " << name << " gauge\n"
      << name << ' ' << value << '\n';
}

Response show_metrics(const Context& context, const Request&, const PathParameters&) {
  std::ostringstream out;
  const ServiceInfo& service = context.service;
  if (service.counts) out << service.counts->text();
  out << "# HELP floeplan_jobs Jobs in the store by state.\n# TYPE floeplan_jobs gauge\n";
  const repository::JobRepository jobs{context.db};
  for (const auto status : {JobStatus::accepted, JobStatus::running, JobStatus::successful, JobStatus::failed,
                            JobStatus::dismissed}) {
    out << "floeplan_jobs{state=\"" << repository::status_name(status) << "\"} " << jobs.count(status)
        << '\n';
  }
  write_gauge(out, "floeplan_store_bytes", "Size of the database and its log.", store_bytes(service.store));
  if (service.connections)
    write_gauge(out, "floeplan_http_connections", "Open connections.", service.connections());
  if (const auto memory = resident_bytes())
    write_gauge(out, "process_resident_memory_bytes", "Resident memory.", *memory);
  out << "# HELP floeplan_info The program.\n# TYPE floeplan_info "
         "gauge\nfloeplan_info{version=\""
      << core::version() << "\"} 1\n";
  Response response;
  response.content_type = "text/plain; version=0.0.4; charset=utf-8";
  response.headers.emplace_back("Cache-Control", "no-store");
  response.body = out.str();
  return response;
}

/// Why the server cannot work now, in words; empty if it can.
std::string obstacle(const Context& context) {
  try {
    repository::JobRepository{context.db}.touch_queue();
  } catch (const std::runtime_error&) {
    return "the queue of jobs cannot be written";
  }
  std::error_code unknown;
  const auto space = std::filesystem::space(context.service.store, unknown);
  if (!unknown && space.available < least_free_bytes) return "the disk is almost full";
  return "";
}

/// Readiness: whether the server can accept work. Health only means that the process answers.
Response show_readiness(const Context& context, const Request& request, const PathParameters&) {
  const std::string found = obstacle(context);
  if (found.empty()) {
    nlohmann::json document{{"status", "ok"}, {"damaged_pages", context.service.damaged_pages}};
    if (const auto& readers = context.service.reader_layers)
      document["sandbox"] = {{"layers", readers->layers}, {"enough", readers->enough}};
    return json_reply(document);
  }
  Response response = problem_reply<"not-ready">(request, found);
  response.headers.emplace_back("Retry-After", "30");
  return response;
}

}  // namespace

std::vector<Route> operation_routes() {
  return {{"GET", "/metrics", {}, show_metrics}, {"GET", "/readyz", {}, show_readiness, Access::everybody}};
}

}  // namespace floeplan::routes
