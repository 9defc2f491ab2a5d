#pragma once

#include <functional>
#include <string>
#include <tl/expected.hpp>
#include <vector>

#include "api/codec/documents/coverage.hpp"
#include "api/routes/edr/edr_request.hpp"
#include "api/routes/request/context.hpp"

namespace floeplan::routes {

/// CoverageJSON, by the older of its two media types when the client asks for that.
[[nodiscard]] Response coverage_reply(const Request& request, const nlohmann::json& coverage);
/// `why`  a sentence for the client; empty: no dataset meets the place and the time at all
[[nodiscard]] Response no_data(const Request& request, const std::string& why = {});
[[nodiscard]] bool has_value(const codec::CoverageGrid& coverage);
/// The number as messages write it, with seven digits at most.
[[nodiscard]] std::string number_text(double value);
/// The refusal of an answer of so many values; empty: it is not too large.
[[nodiscard]] std::optional<Response> refuse_if_too_large(const Request& request, double values);
/// How many values the coverage has at each place.
[[nodiscard]] double layers_of(const codec::CoverageGrid& coverage);

/// A coverage of the wanted parameters, times and depths of a dataset, without places. `z_m`: the depth that goes
/// with the place, before that of the query.
/// Errors   why the dataset has nothing of the times or depths, as a sentence for the client
[[nodiscard]] tl::expected<codec::CoverageGrid, std::string> planned_coverage(const EdrCollection& collection,
                                                                              const EdrShape& shape,
                                                                              const EdrRequest& query,
                                                                              const Wanted& wanted,
                                                                              std::optional<double> z_m = {});

/// Asks the field at every place of the coverage that is inside ([y][x]); the others stay empty.
void fill(codec::CoverageGrid& coverage, const EdrField& field, const EdrCollection& collection,
          const Wanted& wanted, const std::vector<bool>& is_inside);

/// What one dataset says.
struct EdrAttempt {
  std::optional<codec::CoverageGrid> coverage{};  // empty: nothing
  std::vector<bool> is_inside{};                  // [y][x] of it: was asked
  /// Without a value: it was asked wherever it could have one, so that null is the answer.
  bool is_conclusive{false};
  std::string why{};  // there may be no value: a sentence for the client
};

/// Which grids were asked. Of datasets on one grid only the first three are: land and gaps are mostly where they
/// were, and a store may hold hundreds of runs.
class AskedGrids {
 public:
  /// Whether to ask a dataset on the grid, which then counts as asked.
  [[nodiscard]] bool take(const ocean::HorizontalGrid& grid);

 private:
  std::vector<ocean::HorizontalGrid> asked_;
};

/// The coverage of the first dataset with a value, those first that hold most of the box; else of the first whose nulls
/// are the answer; else a refusal.
/// Where a period is asked for, the other runs of the same model add their steps in it that no newer run speaks of.
[[nodiscard]] tl::expected<codec::CoverageGrid, Response> first_with_values(
    sql::Connection& db, const Request& request, const EdrCollection& collection, const Wanted& wanted,
    const geo::BoundingBox& box,
    const std::function<tl::expected<EdrAttempt, Response>(const EdrShape&)>& ask);

}  // namespace floeplan::routes
