#include "fit/alone.hpp"

namespace reye::fit {

std::vector<Alone> each_alone(const std::vector<Record>& records, const Model& model, const Unknowns& together) {
  std::vector<Alone> all;
  for (const Record& record : records) {
    const Unknowns at = records.size() > 1 ? descend({record}, model, together).at : together;
    const Matrix taken = taken_columns(record, model, at);
    all.push_back({at, taken, belief_of(record, taken),
                   scores_of(record, columns_of(record, model, at), static_cast<int>(at.theta.size()))});
  }
  return all;
}

}  // namespace reye::fit
