// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "formats/input_formats.h"

#include "files/Unpacked_bytes.h"
#include "files/input.h"
#include "files/output.h"
#include "formats/cad/cad_file.h"
#include "formats/font/font_files.h"
#include "formats/foreign_formats.h"
#include "formats/gcode/toolpath.h"
#include "formats/ifc/read_ifc.h"
#include "formats/landxml/read_landxml.h"
#include "formats/opendrive/read_opendrive.h"
#include "formats/solids/read_solid.h"
#include "formats/svg/svg_drawing.h"

#include <CGAL/Geometric_continuity/Error.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace {

namespace fs = std::filesystem;

// The kinds of files that commands read.
enum Kind : unsigned {
  curves = 1,
  drawings = 2,
  fonts = 4,
  models = 8,
  points = 16,
  toolpaths = 32,
  sources = 64,
  roads = 128,
  rails = 256,
  solids = 512
};

struct Reader {
  std::string_view command;
  unsigned kinds;
};
constexpr unsigned everything = curves | drawings | fonts | models | toolpaths;
constexpr Reader readers[] = {{"verify", everything | sources | roads | rails},
                              {"report", everything | roads},
                              {"repair", curves | drawings | fonts | sources | roads},
                              {"blend", curves | drawings},
                              {"connect", curves},
                              {"match", curves},
                              {"extend", curves},
                              {"plot", curves},
                              {"tessellate", curves},
                              {"round-edges", curves | solids},
                              {"fit", points},
                              {"interpolate", points}};

constexpr struct {
  Kind kind;
  const char *one, *all;
} kind_words[] = {{curves, "curves or surfaces (.g2)", "curves and surfaces (.g2)"},
                  {drawings, "a drawing", "drawings (.svg, .svgz)"},
                  {fonts, "a font", "fonts (.ttf, .otf, .ttc, .woff, .woff2, .pfb and others, and folders with fonts)"},
                  {sources, "the source of a font", "sources of fonts (.ufo, .glyphs, .designspace)"},
                  {models, "a CAD model", "CAD models (.step, .stp, .iges, .igs, .brep, .brp)"},
                  {solids, "a solid", "solids (.step, .stp, .iges, .igs, .brep, .brp, .off)"},
                  {toolpaths, "a toolpath", "toolpaths (.ngc, .nc, .gcode, .gco, .cnc, .tap)"},
                  {roads, "a road network", "road networks (.xodr)"},
                  {rails, "an alignment", "alignments (.ifc, LandXML in .xml)"},
                  {points, "points", "points (a text, a line for each)"}};

// E.g. "drawings (.svg, .svgz) and fonts".
std::string words_of(unsigned kinds) {
  std::vector<std::string> words;
  for (const auto& w : kind_words)
    if ((kinds & w.kind) != 0) words.push_back(w.all);
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i)
    text += (i == 0 ? "" : i + 1 == words.size() ? " and " : ", ") + words[i];
  return text;
}

// The commands that read a kind, e.g. "verify and report".
std::string readers_of(Kind kind) {
  std::vector<std::string> names;
  for (const Reader& reader : readers)
    if ((reader.kinds & kind) != 0) names.emplace_back(reader.command);
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
    text += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
  return text + (names.size() == 1 ? " reads it" : " read it");
}

// Where the name of a file begins to say its format, in small letters: all from the first point on,
// and from each later one.
std::vector<std::string> endings(const std::string& file) {
  std::string name = file;
  name.erase(name.find_last_not_of('/') + 1);
  name.erase(0, name.find_last_of('/') + 1);
  for (char& c : name)
    if ('A' <= c && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  std::vector<std::string> result;
  for (std::size_t point = name.find('.', 1); point != std::string::npos; point = name.find('.', point + 1))
    result.push_back(name.substr(point));
  return result;
}

bool has_ending(const Foreign_format& format, const std::string& ending) {
  const std::size_t place = format.endings.find(ending + ' ');
  return place != std::string_view::npos && (place == 0 || format.endings[place - 1] == ' ');
}

const Foreign_format* foreign_by_name(const std::string& file) {
  using namespace foreign;
  static constexpr const Foreign_format* formats[] = {&packed_model, &packed,     &dxf,         &dwg,         &json,
                                                      &glyphs,       &ufo,        &designspace, &font_source, &freecad,
                                                      &mesh,         &cad_system, &print,       &image,       &table};
  for (const std::string& ending : endings(file))
    for (const Foreign_format* format : formats)
      if (has_ending(*format, ending)) return format;
  return nullptr;
}

bool begins_with(std::string_view text, std::string_view begin) { return text.substr(0, begin.size()) == begin; }
bool has(std::string_view text, std::string_view word) { return text.find(word) != std::string_view::npos; }

// Numbers and nothing else, as the formats .g2 and of points have them, may begin so.
bool may_be_numbers(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n,;");
  return first == std::string_view::npos ||
         std::string_view("+-.#0123456789").find(text[first]) != std::string_view::npos;
}

const Foreign_format* foreign_by_xml(std::string_view text) {
  using namespace foreign;
  if (has(text, "<svg") || has(text, ":svg") || begins_as_opendrive(text) || begins_as_landxml(text)) return nullptr;
  if (has(text, "<designspace")) return &designspace;
  if (has(text, "<glyph ")) return &ufo;
  if (has(text, "<ttFont")) return &font_source;
  return nullptr;
}

// The ending that a CAD model must have, which is known by it alone; empty for other files.
const char* ending_of_model(std::string_view text) {
  if (has(text.substr(0, 100), "ISO-10303-21")) return ".step";
  if (has(text.substr(0, 200), "CASCADE Topology") || begins_with(text, "DBRep_DrawableShape")) return ".brep";
  if (text.size() > 80 && text[72] == 'S' && has(text.substr(73, 7), "      1")) return ".iges";
  return "";
}

// A file packed by gzip is a drawing when it begins as XML, and when it is damaged before its
// beginning.
const Foreign_format* foreign_by_unpacked(const std::string& bytes) {
  std::istringstream stream(bytes);
  std::string text(200, '\0');
  try {
    Unpacked_bytes unpacked(stream, "");
    text.resize(unpacked.read(text.data(), text.size()));
  } catch (const GC::Error&) { // damaged, or not all of it is here
  }
  if (*ending_of_model(text) != '\0') return &foreign::packed_model;
  const std::size_t first = text.find_first_not_of(std::string_view("\0\xEF\xBB\xBF\xFE\xFF \t\r\n", 10));
  return first == std::string::npos || text[first] == '<' ? nullptr : &foreign::packed;
}

// Finds the format of bytes that no reader knows.
const Foreign_format* foreign_by_content(const std::string& bytes) {
  using namespace foreign;
  static constexpr struct {
    std::string_view begin;
    const Foreign_format* format;
  } signs[] = {{"\x89PNG", &image},
               {"\xFF\xD8\xFF", &image},
               {"GIF8", &image},
               {"RIFF", &image},
               {"%PDF", &print},
               {"%!PS-Adobe-", &print},
               {"PK\3\4", &packed},
               {"BZh", &packed},
               {"\xFD"
                "7zXZ",
                &packed},
               {"AC10", &dwg},
               {"AutoCAD Binary DXF", &dxf},
               {"3D Geometry File Format", &cad_system},
               {"SplineFontDB:", &font_source},
               {"ply\n", &mesh},
               {"ply\r\n", &mesh},
               {"OFF\n", &mesh},
               {"glTF", &mesh}};
  for (const auto& sign : signs)
    if (begins_with(bytes, sign.begin)) {
      if (sign.format == &packed && has(bytes, "Document.xml")) return &freecad;
      return sign.format;
    }
  if (!bytes.empty() && Unpacked_bytes::may_begin(bytes[0])) return foreign_by_unpacked(bytes);
  std::string_view text = bytes;
  if (begins_with(text, "\xEF\xBB\xBF")) text.remove_prefix(3);
  text.remove_prefix((std::min)(text.find_first_not_of(" \t\r\n"), text.size()));
  if (begins_with(text, "<")) return foreign_by_xml(text);
  if (begins_with(text, "{") || begins_with(text, "["))
    return has(text, ".appVersion") || has(text, ".formatVersion") ? &glyphs : &json;
  if (begins_with(text, "solid") && has(text, "facet")) return &mesh;
  if (begins_with(text, "0") && has(text.substr(0, 40), "SECTION")) return &dxf;
  if (begins_with(text, "999") && has(text, "SECTION")) return &dxf;
  return nullptr;
}

// A folder is one source of a font, or holds some and no font.
const Foreign_format* foreign_folder(const std::string& folder, std::string& name) {
  std::error_code error;
  if (const Foreign_format* const format = foreign_by_name(folder)) return format;
  if (fs::exists(fs::path(folder) / "metainfo.plist", error)) return &foreign::ufo;
  std::vector<std::string> sources;
  for (fs::directory_iterator i(folder, error), end; !error && i != end; i.increment(error)) {
    const Foreign_format* const format = foreign_by_name(i->path().string());
    if (format == &foreign::glyphs || format == &foreign::ufo || format == &foreign::designspace)
      sources.push_back(i->path().string());
  }
  if (sources.empty()) return nullptr;
  try {
    std::vector<Unread_file> not_read;
    if (!font_files({folder}, not_read).empty()) return nullptr;
  } catch (const GC::Error&) { // there is no font
  }
  name = *std::min_element(sources.begin(), sources.end());
  return foreign_by_name(name);
}

class Input_check {
  const Reader& reader_;
  const std::string file_;

  [[noreturn]] void refuse(const std::string& what) const {
    throw std::invalid_argument(input_name(file_) + ": " + what + "; " + std::string(reader_.command) + " reads " +
                                words_of(reader_.kinds));
  }
  [[noreturn]] void refuse(const Foreign_format& format) const {
    refuse(format.name + std::string(", which is not read: ") + format.way);
  }

  // A file of a kind that some command reads.
  void check(Kind kind) const {
    if ((reader_.kinds & kind) != 0) return;
    for (const auto& w : kind_words)
      if (w.kind == kind)
        refuse(w.one + std::string(": ") + readers_of(kind) +
               (reader_.command == "plot" ? ", and report draws it" : ""));
  }

  void check_content() const {
    const std::string bytes(Input(file_).beginning(4096));
    if (const Foreign_format* const format = foreign_by_content(bytes)) refuse(*format);
    if (is_ifc_file(file_) || is_landxml_file(file_)) return check(rails);
    if (const std::string ending = ending_of_model(bytes); !ending.empty()) {
      check(models);
      refuse("a CAD model, which is told by the end of its name: call it *" + ending);
    }
    if (is_font_file(file_)) return check(fonts);
    if (is_road_file(file_)) return check(roads);
    if (is_svg_file(file_)) return check(drawings);
    if (is_toolpath_file(file_)) return check(toolpaths);
    const bool is_named = endings(file_).empty() || endings(file_).back() == ".g2" || is_standard_input(file_);
    if (!is_named && !may_be_numbers(bytes)) refuse("no format that is read");
  }

public:
  Input_check(const Reader& reader, const std::string& file) : reader_(reader), file_(file) {}

  void check() const {
    std::error_code error;
    if ((reader_.kinds & sources) != 0 && is_font_source(file_)) return;
    if (fs::is_directory(file_, error)) {
      std::string name = file_;
      if (const Foreign_format* const format = foreign_folder(file_, name)) Input_check(reader_, name).refuse(*format);
      return check(fonts);
    }
    if (!is_standard_input(file_) && !fs::exists(file_, error)) return;
    if ((reader_.kinds & solids) != 0 && is_solid_file(file_)) return;
    if (const Foreign_format* const format = foreign_by_name(file_);
        format != nullptr && !(reader_.kinds == points && format == &foreign::table))
      refuse(*format);
    if (cad_format(file_)) return check(models);
    const std::vector<std::string> all = endings(file_);
    const std::string ending = all.empty() ? "" : all.back();
    if (ending == ".svg" || ending == ".svgz") return check(drawings);
    if (!ending.empty() && is_toolpath_file(file_)) return check(toolpaths);
    if (!ending.empty() && is_road_file(file_)) return check(roads);
    if (ending == ".ifc") return check(rails);
    if (reader_.kinds == points && ending == ".g2") return check(curves);
    if (is_standard_input(file_) || fs::is_regular_file(file_, error)) check_content();
  }
};

} // namespace

void check_input_formats(const std::string& command, const Arguments& files) {
  for (const Reader& reader : readers)
    if (reader.command == command)
      for (const std::string& file : files) Input_check(reader, file).check();
}

bool is_font_source(const std::string& file) {
  std::string name = file;
  name.erase(name.find_last_not_of('/') + 1);
  const std::string ending = extension(name);
  std::error_code error;
  return fs::is_directory(name, error) ? ending == ".ufo" : ending == ".glyphs" || ending == ".designspace";
}
