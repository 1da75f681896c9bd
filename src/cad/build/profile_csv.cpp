#include "base/csv.hpp"
#include "base/errors.hpp"
#include "cad/build/profile.hpp"

namespace reye::cad {

namespace {

[[noreturn]] void refuse(const std::string& rule) { throw base::InputError({{"", "", rule}}); }

}  // namespace

Profile parse_profile(const std::string& csv) {
  Profile profile;
  for (const auto& [line, values] : base::parse_numbers(csv, "arc_length_mm,height_mm").rows) {
    const std::string place = "line " + std::to_string(line) + ": ";
    if (values[0] < 0.0) refuse(place + "arc_length_mm must be >= 0");
    if (!profile.arc_mm.empty() && values[0] <= profile.arc_mm.back()) refuse(place + "arc_length_mm must increase");
    profile.arc_mm.push_back(values[0]);
    profile.height_mm.push_back(values[1]);
  }
  if (profile.arc_mm.size() < 2) refuse("needs at least two rows of numbers");
  return profile;
}

}  // namespace reye::cad
