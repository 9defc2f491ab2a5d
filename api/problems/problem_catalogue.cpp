#include "api/problems/problem_catalogue.hpp"

namespace floeplan::problems {

Problem problem_of(const ProblemKind& kind, std::vector<messages::Value> values) {
  return {.status = kind.status,
          .slug = std::string{kind.slug()},
          .title = std::string{kind.title},
          .detail = messages::message_of(kind.words(), std::move(values)).text};
}

}  // namespace floeplan::problems
