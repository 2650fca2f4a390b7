// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FILES_UNPACKED_BYTES_H
#define GEOMETRIC_CONTINUITY_TOOLS_FILES_UNPACKED_BYTES_H

#include "files/max_unpacked.h"

#include <CGAL/Geometric_continuity/Error.h>

#include <cstddef>
#include <istream>
#include <new>
#include <string>
#include <utility>
#include <vector>

#include <zlib.h>

namespace GC = CGAL::Geometric_continuity;

// The bytes of a stream, unpacked while they are read when they are packed by gzip. The first byte,
// which begins no text, shows this.
class Unpacked_bytes {
  static constexpr int first_byte = 0x1F; // of what gzip has packed

  std::istream& stream_;
  const std::string name_;
  const bool packed_;
  std::vector<char> block_; // of packed bytes
  z_stream inflater_{};
  std::size_t unpacked_ = 0;
  bool between_members_ = false; // of which a packed file has one or more

  [[noreturn]] void refuse(GC::Error_code code, const std::string& reason) const {
    throw GC::Error(code, name_ + ": " + reason);
  }

  // Reads packed bytes and returns whether there are any left.
  bool refill() {
    stream_.read(block_.data(), static_cast<std::streamsize>(block_.size()));
    inflater_.next_in = reinterpret_cast<Bytef*>(block_.data());
    inflater_.avail_in = static_cast<uInt>(stream_.gcount());
    return inflater_.avail_in != 0;
  }

  std::size_t unpack(char* to, std::size_t size) {
    inflater_.next_out = reinterpret_cast<Bytef*>(to);
    inflater_.avail_out = static_cast<uInt>(size);
    while (inflater_.avail_out != 0) {
      if (inflater_.avail_in == 0 && !refill()) {
        if (between_members_) break;
        refuse(GC::Error_code::malformed_input, "packed by gzip, and the end is missing");
      }
      if (std::exchange(between_members_, false)) inflateReset(&inflater_);
      const int status = inflate(&inflater_, Z_NO_FLUSH);
      if (status == Z_MEM_ERROR) throw std::bad_alloc();
      if (status != Z_OK && status != Z_STREAM_END)
        refuse(GC::Error_code::malformed_input, std::string("packed by gzip, but damaged: ") +
                                                    (inflater_.msg == nullptr ? "no valid block" : inflater_.msg));
      between_members_ = status == Z_STREAM_END;
    }
    const std::size_t n = size - inflater_.avail_out;
    unpacked_ += n;
    if (max_unpacked < unpacked_)
      refuse(GC::Error_code::work_limit, "more than " + std::to_string(max_unpacked >> 20) + " MiB when unpacked");
    return n;
  }

public:
  // The name is used in messages.
  Unpacked_bytes(std::istream& stream, std::string name)
      : stream_(stream), name_(std::move(name)), packed_(stream.peek() == first_byte) {
    if (!packed_) return;
    block_.resize(std::size_t(1) << 16);
    constexpr int gzip_only = 16;
    if (inflateInit2(&inflater_, MAX_WBITS + gzip_only) != Z_OK) throw std::bad_alloc();
  }
  Unpacked_bytes(const Unpacked_bytes&) = delete;
  Unpacked_bytes& operator=(const Unpacked_bytes&) = delete;
  ~Unpacked_bytes() {
    if (packed_) inflateEnd(&inflater_);
  }

  // Reads as many bytes as this, fewer only at the end, and returns how many. Throws GC::Error with
  // the name: `malformed_input` for packed bytes that are damaged or cut off, `work_limit` for too
  // many unpacked ones.
  std::size_t read(char* to, std::size_t size) {
    if (packed_) return unpack(to, size);
    stream_.read(to, static_cast<std::streamsize>(size));
    return static_cast<std::size_t>(stream_.gcount());
  }

  // Returns whether a text that begins like this may be packed.
  static bool may_begin(char c) { return c == first_byte; }
};

#endif // GEOMETRIC_CONTINUITY_TOOLS_FILES_UNPACKED_BYTES_H
