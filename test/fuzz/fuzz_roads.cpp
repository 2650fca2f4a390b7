// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Road networks: the reader of the program, and all that is decided about what it reads.

#include "fuzz_target.h"

#include "formats/opendrive/read_opendrive.h"

#include <CGAL/Geometric_continuity/numbers/Work_limit.h>

namespace {

struct Checking_visitor {
  void operator()(const GC::Road_remark& x) const {
    require(!x.what.empty() && !x.reason.empty(), "a remark has a reason");
  }
  void operator()(const GC::Road_plan_join& x) const {
    require(x.join.gap.lower >= 0 && x.join.gap.lower <= x.join.gap.upper, "a gap is enclosed");
    require(x.join.kink.lower >= 0 && x.join.kink.lower <= x.join.kink.upper, "a kink is enclosed");
    require(!x.join.same_heading || x.join.g1 == GC::Verdict::proved, "equal headings are within each tolerance");
  }
  void operator()(const GC::Road_section_join& x) const {
    require(!x.equal || x.within, "equal borders are within each tolerance");
  }
  void operator()(const GC::Road_border_join& x) const {
    require(x.join.gap.lower >= 0 && x.join.kink.lower <= x.join.kink.upper, "a border is enclosed");
  }
  template <class Other> void operator()(const Other&) const {}
};

} // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::istringstream stream{std::string(fuzz_text(data, size))};
  accepts([&] {
    const GC::Work_scope each(GC::Work_limit(10000000));
    const Opendrive_file file = read_opendrive(stream, "fuzz.xodr");
    GC::road_joins(file.network, {}, Checking_visitor(), true);
  });
  return 0;
}
