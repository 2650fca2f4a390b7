// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/fonts/verify_instances.h"

#include "files/input.h"
#include "files/progress.h"
#include "formats/font/Font_face.h"
#include "formats/font/font_files.h"
#include "formats/font/glyph_parts.h"
#include "reports/words.h"

#include <CGAL/Geometric_continuity/IO/text.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <set>
#include <sstream>
#include <string_view>
#include <utility>
#include <vector>

namespace {

namespace fs = std::filesystem;

// Returns the text of an error after its code.
std::string reason_of(const GC::Error& error) {
  return std::string(error.what()).substr(to_string(error.code()).size() + 2);
}

// Returns whether a font is packed (WOFF, WOFF2): then FreeType unpacks it.
bool is_packed(std::string_view bytes) { return bytes.substr(0, 4) == "wOFF" || bytes.substr(0, 4) == "wOF2"; }

// Why a file, or the tables of a font, cannot be covered; empty if they can.
std::string uncovered_form(std::string_view bytes) {
  const std::string_view begin = bytes.substr(0, 4);
  if (begin == "ttcf" || begin == "true" || begin == "OTTO" || begin == std::string_view("\0\1\0\0", 4)) return "";
  return is_packed(bytes) ? "" : "no OpenType or TrueType font";
}
std::string uncovered_tables(const GC::Font_tables& font) {
  if (!font.has("fvar")) return "not a variable font";
  if (!GC::Variable_font::is_variable(font)) return "a variable font without TrueType or CFF2 outlines";
  const int version = GC::axis_map_version(font);
  return version == 1 ? "" : "the table 'avar' of version " + std::to_string(version);
}

// A glyph that could not be read, and why.
struct Unread {
  int index;
  std::string name, reason;
};

// A font, and what was found in it.
struct Instances_of_font {
  std::string file;  // as messages name it
  std::string place; // of the font in it, e.g. "font 1, "
  const GC::Variable_font& font;
  const Font_face& face;
  Instance_counts counts = {};
  std::size_t glyphs = 0, composites = 0;
  Arguments missing = {}; // glyphs that were asked for
  std::vector<Unread> unread = {};
  std::vector<Instance_kink> worst = {};
  std::string rows = {}; // of glyphs, in JSON
};

// Reads variable fonts, decides their joins and reports them.
class Instances_report {
  const Report_mode mode_;
  const bool json_ = mode_.format == Report_format::json;
  const Instance_bounds bounds_;
  const std::string max_kink_;
  const bool required_;
  const std::size_t most_;
  Glyph_selection selection_;
  std::vector<Unread_file> not_read_; // folders and fonts
  std::vector<Font_file> files_;
  bool one_font_; // the only argument is the only font of a file
  Report report_;
  Progress progress_{"joins"};
  std::vector<Instance_kink> worst_;
  Instance_counts counts_;
  std::size_t fonts_ = 0, files_done_ = 0;
  std::string one_font_json_; // of the only font

  static Report_subject subject(const Instance_demand& demand) {
    Report_subject s{"join", "every join that is no corner at the default instance"};
    if (demand.required) s.required = "within " + demand.max_kink + " degrees in every instance";
    s.required_in_json = "\"max_kink\":\"" + demand.max_kink + '"';
    s.proof = "proved";
    return s;
  }

  static bool fails(const Instance_counts& counts) { return counts.refuted + counts.undecided != 0; }

  // The first ones, in order.
  std::vector<Instance_kink> worst_of(std::vector<Instance_kink> kinks) const {
    const std::size_t most = (std::min)(most_, kinks.size());
    std::partial_sort(kinks.begin(), kinks.begin() + static_cast<std::ptrdiff_t>(most), kinks.end(), shown_before);
    kinks.resize(most);
    return kinks;
  }

  void read_file(const Font_file& file) {
    try {
      const std::string bytes = read_bytes(file.name);
      const std::string reason = uncovered_form(bytes);
      if (!reason.empty()) return skip(file, reason);
      const bool packed = is_packed(bytes);
      const std::size_t faces =
          packed ? static_cast<std::size_t>(Font_face(bytes).fonts_of_file()) : GC::Font_tables::face_count(bytes);
      one_font_ = one_font_ && faces == 1;
      for (std::size_t i = 0; i < faces; ++i) {
        const std::string number = faces == 1 ? "" : "font " + std::to_string(i) + ": ";
        const std::string unpacked = packed ? Font_face(bytes, static_cast<int>(i)).unpacked() : std::string();
        const GC::Font_tables tables = packed ? GC::Font_tables(unpacked) : GC::Font_tables(bytes, i);
        const std::string why = uncovered_tables(tables);
        if (!why.empty()) {
          skip(file, number + why);
          continue;
        }
        const GC::Variable_font font(tables);
        // for names
        const Font_face face = packed ? Font_face(unpacked) : Font_face(bytes, static_cast<int>(i));
        Instances_of_font found{input_name(file.name), faces == 1 ? "" : "font " + std::to_string(i) + ", ", font,
                                face};
        read_font(found, faces == 1 ? "" : ",\"font\":" + std::to_string(i));
      }
    } catch (const Font_error& e) {
      refuse(file, e.what());
    } catch (const GC::Error& e) {
      if (e.code() == GC::Error_code::cannot_read_file && !file.from_folder) throw;
      refuse(file, reason_of(e));
    }
  }

  void skip(const Font_file& file, const std::string& reason) { not_read_.push_back({input_name(file.name), reason}); }

  void refuse(const Font_file& file, const std::string& reason) {
    if (!file.from_folder) throw GC::Error(GC::Error_code::malformed_input, input_name(file.name) + ": " + reason);
    skip(file, reason);
  }

  void read_font(Instances_of_font& found, const std::string& json_number) {
    report_.begin_file(found.file);
    std::vector<int> glyphs = selection_.glyphs(found.face, found.missing);
    std::set<int> known(glyphs.begin(), glyphs.end());
    for (std::size_t i = 0; i < glyphs.size(); ++i) { // more of them are appended
      Instance_joins joins;
      try {
        joins = judge(found, glyphs[i], glyphs, known);
      } catch (const GC::Error& e) {
        found.unread.push_back({glyphs[i], found.face.glyph_name(glyphs[i]), reason_of(e)});
        continue;
      }
      add(found, glyphs[i], std::move(joins));
      progress_.step(counts_.joins + found.counts.joins, [&] {
        const double part = static_cast<double>(i) / static_cast<double>(glyphs.size());
        return (static_cast<double>(files_done_) + part) / static_cast<double>(files_.size());
      });
    }
    found.glyphs = glyphs.size();
    found.worst = worst_of(std::move(found.worst));
    for (Instance_kink& kink : found.worst) name(found, kink);
    for (const Unread& glyph : found.unread)
      add_uncovered(found.file, "glyph", found.place + "glyph " + glyph.name, glyph.reason);
    for (const std::string& name : found.missing)
      add_uncovered(found.file, "glyph", found.place + "glyph " + name, "not in this font");
    write(found, json_number);
    for (Instance_kink& kink : found.worst) {
      kink.font_name = found.face.name().empty() ? found.file : found.face.name();
      worst_.push_back(std::move(kink));
    }
    worst_ = worst_of(std::move(worst_));
    counts_ += found.counts;
    ++fonts_;
  }

  // Decides the joins of a glyph: of its own outline, and of parts that it stretches. Its other
  // parts have the joins of the glyphs that they are, which are appended to those to be read.
  Instance_joins judge(Instances_of_font& found, int index, std::vector<int>& glyphs, std::set<int>& known) const {
    Instance_joins joins;
    const GC::Variable_outline glyph = found.font.glyph(index);
    judge_instances(index, index, glyph, GC::outline_joins(glyph), found.font, bounds_, joins);
    found.composites += !glyph.components.empty();
    for (const Glyph_part& part : GC::glyph_parts(found.font, glyph.components))
      if (GC::is_stretched(part)) {
        const GC::Variable_outline outline = found.font.glyph(part.glyph);
        std::vector<GC::Outline_join> stretched = GC::outline_joins(outline);
        for (GC::Outline_join& join : stretched) join.join = GC::join_of_part(part, std::move(join.join));
        judge_instances(index, part.glyph, outline, stretched, found.font, bounds_, joins);
      } else if (known.insert(part.glyph).second)
        glyphs.push_back(part.glyph);
    return joins;
  }

  static void name(const Instances_of_font& found, Instance_kink& kink) {
    kink.glyph_name = found.face.glyph_name(kink.glyph);
    if (kink.part != kink.glyph) kink.part_name = found.face.glyph_name(kink.part);
    kink.instance = instance_texts(found.font.axes(), kink.kink);
  }

  // Every join is in one class: a corner at the default instance is meant, and met.
  void add(Instances_of_font& found, int index, Instance_joins joins) {
    const Instance_counts& counts = joins.counts;
    found.counts += counts;
    Report_part part(mode_);
    part.add(found.file, {Claim::met, "join"}, counts.corners + counts.proved);
    const auto place = [&](int contour, int point) {
      return found.place + "glyph " + found.face.glyph_name(index) + ", contour " + std::to_string(contour) +
             ", point " + std::to_string(point);
    };
    for (Instance_kink& kink : joins.kinks) {
      if (kink.kink.verdict == GC::Verdict::proved) continue;
      const bool refuted = kink.kink.verdict == GC::Verdict::refuted;
      const Claim claim = !refuted ? Claim::undecided : required_ ? Claim::not_met : Claim::met;
      part.add(found.file,
               {claim, "join",
                refuted ? "" : "the bounds of the largest kink lie on both sides of " + max_kink_ + " degrees"},
               true, [&] {
                 name(found, kink);
                 Finding f;
                 f.file = found.file;
                 f.kind = "glyph";
                 f.place = place(kink.contour, kink.point);
                 f.rule = refuted ? Finding_rule::kink : Finding_rule::undecided;
                 f.message = kink_text(kink);
                 f.properties = kink_json(kink, found.font.axes());
                 f.shape = shape(kink);
                 f.measure = Measure{"angle_degrees", GC::in_degrees(kink.kink.angle)};
                 return f;
               });
    }
    for (const GC::Outline_join& join : joins.without_length)
      part.add(found.file, {Claim::not_covered, "join", no_length}, false,
               [&] { return uncovered(found.file, "glyph", place(join.contour, join.point), no_length); });
    report_.add(part);
    if (json_ && (!mode_.summary || fails(counts))) {
      std::vector<Instance_kink> worst = worst_of(std::move(joins.kinks));
      for (Instance_kink& kink : worst) name(found, kink);
      found.rows += ",\n {\"index\":" + std::to_string(index) + ",\"name\":" + json_text(found.face.glyph_name(index)) +
                    ',' + counts_json(counts) + ",\"worst\":" + kinks_json(worst, found.font.axes()) + '}';
    } else
      found.worst.insert(found.worst.end(), joins.kinks.begin(), joins.kinks.end());
    if (found.worst.size() > 2 * most_ + 1000) found.worst = worst_of(std::move(found.worst));
  }

  // The numbers of a kink, wherever it is.
  static std::string shape(const Instance_kink& kink) {
    std::ostringstream os;
    os.precision(17);
    os << kink.kink.angle << ' ' << kink.initial_angle << ' ' << kink.severity;
    for (const GC::Variation_axis::FT& value : kink.kink.instance) os << ' ' << value;
    return os.str();
  }

  static Finding uncovered(const std::string& file, const std::string& kind, const std::string& place,
                           const std::string& reason) {
    Finding f;
    f.file = file;
    f.kind = kind;
    f.place = place;
    f.rule = Finding_rule::not_verified;
    f.message = "not covered, " + reason;
    return f;
  }
  void add_uncovered(const std::string& file, const char* kind, const std::string& place, const std::string& reason) {
    report_.add(file, {Claim::not_covered, kind, reason}, false, [&] { return uncovered(file, kind, place, reason); });
  }

  // The rows of a font.
  void write(const Instances_of_font& found, const std::string& json_number) {
    if (!json_) return write_text(found);
    if (one_font_) {
      report_.row("glyphs", found.rows);
      one_font_json_ = json_of(found);
      return;
    }
    report_.row("fonts", ",\n{\"file\":" + json_text(found.file) + json_number + ",\"glyphs\":[" +
                             (found.rows.empty() ? "" : found.rows.substr(1)) + "],\n " + json_of(found) + '}');
  }

  std::string json_of(const Instances_of_font& found) const {
    Arguments unread, missing;
    for (const Unread& glyph : found.unread)
      unread.push_back("{\"index\":" + std::to_string(glyph.index) + ",\"name\":" + json_text(glyph.name) +
                       ",\"reason\":" + json_text(glyph.reason) + '}');
    for (const std::string& name : found.missing) missing.push_back(json_text(name));
    return "\"not_verified\":" + json_array(unread) + ",\"not_found\":" + json_array(missing) +
           ",\"composites\":" + std::to_string(found.composites) + ",\n \"axes\":" + axes_json(found.font.axes()) +
           ",\n \"summary\":{\"glyphs\":" + std::to_string(found.glyphs - found.unread.size()) + ',' +
           counts_json(found.counts) + "},\"name\":" + json_text(found.face.name()) +
           ",\"units_per_em\":" + std::to_string(found.font.units_per_em());
  }

  void write_text(const Instances_of_font& found) {
    std::string text =
        GC::printable((found.face.name().empty() ? found.file : found.face.name()) + ", " + found.file) + "\n  axes:";
    const char* separator = " ";
    for (const GC::Variation_axis& axis : found.font.axes())
      text += std::exchange(separator, ", ") + GC::printable(axis.tag) + " from " +
              axis_text(axis, axis.range().lowest) + " to " + axis_text(axis, axis.range().highest) + " (" +
              axis_text(axis, 0) + ')';
    text += "\n  " + counted(found.glyphs, "glyph");
    if (found.composites != 0) text += " (" + std::to_string(found.composites) + " of them composed of other ones)";
    text += ", " + counts_text(found.counts, max_kink_) + '\n';
    for (const Unread& glyph : found.unread)
      text += "  " + GC::printable("glyph " + glyph.name + ": not covered, " + glyph.reason) + '\n';
    for (const std::string& name : found.missing) text += "  not in this font: " + GC::printable(name) + '\n';
    const std::string table = kinks_table(found.worst, "    ");
    Report_part part(mode_);
    part.rows = text + table;
    part.failing_rows = text + (fails(found.counts) ? table : "");
    report_.add(part);
  }

public:
  Instances_report(const Arguments& arguments, const Report_mode& mode, const Instance_demand& demand)
      : mode_(mode), bounds_(demand.bounds), max_kink_(demand.max_kink), required_(demand.required),
        most_(demand.worst), selection_(demand.glyphs), files_(font_files(arguments, not_read_)),
        report_(mode, subject(demand)) {
    std::error_code none;
    one_font_ = files_.size() == 1 && arguments.size() == 1 && !fs::is_directory(arguments[0], none);
  }

  void read() {
    for (; files_done_ < files_.size(); ++files_done_) read_file(files_[files_done_]);
    progress_.clear();
    if (fonts_ != 0) selection_.check_all_found();
  }

  // Prints the report and returns the exit code.
  int print(std::ostream& os) {
    for (const Unread_file& file : not_read_) add_uncovered(file.name, "font", "font", file.reason);
    return report_.print(os, json_                                 ? json_summary()
                             : mode_.format != Report_format::text ? all_json()
                                                                   : text_summary());
  }

private:
  static constexpr const char* no_length = "a handle has no length at the default instance";

  std::string text_summary() const {
    std::string text;
    for (const Unread_file& file : not_read_) text += GC::printable(file.name + ": not covered, " + file.reason) + '\n';
    if (fonts_ > 1)
      text += counted(fonts_, "font") + ", " + counts_text(counts_, max_kink_) + '\n' + kinks_table(worst_, "    ");
    return text;
  }

  std::string all_json() const {
    return "\"summary\":{\"fonts\":" + std::to_string(fonts_) + ',' + counts_json(counts_) + '}';
  }

  std::string json_summary() {
    if (one_font_ && fonts_ != 0) return one_font_json_;
    report_.row("fonts");
    Arguments not_read;
    for (const Unread_file& file : not_read_)
      not_read.push_back("{\"file\":" + json_text(file.name) + ",\"reason\":" + json_text(file.reason) + '}');
    return "\"not_verified\":" + json_array(not_read) + ",\n" + all_json();
  }
};

} // namespace

int verify_instances(const Arguments& files, const Report_mode& mode, const Instance_demand& demand) {
  Instances_report report(files, mode, demand);
  report.read();
  return report.print(std::cout);
}
