#include "engine/messages/catalogue.hpp"

#include "engine/messages/command_messages.hpp"
#include "engine/messages/data_messages.hpp"
#include "engine/messages/export_messages.hpp"
#include "engine/messages/flight_fault_messages.hpp"
#include "engine/messages/flight_messages.hpp"
#include "engine/messages/ingest_area_messages.hpp"
#include "engine/messages/ingest_current_messages.hpp"
#include "engine/messages/ingest_depth_messages.hpp"
#include "engine/messages/ingest_feature_messages.hpp"
#include "engine/messages/ingest_file_messages.hpp"
#include "engine/messages/ingest_grib_messages.hpp"
#include "engine/messages/ingest_grid_messages.hpp"
#include "engine/messages/ingest_hdf5_messages.hpp"
#include "engine/messages/ingest_ice_messages.hpp"
#include "engine/messages/ingest_iceberg_messages.hpp"
#include "engine/messages/ingest_netcdf_messages.hpp"
#include "engine/messages/ingest_tide_messages.hpp"
#include "engine/messages/ingest_time_messages.hpp"
#include "engine/messages/ingest_track_messages.hpp"
#include "engine/messages/ingest_velocity_messages.hpp"
#include "engine/messages/ingest_zarr_messages.hpp"
#include "engine/messages/mission_check_messages.hpp"
#include "engine/messages/mission_fault_messages.hpp"
#include "engine/messages/mission_file_messages.hpp"
#include "engine/messages/plan_messages.hpp"
#include "engine/messages/refusal_messages.hpp"
#include "engine/messages/request_messages.hpp"
#include "engine/messages/seaglider_file_messages.hpp"
#include "engine/messages/store_messages.hpp"

namespace floeplan::messages {

std::vector<Kind> catalogue() {
  std::vector<Kind> all;
  using Kinds = std::span<const Kind>;
  for (const Kinds kinds :
       {Kinds{plan_kinds},          Kinds{data_kinds},           Kinds{refusal_kinds},
        Kinds{phrase_kinds},        Kinds{request_kinds},        Kinds{export_kinds},
        Kinds{mission_fault_kinds}, Kinds{flight_fault_kinds},   Kinds{command_kinds},
        Kinds{mission_file_kinds},  Kinds{seaglider_file_kinds}, Kinds{mission_check_kinds},
        Kinds{ingest_area_kinds},   Kinds{ingest_current_kinds}, Kinds{ingest_depth_kinds},
        Kinds{ingest_file_kinds},   Kinds{ingest_netcdf_kinds},  Kinds{ingest_zarr_kinds},
        Kinds{ingest_hdf5_kinds},   Kinds{ingest_time_kinds},    Kinds{ingest_grid_kinds},
        Kinds{ingest_grib_kinds},   Kinds{ingest_feature_kinds}, Kinds{ingest_velocity_kinds},
        Kinds{ingest_ice_kinds},    Kinds{ingest_iceberg_kinds}, Kinds{ingest_tide_kinds},
        Kinds{ingest_track_kinds},  Kinds{store_kinds},          Kinds{flight_kinds}})
    all.insert(all.end(), kinds.begin(), kinds.end());
  return all;
}

}  // namespace floeplan::messages
