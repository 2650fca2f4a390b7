// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef CGAL_GEOMETRIC_CONTINUITY_IO_INTERNAL_TEMPORARY_FILE_H
#define CGAL_GEOMETRIC_CONTINUITY_IO_INTERNAL_TEMPORARY_FILE_H

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
} // namespace Geometric_continuity
} // namespace CGAL

#endif // CGAL_GEOMETRIC_CONTINUITY_IO_INTERNAL_TEMPORARY_FILE_H
