// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FILES_TEMPORARY_FILE_H
#define GEOMETRIC_CONTINUITY_TOOLS_FILES_TEMPORARY_FILE_H

#include <CGAL/Geometric_continuity/Error.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <memory>
#include <mutex>
#include <random>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace CGAL {
namespace Geometric_continuity {

[[noreturn]] inline void refuse_to_write(const std::string& path, int system_error) {
  throw Error(Error_code::cannot_write_file,
              path + ": " + (system_error == 0 ? "write error" : std::generic_category().message(system_error)));
}

// The names of the temporary files that exist, for the handler of a signal. It may interrupt
// anything, and therefore finds nothing but pointers. A file for which there is no place left is
// not removed by a handler.
inline std::atomic<const char*> unfinished_files[16];
static_assert(std::atomic<const char*>::is_always_lock_free);

// An empty file with a new name in a folder. It is removed unless it gets the name for which it is
// meant.
class Temporary_file {
  std::unique_ptr<char[]> path_; // empty when the file has got its name
  std::atomic<const char*>* entry_ = nullptr;
  int descriptor_ = -1;

  // The name is entered before the file exists, so that a signal cannot come in between.
  void enter() {
    for (std::atomic<const char*>& entry : unfinished_files) {
      const char* free = nullptr;
      if (!entry.compare_exchange_strong(free, path_.get())) continue;
      entry_ = &entry;
      return;
    }
  }

  // Forgets the name, after which no handler removes the file.
  void forget() {
    // a handler that runs in another thread may still read the name that it has taken: it is kept
    // to the end
    if (entry_ != nullptr && entry_->exchange(nullptr) == nullptr) keep(std::move(path_));
    path_.reset();
    entry_ = nullptr;
  }

  static void keep(std::unique_ptr<char[]> name) {
    static std::mutex mutex;
    // for good
    static std::vector<std::unique_ptr<char[]>>& names = *new std::vector<std::unique_ptr<char[]>>;
    const std::lock_guard<std::mutex> lock(mutex);
    names.push_back(std::move(name));
  }

public:
  // `target` stands for it in messages.
  Temporary_file(const std::string& folder, mode_t mode, const std::string& target) {
    std::random_device random;
    for (int attempts_left = 100; descriptor_ < 0; --attempts_left) {
      const std::string number = std::to_string(random()) + std::to_string(random()),
                        path = folder + "/.geometric_continuity_" + number + ".tmp";
      path_ = std::make_unique<char[]>(path.size() + 1); // ends with 0
      std::copy(path.begin(), path.end(), path_.get());
      enter();
      descriptor_ = ::open(path_.get(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
      if (descriptor_ >= 0) break;
      const int error = errno;
      forget();
      if (error != EEXIST || attempts_left == 0) refuse_to_write(target, error);
    }
  }
  Temporary_file(const Temporary_file&) = delete;
  Temporary_file& operator=(const Temporary_file&) = delete;
  ~Temporary_file() {
    if (descriptor_ >= 0) ::close(descriptor_);
    if (path_) ::unlink(path_.get());
    forget();
  }

  int descriptor() const { return descriptor_; }
  const char* path() const { return path_.get(); }

  // Gives the file its name. Everything is stored before, so that not even a power failure leaves
  // half a file.
  void rename(const std::string& path, const std::string& target) {
    if (::fsync(descriptor_) != 0 && errno != EINVAL) refuse_to_write(target, errno);
    if (::close(std::exchange(descriptor_, -1)) != 0) refuse_to_write(target, errno);
    if (::rename(path_.get(), path.c_str()) != 0) refuse_to_write(target, errno);
    forget();
  }
};

} // namespace Geometric_continuity
} // namespace CGAL

#endif // GEOMETRIC_CONTINUITY_TOOLS_FILES_TEMPORARY_FILE_H
