#include "api/codec/documents/vehicle_axes_document.hpp"

#include "storage/json/json.hpp"

namespace floeplan::codec {

nlohmann::json vehicle_axes_document(const ocean::VehicleAxes& known) {
  return {{"utm_zone", known.axes.utm_zone()},
          {"declination_deg", -core::radians_to_degrees(known.axes.variation_west().value)},
          {"declination_from", ocean::source_name(known.source)}};
}

}  // namespace floeplan::codec
