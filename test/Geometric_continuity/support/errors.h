// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include <CGAL/Geometric_continuity/Error.h>

#include <boost/test/unit_test.hpp>

#include <string>

// Checks that a typed error is thrown.

#define CHECK_ERROR(expression, expected)                                                                              \
  BOOST_CHECK_EXCEPTION((void)(expression), CGAL::Geometric_continuity::Error,                                         \
                        [](const CGAL::Geometric_continuity::Error& e) {                                               \
                          return e.code() == CGAL::Geometric_continuity::Error_code::expected;                         \
                        })

// The text of the error that f() throws.
template <class F> std::string error_of(F f) {
  try {
    f();
  } catch (const CGAL::Geometric_continuity::Error& error) {
    return error.what();
  }
  return "no error";
}
