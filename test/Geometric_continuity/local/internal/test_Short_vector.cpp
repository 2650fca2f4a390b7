// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include <CGAL/Geometric_continuity/local/internal/Short_vector.h>

#include "support/test.h"

// The test does the same to a std::vector, on both sides of the number of elements that need no
// memory.
BOOST_AUTO_TEST_CASE(like_a_vector) {
  typedef GC::internal::Short_vector<double, 4> Vector;
  for (std::size_t first = 0; first <= 9; ++first)
    for (std::size_t last = first; last <= 9; ++last) {
      Vector x(first, 7);
      std::vector<double> y(first, 7);
      for (std::size_t i = 0; i < first; ++i) x[i] = y[i] = static_cast<double>(i);
      x.resize(last);
      y.resize(last);
      Vector copy = x, assigned(9 - last, 1);
      assigned = x;
      copy.resize(last + 1);
      y.push_back(0);
      BOOST_CHECK_EQUAL_COLLECTIONS(copy.begin(), copy.end(), y.begin(), y.end());
      y.pop_back();
      copy = x;
      if (last > 0) x[last - 1] = -1; // of the copies none knows
      for (const Vector* v : {&copy, &assigned})
        BOOST_CHECK_EQUAL_COLLECTIONS(v->begin(), v->end(), y.begin(), y.end());
      BOOST_CHECK_EQUAL(x.size(), last);
      assigned = Vector(2, 3);
      BOOST_CHECK_EQUAL(assigned.size(), 2);
      BOOST_CHECK(assigned[0] == 3 && assigned[1] == 3);
    }
}

BOOST_AUTO_TEST_CASE(elements_with_memory) {
  BOOST_CHECK((std::is_same_v<GC::internal::Short_vector<std::string, 4>, std::vector<std::string>>));
}
