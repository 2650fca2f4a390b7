// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FILES_ATOMIC_FILE_H
#define GEOMETRIC_CONTINUITY_TOOLS_FILES_ATOMIC_FILE_H

#include "files/Descriptor_buffer.h"
#include "files/Output_file.h"
#include "files/Temporary_file.h"

#include <atomic>
#include <ios>
#include <ostream>
#include <string>

#include <unistd.h>

/// Writes files as a whole or not at all, on systems of the POSIX family.

namespace CGAL {
namespace Geometric_continuity {

/// Writes a file as a whole or not at all: what `writer(os)` writes goes to a temporary file in the
/// same folder, which replaces `path` when everything has been written and stored. An older file
/// `path` stays as it is until then; when something fails it is kept, and the temporary file is
/// removed. The temporary file is created when there is something to write.
///
/// Links are followed, also one that leads to a file which does not exist yet. A file that is
/// replaced keeps its mode (without the bits that set a user or a group), its group and its owner,
/// as far as the system allows, and until then nobody else can read the new content. Other names of
/// the same file (hard links) keep the old content. A device, a pipe, or any other file that is not
/// regular is written directly, and so is a descriptor by the name `/dev/stdout`, `/dev/stderr` or
/// `/dev/fd/N`.
///
/// \tparam Writer a function object callable with a `std::ostream&`. Its own exceptions are passed
///   on.
/// \throws Error `cannot_write_file`, with the path and the reason of the system, when the file
///   cannot be created, written or replaced; a folder, and a path in a folder that cannot be
///   written, are refused before `writer` is called
template <class Writer> void write_file_atomically(const std::string& path, Writer writer) {
  Output_file file(path);
  Descriptor_buffer buffer([&file] { return file.open(); });
  std::ostream os(&buffer);
  try {
    os.exceptions(std::ios::badbit | std::ios::failbit);
    writer(os);
    os.flush();
  } catch (const std::ios::failure&) {
    if (os) throw; // of another stream
    refuse_to_write(path, buffer.error());
  }
  if (!os) refuse_to_write(path, buffer.error()); // an exception that the writer kept to itself
  file.finish();
}

/// Removes the temporary files of all calls of `write_file_atomically()` that are under way (of 16
/// at most), so that these fail. It may be called by the handler of a signal that ends the program,
/// at any time.
inline void remove_unfinished_files() {
  for (std::atomic<const char*>& entry : unfinished_files)
    if (const char* const path = entry.exchange(nullptr)) ::unlink(path);
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // GEOMETRIC_CONTINUITY_TOOLS_FILES_ATOMIC_FILE_H
