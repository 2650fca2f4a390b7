// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_OPENCASCADE_CLOSED_SHELLS_H
#define GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_OPENCASCADE_CLOSED_SHELLS_H

#include <TopoDS_Shape.hxx>
#include <TopoDS_TShape.hxx>
#include <XSControl_Reader.hxx>

#include <map>
#include <string>
#include <vector>

// A shell that a file says to be closed.
struct Closed_shell {
  std::string name; // e.g. "#16 CLOSED_SHELL"
  std::vector<TopoDS_Shape> faces;
};

// The names of closed shells, by their faces.
typedef std::map<const TopoDS_TShape*, std::string> Shell_names;

// Returns the closed shells that a STEP file names. Shells in IGES are written as closed whether
// they are or not: there only solids count.
Shell_names closed_shell_names(XSControl_Reader& reader);

// Returns the shells of a shape that are named or belong to a solid, and, of BREP, those that are
// marked. A shell that is placed again comes once.
std::vector<Closed_shell> closed_shells(const TopoDS_Shape& shape, const Shell_names& names, bool with_marked);

// Returns "#16 CLOSED_SHELL: said to be closed, but has 4 free edges" for each shell with edges of
// only one face.
std::vector<std::string> open_shells(const std::vector<Closed_shell>& shells);

#endif // GEOMETRIC_CONTINUITY_TOOLS_FORMATS_CAD_OPENCASCADE_CLOSED_SHELLS_H
