// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_IFC_STEP_FILE_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_IFC_STEP_FILE_H

#include <CGAL/Exact_rational.h>

#include <cstddef>
#include <cstdint>
#include <istream>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

// A value in a file of ISO 10303-21: an argument of an entity.
struct Step_value {
  enum class Kind { unset, number, text, word, reference, list, typed };

  Kind kind = Kind::unset;
  std::string_view text;         // of a number, a text, a word; the name of a typed value
  std::uint64_t reference = 0;   // the entity that is referred to
  std::vector<Step_value> items; // of a list; of a typed value its argument
};

// The entities of a file, of which each is taken apart when it is asked for. Names of types are in
// capital letters; line numbers begin with 1.
//
// Throws GC::Error with file, line and reason: `malformed_input` for what is not ISO 10303-21, for
// a number of an entity that is given twice, for values nested deeper than 64, for references to
// entities that do not exist; `work_limit` for more than 2 GiB.
class Step_file {
public:
  struct Entity {
    std::string type;
    std::string_view arguments; // between the parentheses
    long long line = 0;
  };

private:
  const std::string name_;
  std::string bytes_;
  std::string schema_;
  std::unordered_map<std::uint64_t, Entity> entities_;
  std::vector<std::uint64_t> order_; // as in the file

  [[noreturn]] void refuse(long long line, const std::string& reason) const;

public:
  Step_file(std::istream& stream, const std::string& name);
  Step_file(const Step_file&) = delete;
  Step_file& operator=(const Step_file&) = delete;

  const std::string& schema() const { return schema_; }
  const std::vector<std::uint64_t>& ids() const { return order_; }
  // The entity of a number, to which another one in this line refers.
  const Entity& entity(std::uint64_t id, long long from_line) const;
  const Entity& entity(std::uint64_t id) const { return entities_.at(id); }

  // The arguments of an entity; at least so many.
  std::vector<Step_value> arguments(const Entity& entity, std::size_t least) const;

  // These return values of one kind, and refuse others.
  CGAL::Exact_rational number(const Step_value& value, const Entity& of) const;
  std::vector<CGAL::Exact_rational> numbers(const Step_value& list, const Entity& of) const;
  std::uint64_t reference(const Step_value& value, const Entity& of) const;
  std::vector<std::uint64_t> references(const Step_value& list, const Entity& of) const;
  [[noreturn]] void refuse(const Entity& entity, const std::string& reason) const;
};

// Returns whether a text begins as a file in IFC does.
bool begins_as_ifc(std::string_view text);

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_IFC_STEP_FILE_H
