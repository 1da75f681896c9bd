#pragma once
#include <optional>
#include <string>

#include "sim/solid/solid_observer.hpp"
#include "sim/solid/solid_span.hpp"
#include "sim/solid/touchable.hpp"

namespace reye::sim {

/// Plays cycles and load steps on the present shapes. It owns the equations, which are made of the shapes and of the
/// nodes that contact may touch; states made before there were more of these are carried onto them.
class SolidPlayer {
 public:
  /// `assembly`: the equations of the state where it is under way; else they are made. Throws base::SolveError.
  SolidPlayer(const SolidProblem& problem, SolidRunState& state, std::optional<SolidAssembly> assembly);

  /// A state carried onto the present points.
  SolidRunState brought_up(SolidRunState state) const;
  /// One play of the span's step, or what is left of it where the state is within. Rows, frames inside and progress go
  /// to `observer`, and states at the ends of increments but the last.
  SolidOutcome play(SolidRunState state, const SolidSpan& span, const SolidObserver& observer);
  /// Makes the equations of other shapes, with the state's values carried onto them. Bodies that have not changed keep
  /// theirs. Throws base::SolveError.
  void reshape(SolidRunState& state, SolidMeshes meshes);

  /// Shows the state on other shapes, on which nothing is played any more: the bodies keep their equations.
  void show_on(SolidRunState& state, SolidMeshes meshes);

  /// Makes the equations of fresh meshes with these touchable nodes; what the state holds of contacts is to be carried
  /// onto them.
  void redraw(SolidRunState& state, SolidMeshes meshes, Touchable touchable);
  /// Solves the state as it is again, without slip and wear; a reason where that fails.
  std::string settle(SolidRunState& state, const scene::Step& step) const;

  /// False where the last ones that were asked for could not be made.
  bool has_equations() const { return assembly_.has_value(); }
  const SolidAssembly& assembly() const { return *assembly_; }
  const solver::SolidSystem& system() const { return assembly_->system; }

 private:
  struct Playing;
  void assemble_bodies(SolidRunState& state);
  void build(SolidRunState& state);
  void bring_up(SolidRunState& state) const;
  /// Places the points by the state's tractions, and carries the gap onto the present shapes.
  void fit(SolidRunState& state) const;
  std::string settle_for(SolidRunState& state, solver::SolidTarget target) const;
  std::string settle_ahead(SolidRunState& state, const SolidSpan& span) const;
  std::string play_between(Playing& play, double from, double to, int depth);
  std::string solve(Playing& play, const std::map<std::string, double>& factors, double from, double to);
  void accept(Playing& play, const std::map<std::string, double>& factors, double to);
  static void note_course(Playing& play, double to);
  void record(const Playing& play, double to) const;
  void show_inside(const Playing& play, double to) const;

  const SolidProblem& problem_;
  double increments_;  ///< of all steps and cycles
  Touchable touchable_;
  std::optional<SolidAssembly> assembly_;
};

/// The row of the history for the increment that led to a state.
SolidIncrement row_of(const SolidProblem& problem, const solver::SolidSystem& system, const SolidRunState& state);

}  // namespace reye::sim
