// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "files/deferred_output.h"
#include "reports/Fingerprints.h"
#include "reports/Report.h"
#include "reports/words.h"

#include <iterator>
#include <sstream>
#include <utility>

// SARIF 2.1.0, the Static Analysis Results Interchange Format of OASIS: one run, the rules first,
// then a result for each finding.

namespace {

struct Rule {
  Finding_rule rule; // as they follow each other there
  const char *name, *summary, *description;
};
const Rule rules[] = {
    {Finding_rule::gap, "Gap", "Ends that do not meet",
     "The end of one curve and the start of the next one, or two edges of surfaces, are apart."},
    {Finding_rule::corner, "Corner", "A corner",
     "The tangents of two curves, or the normals of two surfaces, differ by more than the angle of a kink."},
    {Finding_rule::kink, "Kink", "A kink",
     "The tangents of two curves differ where they meet, or the normals of two surfaces somewhere along an edge."},
    {Finding_rule::tangent, "NoTangent", "No tangent",
     "A curve has no tangent at the join, or a surface no normal somewhere on the edge."},
    {Finding_rule::curvature, "CurvatureJump", "A jump of the curvature",
     "The tangents agree, the curvatures do not: reflections break here."},
    {Finding_rule::bend, "CurvatureExceeded", "A curve that is bent too much",
     "The curvature of a curve is larger, its radius of curvature less, than is allowed."},
    {Finding_rule::derivative, "DerivativeJump", "A jump of a higher derivative",
     "Tangents and curvatures agree, but not what is required besides: torsions, derivatives of higher order, or those "
     "with "
     "respect to the parameter."},
    {Finding_rule::undecided, "Undecided", "Not decided",
     "The tolerance lies between the guaranteed bounds, or the numbers do not allow a decision."},
    {Finding_rule::not_verified, "NotVerified", "Not verified", "What the file has here cannot be read or compared."},
    {Finding_rule::rounding, "Rounding", "Rounding",
     "Segments that are no longer than one unit of the last decimal of their path are looked through: the join of "
     "their "
     "neighbours is decided."},
    {Finding_rule::length, "WrongLength", "A wrong length",
     "The arc length of a piece of a road is not the one that the file declares."}};

// A message in plain text: braces would stand for arguments, brackets for links.
std::string json_message(const std::string& text) {
  std::string escaped;
  for (const char c : text) {
    if (c == '[' || c == ']' || c == '\\') escaped += '\\';
    escaped.append(c == '{' || c == '}' ? 2 : 1, c);
  }
  return "{\"text\":" + json_text(escaped) + '}';
}

std::string json_location(const std::string& file) {
  constexpr char hex[] = "0123456789ABCDEF";
  const std::string path = path_in_folder(file);
  const bool is_relative = path.substr(0, 1) != "/";
  std::string uri = is_relative ? "" : "file://";
  for (const char c : path) {
    const auto between = [c](char first, char last) { return first <= c && c <= last; };
    if (between('a', 'z') || between('A', 'Z') || between('0', '9') ||
        std::string("-._~/").find(c) != std::string::npos)
      uri += c;
    else
      uri += {'%', hex[static_cast<unsigned char>(c) / 16], hex[static_cast<unsigned char>(c) % 16]};
  }
  return "{\"uri\":\"" + uri + '"' + (is_relative ? ",\"uriBaseId\":\"%SRCROOT%\"}" : "}");
}

class Sarif_writer : public Report::Writer {
  const bool is_new_; // what is known is left out
  Deferred_output results_;

public:
  explicit Sarif_writer(bool is_new) : is_new_(is_new) {}

  void row(const std::string&, const std::string&, const std::string&) override {}

  void find(const Finding& f) override {
    const std::size_t rule = static_cast<std::size_t>(f.rule);
    std::string result = results_.size() == 0 ? "\n  {\"ruleId\":\"" : ",\n  {\"ruleId\":\"";
    ((result += rule_id(f.rule)) += "\",\"ruleIndex\":") += std::to_string(rule);
    (result += ",\"level\":\"") += level_name(f.level);
    (result += "\",\"message\":") += json_message(f.place + ": " + f.message);
    (result += ",\n   \"locations\":[{\"physicalLocation\":{\"artifactLocation\":") += json_location(f.file);
    if (f.line != no_line)
      result += ",\"region\":{\"startLine\":" + std::to_string(f.line > 0 ? f.line : 1) +
                '}'; // of a file without lines the first
    ((result += "},\"logicalLocations\":[{\"fullyQualifiedName\":") += json_text(f.place)) +=
        ",\"kind\":" + json_text(f.kind) + "}]}],\n   \"partialFingerprints\":{\"" + place_fingerprint + "\":\"" +
        f.fingerprints.place + "\",\"" + defect_fingerprint + "\":\"" + f.fingerprints.defect + "\"}";
    if (is_new_) result += ",\n   \"baselineState\":\"new\"";
    if (const std::string properties = json_properties(f); !properties.empty())
      result += ",\n   \"properties\":{" + properties + '}';
    results_.write(result + '}');
  }

  void pass(const std::string&, std::size_t) override {}

  void print(std::ostream& os, const std::string& summary, const Conclusion& end) override {
    os << "{\"$schema\":\"https://docs.oasis-open.org/sarif/sarif/v2.1.0/errata01/os/schemas/"
          "sarif-schema-2.1.0.json\",\n"
          " \"version\":\"2.1.0\",\n"
          " \"runs\":[{\"tool\":{\"driver\":{\"name\":\"geometric_continuity\",\"version\":"
          "\"" GEOMETRIC_CONTINUITY_VERSION "\",\"informationUri\":\"urn:geometric_continuity\",\"rules\":[";
    for (const Rule& rule : rules)
      os << (&rule == std::begin(rules) ? "\n  " : ",\n  ") << "{\"id\":\"" << rule_id(rule.rule) << "\",\"name\":\""
         << rule.name << "\",\"shortDescription\":{\"text\":\"" << rule.summary
         << "\"},\"fullDescription\":{\"text\":\"" << rule.description << "\"},\"help\":{\"text\":\""
         << rule.description << "\"}}";
    os << "]}},\n \"columnKind\":\"unicodeCodePoints\",\n \"results\":[";
    results_.copy_to(os);
    os << "],\n \"properties\":{" << summary << ",\n " << end.json() << "}}]}\n";
  }
};

} // namespace

std::unique_ptr<Report::Writer> sarif_writer(bool is_new) { return std::make_unique<Sarif_writer>(is_new); }
