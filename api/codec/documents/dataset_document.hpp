#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <vector>

#include "engine/core/units.hpp"
#include "engine/ocean/dataset_ref.hpp"
#include "storage/repository/datasets/dataset.hpp"

namespace floeplan::codec {

/// A longer time axis is not listed in the document; its first and last time always are.
inline constexpr std::size_t max_listed_times = 2000;

/// An entry in the list of datasets, for API and command line.
/// `times`  the time steps of currents, wind and ice, otherwise empty
/// `all`    the stored datasets, among which the better one of a resampled dataset is found
[[nodiscard]] nlohmann::json dataset_document(const repository::Dataset& dataset,
                                              const std::vector<core::UtcTime>& times = {},
                                              std::span<const repository::Dataset> all = {});

/// The datasets from which a result was computed.
[[nodiscard]] nlohmann::json dataset_refs_json(const std::vector<ocean::DatasetRef>& datasets);
/// Reads one of them back.
/// Errors  nlohmann::json::exception when a required member is missing
[[nodiscard]] ocean::DatasetRef parse_dataset_ref(const nlohmann::json& document);

}  // namespace floeplan::codec
