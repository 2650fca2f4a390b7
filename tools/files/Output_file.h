// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FILES_OUTPUT_FILE_H
#define GEOMETRIC_CONTINUITY_TOOLS_FILES_OUTPUT_FILE_H

#include "files/Temporary_file.h"

#include <cerrno>
#include <charconv>
#include <filesystem>
#include <optional>
#include <string>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace CGAL {
namespace Geometric_continuity {

// A file that is to be written. A regular file, or one that does not exist, gets its content at the
// end, by the renaming of a temporary file in its folder; a device, a pipe or a socket is written
// directly.
class Output_file {
  const std::string name_; // as it was given, for messages
  std::string target_;     // behind all links
  std::optional<struct stat> old_;
  int direct_ = -1; // the descriptor of a file that is not replaced
  std::optional<Temporary_file> temporary_;

  std::string folder() const {
    const std::string parent = std::filesystem::path(target_).parent_path().string();
    return parent.empty() ? "." : parent;
  }

  // The descriptor that the name stands for: /dev/stdout, /dev/stderr, /dev/fd/N. It is duplicated,
  // because opening such a name begins a regular file anew, and fails for a socket.
  std::optional<int> named_descriptor() const {
    if (name_ == "/dev/stdout") return STDOUT_FILENO;
    if (name_ == "/dev/stderr") return STDERR_FILENO;
    for (const std::string prefix : {"/dev/fd/", "/proc/self/fd/"}) {
      if (name_.compare(0, prefix.size(), prefix) != 0) continue;
      int descriptor = -1;
      const char* const end = name_.data() + name_.size();
      if (std::from_chars(name_.data() + prefix.size(), end, descriptor).ptr == end) return descriptor;
    }
    return std::nullopt;
  }

  // The last link of a chain may lead to a file that does not exist yet.
  void follow_links() {
    std::error_code error;
    std::filesystem::path path = name_;
    while (std::filesystem::is_symlink(std::filesystem::symlink_status(path, error))) {
      // an absolute path replaces the other one
      path = path.parent_path() / std::filesystem::read_symlink(path, error);
      if (error) refuse_to_write(name_, error.value());
    }
    target_ = path.string();
  }

  void open_directly(int descriptor) {
    if (descriptor < 0) refuse_to_write(name_, errno);
    direct_ = descriptor;
  }

  // Owner, group and mode of the file that is replaced, as far as the system allows. Another group
  // gets no right that not everybody has.
  void keep_attributes() {
    const int descriptor = temporary_->descriptor();
    mode_t mode = old_->st_mode & (S_ISVTX | S_IRWXU | S_IRWXG | S_IRWXO);
    struct stat now;
    if (::fstat(descriptor, &now) != 0) refuse_to_write(name_, errno);
    if (now.st_gid != old_->st_gid && ::fchown(descriptor, static_cast<uid_t>(-1), old_->st_gid) != 0)
      mode &= ~static_cast<mode_t>(S_IRWXG) | ((mode & S_IRWXO) << 3);
    if (::fchmod(descriptor, mode) != 0) refuse_to_write(name_, errno);
    // last, because the old owner may not change it any more
    if (now.st_uid != old_->st_uid && ::fchown(descriptor, old_->st_uid, static_cast<gid_t>(-1)) != 0) return;
  }

  // Stores the new entry of the folder, where that is possible.
  void store_folder() {
    const int descriptor = ::open(folder().c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0) return; // a folder that may be written but not read
    const int error = ::fsync(descriptor) == 0 ? 0 : errno;
    ::close(descriptor);
    if (error != 0 && error != EINVAL) refuse_to_write(name_, error);
  }

public:
  // Refuses what cannot be written; nothing is created yet.
  explicit Output_file(std::string name) : name_(std::move(name)) {
    if (const std::optional<int> descriptor = named_descriptor()) {
      open_directly(::fcntl(*descriptor, F_DUPFD_CLOEXEC, 3));
      return;
    }
    struct stat status;
    if (::stat(name_.c_str(), &status) != 0) {
      if (errno != ENOENT || name_.empty()) refuse_to_write(name_, errno);
    } else {
      if (S_ISDIR(status.st_mode)) refuse_to_write(name_, EISDIR);
      open_directly(::open(name_.c_str(), O_WRONLY | O_CLOEXEC | O_NOCTTY));
      if (!S_ISREG(status.st_mode)) return;
      ::close(std::exchange(direct_, -1)); // a file that may be written is replaced
      old_ = status;
    }
    follow_links();
    if (::faccessat(AT_FDCWD, (folder() + "/.").c_str(), W_OK | X_OK, AT_EACCESS) != 0) refuse_to_write(name_, errno);
  }
  Output_file(const Output_file&) = delete;
  Output_file& operator=(const Output_file&) = delete;
  ~Output_file() {
    if (direct_ >= 0) ::close(direct_);
  }

  // Returns the descriptor for the new content, which until the end is for its owner only when an
  // old file is replaced.
  int open() {
    if (direct_ >= 0) return direct_;
    if (!temporary_) temporary_.emplace(folder(), old_ ? 0600 : 0666, name_);
    return temporary_->descriptor();
  }

  // Makes the new content that of the file.
  void finish() {
    if (direct_ >= 0) {
      if (::close(std::exchange(direct_, -1)) != 0) refuse_to_write(name_, errno);
      return;
    }
    open(); // when nothing was written
    if (old_) keep_attributes();
    temporary_->rename(target_, name_);
    store_folder();
  }
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // GEOMETRIC_CONTINUITY_TOOLS_FILES_OUTPUT_FILE_H
