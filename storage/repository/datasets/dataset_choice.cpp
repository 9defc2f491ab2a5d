#include "storage/repository/datasets/dataset_choice.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "engine/messages/fault.hpp"

namespace floeplan::repository {
namespace {

/// Why a named dataset cannot be used; empty if it can.
std::optional<core::Violation> objection(const Dataset& dataset, DatasetKind kind,
                                         const geo::BoundingBox& area) {
  const std::string field = "/" + kind_name(kind);
  if (dataset.kind != kind)
    return messages::fault<"dataset-holds-another-kind">(field, title(dataset), kind_name(dataset.kind),
                                                         kind_name(kind));
  if (!geo::intersects(dataset.bounds, area))
    return messages::fault<"dataset-of-another-area">(field, title(dataset), geo::bounds_text(dataset.bounds),
                                                      geo::bounds_text(area));
  return std::nullopt;
}

}  // namespace

std::vector<Dataset> candidates(const std::vector<Dataset>& stored, DatasetKind kind,
                                const DatasetChoice& choice, const geo::BoundingBox& area,
                                core::Violations& violations) {
  std::vector<Dataset> found;
  switch (choice.how) {
    case DatasetChoice::How::none: break;
    case DatasetChoice::How::newest:
      std::ranges::copy_if(stored, std::back_inserter(found), [&](const Dataset& dataset) {
        return dataset.kind == kind && geo::intersects(dataset.bounds, area);
      });
      if (has_steps(kind)) sort_newest_run_first(found);
      break;
    case DatasetChoice::How::named:
      for (const DatasetId& id : choice.ids) {
        const auto dataset = std::ranges::find(stored, id, &Dataset::id);
        std::optional<core::Violation> fault =
            dataset == stored.end()
                ? messages::fault<"no-dataset-of-this-id">("/" + kind_name(kind), id.value)
                : objection(*dataset, kind, area);
        if (fault) {
          violations.push_back(std::move(*fault));
        } else {
          found.push_back(*dataset);
        }
      }
      break;
  }
  return found;
}

std::string title(const Dataset& dataset) { return dataset.name + " (" + dataset.id.value + ")"; }

}  // namespace floeplan::repository
