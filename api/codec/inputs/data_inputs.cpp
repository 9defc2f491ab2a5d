#include "api/codec/inputs/data_inputs.hpp"

#include "api/codec/reading/input_fields.hpp"
#include "api/fields/request_fields.hpp"
#include "storage/json/json.hpp"

namespace floeplan::codec {

void read_data(InputReader& reader, repository::EnvironmentQuery& data) {
  read_fields(reader, fields::data_fields(), data);
}

void write_data(const repository::EnvironmentQuery& data, nlohmann::json& inputs) {
  write_fields(fields::data_fields(), data, inputs);
}

}  // namespace floeplan::codec
