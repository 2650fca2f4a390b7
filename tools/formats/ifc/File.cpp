// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "formats/ifc/File.h"

#include <CGAL/Geometric_continuity/Error.h>

#include <set>

namespace ifc {

namespace {

std::set<std::uint64_t> assigned_units(const File& file) {
  std::set<std::uint64_t> units;
  for (const std::uint64_t id : file.ids()) {
    const Entity& e = file.entity(id);
    if (e.type != "IFCUNITASSIGNMENT") continue;
    for (const std::uint64_t x : file.references(file.arguments(e, 1)[0], e)) units.insert(x);
  }
  return units;
}

} // namespace

File::File(std::istream& stream, const std::string& name) : Step_file(stream, name) {
  if (schema().substr(0, 3) != "IFC")
    throw GC::Error(GC::Error_code::malformed_input, name + ": the schema '" + schema() + "' is none of IFC");
  read_units();
}

void File::read_units() {
  const std::set<std::uint64_t> assigned = assigned_units(*this);
  for (const std::uint64_t id : ids()) {
    const Entity& e = entity(id);
    if (e.type == "IFCGEOMETRICREPRESENTATIONCONTEXT") {
      const std::optional<Q> precision = optional_number(arguments(e, 4)[3], e);
      if (precision && *precision > 0 && (!precision_ || *precision_ < *precision)) precision_ = precision;
    }
    if (e.type == "IFCCONVERSIONBASEDUNIT") {
      const std::vector<Step_value> a = arguments(e, 4);
      if (a[1].kind != Kind::word || a[1].text != "PLANEANGLEUNIT") continue;
      if (assigned.count(id) == 0) continue;
      const Entity& factor = at(reference(a[3], e), e);
      radians_ = number(arguments(factor, 2)[0], factor);
    }
  }
}

std::optional<Q> File::optional_number(const Step_value& value, const Entity& of) const {
  if (value.kind == Kind::unset) return std::nullopt;
  return number(value, of);
}

std::vector<Q> File::coordinates(std::uint64_t id, const Entity& from) const {
  const Entity& point = at(id, from);
  std::vector<Q> x = numbers(arguments(point, 1)[0], point);
  if (x.size() < 2) refuse(point, "fewer than two coordinates");
  return x;
}

Placement File::placement(std::uint64_t id, const Entity& from) const {
  const Entity& p = at(id, from);
  const bool in_space = p.type == "IFCAXIS2PLACEMENT3D";
  if (!in_space && p.type != "IFCAXIS2PLACEMENT2D") throw Not_covered{"a placement by " + p.type};
  const std::vector<Step_value> a = arguments(p, in_space ? 3 : 2);
  const std::vector<Q> location = coordinates(reference(a[0], p), p);
  const Step_value& direction = a[in_space ? 2 : 1];
  if (direction.kind == Kind::unset) return {location[0], location[1], GC::Heading()};
  const std::vector<Q> d = coordinates(reference(direction, p), p);
  if (d[0] == 0 && d[1] == 0) throw Not_covered{"a direction of zero"};
  return {location[0], location[1], GC::Heading(Q(0), d[0], d[1])};
}

} // namespace ifc
