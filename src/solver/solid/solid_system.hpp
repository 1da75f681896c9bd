#pragma once
#include <vector>

#include "body/solid/solid_body.hpp"
#include "contact/solid/skin_place.hpp"
#include "contact/solid/skin_setup.hpp"

/// Equations of solids in contact, in compliance form: displacements of the points that contact may touch follow from
/// the tractions, what is driven and the motions that nothing holds,
///   u = -C Q^T z + U s + A a,      -A^T Q^T z + B s = 0.
namespace reye::solver {

using base::Matrix;
using base::Points3;
using base::Vec3;
using base::Vector;

/// Bodies side by side: points, driven values and free motions of all of them in one numbering each.
struct SolidSystem {
  std::vector<body::SolidBody> bodies;
  std::vector<contact::SkinSetup> contacts;
  std::vector<int> first_point, first_driven, first_free;  ///< per body, and the end
  std::vector<contact::HeldDirections> held;               ///< per point
  std::vector<char> yields;  ///< per body: it moves under forces, as a rigid one does on springs alone
  /// Per body C W, W = A (A^T A)^-1: what is left of the balance of a free body while its equations are being solved is
  /// borne by forces spread over its points, not by the springs that C holds it with.
  std::vector<Matrix> relief;

  int points() const { return first_point.back(); }
  int driven() const { return first_driven.back(); }
  int free() const { return first_free.back(); }
};

/// Where the points of each body begin, for `contact::Columns`: they are numbered body by body as they are retained.
SolidSystem make_system(std::vector<body::SolidBody> bodies);

/// Displacements of all points for forces on them, driven values s and free motions a; with loads out of balance
/// u = C f - (C W)(A^T f + B s) + U s + A a.
Vector displacement(const SolidSystem& system, const Vector& force, const Vector& s, const Vector& a);

/// Adds the forces -Q^T z of one contact.
void add_contact_forces(const contact::SkinPlace& place, const Points3& traction, Vector& force);

/// The forces of all contacts.
Vector contact_forces(const SolidSystem& system, const std::vector<contact::SkinPlace>& places,
                      const std::vector<Points3>& traction);

/// Positions of all points at their displacements.
Vector positions(const SolidSystem& system, const Vector& u);

/// A^T f + B s: what is left of the balance in each free motion [N; N mm].
Vector imbalance(const SolidSystem& system, const Vector& force, const Vector& s);

}  // namespace reye::solver
