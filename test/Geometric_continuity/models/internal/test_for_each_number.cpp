// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Work on several cores.

#include "support/test.h"

#include <CGAL/Geometric_continuity/models/model_continuity.h>
#include <atomic>
#include <chrono>
#include <thread>

BOOST_AUTO_TEST_SUITE(for_each_number)

// Where two cores meet errors it is the one of the least number that leaves, also if the other one
// comes later.
BOOST_AUTO_TEST_CASE(the_first_of_two_errors) {
  std::atomic<bool> last_has_begun(false), first_is_thrown(false);
  const auto wait_for = [](const std::atomic<bool>& flag) { // not for ever: there may be one core
    for (int i = 0; i < 1000 && !flag; ++i) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  };
  const auto work = [&](std::size_t i) {
    if (i == 0) {
      wait_for(last_has_begun);
      first_is_thrown = true;
      throw GC::Error(GC::Error_code::work_limit, "the first");
    }
    if (i == 31) {
      last_has_begun = true;
      wait_for(first_is_thrown);
      std::this_thread::sleep_for(std::chrono::milliseconds(100));
      throw GC::Error(GC::Error_code::work_limit, "the last");
    }
  };
  BOOST_CHECK_EQUAL(error_of([&] { GC::internal::for_each_number<CGAL::Parallel_if_available_tag>(32, work); }),
                    "work_limit: the first");
}

BOOST_AUTO_TEST_SUITE_END()
