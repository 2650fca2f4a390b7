// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_MODELS_MODEL_CERTIFICATE_H
#define GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_MODELS_MODEL_CERTIFICATE_H

#include "commands/models/model_json.h"
#include "reports/certificate.h"

#include <CGAL/Geometric_continuity/edges/edge_continuity.h>

#include <ostream>
#include <sstream>
#include <string>
#include <vector>

// The lines of a certificate about shared edges and knot lines.

inline void write_exact(std::ostream& os, const GC::Power_polynomial<Exact>& p) {
  os << '[';
  for (int k = 0; k <= p.degree(); ++k) write_exact(os << (k == 0 ? "" : ","), p[k]);
  os << ']';
}

inline void write_exact(std::ostream& os, const GC::Edge_rows<Exact, 4>& rows) {
  write_exact(os << '[', rows.edge);
  write_exact(os << ',', rows.cross);
  write_exact(os << ',', rows.second_cross);
  os << ']';
}

inline void write_spans(std::ostream& os, int order, const std::vector<GC::Edge_certificate<Exact>>& spans) {
  os << ",\"order\":" << order << ",\"spans\":[";
  const char* separator = "";
  for (const GC::Edge_certificate<Exact>& c : spans) {
    write_exact(os << separator << "{\"begin\":", c.begin);
    write_exact(os << ",\"end\":", c.end);
    os << ",\"order\":" << c.g_order;
    write_exact(os << ",\"a\":", c.a);
    write_exact(os << ",\"b\":", c.b);
    if (c.determinant) write_exact(os << ",\"determinant\":", *c.determinant);
    if (c.side) write_exact(os << ",\"side\":", *c.side);
    if (c.second_order) {
      os << ",\"factors\":[";
      for (std::size_t i = 0; i < c.factors.size(); ++i) write_exact(os << (i == 0 ? "" : ","), c.factors[i]);
      write_exact(os << "],\"second_order\":", *c.second_order);
    }
    os << '}';
    separator = ",";
  }
  os << ']';
}

// Writes the certificate of a model whose surfaces have exact numbers.
template <class Surface>
void write_model_certificate(std::ostream& os, const Arguments& files, const std::vector<Surface>& surfaces,
                             const GC::Model_continuity<Exact>& model) {
  Certificate certificate(&os, "model", files);
  for (const Edge& e : model.edges) {
    if (e.kind != GC::Model_edge_kind::shared) continue;
    std::ostringstream line;
    line << "\"patch_a\":" << e.patch_a << ",\"edge_a\":\"" << e.edge_a << "\",\"patch_b\":" << *e.patch_b
         << ",\"edge_b\":\"" << *e.edge_b << "\",\"reversed\":" << boolean(e.continuity.reversed);
    write_spans(line, e.continuity.g_order,
                edge_certificates(surfaces[e.patch_a], e.edge_a, surfaces[*e.patch_b], *e.edge_b, e.continuity));
    certificate.add(line.str());
  }
  for (const Line& l : model.knot_lines) {
    std::ostringstream line;
    line << "\"patch\":" << l.patch << ",\"line\":\"" << (l.line.constant_u ? 'u' : 'v') << '"';
    write_exact(line << ",\"knot\":", l.line.knot);
    write_spans(line, l.line.continuity.g_order, knot_line_certificates(surfaces[l.patch], l.line));
    certificate.add(line.str());
  }
  certificate.finish();
}

#endif // GEOMETRIC_CONTINUITY_TOOLS_COMMANDS_MODELS_MODEL_CERTIFICATE_H
