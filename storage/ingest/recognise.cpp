#include "storage/ingest/recognise.hpp"

#include <algorithm>

#include "engine/messages/ingest_file_messages.hpp"
#include "storage/ingest/format_of.hpp"
#include "storage/ingest/netcdf_contents.hpp"
#include "storage/ingest/readers/velocity/velocity_pair.hpp"

namespace floeplan::ingest {

using repository::DatasetKind;

Checked<RecognisedFile> recognise(const std::filesystem::path& file, const Expectation& expected) {
  const auto format = format_of(file, expected.kind == DatasetKind::icebergs);
  if (!format) return refuse(format.error());
  RecognisedFile result{.path = file,
                        .format = *format,
                        .kinds = {},
                        .netcdf = nullptr,
                        .companions = {},
                        .features = nullptr,
                        .warnings = {}};
  if (result.format->look_into != nullptr) {
    if (const auto looked = result.format->look_into(result, expected); !looked)
      return refuse(looked.error());
  } else {
    result.kinds = result.format->kinds;
  }
  if (!expected.kind) return result;

  const bool held = std::ranges::find(result.kinds, *expected.kind) != result.kinds.end();
  if (!held && *expected.kind == DatasetKind::ice && result.format->is_plain_raster)
    return refuse(messages::ingest_file_message<"raster-of-no-depths">());
  if (!held && *expected.kind == DatasetKind::ice && result.netcdf && !expected.variable)
    if (auto unnamed = ice_not_named(*result.netcdf)) return refuse(std::move(*unnamed));
  const bool moves = *expected.kind == DatasetKind::currents || *expected.kind == DatasetKind::wind;
  if (!held && moves && result.netcdf) {
    const Moving what = *expected.kind == DatasetKind::currents ? Moving::sea : Moving::air;
    if (auto left_out = velocities_left_out(*result.netcdf, what)) return refuse(std::move(*left_out));
  }
  if (!held)
    return refuse(messages::ingest_file_message<"other-kind-than-stated">(
        repository::kind_name(result.kinds.front()), repository::kind_name(*expected.kind)));
  result.kinds = {*expected.kind};
  return result;
}

}  // namespace floeplan::ingest
