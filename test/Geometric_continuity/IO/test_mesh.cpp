// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "support/test.h"

#include <CGAL/Geometric_continuity/IO/mesh.h>

BOOST_AUTO_TEST_SUITE(mesh)

typedef GC::Traits_3<CGAL::Simple_cartesian<double>> Traits;
typedef GC::Tessellation<Traits> Tessellation;

const GC::Mesh_format formats[] = {GC::Mesh_format::off, GC::Mesh_format::obj, GC::Mesh_format::ply,
                                   GC::Mesh_format::stl};

Tessellation triangle() {
  Tessellation t;
  t.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0.1}};
  t.triangles = {{0, 1, 2}};
  return t;
}

// In no format anything is written, but this error is thrown.
template <class Traits> void check_refused(const GC::Tessellation<Traits>& t, GC::Error_code code) {
  for (const GC::Mesh_format format : formats) {
    std::ostringstream os;
    BOOST_CHECK_EXCEPTION(GC::write_mesh(os, t, format), GC::Error, [&](const auto& e) { return e.code() == code; });
    BOOST_CHECK_EQUAL(os.str(), "");
  }
}

BOOST_AUTO_TEST_CASE(triangles_without_points_are_refused) {
  Tessellation t = triangle();
  t.triangles.push_back({1, 2, 3});
  check_refused(t, GC::Error_code::wrong_number_of_points);
  t.points.clear();
  check_refused(t, GC::Error_code::wrong_number_of_points);
}

BOOST_AUTO_TEST_CASE(numbers_that_are_not_finite_are_refused) {
  for (const double bad : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    Tessellation t = triangle();
    t.points[2] = {0, 1, bad};
    check_refused(t, GC::Error_code::not_finite);
  }
}

BOOST_AUTO_TEST_CASE(points_of_the_plane_are_refused) {
  GC::Tessellation<GC::Traits_2<CGAL::Simple_cartesian<double>>> t;
  t.points = {{0, 0}, {1, 0}, {0, 1}};
  t.triangles = {{0, 1, 2}};
  check_refused(t, GC::Error_code::dimension_mismatch);
}

BOOST_AUTO_TEST_CASE(formats_by_names) {
  BOOST_CHECK(GC::mesh_format("a.off") == GC::Mesh_format::off && GC::mesh_format("b/c.OBJ") == GC::Mesh_format::obj);
  BOOST_CHECK(GC::mesh_format("a.b.Ply") == GC::Mesh_format::ply && GC::mesh_format(".stl") == GC::Mesh_format::stl);
  for (const char* path : {"", "obj", "a.obj/b", "a.obj.gz", "teapot.", "a.vtk"})
    CHECK_ERROR(GC::mesh_format(path), cannot_write_file);
}

BOOST_AUTO_TEST_SUITE_END()
