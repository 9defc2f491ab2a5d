#pragma once

#include <filesystem>
#include <memory>
#include <string_view>

#include "storage/ingest/common/refusal.hpp"

class GDALDataset;

namespace floeplan::ingest {

/// Whether a document is a chart of sea ice of the S-100 family, of whatever edition.
[[nodiscard]] bool is_s411(std::string_view head);

/// Areas of sea ice of an S-411 chart, with the attributes that SIGRID-3 has for the same: CT of iceact, SA to CD of
/// icesod, POLY_TYPE. What else the chart holds is left out and told in `told`.
///  - iceact 1 to 4 are names of water with less than one tenth of ice, which producers number differently: all of
///    them count as 02. A list of several totals counts as undetermined
///  - icesod is one stage or a list, "[87, 85, 99]"; 1 is ice free
/// Frame    of srsName; EPSG:4326 where there is none, latitude first as the product demands
/// Source   JCOMM S-411 edition 1.1.0, clauses 4.6 (single polygons), 4.7 (reference systems) and 9.3 (encoding); the
///          lists, as the ice services write them: sigrid3.py of the WMO's repository S-41X-PS
/// Errors   no XML; edition 1.2 and later, whose areas have other names and do not state the order of their axes; a
///          latitude over 90 degrees; areas in several reference systems; no area of sea ice
[[nodiscard]] Checked<std::shared_ptr<GDALDataset>> open_s411(const std::filesystem::path& file,
                                                              Messages& told);

}  // namespace floeplan::ingest
