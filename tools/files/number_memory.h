// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FILES_NUMBER_MEMORY_H
#define GEOMETRIC_CONTINUITY_TOOLS_FILES_NUMBER_MEMORY_H

#include <gmp.h>

#include <cstddef>
#include <cstdlib>
#include <new>
#include <utility>

// Memory for the numbers of GMP. Most have one or two words, and come and go: blocks of these sizes
// that are given back are kept, a few of them, and used again, on the threads that ask for it,
// which never end before the program. All memory is that of malloc().
class Number_memory {
  static constexpr std::size_t word = sizeof(mp_limb_t), most_words = 2, most_blocks = std::size_t(1) << 13;

  struct Block {
    Block* next;
  };
  struct Spare_blocks {
    Block* first = nullptr;
    std::size_t room = 0; // for so many more of them
  };
  static Spare_blocks& spare(std::size_t words) {
    static thread_local Spare_blocks blocks[most_words];
    return blocks[words - 1];
  }
  static bool is_short(std::size_t size) { return size == word || size == most_words * word; }

public:
  // Keeps blocks on this thread from now on.
  static void keep_on_this_thread() {
    for (std::size_t words = 1; words <= most_words; ++words) spare(words).room = most_blocks;
  }

  // These return a null pointer when there is no memory.
  static void* take(std::size_t size) {
    if (!is_short(size)) return std::malloc(size);
    Spare_blocks& blocks = spare(size / word);
    if (blocks.first == nullptr) return std::malloc(size);
    ++blocks.room;
    return std::exchange(blocks.first, blocks.first->next);
  }
  static void* resize(void* memory, std::size_t size) { return std::realloc(memory, size); }

  static void give_back(void* memory, std::size_t size) {
    if (!is_short(size)) return std::free(memory);
    Spare_blocks& blocks = spare(size / word);
    if (blocks.room == 0) return std::free(memory);
    --blocks.room;
    blocks.first = ::new (memory) Block{blocks.first};
  }
};

#endif // GEOMETRIC_CONTINUITY_TOOLS_FILES_NUMBER_MEMORY_H
