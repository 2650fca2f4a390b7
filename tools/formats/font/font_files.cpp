// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "formats/font/font_files.h"

#include "files/input.h"
#include "files/output.h"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <set>
#include <stdexcept>
#include <string_view>
#include <system_error>

namespace {

namespace fs = std::filesystem;

constexpr std::size_t max_font_size = std::size_t(1) << 30;

bool has_font_ending(const std::string& file) {
  static const std::set<std::string> endings{".ttf", ".otf", ".ttc",  ".otc",   ".pfb",
                                             ".pfa", ".t1",  ".woff", ".woff2", ".dfont"};
  return endings.count(extension(file)) != 0;
}

bool begins_as_font(std::string_view bytes) {
  for (const std::string_view begin : {std::string_view("\0\1\0\0", 4), std::string_view("\x80\1", 2)})
    if (bytes.substr(0, begin.size()) == begin) return true;
  for (const char* begin : {"OTTO", "true", "typ1", "ttcf", "wOFF", "wOF2", "%!PS-AdobeFont", "%!FontType1"})
    if (bytes.substr(0, std::string_view(begin).size()) == begin) return true;
  return false;
}

bool is_folder(const std::string& name) {
  std::error_code none;
  return fs::is_directory(name, none);
}

// Finds the fonts of folders.
class Font_search {
  std::vector<Unread_file>& not_read_;
  std::set<fs::path> seen_; // folders and files, behind all links
  std::vector<Font_file> found_;

  bool is_new(const fs::path& path) {
    std::error_code error;
    const fs::path behind = fs::canonical(path, error);
    return seen_.insert(error ? path : behind).second;
  }

public:
  explicit Font_search(std::vector<Unread_file>& not_read) : not_read_(not_read) {}

  void add_file(const std::string& file) {
    std::error_code error;
    const std::uintmax_t bytes = fs::file_size(file, error);
    if (is_standard_input(file) || is_new(file)) found_.push_back({file, false, error ? 0 : bytes});
  }

  void add_folder(const fs::path& folder) {
    std::error_code error;
    if (!is_new(folder)) return;
    std::vector<fs::path> entries;
    for (fs::directory_iterator i(folder, error), end; !error && i != end; i.increment(error))
      entries.push_back(i->path());
    if (error) not_read_.push_back({folder.string(), error.message()});
    std::sort(entries.begin(), entries.end());
    for (const fs::path& entry : entries)
      if (fs::is_directory(entry, error))
        add_folder(entry);
      else if (has_font_ending(entry.string()) && fs::is_regular_file(entry, error) && is_new(entry))
        found_.push_back({entry.string(), true, fs::file_size(entry, error)});
  }

  const std::vector<Font_file>& found() const { return found_; }
};

} // namespace

bool is_font_file(const std::string& file) {
  std::error_code error;
  if (has_font_ending(file)) return true;
  // pipes cannot be opened twice
  if (!is_standard_input(file) && !fs::is_regular_file(file, error)) return false;
  return begins_as_font(Input(file).beginning(16));
}

bool are_fonts(const std::vector<std::string>& arguments) {
  const auto fonts = std::count_if(arguments.begin(), arguments.end(),
                                   [](const std::string&a) { return !is_folder(a) && is_font_file(a); }),
             folders = std::count_if(arguments.begin(), arguments.end(), is_folder),
             others = static_cast<std::ptrdiff_t>(arguments.size()) - fonts - folders;
  if (fonts != 0 && others != 0)
    throw std::invalid_argument("fonts cannot be verified together with curves (.g2) or drawings (.svg)");
  return others == 0;
}

std::vector<Font_file> font_files(const std::vector<std::string>& arguments, std::vector<Unread_file>& not_read) {
  Font_search search(not_read);
  for (const std::string& argument : arguments) {
    const std::size_t before = search.found().size(), unread = not_read.size();
    if (!is_folder(argument)) {
      search.add_file(argument);
      continue;
    }
    search.add_folder(argument);
    if (search.found().size() == before && not_read.size() > unread)
      throw GC::Error(GC::Error_code::cannot_read_file, not_read.back().name + ": " + not_read.back().reason);
    if (search.found().empty())
      throw GC::Error(GC::Error_code::cannot_read_file,
                      argument +
                          ": Is a directory, and no name in it ends with .ttf, .otf, .ttc, .otc, .pfb, .pfa, .t1, "
                          ".woff, .woff2 or .dfont");
  }
  return search.found();
}

std::string read_bytes(const std::string& file) {
  Input input(file);
  std::string bytes;
  constexpr std::size_t block = std::size_t(1) << 18;
  for (std::size_t read = block; read == block;) {
    const std::size_t size = bytes.size();
    bytes.resize(size + block);
    read = static_cast<std::size_t>(input.rdbuf()->sgetn(bytes.data() + size, static_cast<std::streamsize>(block)));
    bytes.resize(size + read);
    if (bytes.size() > max_font_size)
      throw GC::Error(GC::Error_code::malformed_input,
                      input_name(file) + ": larger than any font, which has at most 1 GiB");
  }
  return bytes;
}
