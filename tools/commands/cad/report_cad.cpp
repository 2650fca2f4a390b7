// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#include "commands/cad/Cad_words.h"
#include "commands/cad/decide_cad.h"
#include "commands/report_inputs.h"
#include "commands/tolerances.h"
#include "reports/words.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace {

// So many triangles are drawn.
constexpr std::size_t most_drawn_triangles = 40000;

// So many faces that cannot be drawn are named.
constexpr std::size_t most_named_faces = 10;

Report_grade grade(const Cad_verdict& verdict) {
  switch (verdict.shape) {
  case Cad_shape::gap: return Report_grade::gap;
  case Cad_shape::kink:
  case Cad_shape::bent:
  case Cad_shape::fold:
  case Cad_shape::inside_out: return Report_grade::kink;
  case Cad_shape::fading_corner: return Report_grade::fading;
  case Cad_shape::corner: return Report_grade::corner;
  case Cad_shape::smooth:
    if (verdict.order() > 0) return verdict.order() == 2 ? Report_grade::g2 : Report_grade::g1;
    break; // the gap is undecided
  case Cad_shape::undecided: break;
  }
  return Report_grade::undecided;
}

// Returns the worst number of an edge: the gap, the angle, or the jump of the curvature of smooth
// faces.
const GC::Edge_maximum& worst(const GC::Edge_enclosure& e, Report_grade grade) {
  if (grade == Report_grade::gap || !e.angle) return e.gap;
  return grade >= Report_grade::g1 && e.curvature_jump ? *e.curvature_jump : *e.angle;
}

// The page tells G1 from G2 also within a tolerance that has no bound of curvatures: then the
// relative jump of G2 is at most this.
constexpr const char* page_curvature = "0.1%";

Cad_demand page_demand(const std::string& tolerance, const Report_demand& asked) {
  Cad_demand demand = demand_within(tolerance, asked.corner_threshold);
  if (demand.most > 1) return demand;
  demand.bounds.curvature_jump = parse_tolerances(std::string("1,1deg,") + page_curvature, false).joins.curvature_jump;
  demand.tolerance += std::string(", and G2 within a curvature jump of ") + page_curvature;
  return demand;
}

// Returns the bounds, rounded outwards where they are so near to zero that nobody needs to know how
// near.
GC::Enclosure readable(const GC::Enclosure& x) {
  const double least = std::nextafter(1e-9, 0.); // mm, degrees or percent; not above the decimal
  return {x.lower < least ? 0 : x.lower, x.upper > 0 && x.upper < least ? least : x.upper};
}

// Why an edge has no grade, or is not compared; empty if that is decided.
std::string open_reason(const Cad_edge& edge, const Cad_verdict& verdict, const Cad_demand& demand) {
  const std::optional<Given> given = claim_of(edge, verdict, demand);
  if (given && !given->reason.empty()) return given->reason;
  return grade(verdict) == Report_grade::undecided ? "no grade could be proved" : "";
}

// The edge as a card of the page, without what is drawn.
Report_item item_of(std::size_t number, const Cad_edge& edge, const Cad_verdict& verdict, const Cad_model& model,
                    const std::string& reason) {
  Report_item item;
  item.place = cad_place(number, edge, model) + ' ' + cad_kind(edge);
  item.verdict = !verdict.enclosure ? verdict.reason : cad_order(verdict) + (reason.empty() ? "" : ": " + reason);
  item.grade = grade(verdict);
  if (edge.projected) item.marks.push_back("projected");
  if (!verdict.enclosure) return item;
  const GC::Edge_enclosure& e = *verdict.enclosure;
  item.gap = readable(e.gap.value);
  if (e.angle) item.angle = readable(GC::in_degrees(e.angle->value));
  if (e.curvature_jump) item.curvature_jump = readable(GC::in_percent(e.curvature_jump->value));
  if (!e.singular.empty()) item.verdict += ", a normal vanishes near the parameter " + rounded(e.singular[0].first, 6);
  if (!verdict.poles.empty())
    item.verdict += ", what belongs to a pole is left out near the parameter " + rounded(verdict.poles[0].first, 6);
  const GC::Edge_maximum& worst = ::worst(e, item.grade);
  for (const double x : worst.point) item.point.push_back(rounded(std::abs(x) < 1e-9 ? 0 : x, 6));
  item.parameter = rounded(worst.parameter, 6);
  item.severity = worst.value.upper;
  return item;
}

// The join as a card of the page.
Report_item item_of(const Cad_join& join, const Cad_join_verdict& verdict, const Cad_wires& wires,
                    const std::string& reason) {
  Report_item item;
  item.place = cad_place(join, wires);
  item.verdict = verdict.reason;
  if (!verdict.enclosure) return item;
  item.verdict = verdict.order_name() + (reason.empty() ? "" : ": " + reason);
  const GC::Join_deviation& d = verdict.enclosure->deviation;
  item.grade = verdict.shape == Cad_shape::gap      ? Report_grade::gap
               : verdict.shape == Cad_shape::corner ? Report_grade::corner
               : verdict.shape == Cad_shape::kink   ? Report_grade::kink
               : verdict.shape == Cad_shape::bent   ? Report_grade::kink
               : verdict.order() == 2               ? Report_grade::g2
               : verdict.order() == 1               ? Report_grade::g1
                                                    : Report_grade::undecided;
  item.gap = readable(d.gap);
  if (d.tangent_angle) item.angle = readable(GC::in_degrees(*d.tangent_angle));
  if (d.curvature_jump) item.curvature_jump = readable(GC::in_percent(*d.curvature_jump));
  for (const double x : verdict.enclosure->point) item.point.push_back(rounded(std::abs(x) < 1e-9 ? 0 : x, 6));
  item.severity = (item.grade == Report_grade::gap || !d.tangent_angle ? d.gap
                   : item.grade >= Report_grade::g1                    ? *d.curvature_jump
                                                                       : *d.tangent_angle)
                      .upper;
  return item;
}

// Gathers the edges of CAD models, and draws the faces.
class Cad_page {
  const Cad_demand demand_;
  const Cad_reading reading_;
  Report_page& page_;
  Cad_summary summary_;
  std::size_t healed_ = 0;                         // faces that are drawn so
  double healed_distance_ = 0;                     // of their edges
  std::vector<Report_model::Edge> edges_, others_; // those of two sides, and the boundaries
  std::vector<Report_model::Patch> faces_;
  std::vector<std::string> undrawn_; // the faces that cannot be drawn, and why
  // The drawing of each file ends at these numbers.
  struct End {
    std::size_t faces, edges, others;
  };
  std::vector<End> files_;

  // The coordinates of points to draw; none when one is not finite.
  static std::vector<double> coordinates(const std::vector<GC::Cad_point<3>>& points) {
    std::vector<double> result;
    for (const GC::Cad_point<3>& p : points) result.insert(result.end(), p.begin(), p.end());
    if (!std::all_of(result.begin(), result.end(), [](double x) { return std::isfinite(x); })) result.clear();
    return result;
  }

  static Report_model::Edge drawn(const Cad_edge& edge, const std::string& grade, std::size_t first_face) {
    Report_model::Edge result{grade, {}, coordinates(edge.points)};
    for (const std::size_t face : edge.faces) result.patches.push_back(first_face + face);
    return result;
  }

  static Report_model::Patch drawn(const Cad_mesh& mesh, const std::optional<std::array<double, 3>>& colour) {
    Report_model::Patch result{0, 0, coordinates(mesh.points)};
    if (colour) {
      result.colour = "#";
      for (const double x : *colour) {
        const int value = x > 0 ? x < 1 ? static_cast<int>(std::lround(255 * x)) : 255 : 0;
        result.colour += {"0123456789abcdef"[value / 16], "0123456789abcdef"[value % 16]};
      }
    }
    if (!result.points.empty())
      for (const auto& t : mesh.triangles) result.triangles.insert(result.triangles.end(), t.begin(), t.end());
    return result;
  }

  // Leaves out faces as soon as there are too many triangles: those of the worst edges come first.
  void limit_faces(const std::vector<Report_model::Edge>& shown) {
    std::vector<Report_model::Patch> all(faces_.size(), {0, 0, {}});
    all.swap(faces_);
    std::size_t drawn = 0, left_out = 0;
    bool is_worst = true; // the faces of the worst edge are drawn in any case
    const auto keep = [&](std::size_t face) {
      const std::size_t triangles = all[face].triangles.size() / 3;
      if (triangles == 0 || (!is_worst && drawn + triangles > most_drawn_triangles)) return;
      drawn += triangles;
      faces_[face] = std::move(all[face]);
      all[face] = {0, 0, {}};
    };
    for (const Report_model::Edge& edge : shown) {
      std::for_each(edge.patches.begin(), edge.patches.end(), keep);
      is_worst = false;
    }
    is_worst = false;
    for (std::size_t face = 0; face < all.size(); ++face) {
      keep(face);
      left_out += !all[face].triangles.empty();
    }
    if (!undrawn_.empty()) page_.notes.push_back(counted(undrawn_.size(), "face") + " cannot be drawn.");
    for (std::size_t i = 0; i < undrawn_.size() && i < most_named_faces; ++i) page_.notes.push_back(undrawn_[i] + '.');
    if (left_out > 0) page_.notes.push_back(counted(left_out, "face") + " not drawn: there are too many triangles.");
  }

  // Calls work(points) for all that is drawn of the file number i.
  template <class Work> void for_drawn(std::size_t i, Work work) {
    const End begin = i == 0 ? End{0, 0, 0} : files_[i - 1], end = files_[i];
    for (std::size_t j = begin.faces; j < end.faces; ++j) work(faces_[j].points);
    for (std::size_t j = begin.edges; j < end.edges; ++j) work(edges_[j].points);
    for (std::size_t j = begin.others; j < end.others; ++j) work(others_[j].points);
  }

  // Draws several files beside each other, in rows as the page shows them at first, wherever they
  // lie.
  void set_apart() {
    if (files_.size() < 2) return;
    std::vector<std::array<double, 3>> centres;
    double radius = 0;
    std::size_t drawn = 0;
    for (std::size_t i = 0; i < files_.size(); ++i) {
      std::array<double, 3> low, high;
      low.fill(HUGE_VAL);
      high.fill(-HUGE_VAL);
      for_drawn(i, [&](const std::vector<double>& points) {
        for (std::size_t j = 0; j < points.size(); ++j) {
          low[j % 3] = (std::min)(low[j % 3], points[j]);
          high[j % 3] = (std::max)(high[j % 3], points[j]);
        }
      });
      centres.push_back({low[0] / 2 + high[0] / 2, low[1] / 2 + high[1] / 2, low[2] / 2 + high[2] / 2});
      if (!(low[0] <= high[0])) continue;
      ++drawn;
      radius = (std::max)(radius, std::hypot(high[0] - low[0], high[1] - low[1], high[2] - low[2]) / 2);
    }
    if (drawn < 2) return;
    // The directions to the right and up of the camera in page.js.
    constexpr double pi = 3.141592653589793, azimuth = -pi / 3, elevation = 0.4;
    const std::array<double, 3> right{-std::sin(azimuth), std::cos(azimuth), 0},
        up{-std::sin(elevation) * std::cos(azimuth), -std::sin(elevation) * std::sin(azimuth), std::cos(elevation)};
    const std::size_t columns = static_cast<std::size_t>(std::ceil(std::sqrt(double(drawn))));
    std::size_t next = 0;
    for (std::size_t i = 0; i < files_.size(); ++i) {
      if (!std::isfinite(centres[i][0])) continue; // there is nothing to draw
      const double x = 2.1 * radius * double(next % columns), y = -2.1 * radius * double(next / columns);
      ++next;
      for_drawn(i, [&](std::vector<double>& points) {
        for (std::size_t j = 0; j < points.size(); ++j)
          points[j] += x * right[j % 3] + y * up[j % 3] - centres[i][j % 3];
      });
    }
    page_.notes.push_back(counted(files_.size(), "file") + ", which are drawn beside each other, not where they lie.");
  }

  // The page shows this text if no edge is compared.
  std::string empty_text() const {
    std::string text = "There is no edge of two sides";
    if (summary_.boundary > 0) text += ", but " + counted(summary_.boundary, "boundary edge");
    if (summary_.curves > 0)
      text += std::string(summary_.boundary > 0 ? " and " : ", but ") + counted(summary_.curves, "curve") +
              " without a face";
    return text + (summary_.hint().empty() ? "." : ": " + summary_.hint() + '.');
  }

  // Rounds what is drawn to a part of the extent that nobody sees, which makes the page small.
  static void round(Report_model& model) {
    double extent = 0;
    const auto for_coordinates = [&](const auto& work) {
      for (Report_model::Patch& face : model.patches) std::for_each(face.points.begin(), face.points.end(), work);
      for (Report_model::Edge& edge : model.edges) std::for_each(edge.points.begin(), edge.points.end(), work);
    };
    for_coordinates([&](double& x) { extent = (std::max)(extent, std::abs(x)); });
    if (!(extent > 1e-100 && extent < 1e100)) return;
    const int digits = 6 - static_cast<int>(std::floor(std::log10(extent)));
    const double factor = std::pow(10., std::abs(digits));
    for_coordinates(
        [&](double& x) { x = digits < 0 ? std::round(x / factor) * factor : std::round(x * factor) / factor; });
  }

public:
  Cad_page(const Cad_demand& demand, const Cad_reading& reading, Report_page& page)
      : demand_(demand), reading_(reading), page_(page) {}

  // Reads files and gathers their edges.
  void gather(const Arguments& files) {
    decide_cad_files(files, demand_, reading_, [&](const Decided_cad_file& decided) {
      gather(decided, files.size() > 1 ? decided.file + ": " : "");
    });
  }

  // Gathers the edges of a file. Their places begin so.
  void gather(const Decided_cad_file& decided, const std::string& before) {
    const std::string& file = decided.file;
    summary_.add(decided, demand_);
    const std::size_t first_face = faces_.size();
    for (std::size_t i = 0; i < decided.model.meshes.size(); ++i) {
      const Cad_mesh& mesh = decided.model.meshes[i];
      faces_.push_back(drawn(mesh, decided.model.labels[i].colour));
      if (faces_.back().triangles.empty()) {
        const std::string label = cad_label(i, decided.model);
        undrawn_.push_back(
            before + "Face " + std::to_string(i) + " (" + decided.model.faces[i] + (label.empty() ? "" : "; " + label) +
            ") is left white: " + (mesh.reason.empty() ? "it has points that are not finite" : mesh.reason));
      }
      if (!mesh.healed || mesh.triangles.empty()) continue;
      ++healed_;
      healed_distance_ = (std::max)(healed_distance_, *mesh.healed);
    }
    for (const auto& [face, reason] : decided.model.not_covered)
      page_.leave_out("face", reason, file + ": not covered: face " + std::to_string(face) + ": " + reason);
    for (const std::string& lost : decided.model.lost)
      page_.leave_out("element", "cannot be read", file + ": not read: " + lost);
    for (const std::string& shell : decided.model.open_shells)
      page_.leave_out("shell", "is said to be closed, and is not", file + ": not closed: " + shell);
    for (std::size_t i = 0; i < decided.verdicts.size(); ++i) {
      const Cad_edge& edge = decided.model.edges[i];
      if (!has_verdict(edge)) {
        if (edge.kind == Cad_edge_kind::non_manifold) page_.leave_out("edge", "three faces or more meet there", "");
        if (edge.kind == Cad_edge_kind::boundary && !edge.reason.empty()) page_.leave_out("edge", beside_another, "");
        if (edge.kind != Cad_edge_kind::degenerate) others_.push_back(drawn(edge, "boundary", first_face));
        continue;
      }
      const std::string reason = open_reason(edge, decided.verdicts[i], demand_);
      Report_item item = item_of(i, edge, decided.verdicts[i], decided.model, reason);
      item.place = before + item.place;
      if (!page_.count(item.grade, item.severity, reason)) continue;
      item.number = page_.total();
      for (const std::size_t face : edge.faces)
        if (decided.model.meshes[face].healed && item.marks.size() < 2) item.marks.push_back("healed drawing");
      item.edge = edges_.size();
      edges_.push_back(drawn(edge, report_grade_name(item.grade), first_face));
      page_.add(std::move(item));
    }
    add_wires(decided, before);
    files_.push_back({faces_.size(), edges_.size(), others_.size()});
  }

  // Adds the joins of curves without faces: of each the halves of both curves are drawn that meet
  // there.
  void add_wires(const Decided_cad_file& decided, const std::string& before) {
    const Cad_wires& wires = decided.model.wires;
    for (const Cad_curve_edge& curve : wires.curves) {
      if (!curve.reason.empty()) page_.leave_out("curve", curve.reason, "");
      others_.push_back({"boundary", {}, coordinates(curve.points)});
    }
    if (!wires.branchings.empty()) page_.leave_out("place", branching_of_curves, "", wires.branchings.size());
    for (std::size_t i = 0; i < wires.joins.size(); ++i) {
      const Cad_join& join = wires.joins[i];
      const Given given = claim_of(decided.joins[i], demand_);
      Report_item item = item_of(join, decided.joins[i], wires, given.reason);
      item.place = before + item.place;
      if (!page_.count(item.grade, item.severity, given.reason)) continue;
      item.number = page_.total();
      item.edge = edges_.size();
      edges_.push_back({report_grade_name(item.grade), {}, coordinates(points_at(join, wires))});
      page_.add(std::move(item));
    }
  }

  // The points from the middle of the first curve to that of the second one; around a knot a few.
  static std::vector<GC::Cad_point<3>> points_at(const Cad_join& join, const Cad_wires& wires) {
    const auto &left = wires.curves[join.curves[0]].points, &right = wires.curves[join.curves[1]].points;
    if (join.is_knot) return left;
    std::vector<GC::Cad_point<3>> a(left), b(right);
    if (join.ends[0].reversed) std::reverse(a.begin(), a.end());
    if (join.ends[1].reversed) std::reverse(b.begin(), b.end());
    a.erase(a.begin(), a.begin() + static_cast<std::ptrdiff_t>(a.size() / 2));
    a.insert(a.end(), b.begin(), b.begin() + static_cast<std::ptrdiff_t>(b.size() / 2 + 1));
    return a;
  }

  // Fills the page when all is gathered.
  void finish() {
    page_.finish();
    set_apart();
    if (page_.total() == 0) page_.empty = empty_text();
    Report_model& model = page_.model.emplace();
    for (const Report_item& item : page_.items()) model.edges.push_back(std::move(edges_[item.edge]));
    page_.number_edges();
    limit_faces(model.edges);
    model.patches = std::move(faces_);
    std::move(others_.begin(), others_.end(), std::back_inserter(model.edges));
    round(model);
    if (summary_.non_manifold > 0)
      page_.notes.push_back(counted(summary_.non_manifold, "edge") +
                            " of three faces or more: drawn as boundary, not decided.");
    if (healed_ > 0)
      page_.notes.push_back(counted(healed_, "face") + " drawn after OpenCASCADE has healed the boundary, up to " +
                            rounded(healed_distance_, 2) +
                            " mm from the edges: what was decided is the face as it is given.");
    if (summary_.beside > 0) page_.notes.push_back(beside_words(summary_.beside) + '.');
    if (summary_.instances > 0) page_.notes.push_back(parts_words(summary_.instances, summary_.shapes) + '.');
    if (summary_.sewn > 0) page_.notes.push_back(sewn_words(summary_.sewn) + '.');
    if (summary_.projected > 0)
      page_.notes.push_back(
          counted(summary_.projected, "edge") +
          " with curves in parameter planes that are not in the file, but projections of those in space.");
    if (summary_.curves > 0)
      page_.notes.push_back(counted(summary_.curves, "curve") + " without a face: " + counted(summary_.joins, "join") +
                            ", " + counted(summary_.free_ends, "free end") + '.');
    page_.summary = counted(summary_.faces, "face") + ", " + counted(summary_.decided() - summary_.joins, "edge") +
                    " of two sides" +
                    (summary_.joins > 0 ? " and " + counted(summary_.joins, "join") + " of curves" : "") + " within " +
                    demand_.tolerance + "; lengths in mm";
  }
};

} // namespace

void report_cad(const Arguments& files, const Report_demand& demand, Report_page& page) {
  page.dimension = 3;
  page.is_of_cad_models = true;
  page.is_numbered = false; // the places have numbers
  Cad_page gatherer(page_demand(demand.tolerance.empty() ? default_cad_tolerance : demand.tolerance, demand),
                    demand.reading, page);
  gatherer.gather(files);
  gatherer.finish();
}
