#pragma once

#include "engine/messages/kind.hpp"

/// Messages to the pilot about the format of a Zarr store.
namespace floeplan::messages {

inline constexpr auto ingest_zarr_kinds = std::to_array<Kind>({
    {.code = "zarr-not-read",
     .rank = Rank::caution,
     .text = "this Zarr store of version 3 {what}, which this program does not read",
     .hint = "Convert it to NetCDF, for example by Python's xarray.open_zarr(...).to_netcdf(...)",
     .slots = {{{"what", "keeps many chunks in one file (shards)"}}}},
    {.code = "zarr-damaged",
     .rank = Rank::caution,
     .text = "the Zarr store is damaged, because {which} {fault}",
     .hint = "Copy or download it again",
     .slots = {{{"which", "the description of an array"}, {"fault", "has no shape"}}}},
    {.code = "zarr-array-alone",
     .rank = Rank::caution,
     .text = "this folder is one array of a Zarr store, not the whole store",
     .hint = "Give the folder of the whole store"},
    {.code = "zarr-without-group",
     .rank = Rank::caution,
     .text = "this Zarr store has no group at its top",
     .hint = "Give the folder that holds .zgroup"},
    {.code = "zarr-unreadable",
     .rank = Rank::caution,
     .text = "the Zarr store cannot be read",
     .hint = "Check that you may read its folders"},
    {.code = "zarr-with-links",
     .rank = Rank::caution,
     .text = "the Zarr store holds something that is not a file ({name})",
     .hint = "Copy the store without links",
     .slots = {{{"name", "latest"}}}},
    {.code = "zarr-with-too-many-files",
     .rank = Rank::caution,
     .text = "the Zarr store has more than 100000 files, the most that this program reads",
     .hint = "Cut out your area and period first"},
});

/// Makes the message with this code. `given`: its values, in the order of its slots in the table above.
template <Code code, class... Given>
[[nodiscard]] Message ingest_zarr_message(const Given&... given) {
  return make_message<ingest_zarr_kinds, code>(given...);
}

}  // namespace floeplan::messages
