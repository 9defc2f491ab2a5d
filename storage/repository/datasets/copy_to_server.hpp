#pragma once

#include <filesystem>
#include <vector>

#include "storage/repository/datasets/dataset.hpp"
#include "storage/sql/connection.hpp"

namespace floeplan::repository {

/// Does the work of `take_over_datasets` where a database server keeps this store. All rows go over in one
/// transaction. Others see the rows only at its end and may write meanwhile. If this process dies, the server
/// undoes the transaction.
/// `arrived`  a store of this process's own, with the other store attached as "arrived"
std::vector<DatasetId> copy_to_server(sql::Connection& arrived, sql::Connection& server);

}  // namespace floeplan::repository
