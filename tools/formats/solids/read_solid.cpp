// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "formats/solids/read_solid.h"

#include "files/input.h"
#include "files/output.h"
#include "formats/cad/cad_file.h"
#include "formats/cad/read_cad.h"
#include "formats/solids/check_closed.h"
#include "formats/solids/make_planar.h"

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/IO/number.h>

#include <algorithm>
#include <istream>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace {

typedef CGAL::Exact_rational Exact;

Solid::Point exact_point(const std::array<double, 3>& p) { return {Exact(p[0]), Exact(p[1]), Exact(p[2])}; }

// A polygon mesh: after the word OFF the numbers of vertices, faces and edges, then the coordinates
// of all vertices, and for each face a line of the number of its vertices and their numbers. What
// follows in the line of a face, such as a colour, is skipped, and what follows # in any line.
class Off_reader {
  std::istream& is_;
  const std::string& name_;
  long long line_ = 0;
  std::vector<std::string> words_; // of the line
  std::size_t next_ = 0;           // the number of the next one

  [[noreturn]] void refuse(const std::string& reason) const {
    throw GC::Error(GC::Error_code::malformed_input, name_ + ":" + std::to_string(line_) + ": " + reason);
  }

  bool is_at_end_of_line() const { return next_ == words_.size(); }
  void skip_line() { next_ = words_.size(); }

  // Reads the next word, also in another line.
  const std::string& word(const std::string& what) {
    while (is_at_end_of_line()) {
      std::string line;
      if (!std::getline(is_, line)) refuse("the file ends where " + what + " is expected");
      ++line_;
      line.erase((std::min)(line.find('#'), line.size()));
      words_.clear();
      next_ = 0;
      for (std::size_t begin = 0;;) {
        begin = line.find_first_not_of(" \t\r\v\f", begin);
        if (begin == std::string::npos) break;
        const std::size_t end = (std::min)(line.find_first_of(" \t\r\v\f", begin), line.size());
        words_.push_back(line.substr(begin, end - begin));
        begin = end;
      }
    }
    return words_[next_++];
  }

  std::size_t count(const std::string& word) const {
    if (word.empty() || word.size() > 9 || word.find_first_not_of("0123456789") != std::string::npos)
      refuse("a number of things is expected, not " + GC::quoted_token(word));
    return std::stoul(word);
  }

  Exact number(const std::string& word) const {
    try {
      return GC::parse_number<Exact>(word);
    } catch (const GC::Error& e) {
      const std::string code = to_string(e.code()) + ": ", text = e.what();
      refuse(text.substr(code.size()));
    }
  }

public:
  Off_reader(std::istream& is, const std::string& name) : is_(is), name_(name) {}

  Solid read() {
    if (word("the word OFF") != "OFF") refuse("the word OFF is expected at the beginning of a mesh");
    const std::size_t vertices = count(word("the number of vertices")), faces = count(word("the number of faces"));
    skip_line();
    Solid solid;
    for (std::size_t i = 0; i < vertices; ++i) {
      solid.vertices.emplace_back();
      for (Exact& x : solid.vertices.back()) x = number(word("vertex " + std::to_string(i)));
    }
    if (!is_at_end_of_line()) refuse("there are more than three numbers for each vertex");
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> edges; // by their vertices, the smaller one first
    for (std::size_t f = 0; f < faces; ++f) {
      const std::string name = "face " + std::to_string(f);
      const std::size_t n = count(word(name));
      if (words_.size() - next_ < n)
        refuse(std::to_string(n) + " vertices are expected of " + name + ", and there are " +
               std::to_string(words_.size() - next_) + " in the line");
      Solid::Loop loop;
      for (std::size_t i = 0; i < n; ++i) {
        const std::string& vertex = word(name);
        loop.vertices.push_back(count(vertex));
        if (loop.vertices.back() >= vertices)
          refuse("vertex " + vertex + ": there are only " + std::to_string(vertices) + ", counted from 0");
        if (std::count(loop.vertices.begin(), loop.vertices.end(), loop.vertices.back()) > 1)
          refuse("vertex " + vertex + " comes twice");
      }
      skip_line();
      for (std::size_t i = 0; i < n; ++i) {
        const auto [low, high] = std::minmax(loop.vertices[i], loop.vertices[(i + 1) % n]);
        loop.edges.push_back(edges.emplace(std::pair(low, high), edges.size()).first->second);
      }
      solid.faces.push_back({{std::move(loop)}, ""});
    }
    return solid;
  }
};

Solid read_off(const std::string& file) {
  const std::string name = input_name(file);
  Input is(file);
  Solid solid = Off_reader(is, name).read();
  try {
    check_closed(solid);
    make_planar(solid, std::vector<std::optional<Solid_plane>>(solid.faces.size()), 0);
  } catch (const GC::Error&) {
    throw;
  } catch (const std::runtime_error& e) {
    throw std::runtime_error(name + ": " + e.what());
  }
  return solid;
}

Solid polyhedron_of(const Cad_solid& read) {
  Solid solid;
  for (const std::array<double, 3>& p : read.vertices) solid.vertices.push_back(exact_point(p));
  std::vector<std::optional<Solid_plane>> planes;
  for (const Cad_solid::Face& face : read.faces) {
    Solid::Face& result = solid.faces.emplace_back();
    for (const Cad_solid::Loop& loop : face.loops) result.loops.push_back({loop.vertices, loop.edges});
    result.name = face.name;
    planes.push_back(Solid_plane{exact_point(face.point), exact_point(face.normal)});
  }
  check_closed(solid);
  make_planar(solid, planes, read.tolerance);
  return solid;
}

} // namespace

bool is_solid_file(const std::string& file) { return cad_format(file) || extension(file) == ".off"; }

std::variant<Solid, Outlined_solid> read_solid(const std::string& file) {
  if (!cad_format(file)) return read_off(file);
  Cad_solid read = read_cad_solid(file);
  try {
    if (read.is_polyhedron()) return polyhedron_of(read);
    return Outlined_solid(std::move(read));
  } catch (const std::runtime_error& e) {
    throw std::runtime_error(file + ": " + e.what());
  }
}
