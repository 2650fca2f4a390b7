// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_IO_ATOMIC_FILE_H
#define CGAL_GEOMETRIC_CONTINUITY_IO_ATOMIC_FILE_H

#include <CGAL/Geometric_continuity/IO/internal/Temporary_file.h>

#include <cerrno>
#include <fstream>
#include <ios>
#include <ostream>
#include <string>

namespace CGAL {
namespace Geometric_continuity {

/// \ingroup PkgGeometricContinuityIO
/// Writes a file as a whole or not at all: `writer(os)` writes to a new file in the same folder, which replaces `path`
/// when everything has been written. An older file `path` stays as it is until then; when something fails it is kept,
/// and the new file is removed. Links are followed, and the permissions of an older file are kept.
///
/// \tparam Writer a function object callable with a `std::ostream&`. Its own exceptions are passed on.
/// \throws Error `cannot_write_file`, with the path and the reason of the system, when the file cannot be created,
///   written or replaced, or when `path` is something else than a regular file
template <class Writer> void write_file_atomically(const std::string& path, Writer writer) {
  internal::Temporary_file file(internal::writable_target(path));
  errno = 0;
  std::ofstream os(file.path());
  try {
    os.exceptions(std::ios::badbit | std::ios::failbit); // so that errno is read before anything else can change it
    writer(static_cast<std::ostream&>(os));
    os.close();
  } catch (const std::ios::failure&) {
    if (os) throw; // of another stream
    internal::refuse_to_write(path, errno);
  }
  if (!os) internal::refuse_to_write(path, errno); // an exception that the writer kept to itself
  file.replace_target();
}

} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_IO_ATOMIC_FILE_H
