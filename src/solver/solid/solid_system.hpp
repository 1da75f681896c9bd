#pragma once
#include <optional>
#include <vector>

#include "body/solid/solid_body.hpp"
#include "body/solid/solid_turning.hpp"
#include "contact/solid/skin_place.hpp"
#include "contact/solid/skin_setup.hpp"

/// Equations of solids in contact, in compliance form: displacements of the points that contact may touch follow from
/// the tractions, what is driven and the motions that nothing holds,
///   u = -C Q^T z + U s + A a,      -A^T Q^T z + B s = 0,
/// of a body that turns in its frame, a being the unknown motions of its pivot.
namespace reye::solver {

using base::Matrix;
using base::Points3;
using base::Vec3;
using base::Vector;

/// Bodies side by side: points, driven values and free motions of all of them in one numbering each.
struct SolidSystem {
  std::vector<body::SolidBody> bodies;                       ///< one that turns: in its frame
  std::vector<std::optional<body::SolidTurning>> turning{};  ///< per body; empty where it keeps its direction
  std::vector<contact::SkinSetup> contacts;
  std::vector<int> first_point, first_driven, first_free;  ///< per body, and the end
  std::vector<contact::HeldDirections> held;               ///< per point
  std::vector<char> yields;  ///< per body: it moves under forces, as a rigid one does on springs alone
  /// Per body C W, W = A (A^T A)^-1: what is left of the balance of a free body while its equations are being solved is
  /// borne by forces spread over its points, not by the springs that C holds it with.
  std::vector<Matrix> relief;

  int unheld = 0;  ///< free motions that no spring acts against

  bool turns() const;  ///< any body does
  const std::vector<body::Driven>& driven_values(std::size_t body) const {
    return turning[body] ? turning[body]->driven : bodies[body].driven();
  }
  /// Of one body: its forces or displacements, driven values, free motions.
  Vector of_points(const Vector& all, std::size_t body) const { return part(all, first_point, body, 3); }
  Vector of_driven(const Vector& all, std::size_t body) const { return part(all, first_driven, body, 1); }
  Vector of_free(const Vector& all, std::size_t body) const { return part(all, first_free, body, 1); }

  int points() const { return first_point.back(); }
  int driven() const { return first_driven.back(); }
  int free() const { return first_free.back(); }

 private:
  static Vector part(const Vector& all, const std::vector<int>& first, std::size_t body, int size);
};

/// Where the points of each body begin, for `contact::Columns`: they are numbered body by body as they are retained.
/// `turning` per body, or empty: none turns.
SolidSystem make_system(std::vector<body::SolidBody> bodies,
                        std::vector<std::optional<body::SolidTurning>> turning = {});

/// Per free motion what makes it comparable with others: 1 of a translation, of a rotation of a body that turns 1 over
/// its size.
Vector motion_scale(const SolidSystem& system);

/// What moves all points: forces on them, driven values, free motions, and where the frames of bodies that turn are.
struct SolidMotion {
  const Vector& force;
  const Vector& s;
  const Vector& a;
  const std::vector<body::SolidPose>& poses;  ///< per body
};

/// Displacements of all points; with loads out of balance
/// u = C f - (C W)(A^T f + B s) + U s + A a, of a body that turns in its frame and without A a.
Vector displacement(const SolidSystem& system, const SolidMotion& motion);

/// w of a body in its frame for forces and driven values in the frame.
Vector response_in_frame(const SolidSystem& system, std::size_t body, const Vector& force, const Vector& s);

/// Adds the forces -Q^T z of one contact.
void add_contact_forces(const contact::SkinPlace& place, const Points3& traction, Vector& force);

/// The forces of all contacts.
Vector contact_forces(const SolidSystem& system, const std::vector<contact::SkinPlace>& places,
                      const std::vector<Points3>& traction);

/// Positions of all points at their displacements.
Vector positions(const SolidSystem& system, const Vector& u);

/// A^T f + B s: what is left of the balance in each free motion [N; N mm].
Vector imbalance(const SolidSystem& system, const SolidMotion& motion);

/// Sum of forces, of loads and of springs, which the round-off of the balance follows.
double force_scale(const SolidSystem& system, const SolidMotion& motion);

}  // namespace reye::solver
