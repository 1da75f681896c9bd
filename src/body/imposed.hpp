#pragma once
#include <array>
#include <map>
#include <string>

#include "body/supports.hpp"

/// The motions that supports impose, as values that can be compared.
namespace reye::body {

inline constexpr std::array<const char*, 3> motion_names{"x", "y", "rotation"};

/// An imposed displacement as a sum of histories times amplitudes; empty for a fixed motion.
using Imposed = std::map<std::string, double>;

inline bool drives(const Motion& m) { return m.drive == Drive::moved || m.drive == Drive::loaded; }

void add(Imposed& to, const Motion& motion, double weight);
void add(Imposed& to, const Imposed& other, double weight);

/// Equal to round-off of the amplitudes.
bool same(const Imposed& a, const Imposed& b);

}  // namespace reye::body
