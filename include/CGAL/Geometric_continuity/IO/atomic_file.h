// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_IO_ATOMIC_FILE_H
#define CGAL_GEOMETRIC_CONTINUITY_IO_ATOMIC_FILE_H

#include <CGAL/Geometric_continuity/Error.h>

#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <ios>
#include <random>
#include <string>
#include <system_error>

namespace CGAL {
namespace Geometric_continuity {
namespace internal {

[[noreturn]] inline void refuse_to_write(const std::filesystem::path& path, const std::string& reason) {
  throw Error(Error_code::cannot_write_file, path.string() + ": " + reason);
}

[[noreturn]] inline void refuse_to_write(const std::filesystem::path& path, int system_error) {
  refuse_to_write(path, system_error == 0 ? "write error" : std::generic_category().message(system_error));
}

// An empty file with a new name in the folder of `target`. It is removed unless it has replaced `target`.
class Temporary_file {
  std::filesystem::path target_, path_;

public:
  explicit Temporary_file(const std::filesystem::path& target) : target_(target) {
    std::random_device random;
    for (int attempts_left = 100; path_.empty(); --attempts_left) {
      const std::string name = ".geometric_continuity_" + std::to_string(random()) + ".tmp";
      const std::filesystem::path path = target_.parent_path() / name;
      if (std::FILE* file = std::fopen(path.string().c_str(), "wx")) { // x: fails when the file exists
        std::fclose(file);
        path_ = path;
      } else if (errno != EEXIST || attempts_left == 0)
        refuse_to_write(target_, errno);
    }
  }
  Temporary_file(const Temporary_file&) = delete;
  Temporary_file& operator=(const Temporary_file&) = delete;
  ~Temporary_file() {
    std::error_code ignored;
    if (!path_.empty()) std::filesystem::remove(path_, ignored);
  }

  const std::filesystem::path& path() const { return path_; }

  void replace_target() {
    std::error_code error;
    if (std::filesystem::exists(target_, error))
      std::filesystem::permissions(path_, std::filesystem::status(target_, error).permissions(), error);
    if (!error) std::filesystem::rename(path_, target_, error);
    if (error) refuse_to_write(target_, error.message());
    path_.clear();
  }
};

// The file that is to be written: links are followed, and what could not be written directly is refused.
inline std::filesystem::path writable_target(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::exists(path, error)) return path;
  if (!std::filesystem::is_regular_file(path, error)) refuse_to_write(path, "not a regular file");
  errno = 0;
  if (!std::ofstream(path, std::ios::app)) refuse_to_write(path, errno);
  const std::filesystem::path target = std::filesystem::canonical(path, error);
  if (error) refuse_to_write(path, error.message());
  return target;
}

} // namespace internal

/// \ingroup PkgGeometricContinuityIO
/// Writes a file as a whole or not at all: `writer(os)` writes to a new file in the same folder, which replaces `path`
/// when everything has been written. Until then, and for ever when something fails, an older file `path` stays as it
/// is, and the new file is removed. Links are followed, and the permissions of an older file are kept.
///
/// \tparam Writer a function object callable with a `std::ostream&`. Its own exceptions are passed on.
/// \throws Error `cannot_write_file`, with the path and the reason of the system, when the file cannot be created,
///         written or replaced, or when `path` is something else than a regular file
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
