// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FILES_INPUT_H
#define GEOMETRIC_CONTINUITY_TOOLS_FILES_INPUT_H

#include "files/progress.h"

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/IO/G2_text_reader.h>
#include <CGAL/Geometric_continuity/IO/g2.h>

#include <algorithm>
#include <cerrno>
#include <cstddef>
#include <filesystem>
#include <functional>
#include <istream>
#include <memory>
#include <optional>
#include <streambuf>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <unistd.h>

namespace GC = CGAL::Geometric_continuity;

// Whether the name of a file stands for standard input.
inline bool is_standard_input(const std::string& name) { return name == "-" || name == "/dev/stdin"; }

// The name of a file in messages.
inline std::string input_name(const std::string& name) { return is_standard_input(name) ? "standard input" : name; }

// Reads a file, and says why it cannot be read. The beginning can be looked at before anything is read, also of a pipe.
class Input_buffer : public std::streambuf {
  const std::string name_;
  const int descriptor_;
  std::vector<char> block_ = std::vector<char>(std::size_t(1) << 16);
  off_type before_ = 0; // bytes before the block
  std::function<void()> after_block_;

  [[noreturn]] void refuse() const {
    throw GC::Error(GC::Error_code::cannot_read_file,
                    input_name(name_) + ": " + std::generic_category().message(errno));
  }

  // Reads behind what is in the block, and returns how much.
  std::size_t read_more() {
    char* const end = egptr() == nullptr ? block_.data() : egptr();
    ssize_t n;
    do n = ::read(descriptor_, end, static_cast<std::size_t>(block_.data() + block_.size() - end));
    while (n < 0 && errno == EINTR);
    if (n < 0) refuse();
    setg(block_.data(), gptr() == nullptr ? block_.data() : gptr(), end + n);
    return static_cast<std::size_t>(n);
  }

public:
  explicit Input_buffer(const std::string& name)
      : name_(name),
        descriptor_(is_standard_input(name) ? STDIN_FILENO : ::open(name.c_str(), O_RDONLY | O_CLOEXEC | O_NOCTTY)) {
    if (descriptor_ < 0) refuse();
    try {
      read_more(); // a folder can be opened, but not read
    } catch (...) {
      close();
      throw;
    }
  }
  Input_buffer(const Input_buffer&) = delete;
  Input_buffer& operator=(const Input_buffer&) = delete;
  ~Input_buffer() override { close(); }

  // Calls action() whenever a block has been read, instead of what was called before.
  void after_each_block(std::function<void()> action) { after_block_ = std::move(action); }

  // The first bytes, as many as there are up to this number, as long as none has been read.
  std::string_view beginning(std::size_t size) {
    while (static_cast<std::size_t>(egptr() - eback()) < size && read_more() != 0) {
    }
    return std::string_view(eback(), (std::min)(size, static_cast<std::size_t>(egptr() - eback())));
  }

protected:
  int_type underflow() override {
    if (gptr() == egptr()) {
      before_ += egptr() - eback();
      setg(nullptr, nullptr, nullptr);
      if (read_more() == 0) return traits_type::eof();
      if (after_block_) after_block_();
    }
    return traits_type::to_int_type(*gptr());
  }

  // Tells the position; it cannot be changed.
  pos_type seekoff(off_type offset, std::ios_base::seekdir from, std::ios_base::openmode) override {
    return offset == 0 && from == std::ios_base::cur ? pos_type(before_ + (gptr() - eback())) : pos_type(off_type(-1));
  }

private:
  void close() const {
    if (descriptor_ > STDERR_FILENO) ::close(descriptor_);
  }
};

// A file that a command reads; standard input for the name "-", which all inputs of this name share. Throws GC::Error
// `cannot_read_file` with the reason of the system, now or later.
class Input : public std::istream {
  std::shared_ptr<Input_buffer> buffer_;

  static std::shared_ptr<Input_buffer> open(const std::string& name) {
    static std::shared_ptr<Input_buffer> standard_input;
    if (!is_standard_input(name)) return std::make_shared<Input_buffer>(name);
    if (!standard_input) standard_input = std::make_shared<Input_buffer>(name);
    return standard_input;
  }

public:
  explicit Input(const std::string& name) : std::istream(nullptr), buffer_(open(name)) {
    rdbuf(buffer_.get());
    exceptions(std::ios_base::badbit); // lets the reason of a failure pass
  }

  // Calls action() from now on whenever a block has been read, until this input is destroyed.
  void after_each_block(std::function<void()> action) { buffer_->after_each_block(std::move(action)); }
  ~Input() override { after_each_block({}); }

  // The first bytes, as many as there are up to this number, as long as none has been read.
  std::string_view beginning(std::size_t size) { return buffer_->beginning(size); }
};

// What a file begins with, without a byte order mark and the zeros of UTF-16. Of pipes only standard input is looked into, because others
// cannot be opened twice.
inline std::string beginning_of_text(const std::string& file) {
  std::error_code error;
  if (!is_standard_input(file) && !std::filesystem::is_regular_file(file, error)) return "";
  std::string text(Input(file).beginning(256));
  text.erase(std::remove_if(text.begin(), text.end(), [](char c) { return c == '\0' || (c & 0x80) != 0; }), text.end());
  return text;
}

// The surfaces of a model: all of them as rational ones if one is.
template <class Traits> class Surface_model {
  std::vector<GC::Bspline_surface<Traits>> polynomial_;
  std::vector<GC::Rational_bspline_surface<Traits>> rational_;

public:
  Surface_model() = default;
  explicit Surface_model(std::vector<GC::Bspline_surface<Traits>> surfaces) : polynomial_(std::move(surfaces)) {}

  std::size_t size() const { return polynomial_.size() + rational_.size(); }

  void push_back(GC::Bspline_surface<Traits> surface) {
    if (rational_.empty())
      polynomial_.push_back(std::move(surface));
    else
      rational_.push_back(std::move(surface));
  }
  void push_back(GC::Rational_bspline_surface<Traits> surface) {
    if (rational_.empty()) rational_.assign(polynomial_.begin(), polynomial_.end());
    polynomial_.clear();
    rational_.push_back(std::move(surface));
  }

  // Returns f(surfaces).
  template <class Function> auto visit(Function f) const { return rational_.empty() ? f(polynomial_) : f(rational_); }
};

// Where a surface stands: in which file, by its number, and where it begins.
struct Surface_place {
  std::size_t file;
  long long line;
};

// The surfaces of a model with the numbers as they are written, in their order; those with weights over exact numbers.
template <class Exact_traits> class Surface_texts {
  typedef GC::Rational_bspline_surface<Exact_traits> Rational;
  std::vector<GC::G2_surface_text> texts_;
  std::vector<std::pair<std::size_t, Rational>> rational_; // behind so many texts
  std::vector<Surface_place> places_;

public:
  std::size_t size() const { return texts_.size() + rational_.size(); }
  void push_back(GC::G2_surface_text text) { texts_.push_back(std::move(text)); }
  void push_back(Rational surface) { rational_.emplace_back(texts_.size(), std::move(surface)); }

  // Tells where the last surface stands.
  void set_place(const Surface_place& place) { places_.push_back(place); }
  const std::vector<Surface_place>& places() const { return places_; }

  // Brings all surfaces on a grid. Returns false if that is not possible.
  template <class Traits> bool on_grid(GC::G2_grid& grid, std::vector<GC::Bspline_surface<Traits>>& surfaces) const {
    if (!rational_.empty()) return false;
    for (const GC::G2_surface_text& text : texts_) grid.include(text);
    return grid.append(texts_, surfaces);
  }

  Surface_model<Exact_traits> model() const {
    Surface_model<Exact_traits> model;
    auto next = rational_.begin();
    for (std::size_t i = 0; i <= texts_.size(); ++i) {
      for (; next != rational_.end() && next->first == i; ++next) model.push_back(next->second);
      if (i < texts_.size()) model.push_back(texts_[i].surface<Exact_traits>());
    }
    return model;
  }
};

// Reads the surfaces of several files, which together are one model, with a reader for each file. Calls note(file, reader) behind
// each surface, with the number of the file.
template <class Reader, class Model, class Note>
void read_surfaces(const std::vector<std::string>& files, Model& model, Note note) {
  const Reading_position position(files);
  Progress progress("surfaces read");
  for (std::size_t i = 0; i < files.size(); ++i) {
    Input input(files[i]);
    const auto step = [&] { progress.step(model.size(), [&] { return position.part(i, input); }); };
    input.after_each_block(step); // a surface may be large
    Reader reader(input, input_name(files[i]));
    while (reader.visit_next([&](auto&& surface) { model.push_back(std::move(surface)); })) {
      note(i, reader);
      step();
    }
  }
}
template <class Traits> Surface_model<Traits> read_surfaces(const std::vector<std::string>& files) {
  typedef GC::G2_surface_reader<Traits, GC::Rational_bspline_surface<Traits>> Reader;
  Surface_model<Traits> model;
  read_surfaces<Reader>(files, model, [](std::size_t, const Reader&) {});
  return model;
}

template <class Exact_traits> Surface_texts<Exact_traits> read_surface_texts(const std::vector<std::string>& files) {
  typedef GC::G2_surface_text_reader<Exact_traits> Reader;
  Surface_texts<Exact_traits> texts;
  read_surfaces<Reader>(files, texts, [&](std::size_t file, const Reader& reader) {
    texts.set_place({file, reader.line()});
  });
  return texts;
}

#endif // GEOMETRIC_CONTINUITY_TOOLS_FILES_INPUT_H
