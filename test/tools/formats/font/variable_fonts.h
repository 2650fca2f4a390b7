// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#pragma once

#include "support/test.h"

// A writer of small variable TrueType fonts, in the plainest form that the format allows.

struct Font_writer {
  struct Axis {
    std::string tag;
    int minimum, initial, maximum;
    std::vector<std::pair<int, int>> map = {}; // of 'avar', in units of 2^-14
  };
  struct Point {
    int x, y;
    bool on_curve = true;
  };
  struct Tuple {
    std::vector<int> peak; // in units of 2^-14
    std::vector<int> dx, dy;
    std::optional<std::vector<int>> points = {};
    std::vector<int> start = {}, end = {};
    int shared = -1; // the number of the peak among the shared ones
    bool uses_shared_points = false;
  };
  struct Glyph {
    std::vector<std::vector<Point>> contours;
    std::vector<Tuple> tuples = {};
    std::vector<int> shared_points = {};
    std::string bytes = {}; // of 'glyf', instead of the contours
  };

  std::vector<Axis> axes;
  std::vector<Glyph> glyphs;
  std::vector<std::vector<int>> shared_peaks = {};
  int units_per_em = 1000;
  bool long_places = true;
  // With charstrings the outlines are those of 'CFF2'; peaks of regions, one set of all of them.
  std::vector<std::string> charstrings = {}, global_subroutines = {}, local_subroutines = {};
  std::vector<std::vector<int>> region_peaks = {};

  static void put(std::string& s, std::size_t size, std::uint32_t x) {
    while (size-- > 0) s += static_cast<char>(x >> 8 * size & 0xff);
  }
  static void put16(std::string& s, int x) { put(s, 2, static_cast<std::uint32_t>(x)); }
  static void put32(std::string& s, std::size_t x) { put(s, 4, static_cast<std::uint32_t>(x)); }
  static void put16(std::string& s, const std::vector<int>& x) {
    for (int y : x) put16(s, y);
  }

  // The numbers of points, in runs of bytes where the steps are short.
  static std::string packed_points(const std::vector<int>& points) {
    std::string s;
    if (points.size() < 128)
      put(s, 1, static_cast<std::uint32_t>(points.size()));
    else
      put16(s, static_cast<int>(points.size()) | 0x8000);
    int before = 0;
    for (int p : points) {
      const bool is_word = p - before > 255;
      put(s, 1, is_word ? 0x80 : 0);
      put(s, is_word ? 2 : 1, static_cast<std::uint32_t>(p - before));
      before = p;
    }
    return s;
  }

  // Movements in runs of zeros, bytes and words.
  static std::string packed_deltas(const std::vector<int>& deltas) {
    std::string s;
    const auto form = [](int x) { return x == 0 ? 0x80 : -128 <= x && x < 128 ? 0 : 0x40; };
    for (std::size_t i = 0, j; i < deltas.size(); i = j) {
      for (j = i; j < deltas.size() && j < i + 64 && form(deltas[j]) == form(deltas[i]);) ++j;
      put(s, 1, static_cast<std::uint32_t>(form(deltas[i]) + static_cast<int>(j - i) - 1));
      for (std::size_t k = i; k < j && form(deltas[i]) != 0x80; ++k)
        put(s, form(deltas[i]) == 0 ? 1 : 2, static_cast<std::uint32_t>(deltas[k]));
    }
    return s;
  }

  static std::string outline(const Glyph& glyph) {
    if (!glyph.bytes.empty() || glyph.contours.empty()) return glyph.bytes;
    std::string s, flags, xs, ys;
    put16(s, static_cast<int>(glyph.contours.size()));
    s.append(8, '\0');
    int end = 0, x = 0, y = 0;
    for (const std::vector<Point>& contour : glyph.contours) {
      put16(s, (end += static_cast<int>(contour.size())) - 1);
      for (const Point& p : contour) {
        put(flags, 1, p.on_curve);
        put16(xs, p.x - x);
        put16(ys, p.y - y);
        x = p.x;
        y = p.y;
      }
    }
    put16(s, 0);
    s += flags + xs + ys;
    return s;
  }

  std::string variations(const Glyph& glyph) const {
    if (glyph.tuples.empty()) return {};
    std::string headers, data;
    if (!glyph.shared_points.empty()) data = packed_points(glyph.shared_points);
    for (const Tuple& t : glyph.tuples) {
      std::string part;
      if (!t.uses_shared_points) part = t.points ? packed_points(*t.points) : std::string(1, '\0');
      part += packed_deltas(t.dx) + packed_deltas(t.dy);
      put16(headers, static_cast<int>(part.size()));
      put16(headers,
            (t.shared < 0 ? 0x8000 : t.shared) | (t.start.empty() ? 0 : 0x4000) | (t.uses_shared_points ? 0 : 0x2000));
      if (t.shared < 0) put16(headers, t.peak);
      put16(headers, t.start);
      put16(headers, t.end);
      data += part;
    }
    std::string s;
    put16(s, static_cast<int>(glyph.tuples.size()) | (glyph.shared_points.empty() ? 0 : 0x8000));
    put16(s, static_cast<int>(4 + headers.size()));
    return s + headers + data;
  }

  // Tables one after the other, and where each begins; with an even number of bytes each.
  std::pair<std::string, std::string> strung(const std::vector<std::string>& parts) const {
    std::string s, places;
    for (std::size_t i = 0; i <= parts.size(); ++i) {
      put(places, long_places ? 4 : 2, static_cast<std::uint32_t>(long_places ? s.size() : s.size() / 2));
      if (i < parts.size()) s += parts[i];
      if (s.size() % 2 != 0) s += '\0';
    }
    return {s, places};
  }

  // A charstring or dictionary: operators from 1000 on, e.g. 1021 for rmoveto.
  static std::string charstring(const std::vector<int>& items) {
    std::string s;
    for (int x : items)
      if (x >= 1000)
        s += (x - 1000) >= 0x0c00 ? std::string{'\x0c', static_cast<char>(x - 1000 - 0x0c00)}
                                  : std::string(1, static_cast<char>(x - 1000));
      else {
        s += '\x1c';
        put16(s, x);
      }
    return s;
  }

  static std::string index(const std::vector<std::string>& entries) {
    std::string s;
    put32(s, entries.size());
    if (entries.empty()) return s;
    s += '\2';
    std::size_t end = 1;
    put16(s, 1);
    for (const std::string& entry : entries) put16(s, static_cast<int>(end += entry.size()));
    for (const std::string& entry : entries) s += entry;
    return s;
  }

  // An entry of a dictionary, whose numbers have five bytes.
  static std::string entry(const std::vector<std::size_t>& numbers, const std::string& key) {
    std::string s;
    for (std::size_t x : numbers) put32(s += '\x1d', x);
    return s + key;
  }

  std::string cff2() const {
    const std::size_t top = 3 * 5 + 4;
    std::string store, regions, head("\2\0\5", 3);
    put16(regions, {static_cast<int>(axes.size()), static_cast<int>(region_peaks.size())});
    for (const std::vector<int>& peaks : region_peaks)
      for (int p : peaks) put16(regions, {p < 0 ? p : 0, p, p > 0 ? p : 0});
    put16(store, {0, 1, 0, 12, 1});
    put32(store, 12 + regions.size());
    store += regions;
    put16(store, {0, 0, static_cast<int>(region_peaks.size())});
    for (std::size_t r = 0; r < region_peaks.size(); ++r) put16(store, static_cast<int>(r));
    put16(head, static_cast<int>(top));
    const std::string subroutines = index(global_subroutines), glyphs = index(charstrings),
                      local = index(local_subroutines), private_part = entry({6}, "\x13");
    const std::size_t begin = head.size() + top + subroutines.size(), store_at = begin + glyphs.size(),
                      private_at = store_at + store.size(), parts_at = private_at + private_part.size() + local.size();
    return head + entry({begin}, "\x11") + entry({store_at}, "\x18") + entry({parts_at}, "\x0c\x24") + subroutines +
           glyphs + store + private_part + local + index({entry({private_part.size(), private_at}, "\x12")});
  }

  std::vector<std::pair<std::string, std::string>> tables() const {
    std::vector<std::string> outlines, movements;
    for (const Glyph& glyph : glyphs) {
      outlines.push_back(outline(glyph));
      movements.push_back(variations(glyph));
    }
    const auto [glyf, loca] = strung(outlines);
    const auto [data, places] = strung(movements);
    std::string head(18, '\0'), maxp("\0\1\0\0", 4), fvar, avar, gvar;
    put16(head, units_per_em);
    head.append(30, '\0');
    put16(head, long_places);
    head.append(2, '\0');
    const std::size_t count = charstrings.empty() ? glyphs.size() : charstrings.size();
    put16(maxp, static_cast<int>(count));
    maxp.append(26, '\0');
    for (int x : {1, 0, 16, 2, static_cast<int>(axes.size()), 20, 0, 8}) put16(fvar, x);
    for (int x : {1, 0, 0, static_cast<int>(axes.size())}) put16(avar, x);
    bool has_map = false;
    for (const Axis& axis : axes) {
      fvar += axis.tag;
      for (int x : {axis.minimum, axis.initial, axis.maximum}) put(fvar, 4, static_cast<std::uint32_t>(x) << 16);
      fvar.append(4, '\0');
      put16(avar, static_cast<int>(axis.map.size()));
      for (const auto& [from, to] : axis.map) put16(avar, {from, to});
      has_map = has_map || !axis.map.empty();
    }
    for (int x : {1, 0, static_cast<int>(axes.size()), static_cast<int>(shared_peaks.size())}) put16(gvar, x);
    put32(gvar, 20 + places.size());
    put16(gvar, {static_cast<int>(glyphs.size()), long_places});
    put32(gvar, 20 + places.size() + 2 * axes.size() * shared_peaks.size());
    gvar += places;
    for (const std::vector<int>& peak : shared_peaks) put16(gvar, peak);
    gvar += data;
    std::string hhea("\0\1\0\0", 4); // without which programs do not open a font
    hhea.append(30, '\0');
    put16(hhea, 1);
    const std::string hmtx(2 + 2 * count, '\0');
    std::vector<std::pair<std::string, std::string>> all{
        {"head", head}, {"hhea", hhea}, {"hmtx", hmtx}, {"maxp", maxp}, {"fvar", fvar}};
    if (charstrings.empty())
      all.insert(all.end(), {{"loca", loca}, {"glyf", glyf}, {"gvar", gvar}});
    else
      all.emplace_back("CFF2", cff2());
    if (has_map) all.emplace_back("avar", avar);
    return all;
  }

  // The font; `before` stand in the file before it, as those of a collection do.
  std::string font(std::size_t before = 0) const {
    const std::vector<std::pair<std::string, std::string>> all = tables();
    std::string s("\0\1\0\0", 4), data;
    put16(s, {static_cast<int>(all.size()), 0, 0, 0});
    for (const auto& [tag, table] : all) {
      s += tag;
      for (std::size_t x : {std::size_t(0), before + 12 + 16 * all.size() + data.size(), table.size()}) put32(s, x);
      data += table;
    }
    return s + data;
  }

  // A collection of this font only.
  std::string collection() const {
    std::string s("ttcf\0\1\0\0", 8);
    for (std::size_t x : {1, 16}) put32(s, x);
    return s + font(16);
  }
};
