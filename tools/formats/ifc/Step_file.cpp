// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "formats/ifc/Step_file.h"

#include "formats/number_fault.h"

#include <CGAL/Geometric_continuity/Error.h>
#include <CGAL/Geometric_continuity/IO/number.h>
#include <CGAL/Geometric_continuity/IO/text.h>

#include <algorithm>
#include <utility>

namespace GC = CGAL::Geometric_continuity;

namespace {

constexpr std::size_t max_bytes = std::size_t(1) << 31;
constexpr int max_depth = 64;

bool is_digit(char c) { return '0' <= c && c <= '9'; }
bool is_name(char c) { return ('A' <= c && c <= 'Z') || ('a' <= c && c <= 'z') || c == '_' || is_digit(c); }
bool is_blank(char c) { return static_cast<unsigned char>(c) <= ' '; }

std::string capital(std::string_view text) {
  std::string result(text);
  for (char& c : result)
    if ('a' <= c && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  return result;
}

// Reads a text from the front, and knows where it is.
class Step_scanner {
  std::string_view text_;
  std::size_t at_ = 0;

public:
  explicit Step_scanner(std::string_view text) : text_(text) {}

  std::size_t at() const { return at_; }
  bool is_end() const { return at_ >= text_.size(); }
  char next() const { return is_end() ? '\0' : text_[at_]; }
  void step() { ++at_; }

  // Skips blanks and comments. Returns false where a comment does not end.
  bool skip() {
    for (;;) {
      while (!is_end() && is_blank(text_[at_])) ++at_;
      if (text_.substr(at_, 2) != "/*") return true;
      const std::size_t end = text_.find("*/", at_ + 2);
      if (end == std::string_view::npos) return false;
      at_ = end + 2;
    }
  }
  bool take(char c) {
    skip();
    if (next() != c) return false;
    ++at_;
    return true;
  }
  template <class Is> std::string_view take_while(Is is) {
    const std::size_t begin = at_;
    while (!is_end() && is(text_[at_])) ++at_;
    return text_.substr(begin, at_ - begin);
  }
  // The number of an entity behind its sign, 0 where there is none.
  std::uint64_t id() {
    ++at_;
    const std::string_view digits = take_while(is_digit);
    std::uint64_t n = 0;
    if (digits.size() > 18) return 0;
    for (const char c : digits) n = 10 * n + static_cast<std::uint64_t>(c - '0');
    return n;
  }
  // A text in quotation marks, which are doubled inside. Returns false where it does not end.
  bool quoted(std::string_view& content) {
    const char mark = next();
    const std::size_t begin = ++at_;
    for (;; ++at_) {
      if (is_end()) return false;
      if (text_[at_] != mark) continue;
      if (at_ + 1 >= text_.size() || text_[at_ + 1] != mark) break;
      ++at_;
    }
    content = text_.substr(begin, at_ - begin);
    ++at_;
    return true;
  }
  // All up to the parenthesis that closes the one before, or to the semicolon; texts are looked
  // through. Returns false where there is none.
  bool to_closing(std::string_view& content) {
    const std::size_t begin = at_;
    int depth = 1;
    for (; !is_end();) {
      if (!skip()) return false;
      const char c = next();
      if (c == '\'' || c == '"') {
        std::string_view text;
        if (!quoted(text)) return false;
        continue;
      }
      if (c == ';') return false;
      depth += c == '(' ? 1 : c == ')' ? -1 : 0;
      if (depth == 0) {
        content = text_.substr(begin, at_ - begin);
        ++at_;
        return true;
      }
      ++at_;
    }
    return false;
  }
};

// Returns what is wrong, or nothing.
const char* read_value(Step_scanner& s, Step_value& value, int depth) {
  if (depth > max_depth) return "values are nested deeper than 64";
  if (!s.skip()) return "a comment does not end";
  const char c = s.next();
  if (c == '$' || c == '*') {
    s.step();
    return nullptr;
  }
  if (c == '\'' || c == '"') {
    value.kind = Step_value::Kind::text;
    return s.quoted(value.text) ? nullptr : "a text does not end";
  }
  if (c == '#') {
    value.kind = Step_value::Kind::reference;
    value.reference = s.id();
    return value.reference != 0 ? nullptr : "a reference without a number";
  }
  if (c == '.') {
    s.step();
    value.kind = Step_value::Kind::word;
    value.text = s.take_while(is_name);
    if (s.next() != '.') return "a word between points does not end";
    s.step();
    return nullptr;
  }
  if (c == '(') {
    s.step();
    value.kind = Step_value::Kind::list;
    if (s.take(')')) return nullptr;
    do {
      value.items.emplace_back();
      if (const char* const wrong = read_value(s, value.items.back(), depth + 1)) return wrong;
    } while (s.take(','));
    return s.take(')') ? nullptr : "a list does not end";
  }
  if (is_digit(c) || c == '-' || c == '+') {
    value.kind = Step_value::Kind::number;
    value.text =
        s.take_while([](char x) { return is_digit(x) || x == '-' || x == '+' || x == '.' || x == 'E' || x == 'e'; });
    return nullptr;
  }
  if (is_name(c)) {
    value.kind = Step_value::Kind::typed;
    value.text = s.take_while(is_name);
    if (!s.take('(')) return "a name without an argument";
    value.items.emplace_back();
    if (const char* const wrong = read_value(s, value.items.back(), depth + 1)) return wrong;
    return s.take(')') ? nullptr : "a value does not end";
  }
  return "a value is missing";
}

} // namespace

void Step_file::refuse(long long line, const std::string& reason) const {
  throw GC::Error(GC::Error_code::malformed_input, name_ + ':' + std::to_string(line) + ": " + reason);
}
void Step_file::refuse(const Entity& entity, const std::string& reason) const {
  refuse(entity.line, entity.type + ": " + reason);
}

Step_file::Step_file(std::istream& stream, const std::string& name) : name_(name) {
  std::vector<char> block(1 << 20);
  while (stream) {
    stream.read(block.data(), static_cast<std::streamsize>(block.size()));
    bytes_.append(block.data(), static_cast<std::size_t>(stream.gcount()));
    if (bytes_.size() > max_bytes) throw GC::Error(GC::Error_code::work_limit, name_ + ": more than 2 GiB");
  }
  Step_scanner s(bytes_);
  std::size_t counted = 0;
  long long line = 1;
  const auto line_here = [&] {
    line += std::count(bytes_.begin() + static_cast<std::ptrdiff_t>(counted),
                       bytes_.begin() + static_cast<std::ptrdiff_t>((std::min)(s.at(), bytes_.size())), '\n');
    counted = s.at();
    return line;
  };
  s.skip();
  if (bytes_.compare((std::min)(s.at(), bytes_.size()), 13, "ISO-10303-21;") != 0)
    refuse(line_here(), "the text does not begin with ISO-10303-21;");
  bool is_complete = false;
  for (;;) {
    if (!s.skip()) refuse(line_here(), "a comment does not end");
    if (s.is_end()) break;
    if (s.take(';')) continue;
    if (s.next() == '#') {
      const long long here = line_here();
      const std::uint64_t id = s.id();
      if (id == 0) refuse(here, "an entity without a number");
      const std::string entity_name = "#" + std::to_string(id);
      if (!s.take('=')) refuse(here, entity_name + ": the sign = is missing");
      s.skip();
      Entity entity;
      entity.line = here;
      entity.type = capital(s.take_while(is_name)); // a composed one has none
      if (!s.take('(')) refuse(here, entity_name + ": a parenthesis is missing");
      if (!s.to_closing(entity.arguments)) refuse(here, entity_name + ": it does not end");
      if (!s.take(';')) refuse(here, entity_name + ": a semicolon is missing");
      if (!entities_.emplace(id, std::move(entity)).second) refuse(here, entity_name + " is given twice");
      order_.push_back(id);
      continue;
    }
    // a word, with arguments in the header
    const long long here = line_here();
    const std::string word = capital(s.take_while([](char c) { return is_name(c) || c == '-'; }));
    if (word.empty()) refuse(here, "a character that is none of ISO 10303-21");
    if (word == "END-ISO-10303-21") {
      is_complete = true;
      break;
    }
    std::string_view arguments;
    if (s.take('(') && !s.to_closing(arguments)) refuse(here, word + " does not end");
    if (word == "FILE_SCHEMA") {
      Step_scanner inner(arguments);
      std::string_view schema;
      if (inner.take('(') && inner.skip() && inner.next() == '\'' && inner.quoted(schema)) schema_ = capital(schema);
    }
    if (!s.take(';')) refuse(here, word + ": a semicolon is missing");
  }
  if (!is_complete) refuse(line_here(), "the file ends before END-ISO-10303-21;");
}

const Step_file::Entity& Step_file::entity(std::uint64_t id, long long from_line) const {
  const auto found = entities_.find(id);
  if (found == entities_.end()) refuse(from_line, "#" + std::to_string(id) + " is referred to, and does not exist");
  return found->second;
}

std::vector<Step_value> Step_file::arguments(const Entity& entity, std::size_t least) const {
  Step_scanner s(entity.arguments);
  std::vector<Step_value> values;
  s.skip();
  if (!s.is_end()) do {
      values.emplace_back();
      if (const char* const wrong = read_value(s, values.back(), 0)) refuse(entity, wrong);
    } while (s.take(','));
  s.skip();
  if (!s.is_end()) refuse(entity, "an argument is followed by something else than a comma");
  if (values.size() < least)
    refuse(entity, std::to_string(values.size()) + " arguments instead of " + std::to_string(least));
  return values;
}

CGAL::Exact_rational Step_file::number(const Step_value& value, const Entity& of) const {
  if (value.kind == Step_value::Kind::typed) return number(value.items[0], of);
  if (value.kind != Step_value::Kind::number) refuse(of, "a number is missing");
  try {
    return GC::parse_number<CGAL::Exact_rational>(value.text);
  } catch (const GC::Error& e) {
    refuse(of, number_fault(e) + ": " + GC::quoted_token(value.text));
  }
}

std::vector<CGAL::Exact_rational> Step_file::numbers(const Step_value& list, const Entity& of) const {
  if (list.kind != Step_value::Kind::list) refuse(of, "a list of numbers is missing");
  std::vector<CGAL::Exact_rational> result;
  for (const Step_value& item : list.items) result.push_back(number(item, of));
  return result;
}

std::uint64_t Step_file::reference(const Step_value& value, const Entity& of) const {
  if (value.kind != Step_value::Kind::reference) refuse(of, "a reference is missing");
  return value.reference;
}

std::vector<std::uint64_t> Step_file::references(const Step_value& list, const Entity& of) const {
  if (list.kind != Step_value::Kind::list) refuse(of, "a list of references is missing");
  std::vector<std::uint64_t> result;
  for (const Step_value& item : list.items) result.push_back(reference(item, of));
  return result;
}

bool begins_as_ifc(std::string_view text) {
  if (text.find("ISO-10303-21") == std::string_view::npos) return false;
  const std::size_t schema = text.find("FILE_SCHEMA");
  return schema != std::string_view::npos && text.find("IFC", schema) != std::string_view::npos;
}
