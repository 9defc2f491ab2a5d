#pragma once

#include <nlohmann/json.hpp>

/// nlohmann::json with its members compiled once, in json.cpp, instead of in every unit that uses it.
extern template class nlohmann::basic_json<>;
