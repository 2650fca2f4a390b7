// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#define BOOST_TEST_MODULE number_memory
#include "support/test.h"

#include "files/number_memory.h"

#include <cstring>
#include <thread>

namespace {

struct Piece {
  unsigned char* memory;
  std::size_t size;
  unsigned char mark;

  bool is_intact() const {
    return std::all_of(memory, memory + size, [this](unsigned char c) { return c == mark; });
  }
};

// Returns whether pieces of memory that are taken, resized and given back in any order never
// overlap, and keep what is in them.
bool all_intact(unsigned seed) {
  std::mt19937 random(seed);
  const std::size_t sizes[] = {8, 8, 8, 16, 16, 24, 40, 4096, 1, 7, 9};
  const auto any_size = [&] { return sizes[random() % std::size(sizes)]; };
  std::vector<Piece> pieces;
  bool intact = true;
  for (int i = 0; i < 200000; ++i) {
    const std::size_t k = pieces.empty() ? 0 : random() % pieces.size();
    const bool grows = i / 20000 % 2 == 0; // to more blocks than are kept, and back
    const unsigned what = random() % 8;
    if (pieces.empty() || what < (grows ? 5u : 2u)) {
      const std::size_t size = any_size();
      pieces.push_back(
          {static_cast<unsigned char*>(Number_memory::take(size)), size, static_cast<unsigned char>(random())});
    } else if (what == 7) {
      const std::size_t size = any_size();
      Piece& p = pieces[k];
      intact = intact && p.is_intact();
      p.memory = static_cast<unsigned char*>(Number_memory::resize(p.memory, size));
      p.size = (std::min)(p.size, size);
      intact = intact && p.is_intact();
      p.size = size;
      std::memset(p.memory, p.mark, p.size);
      continue;
    } else {
      intact = intact && pieces[k].is_intact();
      Number_memory::give_back(pieces[k].memory, pieces[k].size);
      pieces[k] = pieces.back();
      pieces.pop_back();
      continue;
    }
    std::memset(pieces.back().memory, pieces.back().mark, pieces.back().size);
  }
  for (const Piece& p : pieces) {
    intact = intact && p.is_intact();
    Number_memory::give_back(p.memory, p.size);
  }
  return intact;
}

} // namespace

BOOST_AUTO_TEST_CASE(pieces_keep_what_is_in_them) {
  const unsigned seed = 20261125;
  BOOST_TEST_MESSAGE("seed " << seed);
  Number_memory::keep_on_this_thread();
  BOOST_CHECK(all_intact(seed));
  bool intact = false; // on a thread that keeps none
  std::thread([&] { intact = all_intact(seed + 1); }).join();
  BOOST_CHECK(intact);
}

// A block that was given back is the next one of its size, also when another thread took it.
BOOST_AUTO_TEST_CASE(memory_is_used_again) {
  Number_memory::keep_on_this_thread();
  for (const std::size_t size : {sizeof(mp_limb_t), 2 * sizeof(mp_limb_t)}) {
    void* block = nullptr;
    std::thread([&] { block = Number_memory::take(size); }).join();
    Number_memory::give_back(block, size);
    BOOST_CHECK_EQUAL(Number_memory::take(size), block);
    std::thread([&] { Number_memory::give_back(block, size); }).join();
  }
}
