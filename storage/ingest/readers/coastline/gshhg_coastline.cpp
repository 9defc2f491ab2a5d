#include <functional>

#include "engine/messages/ingest_area_messages.hpp"
#include "storage/ingest/readers/coastline/coastline_readers.hpp"
#include "storage/ingest/readers/coastline/gshhg_reader.hpp"
#include "storage/repository/features/coastline_repository.hpp"

namespace floeplan::ingest {
namespace {

constexpr double band_deg = 20.0;  // a whole number of bins at every resolution (1 to 20 degrees)
constexpr int bands = 9;
constexpr double checking_share = 0.1;  // share of checking in the whole time, measured; the rest is writing
// margin that keeps a band from including its neighbour's bins, which would come twice
constexpr double inside_deg = 0.01;

using Land = std::vector<geo::Polygon>;

/// Passes the land of each band to `use`, from the north pole southwards; `told` is called with the completed
/// share.
Checked<bool> for_each_band(const std::filesystem::path& file, const std::function<void(const Land&)>& use,
                            const std::function<void(double)>& told) {
  for (int band = 0; band < bands; ++band) {
    told(static_cast<double>(band) / bands);
    const double north_deg = 90.0 - band * band_deg;
    const auto land =
        read_gshhg(file, {-180.0, north_deg - band_deg + inside_deg, 180.0, north_deg - inside_deg});
    if (!land)
      return refuse(messages::ingest_area_message<"gshhg-damaged">(land.error().field, land.error().rule));
    use(*land);
  }
  return true;
}

}  // namespace

Checked<PreparedDataset> read_gshhg_coastline(const std::filesystem::path& file,
                                              const core::ProgressCallback& progress) {
  PreparedDataset data;
  data.kind = repository::DatasetKind::coastline;
  data.variables = {"land"};
  data.bounds = {-180.0, -90.0, 180.0, 90.0};
  const auto count = [&](const Land& land) { data.rows_accepted += static_cast<std::int64_t>(land.size()); };
  const auto checking = [&](double share) {
    if (progress) progress("checking the coastline", checking_share * share);
  };
  if (const auto read = for_each_band(file, count, checking); !read) return refuse(read.error());

  data.warnings.push_back(messages::ingest_area_message<"gshhg-is-rough">());
  data.write = [file, progress](sql::Connection& db, const repository::DatasetId& id) -> Checked<void> {
    repository::CoastlineRepository repository{db};
    const auto writing = [&](double share) {
      if (progress) progress("storing the coastline", checking_share + (1.0 - checking_share) * share);
    };
    const auto read = for_each_band(file, [&](const Land& land) { repository.insert(id, land); }, writing);
    if (!read) return tl::unexpected(read.error());
    return {};
  };
  return data;
}

}  // namespace floeplan::ingest
