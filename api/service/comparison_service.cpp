#include "api/service/comparison_service.hpp"

#include <utility>

#include "engine/core/violation_list.hpp"
#include "engine/simulation/vehicle/glider_motion.hpp"

namespace floeplan::service {

ComparedFlights compare_flights(std::span<const codec::GliderLog> logs, const vehicle::GliderProfile& vehicle,
                                simulation::DragOf drag, const std::stop_token& stop,
                                const core::ProgressCallback& progress) {
  std::size_t dives = 0;
  for (const codec::GliderLog& log : logs) dives += log.dives.size();
  ComparedFlights result;
  const simulation::HullMotion hull = simulation::hull_motion_for(vehicle);
  std::size_t flown = 0;
  for (const codec::GliderLog& log : logs) {
    for (const simulation::LoggedSegment& dive : log.dives) {
      if (stop.stop_requested()) return result;
      if (progress) progress("flying", static_cast<double>(flown++) / static_cast<double>(dives));
      const auto compared = simulation::compare_segment(dive, vehicle, hull, drag);
      if (compared) {
        result.dives.push_back({log.name, dive, *compared});
        continue;
      }
      for (core::Violation fault : compared.error()) {
        fault.field = log.name + fault.field;
        core::note(result.violations, std::move(fault));
      }
    }
  }
  return result;
}

}  // namespace floeplan::service
