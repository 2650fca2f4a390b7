// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

// Measures the cost of guaranteed verdicts on all edges of CAD models, against the verdicts that
// OpenCASCADE takes from samples, and lists where both differ or where enclosures are wide.
//   benchmark_cad MODEL...
// Each model has a process of its own on one core, which reads it and decides its edges with the
// code of the program. Then, in the same process, OpenCASCADE takes its samples. The tolerances are
// those of VDA 4955.

#include "commands/cad/Cad_words.h"
#include "commands/tolerances.h"
#include "measured_process.h"

#include <CGAL/Exact_rational.h>
#include <CGAL/Geometric_continuity/cad/cad_edge_continuity.h>

// behind CGAL's headers, whose Handle is no macro
#include "formats/cad/opencascade/read_model.h"
#include "sampled_continuity.h"

#include <Standard_Failure.hxx>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <iomanip>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include <sys/mman.h>

namespace {

// Holds the counts for one model, or for all. Edges with two sides are decided, seams as well. An
// edge is missed if the largest angle exceeds all angles at the samples by more than a tenth, and
// by a thousandth of a degree. Times are in seconds of the processor.
struct Row {
  std::size_t edges, decided, proved, refuted, undecided, wide, exact, differing, missed;
  double reading, deciding, slowest, deciding_exactly, sampling;

  void add(const Row& x) {
    edges += x.edges;
    decided += x.decided;
    proved += x.proved;
    refuted += x.refuted;
    undecided += x.undecided;
    wide += x.wide;
    exact += x.exact;
    differing += x.differing;
    missed += x.missed;
    reading += x.reading;
    deciding += x.deciding;
    slowest = (std::max)(slowest, x.slowest);
    deciding_exactly += x.deciding_exactly;
    sampling += x.sampling;
  }
};

// A row that a process writes and the one that started it reads.
class Shared_row {
  void* const memory_ = ::mmap(nullptr, sizeof(Row), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);

public:
  Shared_row() {
    if (memory_ == MAP_FAILED) system_failure("mmap");
  }
  Shared_row(const Shared_row&) = delete;
  Shared_row& operator=(const Shared_row&) = delete;
  ~Shared_row() { ::munmap(memory_, sizeof(Row)); }
  Row& operator*() const { return *static_cast<Row*>(memory_); }
};

double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

Cad_demand demand() {
  Cad_demand result;
  result.tolerance = "vda-4955";
  result.most = 1;
  result.bounds = parse_tolerances(result.tolerance, false).joins;
  result.kink = GC::in_radians(CGAL::Exact_rational(5));
  return result;
}

// Returns whether an enclosure is not as narrow as it should be.
bool is_wide(const GC::Enclosure& x, double floor) {
  return x.upper > floor && !(x.upper - x.lower <= GC::Edge_precision().relative * x.upper * (1 + 1e-9));
}
bool is_wide(const GC::Edge_enclosure& e) {
  const GC::Edge_precision precision;
  return is_wide(e.gap.value, precision.gap) || (e.angle && is_wide(e.angle->value, precision.angle)) ||
         (e.curvature_jump && is_wide(e.curvature_jump->value, precision.curvature_jump));
}

// The largest angle of the normals that 21 samples show, in radians: those in the middle 98 % of
// the edge.
double angle_at_samples(const Cad_edge& edge) {
  double largest = 0;
  for (int i = 0; i <= 20; ++i) {
    const double t = edge.begin + (edge.end - edge.begin) * (0.01 + 0.049 * i);
    try {
      const GC::Edge_enclosure e = GC::edge_enclosure((*edge.sides)[0], (*edge.sides)[1], t, t);
      if (e.angle) largest = (std::max)(largest, e.angle->value.upper);
    } catch (const GC::Error&) { // nothing is known there
    }
  }
  return largest;
}

// Why samples and proof differ. OpenCASCADE compares derivatives of both surfaces: at each sample
// that orthogonal to the edge in the parameter plane, hence along the tangent plane in a direction
// that depends on the parametrisation. They must be parallel there, or else where the curve on the
// second surface is next to the point on the first one.
const char* reason(bool sampled_g1, const Cad_verdict& verdict, double at_samples, const GC::Bound& angle) {
  if (!verdict.enclosure) return "not covered";
  if (verdict.within[1] == GC::Verdict::undecided) return "the enclosure holds the tolerance";
  if (!sampled_g1) return "the derivatives that are compared differ in direction within the common tangent plane";
  if (verdict.shape == Cad_shape::gap) return "samples ignore the gap";
  return at_samples < angle.lower()
             ? "the angle is too large between the samples only"
             : "the derivatives that are compared differ less than the tangent planes at equal parameters";
}

bool has_two_sides(const Cad_edge& edge) {
  return edge.kind == Cad_edge_kind::inner || edge.kind == Cad_edge_kind::seam;
}

class Cad_benchmark {
  const std::string file_;
  const Cad_demand demand_ = demand();
  Row row_{};

  void decide(const Cad_model& model, std::vector<Cad_verdict>& verdicts) {
    for (const Cad_edge& edge : model.edges) {
      const double start = processor_seconds();
      // also of knot lines, and of edges that are said to be points
      verdicts.push_back(cad_verdict(edge, demand_));
      const Cad_verdict& verdict = verdicts.back();
      const double seconds = processor_seconds() - start;
      row_.deciding += seconds;
      if (!has_two_sides(edge)) continue;
      row_.slowest = (std::max)(row_.slowest, seconds);
      ++row_.decided;
      ++(verdict.within[1] == GC::Verdict::proved    ? row_.proved
         : verdict.within[1] == GC::Verdict::refuted ? row_.refuted
                                                     : row_.undecided);
    }
  }

  // Decides without tolerance what can be decided so, and compares.
  void decide_exactly(const Cad_model& model, const std::vector<Cad_verdict>& verdicts) {
    for (std::size_t i = 0; i < model.edges.size(); ++i) {
      const Cad_edge& edge = model.edges[i];
      if (!verdicts[i].enclosure || !has_two_sides(edge) || verdicts[i].computed) continue;
      const double start = processor_seconds();
      const auto exact = GC::edge_continuity((*edge.sides)[0], (*edge.sides)[1], edge.begin, edge.end);
      row_.deciding_exactly += processor_seconds() - start;
      if (!exact) continue;
      ++row_.exact;
      const GC::Edge_enclosure& e = *verdicts[i].enclosure;
      if ((exact->g_order >= 0 && e.gap.value.lower > 0) ||
          (exact->g_order >= 1 && e.angle && e.angle->value.lower > 0))
        throw std::runtime_error(file_ + ": " + cad_place(i, edge, model) + ": enclosure and exact verdict contradict");
    }
  }

  void sample(const Cad_model& model, const std::vector<std::optional<Sampled_edge>>& edges,
              const std::vector<Cad_verdict>& verdicts) {
    const auto is_knot_line = [](const Cad_edge& edge) { return edge.kind == Cad_edge_kind::knot_line; };
    // which come last
    const auto lines = std::count_if(model.edges.begin(), model.edges.end(), is_knot_line);
    if (edges.size() + static_cast<std::size_t>(lines) != model.edges.size())
      throw std::runtime_error(file_ + ": not the same edges");
    std::vector<char> g1(edges.size());
    int runs = 0;
    const double start = processor_seconds();
    do { // until the clock is precise enough
      for (std::size_t i = 0; i < edges.size(); ++i)
        if (edges[i]) g1[i] = is_sampled_g1(*edges[i], demand_.bounds.tangent_angle.upper());
      ++runs;
    } while (processor_seconds() - start < 0.02);
    row_.sampling = (processor_seconds() - start) / runs;
    for (std::size_t i = 0; i < edges.size(); ++i) compare(i, model, verdicts[i], edges[i] && g1[i]);
  }

  void compare(std::size_t number, const Cad_model& model, const Cad_verdict& verdict, bool sampled_g1) {
    const Cad_edge& edge = model.edges[number];
    if (!has_two_sides(edge)) return;
    const double at_samples = edge.sides ? angle_at_samples(edge) : 0,
                 angle = verdict.enclosure && verdict.enclosure->angle ? verdict.enclosure->angle->value.lower : 0;
    const bool differs = verdict.within[1] != (sampled_g1 ? GC::Verdict::proved : GC::Verdict::refuted);
    const bool missed = angle > 1.1 * at_samples && angle - at_samples > 1e-3 / 180 * M_PI;
    const bool wide = verdict.enclosure && is_wide(*verdict.enclosure);
    row_.differing += differs;
    row_.missed += missed;
    row_.wide += wide;
    if (!differs && !missed && !wide) return;
    std::cout << file_ << ": " << cad_place(number, edge, model) << ' ' << cad_kind(edge) << ": samples say "
              << (sampled_g1 ? "G1" : "not G1") << "; it is " << verdict.within[1] << "; "
              << (differs  ? reason(sampled_g1, verdict, at_samples, demand_.bounds.tangent_angle)
                  : missed ? "missed"
                           : "wide")
              << "; " << cad_numbers(edge, verdict, demand_) << "; at the samples the angle is at most "
              << at_samples / M_PI * 180 << " degrees\n";
  }

public:
  explicit Cad_benchmark(const std::string& file) : file_(file) {}

  Row run() {
    const double start = processor_seconds();
    const Shape_of_file file = read_shape(file_, Cad_reading());
    const TopoDS_Shape& shape = file.shape;
    const Cad_model model = cad_model(shape, Cad_reading());
    row_.reading = processor_seconds() - start;
    row_.edges = model.edges.size();
    for (const std::string& what : file.lost) std::cout << file_ << ": not read: " << what << '\n';
    std::vector<Cad_verdict> verdicts;
    decide(model, verdicts);
    decide_exactly(model, verdicts);
    sample(model, sampled_edges(shape), verdicts);
    return row_;
  }
};

void print(const std::string& name, const Row& x, double mebibytes) {
  std::cout << std::fixed << std::setw(6) << x.edges << std::setw(8) << x.decided << std::setw(7) << x.proved
            << std::setw(8) << x.refuted << std::setw(10) << x.undecided << std::setw(6) << x.wide << std::setw(6)
            << x.exact << std::setw(8) << x.differing << std::setw(7) << x.missed << std::setprecision(2)
            << std::setw(8) << x.reading << std::setw(8) << x.deciding << std::setw(8) << x.slowest << std::setw(7)
            << x.deciding_exactly << std::setprecision(1) << std::setw(9) << 1000 * x.sampling << std::setprecision(0)
            << std::setw(7) << (x.sampling > 0 ? x.deciding / x.sampling : 0) << std::setw(6) << mebibytes << "  "
            << name << std::endl;
}

// Prints where verdicts differ, and then the table.
void run(const std::vector<std::string>& files) {
  std::vector<Row> rows;
  std::vector<Cost> costs;
  for (const std::string& file : files) {
    const Shared_row row;
    const Measured_process process([&] {
      use_cores(1);
      try {
        *row = Cad_benchmark(file).run();
      } catch (const Standard_Failure& e) {
        throw std::runtime_error(file + ": " + e.GetMessageString());
      }
    });
    costs.push_back({});
    try {
      costs.back() = process.wait(file);
    } catch (const std::runtime_error& e) { // the others go on
      if (Interruption::requested()) throw;
      std::cout << e.what() << '\n';
    }
    rows.push_back(*row);
  }
  std::cout << "verdicts: G1 within vda-4955; wide: not within 1 % or below the floor; times: seconds of one core, of "
               "OpenCASCADE's\n"
            << "samples milliseconds; ratio: deciding to sampling; missed: an angle between samples that is larger by "
               "a tenth\n"
            << " edges decided proved refuted undecided  wide exact differs missed    read  decide slowest  exact "
               "sampling  ratio   "
               "MiB  model\n";
  Row total{};
  double mebibytes = 0;
  for (std::size_t i = 0; i < files.size(); ++i) {
    print(files[i].substr(files[i].rfind('/') + 1), rows[i], costs[i].mebibytes);
    total.add(rows[i]);
    mebibytes = (std::max)(mebibytes, costs[i].mebibytes);
  }
  print("all", total, mebibytes);
}

} // namespace

int main(int argc, char** argv) {
  try {
    const Interruption interruption;
    const std::vector<std::string> files(argv + 1, argv + argc);
    if (files.empty())
      std::cout << "skipped: no CAD model is given\n";
    else
      run(files);
    return EXIT_SUCCESS;
  } catch (const std::exception& e) {
    std::cerr << "benchmark_cad: " << e.what() << '\n';
    return EXIT_FAILURE;
  }
}
