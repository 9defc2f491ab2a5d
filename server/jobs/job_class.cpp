#include "server/jobs/job_class.hpp"

#include <stdexcept>

#include "api/codec/inputs/plan_inputs.hpp"
#include "api/log/log.hpp"
#include "storage/json/json.hpp"

namespace floeplan::jobs {
namespace {

using nlohmann::json;
using repository::JobClass;

bool makes_many_searches(const std::string& inputs_json) {
  const json inputs = json::parse(inputs_json, nullptr, false);
  if (!inputs.is_object()) return false;
  const auto parsed = codec::parse_plan_inputs(inputs);
  if (!parsed) return false;
  const planning::UncertaintyRules& uncertainty = parsed->request.uncertainty;
  return parsed->request.departures.until || parsed->request.alternatives > 0 ||
         uncertainty.drawn_members > 0 || uncertainty.objective != planning::RobustObjective::none;
}

const char* what_to_ask(JobClass job_class) {
  switch (job_class) {
    case JobClass::interactive: return "a wider spacing_m, fewer sectors or a nearer goal";
    case JobClass::batch: return "fewer runs, departures or members";
    case JobClass::ingest: return "one file at a time, cut to the area and the period that you plan in";
  }
  throw std::logic_error{"JobClass without advice"};
}

}  // namespace

JobClass class_of(const std::string& process, const std::string& inputs_json) {
  if (process == "ingest") return JobClass::ingest;
  if (process == "simulate-plan" || process == "fly-scenario") return JobClass::batch;
  if (process == "plan-route" && makes_many_searches(inputs_json)) return JobClass::batch;
  return JobClass::interactive;
}

core::Seconds TimeLimits::of(JobClass job_class) const {
  switch (job_class) {
    case JobClass::interactive: return interactive;
    case JobClass::batch: return batch;
    case JobClass::ingest: return ingest;
  }
  throw std::logic_error{"JobClass without a limit"};
}

std::string overdue_message(JobClass job_class, core::Seconds limit) {
  const std::string name = repository::class_name(job_class);
  return "stopped after " + log::decimals(limit.count(), limit < core::Seconds{10.0} ? 1 : 0) +
         " s, the time limit of this server for " + name +
         " jobs; it has no result, and would take as long again; ask for less at once (" +
         what_to_ask(job_class) + "), or have the limit raised (serve --max-" + name + "-s)";
}

}  // namespace floeplan::jobs
