#pragma once

#include <nlohmann/json_fwd.hpp>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/ocean/dataset_ref.hpp"
#include "storage/repository/datasets/dataset.hpp"

namespace floeplan::codec {

/// A time axis longer than this is left out of the document; its ends are always there.
inline constexpr std::size_t max_listed_times = 2000;

/// One entry of the list of datasets, for API and command line. `times`: the time steps of currents and ice, else
/// empty.
[[nodiscard]] nlohmann::json dataset_document(const repository::Dataset& dataset,
                                              const std::vector<core::UtcTime>& times = {});

/// The data that a result rests on.
[[nodiscard]] nlohmann::json dataset_refs_json(const std::vector<ocean::DatasetRef>& datasets);
/// One of them, read back.
/// Errors  nlohmann::json::exception where a part that each has is missing
[[nodiscard]] ocean::DatasetRef parse_dataset_ref(const nlohmann::json& document);

}  // namespace floeplan::codec
