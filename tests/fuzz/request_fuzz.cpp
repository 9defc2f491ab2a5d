#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string_view>

#include "api/codec/bytes/json_text.hpp"
#include "api/codec/inputs/ingest_inputs.hpp"
#include "api/codec/inputs/plan_inputs.hpp"
#include "api/codec/inputs/reach_inputs.hpp"
#include "api/codec/inputs/simulate_inputs.hpp"

namespace {

using namespace floeplan::codec;
using nlohmann::json;

/// Accepted inputs, written with all defaults, are accepted again and give the same text: a job repeated
/// after a crash is the same job.
template <class Parse>
void check(const json& inputs, const Parse& parse) {
  const auto read = parse(inputs);
  if (!read) {
    if (read.error().empty()) std::abort();  // a refusal has a reason
    return;
  }
  const json written = to_json(*read);
  const auto again = parse(written);
  if (!again || to_json(*again) != written) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto inputs = parse_json({reinterpret_cast<const char*>(data), size});
  if (!inputs) return 0;
  check(*inputs, [](const json& value) { return parse_plan_inputs(value); });
  check(*inputs, [](const json& value) { return parse_evaluate_inputs(value); });
  check(*inputs, [](const json& value) { return parse_reach_inputs(value); });
  check(*inputs, [](const json& value) { return parse_simulate_inputs(value); });
  check(*inputs, [](const json& value) { return parse_ingest_inputs(value); });
  return 0;
}
