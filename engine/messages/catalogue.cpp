#include "engine/messages/catalogue.hpp"

#include "engine/messages/data_messages.hpp"
#include "engine/messages/plan_messages.hpp"

namespace floeplan::messages {

std::vector<Kind> catalogue() {
  std::vector<Kind> all;
  for (const std::span<const Kind> kinds :
       {std::span<const Kind>{plan_kinds}, std::span<const Kind>{data_kinds}})
    all.insert(all.end(), kinds.begin(), kinds.end());
  return all;
}

}  // namespace floeplan::messages
