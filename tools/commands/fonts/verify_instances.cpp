// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/fonts/verify_instances.h"

#include "commands/chains/join_report.h"
#include "commands/fonts/Instance_findings.h"
#include "files/deferred_output.h"
#include "files/input.h"
#include "files/progress.h"
#include "formats/font/Font_face.h"
#include "formats/font/font_files.h"
#include "formats/font/uncovered_font.h"

#include <CGAL/Geometric_continuity/IO/json.h>
#include <CGAL/Geometric_continuity/IO/printable.h>

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <sstream>
#include <utility>
#include <vector>

namespace {

namespace fs = std::filesystem;

std::string json_string(const std::string& text) {
  std::ostringstream os;
  GC::write_json(os, text);
  return os.str();
}

std::string json_array(const Arguments& values) {
  std::string text;
  for (const std::string& value : values) text += (text.empty() ? "" : ",") + value;
  return '[' + text + ']';
}

// What an error says behind its code.
std::string reason_of(const GC::Error& error) {
  return std::string(error.what()).substr(to_string(error.code()).size() + 2);
}

// A glyph that could not be read, and why.
struct Unread {
  int index;
  std::string name, reason;
};

// Reads variable fonts, decides their joins and keeps what the report says.
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
  bool one_font_;                               // the only argument is the only font of a file
  std::unique_ptr<Instance_findings> findings_; // for SARIF and JUnit
  Deferred_output out_;
  Progress progress_{"joins"};
  std::vector<Instance_kink> worst_;
  Instance_counts counts_;
  std::size_t fonts_ = 0, unverified_ = 0, files_done_ = 0;

  bool fails(const Instance_counts& counts) const { return counts.refuted + counts.undecided != 0; }

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
      const std::size_t faces = GC::Font_tables::face_count(bytes);
      one_font_ = one_font_ && faces == 1;
      for (std::size_t face = 0; face < faces; ++face) {
        const std::string number = faces == 1 ? "" : "font " + std::to_string(face) + ": ";
        const GC::Font_tables tables(bytes, face);
        const std::string why = uncovered_tables(tables);
        if (!why.empty())
          skip(file, number + why);
        else
          read_font(file, bytes, face, faces, GC::Variable_font(tables));
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

  void read_font(const Font_file& file, const std::string& bytes, std::size_t face_number, std::size_t faces,
                 const GC::Variable_font& font) {
    const Font_face face(bytes, static_cast<int>(face_number)); // for names
    Arguments missing;
    std::vector<Unread> unread;
    const std::vector<int> glyphs = selection_.glyphs(face, missing);
    const std::string name = face.name().empty() ? input_name(file.name) : face.name();
    Instance_counts counts;
    std::size_t composites = 0;
    std::vector<Instance_kink> worst;
    if (json_) begin_json(file, face_number, faces);
    bool has_row = false;
    for (const int index : glyphs) {
      std::vector<Instance_kink> kinks;
      Instance_counts joins;
      try {
        const GC::Variable_outline glyph = font.glyph(index);
        composites += glyph.outline.components != 0;
        joins = judge_instances(index, glyph, font, bounds_, kinks);
      } catch (const GC::Error& e) {
        unread.push_back({index, face.glyph_name(index), reason_of(e)});
        continue;
      }
      counts += joins;
      if (json_ && (!mode_.summary || fails(joins)))
        out_.write((std::exchange(has_row, true) ? ",\n " : "\n ") + ("{\"index\":" + std::to_string(index)) +
                   ",\"name\":" + json_string(face.glyph_name(index)) + ',' + counts_json(joins) +
                   ",\"worst\":" + kinks_json(worst_of(std::move(kinks)), font.axes()) + '}');
      else
        worst.insert(worst.end(), kinks.begin(), kinks.end());
      if (worst.size() > 2 * most_ + 1000) worst = worst_of(std::move(worst));
      progress_.step(counts_.joins + counts.joins, [&] {
        const double part = static_cast<double>(index) / font.glyph_count();
        return (static_cast<double>(files_done_) + part) / static_cast<double>(files_.size());
      });
    }
    worst = worst_of(std::move(worst));
    for (Instance_kink& kink : worst) {
      kink.glyph_name = face.glyph_name(kink.glyph);
      for (std::size_t k = 0; k < font.axes().size(); ++k)
        kink.instance.push_back(font.axes()[k].tag + ' ' + axis_text(font.axes()[k], kink.kink.instance[k]));
    }
    if (json_)
      out_.write("],\n \"not_verified\":" + json_unread(unread) + ",\"not_found\":" + json_names(missing) +
                 ",\"composites\":" + std::to_string(composites) + ",\n \"axes\":" + axes_json(font.axes()) +
                 ",\n \"summary\":{\"glyphs\":" + std::to_string(glyphs.size() - unread.size()) + ',' +
                 counts_json(counts) + "},\"name\":" + json_string(face.name()) +
                 ",\"units_per_em\":" + std::to_string(font.units_per_em()) + (one_font_ ? "" : "}"));
    else if (findings_)
      add_findings(input_name(file.name), faces == 1 ? "" : "font " + std::to_string(face_number) + ", ", font, counts,
                   missing, unread, worst);
    else
      write_text(name + ", " + input_name(file.name), font, glyphs.size(), composites, counts, missing, unread, worst);
    for (Instance_kink& kink : worst) {
      kink.font_name = name;
      worst_.push_back(std::move(kink));
    }
    worst_ = worst_of(std::move(worst_));
    counts_ += counts;
    unverified_ += unread.size() + missing.size();
    ++fonts_;
  }

  static std::string json_unread(const std::vector<Unread>& glyphs) {
    Arguments objects;
    for (const Unread& glyph : glyphs)
      objects.push_back("{\"index\":" + std::to_string(glyph.index) + ",\"name\":" + json_string(glyph.name) +
                        ",\"reason\":" + json_string(glyph.reason) + '}');
    return json_array(objects);
  }

  static std::string json_names(const Arguments& names) {
    Arguments texts;
    for (const std::string& name : names) texts.push_back(json_string(name));
    return json_array(texts);
  }

  void begin_json(const Font_file& file, std::size_t face, std::size_t faces) {
    if (one_font_) return out_.write("{\"glyphs\":[");
    out_.write((fonts_ == 0 ? "{\"fonts\":[\n{\"file\":" : ",\n{\"file\":") + json_string(input_name(file.name)) +
               (faces == 1 ? "" : ",\"font\":" + std::to_string(face)) + ",\"glyphs\":[");
  }

  void add_findings(const std::string& file, const std::string& place, const GC::Variable_font& font,
                    const Instance_counts& counts, const Arguments& missing, const std::vector<Unread>& unread,
                    const std::vector<Instance_kink>& worst) {
    findings_->add_font(file, place, counts, worst, font.axes());
    for (const Unread& glyph : unread)
      findings_->not_verified(file, "glyph", place + "glyph " + glyph.name, glyph.reason);
    for (const std::string& name : missing)
      findings_->not_verified(file, "glyph", place + "glyph " + name, "not in this font");
  }

  void write_text(const std::string& title, const GC::Variable_font& font, std::size_t glyphs, std::size_t composites,
                  const Instance_counts& counts, const Arguments& missing, const std::vector<Unread>& unread,
                  const std::vector<Instance_kink>& worst) {
    std::string text = GC::printable(title) + "\n  axes:";
    const char* separator = " ";
    for (const GC::Variation_axis& axis : font.axes())
      text += std::exchange(separator, ", ") + GC::printable(axis.tag) + " from " + axis_text(axis, axis.lowest()) +
              " to " + axis_text(axis, axis.highest()) + " (" + axis_text(axis, 0) + ')';
    text += "\n  " + counted(glyphs, "glyph");
    if (composites != 0) text += " (" + std::to_string(composites) + " of them composed of other ones)";
    text += ", " + counts_text(counts, max_kink_) + '\n';
    for (const Unread& glyph : unread)
      text += "  " + GC::printable("glyph " + glyph.name + ": not verified, " + glyph.reason) + '\n';
    for (const std::string& name : missing) text += "  not in this font: " + GC::printable(name) + '\n';
    if (!mode_.summary || fails(counts)) text += kinks_table(worst, "    ");
    out_.write(text);
  }

public:
  Instances_report(const Arguments& arguments, const Report_mode& mode, const Instance_demand& demand)
      : mode_(mode), bounds_(demand.bounds), max_kink_(demand.max_kink), required_(demand.required),
        most_(demand.worst), selection_(demand.glyphs), files_(font_files(arguments, not_read_)) {
    if (!json_ && mode.format != Report_format::text) findings_ = std::make_unique<Instance_findings>(mode, required_);
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
    out_.copy_to(os);
    if (json_)
      print_json_end(os);
    else if (findings_)
      print_findings(os);
    else
      print_summary(os);
    return conclusion().exit_code(mode_, "join");
  }

private:
  Old_conclusion conclusion() const {
    return {counts_.decided() + counts_.corners, required_ ? counts_.refuted + counts_.undecided : 0,
            not_read_.size() + unverified_ + counts_.unverified() + (required_ ? 0 : counts_.undecided)};
  }

  void print_summary(std::ostream& os) const {
    for (const Unread_file& file : not_read_) os << GC::printable(file.name + ": " + file.reason) << '\n';
    if (fonts_ > 1)
      os << counted(fonts_, "font") << ", " << counts_text(counts_, max_kink_) << '\n' << kinks_table(worst_, "    ");
    const Old_conclusion end = conclusion();
    if (end.decided == 0)
      os << "no join, nothing was decided\n";
    else if (required_ && end.failing == 0)
      os << "no instance has a kink above " << max_kink_ << " degrees, proved\n";
    else if (required_)
      os << counts_.refuted << " of them not within " << max_kink_ << " degrees, and " << counts_.undecided
         << " not proved to be\n";
    if (!mode_.allow_undecided && end.unverified > 0) os << "not met, because not all was verified\n";
  }

  void print_findings(std::ostream& os) const {
    for (const Unread_file& file : not_read_) findings_->not_verified(file.name, "font", "font", file.reason);
    findings_->print(os, "\"fonts\":" + std::to_string(fonts_) + ',' + counts_json(counts_) + ",\"max_kink\":\"" +
                             max_kink_ + '"' + (required_ ? ",\"met\":" + conclusion().json_met(mode_) : ""));
  }

  void print_json_end(std::ostream& os) const {
    Arguments not_read;
    for (const Unread_file& file : not_read_)
      not_read.push_back("{\"file\":" + json_string(file.name) + ",\"reason\":" + json_string(file.reason) + '}');
    if (!one_font_ || fonts_ == 0)
      os << (fonts_ == 0 ? "{\"fonts\":[" : "") << "],\n\"not_verified\":" << json_array(not_read)
         << ",\n\"summary\":{\"fonts\":" << fonts_ << ',' << counts_json(counts_) << '}';
    os << ",\n\"max_kink\":\"" << max_kink_ << '"';
    if (required_) os << ",\"met\":" << conclusion().json_met(mode_);
    os << "}\n";
  }
};

} // namespace

int verify_instances(const Arguments& files, const Report_mode& mode, const Instance_demand& demand) {
  Instances_report report(files, mode, demand);
  report.read();
  return report.print(std::cout);
}
