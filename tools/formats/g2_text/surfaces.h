// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_G2_TEXT_SURFACES_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_G2_TEXT_SURFACES_H

#include "files/input.h"
#include "files/progress.h"

#include <CGAL/Geometric_continuity/IO/G2_text_reader.h>
#include <CGAL/Geometric_continuity/IO/g2.h>

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

// The surfaces of a model: all of them as rational ones if one is.
template <class Traits> class Surface_model {
  std::vector<GC::Bspline_surface<Traits>> polynomial_;
  std::vector<GC::Rational_bspline_surface<Traits>> rational_;

public:
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

// The surfaces of a model with the numbers as they are written, in their order; those with weights
// over exact numbers.
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

// Reads the surfaces of several files, which together are one model, with a reader for each file.
// Calls note(file, reader) behind each surface, with the number of the file.
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

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_G2_TEXT_SURFACES_H
