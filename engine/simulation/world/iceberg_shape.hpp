#pragma once

#include <random>
#include <string_view>

#include "engine/core/units.hpp"
#include "engine/simulation/world/body.hpp"

namespace floeplan::simulation {

/// Shapes of icebergs, by the codes of the ice services.
enum class IcebergForm { tabular, blocky, domed, pinnacle, wedge, drydock };

/// The shape for an ice service's code (TAB, BLK, DOM, PIN, WDG, DD, NTB); a random one for other codes.
[[nodiscard]] IcebergForm iceberg_form(std::string_view code, std::mt19937_64& rng);

/// A random draft for this length: uniform between the two relations in use.
/// Source   1.78 L^0.71: C-CORE, from iceberg profiles off Newfoundland, as ocean::drift_draft; 2.91 L^0.71
///          and, above 160 m, 3.78 L^0.63: Barker, Sayed and Carrieres 2004, Hotzel and Miller 1983, as
///          ocean::safe_draft
[[nodiscard]] core::Metres likely_draft(core::Metres length, std::mt19937_64& rng);

/// A solid of this shape, with its length along the first axis and its deepest point at the draft. Facets are
/// chipped at random by up to a tenth.
/// Form     tabular and blocky: vertical sides; domed: half an ellipsoid; pinnacle: sides lean in towards the
///          keel; wedge: a keel that rises from one end to the other; drydock: two columns with a slab
///          between them below the water
/// Source   length over width 1.62: Dowdeswell; height over draft by form, 1:5 (tabular, blocky, wedge), 1:4
///          (domed), 1:2 (pinnacle), 1:1 (drydock): Canadian Ice Service, MANICE, chapter 4
/// Errors   std::invalid_argument unless length and draft are positive
[[nodiscard]] Shape iceberg_shape(IcebergForm form, core::Metres length, core::Metres draft,
                                  std::mt19937_64& rng);

}  // namespace floeplan::simulation
