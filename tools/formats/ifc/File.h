// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_IFC_FILE_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_IFC_FILE_H

#include "formats/ifc/Step_file.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity/joins/alignment_join.h>

#include <cstdint>
#include <istream>
#include <optional>
#include <string>
#include <vector>

namespace GC = CGAL::Geometric_continuity;

namespace ifc {

typedef CGAL::Exact_rational Q;
typedef Step_file::Entity Entity;
typedef Step_value::Kind Kind;

// Thrown for a segment that cannot be decided, with the reason.
struct Not_covered {
  std::string reason;
};

// A point of the plane and a direction.
struct Placement {
  Q x, y;
  GC::Heading heading;
};

inline std::string hash(std::uint64_t id) { return "#" + std::to_string(id); }

// The entities of a file in IFC, with what all parts of the reader ask for: numbers that may be
// missing, points and directions, and units.
class File : public Step_file {
  Q radians_ = 1;
  std::optional<Q> precision_;

  void read_units();

public:
  // Throws GC::Error as Step_file does, `malformed_input` also for other schemata.
  File(std::istream& stream, const std::string& name);

  // The unit of angles, and the largest precision that is given.
  const Q& radians() const { return radians_; }
  const std::optional<Q>& precision() const { return precision_; }

  const Entity& at(std::uint64_t id, const Entity& from) const { return entity(id, from.line); }
  std::optional<Q> optional_number(const Step_value& value, const Entity& of) const;

  // The coordinates of a point, or of a direction; at least two.
  std::vector<Q> coordinates(std::uint64_t id, const Entity& from) const;
  Placement placement(std::uint64_t id, const Entity& from) const;

  // A measure of length, or of a parameter that `length_of` makes a length.
  template <class Length_of> Q measure(const Step_value& value, const Entity& of, Length_of length_of) const {
    const Q x = number(value, of);
    return value.kind == Kind::typed && value.text == "IFCPARAMETERVALUE" ? length_of(x) : x;
  }
};

} // namespace ifc

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_IFC_FILE_H
