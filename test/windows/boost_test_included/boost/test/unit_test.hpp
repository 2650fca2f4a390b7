// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Found before the header of Boost.Test: its library as headers, because there is none for Windows.

#ifndef BOOST_TEST_INCLUDED
#undef BOOST_TEST_DYN_LINK
#include <boost/test/included/unit_test.hpp>
#else
#include_next <boost/test/unit_test.hpp>
#endif
