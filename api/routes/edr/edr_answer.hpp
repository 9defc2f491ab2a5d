#pragma once

#include <functional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "api/codec/documents/coverage.hpp"
#include "api/routes/edr/edr_request.hpp"
#include "api/routes/request/context.hpp"

namespace floeplan::routes {

/// The coverage as CoverageJSON; with the older of its two media types if the client asks for that.
[[nodiscard]] Response coverage_reply(const Request& request, const nlohmann::json& coverage);
/// `why`  a sentence for the client; empty: no dataset covers the place and time
[[nodiscard]] Response no_data(const Request& request, const std::string& why = {});
[[nodiscard]] bool has_value(const codec::CoverageGrid& coverage);
/// The number with at most seven digits, for messages.
[[nodiscard]] std::string number_text(double value);
/// The refusal of an answer with too many values; nullopt if it is not too large.
[[nodiscard]] std::optional<Response> refuse_if_too_large(const Request& request, double values);
/// Number of values that the coverage has at each place.
[[nodiscard]] double layers_of(const codec::CoverageGrid& coverage);

/// A coverage with the requested parameters, times and depths of a dataset, still without places. `z_m`: the
/// depth in the place of the query, which has priority over the query's z.
/// Errors   why the dataset has no data at these times or depths, as a sentence for the client
[[nodiscard]] tl::expected<codec::CoverageGrid, std::string> planned_coverage(const EdrCollection& collection,
                                                                              const EdrShape& shape,
                                                                              const EdrRequest& query,
                                                                              const Wanted& wanted,
                                                                              std::optional<double> z_m = {});

/// Samples the field at all places of the coverage with `is_inside` ([y][x]) true; the others stay empty.
void fill(codec::CoverageGrid& coverage, const EdrField& field, const EdrCollection& collection,
          const Wanted& wanted, const std::vector<bool>& is_inside);

/// The answer of one dataset.
struct EdrAttempt {
  std::optional<codec::CoverageGrid> coverage{};  // empty: no data
  std::vector<bool> is_inside{};                  // [y][x] of the coverage: whether the place was sampled
  /// True if the dataset was sampled wherever it may have values. If it has none, null is then the answer.
  bool is_conclusive{false};
  std::string why{};  // why there is no value, as a sentence for the client
};

/// The grids of datasets already sampled. Only the first three datasets on the same grid are sampled, because
/// land and gaps are mostly in the same places, and a store may contain hundreds of runs.
class AskedGrids {
 public:
  /// Whether to sample a dataset on this grid; if so, it is counted.
  [[nodiscard]] bool take(const ocean::HorizontalGrid& grid);

 private:
  std::vector<ocean::HorizontalGrid> asked_;
};

/// The coverage of the first dataset with a value; datasets that cover most of the box come first. Otherwise
/// the first conclusive answer; otherwise a refusal. If a period is requested, other runs of the same model
/// add steps in it that no newer run covers.
[[nodiscard]] tl::expected<codec::CoverageGrid, Response> first_with_values(
    sql::Connection& db, const Request& request, const EdrCollection& collection, const Wanted& wanted,
    const geo::BoundingBox& box,
    const std::function<tl::expected<EdrAttempt, Response>(const EdrShape&)>& ask);

}  // namespace floeplan::routes
