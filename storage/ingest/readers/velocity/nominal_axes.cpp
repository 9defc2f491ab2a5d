#include "storage/ingest/readers/velocity/nominal_axes.hpp"

#include "engine/messages/ingest_current_messages.hpp"
#include "storage/ingest/notation/text.hpp"

namespace floeplan::ingest {
namespace {

constexpr double bent_above_lat_deg = 60.0;  // with a margin of some degrees

}  // namespace

std::optional<messages::Message> doubt_in_nominal_axes(const VelocityPair& pair, double northernmost_deg) {
  if (pair.axes != VelocityAxes::grid || northernmost_deg <= bent_above_lat_deg) return std::nullopt;
  return messages::ingest_current_message<"along-bent-axes">(pair.first->name(), pair.second->name(),
                                                             number(northernmost_deg),
                                                             number(bent_above_lat_deg) + " degrees");
}

}  // namespace floeplan::ingest
