#pragma once
#include <string>
#include <vector>

#include "contact/solid/cone.hpp"
#include "contact/solid/skin_wear.hpp"
#include "solver/solid/solid_system.hpp"

namespace reye::solver {

/// What is carried from increment to increment: per contact the tractions of its secondary points as vectors, so that
/// no frame enters, and whether each is open, sticks or slips.
struct SolidState {
  std::vector<Points3> traction;
  std::vector<std::vector<contact::SkinStatus>> status;
  std::vector<contact::SkinWear> wear;  ///< per contact
  Vector a;  ///< free motions; of a rotation of a body that turns the sum of what increments turned about its axis
  Vector s;  ///< driven values
  Vector u;  ///< displacements of the points
  std::vector<base::Turn> turn;  ///< per body: its rotation by free motions of its pivot, unit; else none
};

/// Where the frames of all bodies are in a state; of bodies that do not turn at rest.
std::vector<body::SolidPose> poses_of(const SolidSystem& system, const SolidState& state);

/// Where they are while an increment is being solved, `before` at its beginning.
std::vector<body::SolidPose> poses_between(const SolidSystem& system, const SolidState& before, const Vector& a,
                                           const Vector& s);

/// Before anything has happened.
SolidState initial_state(const SolidSystem& system);

/// Whether any point was in contact.
bool touched(const SolidState& state);

/// Displacements of all points that belong to a state's tractions, drives and free motions, integrated without
/// displacements: to begin from after the points were chosen again.
Vector displacements_of(const SolidSystem& system, const SolidState& state);

/// Whether any point is closed.
bool touched(const SolidState& state);

/// What one increment asks for.
struct SolidTarget {
  Vector s;                      ///< driven values at its end
  std::vector<Points3> slip;     ///< per contact and secondary point: slip that is imposed, besides that of the motion
  std::vector<double> friction;  ///< per contact
  std::vector<contact::SkinWearing> wear;  ///< per contact
  bool keeps_shear = false;                ///< shear is a given load: bodies settle in their gaps, and nothing slides
};

/// How an attempt begins. natural: what was closed stays closed in the first step, and sticks or slips by its old
/// traction and the new motion; settled: shear is kept until normal contact has settled; sticking: every closed point
/// sticks at first.
enum class SolidStart { natural, settled, sticking };

/// An increment that was solved, or why it was not.
struct SolidSolution {
  bool converged = false;
  std::string reason;  ///< of a failure
  bool loose = false;  ///< it failed since a body is free to move and nothing that touches it holds it
  int iterations = 0;
  std::vector<double> errors;  ///< largest violation over largest traction, per iteration
  SolidState state;
  std::vector<contact::SkinPlace> place;
  std::vector<std::vector<contact::SkinNode>> nodes;  ///< tractions, gaps, slips
  double mortar_s = 0.0, interface_s = 0.0;           ///< CPU seconds
};

}  // namespace reye::solver
