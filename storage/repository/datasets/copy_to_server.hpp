#pragma once

#include <filesystem>
#include <vector>

#include "storage/repository/datasets/dataset.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::repository {

/// What `take_over_datasets` does where a server keeps this store: all rows go over in one transaction, which nobody sees
/// before its end, which hinders no other writer, and which is undone when this process dies.
/// `arrived`  a store of this process's own to which the other one is attached as "arrived"
std::vector<DatasetId> copy_to_server(sql::Connection& arrived, sql::Connection& server);

}  // namespace floeplan::repository
