// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// No report says more than the classes of what was given allow, whatever they are, and all formats
// agree.
#define BOOST_TEST_MODULE Report
#include "support/random.h"

#include "reports/Report.h"
#include "reports/report_page.h"
#include <boost/property_tree/json_parser.hpp>
#include <boost/property_tree/xml_parser.hpp>

namespace {

typedef boost::property_tree::ptree Tree;

// Something that was given, as the test knows it.
struct Thing {
  Claim claim;
  std::string file, reason;
  bool noted;
};

// How many things have this class.
std::size_t count(const std::vector<Thing>& things, Claim claim) {
  return static_cast<std::size_t>(
      std::count_if(things.begin(), things.end(), [&](const Thing& t) { return t.claim == claim; }));
}

struct Printed {
  int code;
  std::string text;
};

// The report on the things, added one by one or in parts.
Printed print(const std::vector<Thing>& things, const Report_mode& mode, bool required, bool in_parts) {
  Report_subject subject{"join", "every join"};
  if (required) {
    subject.required = "G1";
    subject.required_in_json = "\"required\":\"G1\"";
  }
  Report report(mode, subject);
  report.row("joins");
  for (const char* file : {"a.g2", "b.g2"}) report.begin_file(file);
  Report_part part(mode);
  for (std::size_t i = 0; i < things.size(); ++i) {
    const Thing& t = things[i];
    const Given given{t.claim, "join", t.reason};
    const auto finding = [&] {
      Finding f;
      f.file = t.file;
      f.kind = "join";
      f.place = "join " + std::to_string(i);
      f.rule = Finding_rule::kink;
      f.message = "message";
      return f;
    };
    const std::string row = mode.format == Report_format::json ? ",\n {\"join\":" + std::to_string(i) + '}'
                                                               : "row " + std::to_string(i) + '\n';
    if (!in_parts) {
      report.add(t.file, given, t.noted, finding);
      report.row("joins", row, t.claim);
      continue;
    }
    part.add(t.file, given, t.noted, finding);
    part.rows += row;
    if (t.claim != Claim::met) part.failing_rows += row;
    if (i % 3 == 2) {
      report.add(part, "joins");
      part = Report_part(mode);
    }
  }
  report.add(part, "joins");
  std::ostringstream os;
  const int code = report.print(os, mode.format == Report_format::text ? "summary\n" : "\"summary\":{}");
  return {code, os.str()};
}

std::size_t occurrences(const std::string& text, const std::string& part) {
  std::size_t n = 0;
  for (std::size_t i = text.find(part); i != std::string::npos; i = text.find(part, i + 1)) ++n;
  return n;
}

Tree json(const std::string& text) {
  std::istringstream is(text);
  Tree tree;
  boost::property_tree::read_json(is, tree);
  return tree;
}

// The classes as a report in JSON tells them.
void check_claims(const Tree& claims, const std::vector<Thing>& things) {
  const auto open = [&](const char* name) {
    std::size_t n = 0;
    for (const auto& entry : claims.get_child(name)) n += entry.second.get<std::size_t>("count");
    return n;
  };
  BOOST_TEST(claims.get<std::size_t>("given") == things.size());
  BOOST_TEST(claims.get<std::size_t>("decided") == count(things, Claim::met) + count(things, Claim::not_met));
  BOOST_TEST(claims.get<std::size_t>("not_met") == count(things, Claim::not_met));
  BOOST_TEST(open("undecided") == count(things, Claim::undecided));
  BOOST_TEST(open("not_covered") == count(things, Claim::not_covered));
  BOOST_TEST(claims.get<std::size_t>("decided") + open("undecided") + open("not_covered") == things.size());
}

std::vector<Thing> random_things(std::mt19937& random) {
  const auto below = [&](unsigned n) { return static_cast<unsigned>(random() % n); };
  const unsigned classes = below(16); // which may occur
  std::vector<Thing> things;
  for (unsigned n = below(8); n > 0; --n) {
    const unsigned c = below(4);
    if ((classes & (1u << c)) == 0) continue;
    const Claim claim = static_cast<Claim>(c);
    things.push_back({claim, below(2) == 0 ? "a.g2" : "b.g2", "reason " + std::to_string(below(3)), below(2) == 0});
  }
  return things;
}

} // namespace

BOOST_AUTO_TEST_CASE(no_format_says_more_than_the_classes_allow) {
  const unsigned seed = first_seed();
  std::mt19937 random = seeded(seed);
  std::ostringstream errors; // of the runs without anything to decide
  std::streambuf* const standard = std::cerr.rdbuf(errors.rdbuf());
  for (int i = 0; i < 3000; ++i) {
    const std::vector<Thing> things = random_things(random);
    Report_mode mode;
    mode.allow_undecided = random() % 2 == 0;
    mode.allow_uncovered = random() % 2 == 0;
    mode.allow_empty = random() % 2 == 0;
    mode.summary = random() % 2 == 0;
    const bool required = random() % 2 == 0, in_parts = random() % 2 == 0;
    const std::size_t undecided = count(things, Claim::undecided), uncovered = count(things, Claim::not_covered),
                      failing = count(things, Claim::not_met), met = count(things, Claim::met),
                      refused = (mode.allow_undecided ? 0 : undecided) + (mode.allow_uncovered ? 0 : uncovered);
    const bool empty = met + failing + undecided == 0, good = failing + refused == 0;
    const int code = empty && !mode.allow_empty ? 2 : good ? 0 : 1;
    const char* const word = !required ? "none" : empty ? "null" : !good ? "false" : met > 0 ? "true" : "null";
    BOOST_TEST_CONTEXT("seed " << seed << ", set " << i) {
      Printed p = print(things, mode, required, in_parts);
      BOOST_TEST(p.code == code);
      BOOST_TEST((contains(p.text, "proved")) == (required && good && met > 0));
      if (contains(p.text, "proved")) BOOST_TEST((contains(p.text, "every join is")) == (undecided + uncovered == 0));
      BOOST_TEST((contains(p.text, "not met")) == (refused > 0));
      BOOST_TEST((contains(p.text, std::to_string(failing) + " of them not G1")) == (required && failing > 0));
      BOOST_TEST(occurrences(p.text, "row ") == (mode.summary ? things.size() - met : things.size()));

      mode.format = Report_format::json;
      p = print(things, mode, required, in_parts);
      BOOST_TEST(p.code == code);
      BOOST_TEST(p.text.find("proved") == std::string::npos);
      Tree tree = json(p.text);
      BOOST_TEST(tree.get_child("joins").size() == (mode.summary ? things.size() - met : things.size()));
      BOOST_TEST(tree.get<std::string>("met", "none") == word);
      check_claims(tree.get_child("claims"), things);

      mode.format = Report_format::sarif;
      p = print(things, mode, required, in_parts);
      BOOST_TEST(p.code == code);
      tree = json(p.text).get_child("runs").front().second;
      BOOST_TEST(occurrences(p.text, "\"level\":\"error\"") == failing + refused);
      BOOST_TEST(occurrences(p.text, "\"level\":\"warning\"") == undecided + uncovered - refused);
      check_claims(tree.get_child("properties.claims"), things);
      BOOST_TEST(tree.get<std::string>("properties.met", "none") == word);

      mode.format = Report_format::junit;
      p = print(things, mode, required, in_parts);
      BOOST_TEST(p.code == code);
      std::istringstream is(p.text);
      boost::property_tree::read_xml(is, tree);
      tree = tree.get_child("testsuites");
      BOOST_TEST(tree.get<std::size_t>("<xmlattr>.failures") == failing + refused);
      BOOST_TEST(tree.get<std::size_t>("<xmlattr>.skipped") == undecided + uncovered - refused);
      std::size_t all = 0; // things, of which some share a test case
      for (const auto& suite : tree) {
        if (suite.first != "testsuite") continue;
        for (const auto& test : suite.second)
          if (test.first == "testcase") all += test.second.get<std::size_t>("<xmlattr>.assertions", 1);
      }
      BOOST_TEST(all == things.size());
    }
  }
  std::cerr.rdbuf(standard);
}

namespace {

// The data of a page, which stand in its HTML as a block of their own.
std::string data_of(const Report_page& page) {
  std::ostringstream os;
  page.write(os);
  const std::string text = os.str(), begin = "id=\"data\">";
  const std::size_t first = text.find(begin) + begin.size();
  return text.substr(first, text.find("</script>", first) - first);
}

} // namespace

BOOST_AUTO_TEST_CASE(no_page_says_more_than_the_classes_allow) {
  const unsigned seed = first_seed();
  std::mt19937 random = seeded(seed);
  const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random() % n); };
  for (int i = 0; i < 3000; ++i) {
    const std::size_t most = 1 + below(12);
    Report_page page(most);
    page.title = "<b>";
    page.summary = "summary";
    page.is_of_fonts = below(2) == 0;
    std::vector<Report_item> joins;
    std::vector<Thing> things;
    const std::size_t grades = below(1u << number_of_report_grades); // which may occur
    for (std::size_t n = below(20); n > 0; --n) {
      if (below(4) == 0) {
        const std::string reason = "reason " + std::to_string(below(3));
        things.push_back({Claim::not_covered, "", reason, false});
        page.leave_out(below(2) == 0 ? "element" : "face", reason, below(2) == 0 ? "a note" : "");
        continue;
      }
      const std::size_t number = below(number_of_report_grades);
      const Report_grade grade = static_cast<Report_grade>(number);
      if (!page.has(grade) || (grades & (std::size_t(1) << number)) == 0) continue;
      things.push_back({grade == Report_grade::undecided ? Claim::undecided : Claim::met, "", "", false});
      Report_item item;
      item.grade = grade;
      item.severity = static_cast<double>(below(4));
      item.number = joins.size() + 1;
      item.place = "join " + std::to_string(item.number);
      joins.push_back(item);
      if (page.count(grade, item.severity)) page.add(item);
    }
    page.finish();
    page.number_edges();
    std::sort(joins.begin(), joins.end(), is_worse);
    const std::size_t undecided = count(things, Claim::undecided), uncovered = count(things, Claim::not_covered),
                      shown = (std::min)(most, joins.size());
    BOOST_TEST_CONTEXT("seed " << seed << ", page " << i) {
      const std::string text = data_of(page);
      BOOST_TEST(text.find_first_of("<>") == std::string::npos);
      BOOST_TEST(text.find("\"met\"") == std::string::npos);
      // "no grade could be proved"
      BOOST_TEST(occurrences(text, "proved") == (undecided == 0 ? 0u : 1u));
      const Tree data = json(text);
      check_claims(data.get_child("claims"), things);
      BOOST_TEST(data.get<std::string>("summary") ==
                 "summary" + (undecided == 0 ? "" : "; " + std::to_string(undecided) + " undecided") +
                     (uncovered == 0 ? "" : "; " + std::to_string(uncovered) + " not covered"));
      BOOST_TEST(data.get<std::size_t>("total") == joins.size());
      const Tree& counts = data.get_child("counts");
      std::size_t sum = 0;
      for (std::size_t number = 0; number < number_of_report_grades; ++number) {
        const Report_grade grade = static_cast<Report_grade>(number);
        const auto found = counts.get_optional<std::size_t>(report_grade_name(grade));
        BOOST_TEST(found.has_value() == page.has(grade));
        if (!found) continue;
        BOOST_TEST(*found ==
                   static_cast<std::size_t>(std::count_if(
                       joins.begin(), joins.end(), [&](const Report_item& item) { return item.grade == grade; })));
        sum += *found;
      }
      BOOST_TEST(sum == joins.size());
      BOOST_TEST(data.get_child("joins").size() == shown);
      std::size_t next = 0; // the worst ones
      for (const auto& join : data.get_child("joins")) {
        BOOST_TEST(join.second.get<std::size_t>("number") == joins[next].number);
        BOOST_TEST(join.second.get<std::string>("grade") == report_grade_name(joins[next++].grade));
      }
      BOOST_TEST(occurrences(text, "The page shows the worst " + std::to_string(shown) + " of " +
                                       std::to_string(joins.size()) + "; " + std::to_string(joins.size() - shown) +
                                       " are left out.") == (shown < joins.size() ? 1u : 0u));
    }
  }
}

BOOST_AUTO_TEST_CASE(texts_from_files_are_no_links) {
  Report report({Report_format::sarif}, {"join", "every join"});
  report.add("a.svg", {Claim::not_met, "join"}, false, [] {
    Finding f;
    f.file = "a.svg";
    f.kind = "join";
    f.place = "path \"[x](https://example.org)\\\"";
    f.rule = Finding_rule::kink;
    f.message = "{0}";
    return f;
  });
  std::ostringstream os;
  report.print(os, "\"summary\":{}");
  BOOST_TEST(os.str().find(R"(\\[x\\](https://example.org)\\\\\": {{0}}")") != std::string::npos);
}
