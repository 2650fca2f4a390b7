// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#define BOOST_TEST_MODULE atomic_file
#include "support/test.h"

#include "files/atomic_file.h"

#include <csignal>
#include <filesystem>
#include <fstream>
#include <ios>
#include <sys/resource.h>
#include <sys/stat.h>
#include <system_error>
#include <unistd.h>

namespace fs = std::filesystem;

namespace {

// A folder that is removed with all its files.
class Folder {
  fs::path path_;

public:
  Folder() {
    std::random_device random;
    path_ = fs::temp_directory_path() / ("test_io_" + std::to_string(random()) + std::to_string(random()));
    fs::create_directory(path_);
  }
  ~Folder() { fs::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  std::string operator/(const std::string& name) const { return (path_ / name).string(); }
  std::ptrdiff_t number_of_files() const {
    return std::distance(fs::directory_iterator(path_), fs::directory_iterator());
  }
};

std::string content(const std::string& path) {
  std::ifstream is(path);
  return std::string(std::istreambuf_iterator<char>(is), std::istreambuf_iterator<char>());
}

void set_content(const std::string& path, const std::string& text) { std::ofstream(path) << text; }

std::string reason(std::errc code) { return std::make_error_code(code).message(); }

struct stat stat_of(const std::string& path) {
  struct stat result;
  BOOST_REQUIRE_EQUAL(stat(path.c_str(), &result), 0);
  return result;
}

void write(const std::string& path, const std::string& text) {
  GC::write_file_atomically(path, [&](std::ostream& os) { os << text; });
}

} // namespace

BOOST_AUTO_TEST_CASE(files_are_written) {
  const Folder folder;
  const std::string path = folder / "curve.g2";
  write(path, "text");
  BOOST_CHECK_EQUAL(content(path), "text");
  write(path, "");
  BOOST_CHECK_EQUAL(content(path), "");
  BOOST_CHECK_EQUAL(folder.number_of_files(), 1);
  // a file without a folder in its name
  const std::string name = "test_io_" + std::to_string(std::random_device()()) + ".g2";
  write(name, "here");
  BOOST_CHECK_EQUAL(content(name), "here");
  BOOST_CHECK(fs::remove(name));
}

BOOST_AUTO_TEST_CASE(older_files_are_replaced) {
  const Folder folder;
  const std::string path = folder / "old.g2", link = folder / "link.g2";
  set_content(path, "a longer old text");
  fs::permissions(path, fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink("old.g2", link);
  GC::write_file_atomically(link, [&](std::ostream& os) {
    os << "new" << std::flush;
    BOOST_CHECK_EQUAL(content(path), "a longer old text");
  });
  BOOST_CHECK_EQUAL(content(path), "new");
  BOOST_CHECK(fs::is_symlink(link));
  BOOST_CHECK(fs::status(path).permissions() == (fs::perms::owner_read | fs::perms::owner_write));
  BOOST_CHECK_EQUAL(folder.number_of_files(), 2);
}

BOOST_AUTO_TEST_CASE(older_files_are_kept_when_the_writer_throws) {
  const Folder folder;
  const std::string path = folder / "old.g2";
  set_content(path, "old");
  const auto fails = [](std::ostream& os) {
    os << "half" << std::flush;
    throw std::range_error("the writer's own");
  };
  BOOST_CHECK_EXCEPTION(GC::write_file_atomically(path, fails), std::range_error,
                        [](const std::range_error& error) { return error.what() == std::string("the writer's own"); });
  BOOST_CHECK_EQUAL(content(path), "old");
  BOOST_CHECK_EQUAL(folder.number_of_files(), 1);
  // a stream that was set to fail, in silence
  const std::string message = "cannot_write_file: " + path + ": write error";
  BOOST_CHECK_EQUAL(
      error_of([&] { GC::write_file_atomically(path, [](std::ostream& os) { os.setstate(std::ios::badbit); }); }),
      message);
  BOOST_CHECK_EQUAL(error_of([&] {
                      GC::write_file_atomically(path, [](std::ostream& os) {
                        os.exceptions(std::ios::goodbit);
                        os.setstate(std::ios::badbit);
                      });
                    }),
                    message);
  BOOST_CHECK_EQUAL(content(path), "old");
  BOOST_CHECK_EQUAL(folder.number_of_files(), 1);
  // the failure of another stream is the writer's own
  BOOST_CHECK_THROW(GC::write_file_atomically(path,
                                              [](std::ostream&) {
                                                std::istringstream other;
                                                other.exceptions(std::ios::failbit);
                                                other.get();
                                              }),
                    std::ios::failure);
  BOOST_CHECK_EQUAL(folder.number_of_files(), 1);
}

BOOST_AUTO_TEST_CASE(files_that_cannot_be_written) {
  const Folder folder;
  bool called = false;
  const auto writer = [&](std::ostream&) { called = true; };
  const auto error = [&](const std::string& path) {
    return error_of([&] { GC::write_file_atomically(path, writer); });
  };
  std::string path = folder / "missing/curve.g2";
  BOOST_CHECK_EQUAL(error(path), "cannot_write_file: " + path + ": " + reason(std::errc::no_such_file_or_directory));
  set_content(folder / "file", "text");
  path = folder / "file/curve.g2";
  BOOST_CHECK_EQUAL(error(path), "cannot_write_file: " + path + ": " + reason(std::errc::not_a_directory));
  path = folder / "";
  BOOST_CHECK_EQUAL(error(path), "cannot_write_file: " + path + ": " + reason(std::errc::is_a_directory));
  BOOST_CHECK(!called);
  BOOST_CHECK_EQUAL(folder.number_of_files(), 1);
}

BOOST_AUTO_TEST_CASE(full_disks) {
  const Folder folder;
  const std::string path = folder / "old.g2";
  set_content(path, "old");
  // a limit for the size of files takes the place of a full disk
  rlimit old_limit;
  BOOST_REQUIRE_EQUAL(getrlimit(RLIMIT_FSIZE, &old_limit), 0);
  rlimit limit = old_limit;
  limit.rlim_cur = 100000;
  const auto old_handler = std::signal(SIGXFSZ, SIG_IGN);
  BOOST_REQUIRE_EQUAL(setrlimit(RLIMIT_FSIZE, &limit), 0);
  bool reached_end = false;
  const std::string message = error_of([&] {
    GC::write_file_atomically(path, [&](std::ostream& os) {
      for (int i = 0; i < 200000; ++i) os.put('x');
      reached_end = true;
    });
  });
  // so little too much that it is seen at the end only
  const std::string late_message = error_of(
      [&] { GC::write_file_atomically(path, [&](std::ostream& os) { os << std::string(99999, 'x') << "yz"; }); });
  setrlimit(RLIMIT_FSIZE, &old_limit);
  std::signal(SIGXFSZ, old_handler);
  const std::string too_large = reason(std::errc::file_too_large);
  BOOST_CHECK_EQUAL(message, "cannot_write_file: " + path + ": " + too_large);
  BOOST_CHECK_EQUAL(late_message, "cannot_write_file: " + path + ": " + too_large);
  BOOST_CHECK(!reached_end);
  BOOST_CHECK_EQUAL(content(path), "old");
  BOOST_CHECK_EQUAL(folder.number_of_files(), 1);
}

BOOST_AUTO_TEST_CASE(links_are_followed_to_files_that_do_not_exist) {
  const Folder folder;
  fs::create_directory(folder / "below");
  fs::create_symlink("below/second", folder / "first");
  fs::create_symlink("../target", folder / "below/second");
  write(folder / "first", "text");
  BOOST_CHECK(fs::is_symlink(folder / "first"));
  BOOST_CHECK(fs::is_symlink(folder / "below/second"));
  BOOST_CHECK(fs::is_regular_file(fs::symlink_status(folder / "target")));
  BOOST_CHECK_EQUAL(content(folder / "target"), "text");
  fs::create_symlink("loop", folder / "loop");
  BOOST_CHECK_EQUAL(error_of([&] { write(folder / "loop", "text"); }),
                    "cannot_write_file: " + (folder / "loop") + ": " +
                        reason(std::errc::too_many_symbolic_link_levels));
}

BOOST_AUTO_TEST_CASE(owner_group_and_mode_are_kept) {
  const Folder folder;
  const std::string path = folder / "old";
  set_content(path, "old");
  const bool root = geteuid() == 0;
  if (root) BOOST_REQUIRE_EQUAL(chown(path.c_str(), 12345, 54321), 0);
  for (const mode_t mode : {0600, 0640, 0664, 0777}) {
    BOOST_REQUIRE_EQUAL(chmod(path.c_str(), mode), 0);
    GC::write_file_atomically(path, [&](std::ostream& os) {
      os << mode << std::flush;
      for (const fs::directory_entry& entry : fs::directory_iterator(folder / ""))
        if (entry.path() != path) BOOST_CHECK_EQUAL(stat_of(entry.path()).st_mode & 0777, 0600);
    });
    BOOST_CHECK_EQUAL(content(path), std::to_string(mode));
    BOOST_CHECK_EQUAL(stat_of(path).st_mode & 07777, mode);
    if (root) BOOST_CHECK_EQUAL(stat_of(path).st_uid, 12345u);
    if (root) BOOST_CHECK_EQUAL(stat_of(path).st_gid, 54321u);
  }
  // a new file is as wide as the mask says
  const mode_t old_mask = umask(026);
  write(folder / "new", "new");
  umask(old_mask);
  BOOST_CHECK_EQUAL(stat_of(folder / "new").st_mode & 0777, 0640);
}

BOOST_AUTO_TEST_CASE(hard_links_keep_the_old_content) {
  const Folder folder;
  set_content(folder / "one", "old");
  fs::create_hard_link(folder / "one", folder / "other");
  write(folder / "one", "new");
  BOOST_CHECK_EQUAL(content(folder / "one"), "new");
  BOOST_CHECK_EQUAL(content(folder / "other"), "old");
}

BOOST_AUTO_TEST_CASE(devices_and_pipes_are_written_directly) {
  const Folder folder;
  write("/dev/null", "text");
  BOOST_CHECK(fs::is_character_file("/dev/null"));
  int ends[2];
  BOOST_REQUIRE_EQUAL(pipe(ends), 0);
  write("/dev/fd/" + std::to_string(ends[1]), "through a pipe");
  char text[32] = "";
  BOOST_CHECK_EQUAL(read(ends[0], text, sizeof text - 1), 14);
  BOOST_CHECK_EQUAL(text, std::string("through a pipe"));
  close(ends[0]);
  close(ends[1]);
  BOOST_CHECK_EQUAL(error_of([&] { write("/dev/fd/" + std::to_string(ends[1]), "text"); }),
                    "cannot_write_file: /dev/fd/" + std::to_string(ends[1]) + ": " +
                        reason(std::errc::bad_file_descriptor));
  if (fs::exists("/dev/full"))
    BOOST_CHECK_EQUAL(error_of([&] { write("/dev/full", "text"); }),
                      "cannot_write_file: /dev/full: " + reason(std::errc::no_space_on_device));
}

BOOST_AUTO_TEST_CASE(temporary_files) {
  const Folder folder;
  const std::string path = folder / "file";
  GC::write_file_atomically(path, [&](std::ostream& os) {
    BOOST_CHECK_EQUAL(folder.number_of_files(), 0); // nothing to write yet
    os << "text" << std::flush;
    BOOST_CHECK_EQUAL(folder.number_of_files(), 1);
  });
  // what a handler of signals does
  set_content(path, "old");
  BOOST_CHECK_THROW(GC::write_file_atomically(path,
                                              [&](std::ostream& os) {
                                                os << "new" << std::flush;
                                                BOOST_CHECK_EQUAL(folder.number_of_files(), 2);
                                                GC::remove_unfinished_files();
                                                BOOST_CHECK_EQUAL(folder.number_of_files(), 1);
                                              }),
                    GC::Error);
  BOOST_CHECK_EQUAL(content(path), "old");
  GC::remove_unfinished_files();
  BOOST_CHECK_EQUAL(folder.number_of_files(), 1);
}
