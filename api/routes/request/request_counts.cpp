#include "api/routes/request/request_counts.hpp"

#include <algorithm>
#include <sstream>

namespace floeplan::routes {
namespace {

constexpr std::array known_methods{"GET", "HEAD", "POST", "PUT", "PATCH", "DELETE", "OPTIONS"};

std::string label_of(const std::string& method) {
  const bool known = std::find(known_methods.begin(), known_methods.end(), method) != known_methods.end();
  return known ? method : "other";
}

}  // namespace

void RequestCounts::add(const std::string& method, const std::string& route, int status,
                        std::chrono::duration<double> taken) {
  const std::string name = route.empty() ? "none" : route;
  const std::lock_guard lock{mutex_};
  ++requests_[{label_of(method), name, status}];
  Histogram& histogram = durations_[name];
  for (std::size_t i = 0; i < bounds_s.size(); ++i)
    if (taken.count() <= bounds_s[i]) ++histogram.within[i];
  ++histogram.count;
  histogram.sum_s += taken.count();
}

std::string RequestCounts::text() const {
  const std::lock_guard lock{mutex_};
  std::ostringstream out;
  out << "# HELP floeplan_http_requests_total Requests answered.\n"
         "# TYPE floeplan_http_requests_total counter\n";
  for (const auto& [key, count] : requests_) {
    const auto& [method, route, status] = key;
    out << "floeplan_http_requests_total{method=\"" << method << "\",route=\"" << route << "\",status=\""
        << status << "\"} " << count << '\n';
  }
  out << "# HELP floeplan_http_request_duration_seconds From the end of a request to the end of its answer.\n"
         "# TYPE floeplan_http_request_duration_seconds histogram\n";
  for (const auto& [route, histogram] : durations_) {
    const std::string label = "route=\"" + route + "\"";
    const std::string name = "floeplan_http_request_duration_seconds";
    for (std::size_t i = 0; i < bounds_s.size(); ++i)
      out << name << "_bucket{" << label << ",le=\"" << bounds_s[i] << "\"} " << histogram.within[i] << '\n';
    out << name << "_bucket{" << label << ",le=\"+Inf\"} " << histogram.count << '\n'
        << name << "_sum{" << label << "} " << histogram.sum_s << '\n'
        << name << "_count{" << label << "} " << histogram.count << '\n';
  }
  return out.str();
}

}  // namespace floeplan::routes
