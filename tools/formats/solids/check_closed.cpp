// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "formats/solids/check_closed.h"

#include <algorithm>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

// A face that passes an edge, and the vertex where it begins to do so.
struct Edge_pass {
  std::size_t face, vertex;
};
typedef std::map<std::size_t, std::vector<Edge_pass>> Edge_passes; // by the numbers of edges

[[noreturn]] void refuse(const Solid& solid, std::size_t face, const std::string& reason) {
  throw std::runtime_error(face_name(solid, face) + ": " + reason);
}

void check_edge(const Solid& solid, std::size_t number, const std::vector<Edge_pass>& faces) {
  const std::string name = "edge " + std::to_string(number);
  if (faces.size() == 1)
    refuse(solid, faces[0].face, name + " has no other face: the shell is open, and a closed solid is needed");
  if (faces.size() > 2) refuse(solid, faces[0].face, name + " has " + std::to_string(faces.size()) + " faces, not two");
  if (faces[0].face == faces[1].face) refuse(solid, faces[0].face, name + " is in its boundary twice");
  if (faces[0].vertex == faces[1].vertex)
    refuse(solid, faces[0].face,
           "at " + name + " it and " + face_name(solid, faces[1].face) +
               " are oriented as if one of them were inside out");
}

void check_connected(const Solid& solid, const Edge_passes& passes) {
  std::vector<bool> found(solid.faces.size());
  std::vector<std::size_t> next{0};
  found[0] = true;
  while (!next.empty()) {
    const Solid::Face& face = solid.faces[next.back()];
    next.pop_back();
    for (const Solid::Loop& loop : face.loops)
      for (const std::size_t edge : loop.edges)
        for (const Edge_pass& pass : passes.at(edge))
          if (!found[pass.face]) {
            found[pass.face] = true;
            next.push_back(pass.face);
          }
  }
  const auto other = std::find(found.begin(), found.end(), false);
  if (other != found.end())
    refuse(solid, static_cast<std::size_t>(other - found.begin()),
           "no edges lead from it to face 0: one solid is expected in a file, without voids");
}

// Returns six times the volume: the sum of determinants over triangles, those of holes negative.
CGAL::Exact_rational volume(const Solid& solid) {
  CGAL::Exact_rational sum = 0;
  for (const Solid::Face& face : solid.faces)
    for (const Solid::Loop& loop : face.loops)
      for (std::size_t i = 1; i + 1 < loop.vertices.size(); ++i) {
        const Solid::Point &a = solid.vertices[loop.vertices[0]], &b = solid.vertices[loop.vertices[i]],
                           &c = solid.vertices[loop.vertices[i + 1]];
        sum += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
               a[2] * (b[0] * c[1] - b[1] * c[0]);
      }
  return sum;
}

} // namespace

std::string face_name(const Solid& solid, std::size_t face) {
  const std::string& name = solid.faces[face].name;
  return "face " + std::to_string(face) + (name.empty() ? "" : " (" + name + ")");
}

void check_closed(Solid& solid) {
  if (solid.faces.empty()) throw std::runtime_error("there is no face: a closed solid is expected");
  Edge_passes passes;
  for (std::size_t f = 0; f < solid.faces.size(); ++f) {
    const Solid::Face& face = solid.faces[f];
    if (face.loops.empty()) refuse(solid, f, "it has no edges");
    for (const Solid::Loop& loop : face.loops) {
      if (loop.vertices.size() < 3) refuse(solid, f, "it has less than three edges");
      for (std::size_t i = 0; i < loop.edges.size(); ++i) passes[loop.edges[i]].push_back({f, loop.vertices[i]});
    }
  }
  for (const auto& [edge, faces] : passes) check_edge(solid, edge, faces);
  check_connected(solid, passes);
  const CGAL::Exact_rational six_volumes = volume(solid);
  if (six_volumes == 0) throw std::runtime_error("its volume is 0");
  if (six_volumes > 0) return;
  for (Solid::Face& face : solid.faces)
    for (Solid::Loop& loop : face.loops) {
      std::reverse(loop.vertices.begin(), loop.vertices.end());
      std::reverse(loop.edges.begin(), loop.edges.end()); // edge i leads to vertex i
      std::rotate(loop.edges.begin(), loop.edges.begin() + 1, loop.edges.end());
    }
}
