#pragma once
#include <array>
#include <map>
#include <string>
#include <vector>

namespace reye::sim {

/// Volumes per point of either side of each contact, secondary first.
using Volumes = std::vector<std::array<std::vector<double>, 2>>;

bool same_sizes(const Volumes& a, const Volumes& b);

/// What has been removed between two states on the same points.
Volumes worn_between(const Volumes& before, const Volumes& after);

/// How far two plays wear other places: sum over the points of |v_a / sum v_a - v_b / sum v_b|, of the worst side.
/// Shares, since volumes on moved outlines are those of other areas than in gaps.
double worn_elsewhere(const Volumes& a, const Volumes& b);

/// What a play has worn until a progress of it.
struct WornUntil {
  double progress = 0.0;
  Volumes volumes;
};

/// What a play has worn, from increment to increment.
struct CourseOfWear {
  double cycles = 0.0;  ///< of the play; 0: there is none
  std::vector<WornUntil> until;

  /// Notes what has been removed in all until a progress; `at_start` of the play.
  void note(double progress, const Volumes& removed, const Volumes& at_start);

  /// What it has worn after a progress, times a factor: between increments by interpolation.
  Volumes after(double progress, double factor) const;
};

/// A play that the two-step formula continues: all of its increments see contacts as worn as at its end.
struct Continued {
  double cycle = 0.0;                      ///< of the end, at which laws are read
  const CourseOfWear* expected = nullptr;  ///< what the play is expected to wear, but for a factor
};

/// Volumes that contacts have removed.
template <class Contact>
Volumes removed_volumes(const std::vector<Contact>& contacts) {
  Volumes volumes;
  for (const auto& contact : contacts) volumes.push_back({contact.removed_secondary, contact.removed_primary});
  return volumes;
}

/// What the last block of a step has worn: the next one may continue by it (`two_step`).
template <class Contact>
struct BlockWear {
  double cycles = 0.0;                     ///< of the block; 0: there is none to continue
  std::vector<Contact> contacts;           ///< growth in it of the quantities that wear; the others are empty
  std::map<std::string, double> measures;  ///< of the limits at its start, where known
  CourseOfWear course;                     ///< of its last play
};

}  // namespace reye::sim
