#include "storage/repository/datasets/dataset_choice.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace floeplan::repository {
namespace {

std::string degrees_text(double degrees, char positive, char negative) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.4g %c", std::abs(degrees), degrees < 0.0 ? negative : positive);
  return text.data();
}

/// Why a named dataset cannot be used; empty: it can.
std::string objection(const Dataset& dataset, DatasetKind kind, const geo::BoundingBox& area) {
  if (dataset.kind != kind) {
    return title(dataset) + " holds " + kind_name(dataset.kind) + ", not " + kind_name(kind);
  }
  if (!geo::intersects(dataset.bounds, area)) {
    return title(dataset) + " covers " + bounds_text(dataset.bounds) + " and shares nothing with the area " +
           bounds_text(area);
  }
  return "";
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
        const std::string why = dataset == stored.end() ? "no dataset has the id " + id.value +
                                                              "; list them with `floeplan datasets`"
                                                        : objection(*dataset, kind, area);
        if (why.empty()) {
          found.push_back(*dataset);
        } else {
          violations.push_back({"/" + kind_name(kind), why});
        }
      }
      break;
  }
  return found;
}

std::string title(const Dataset& dataset) { return dataset.name + " (" + dataset.id.value + ")"; }

std::string bounds_text(const geo::BoundingBox& box) {
  return degrees_text(box.west_deg, 'E', 'W') + " to " + degrees_text(box.east_deg, 'E', 'W') + ", " +
         degrees_text(box.south_deg, 'N', 'S') + " to " + degrees_text(box.north_deg, 'N', 'S');
}

}  // namespace floeplan::repository
