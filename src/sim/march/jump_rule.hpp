#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "scene/scene.hpp"
#include "sim/problem/records.hpp"

/// The cycles of blocks under a tolerance, by the errors they make, whatever the dimension.
namespace reye::sim {

inline constexpr double unjumped = 1.0;     ///< cycles of a block without a jump: it is played once and has no error
inline constexpr double most_growth = 4.0;  ///< of the cycles from one block to the next
/// Of a block's cycles to those of the one that it continues: with 1.7 and 2 more blocks are refused than are saved.
inline constexpr double usual_ratio = 1.5;
/// Cycles of a block that is tried once more after a refusal: one of fewer is played three times, which costs more than
/// its cycles by themselves, and they have no error.
inline constexpr double fewest_tried = 3.0;
/// Share of a block's cycles that level it: more than its extrapolation leaves uneven.
inline constexpr double levelling = 0.2;

/// The error that a block may have which ends after `end` cycles of its step: errors fade as more is worn, until the
/// end of the step or the next limit, where the tolerance holds. `measure`, `reached`: of the limits, when
/// `step_cycles` of the step were done.
double allowed(const std::vector<scene::Limit>& limits, const std::map<std::string, double>& measure,
               const std::map<std::string, double>& reached, const scene::Step& step, double step_cycles, double end);

/// The error of a block whose two halves are so far from the block as a whole. Where some of the contact sticks, the
/// edge of the stick zone recedes from node to node, and halves keep more of the error than half: a share is added.
double block_error(double difference, bool slips_throughout);

/// Cycles to try after a block of one cycle, which the one that was `tried` before it has come down to. `first`: it is
/// the first one of its step, unlike all later ones. `continues`: the next block may continue a cycle by itself, at a
/// third of what blocks of more cost, to begin with after the second one.
double after_one_cycle(double tried, bool first, bool continues);

/// The factor by which the cycles of a block are cut that has failed, or had an error beyond the one that is allowed.
double shortened(bool too_long, double allowed, double error);

/// Cycles for the next block. Errors count relative to all that is worn: they scale with the block's share of it,
/// between the first power (edges of the scar) and the second (the rest), and where error per share grew from one block
/// to the next (`rate_before`: that of the block before; 0: not known) it is assumed to grow again. `share`, `error`:
/// of the block that had `jump` cycles.
double next_jump(double jump, double share, double error, double tolerance, double rate_before = 0.0);

/// Cycles of a block that is to continue one of `before` cycles (`two_step`), where errors would permit `jump`: more
/// where the error of the run is a small share of the one that is allowed.
double to_continue(double jump, double before, double share_of_error);

/// What a reader must know of blocks of one size, of which the last one wore so much elsewhere than a cycle by itself
/// does at its end (`worn_elsewhere`); nothing where that is little.
std::optional<Warning> uneven_jump(const scene::Step& step, double cycle, double cycles, double apart);

}  // namespace reye::sim
