// Copyright (c) 2026 The Geometric_continuity developers
//
// SPDX-License-Identifier: LGPL-3.0-or-later

#ifndef GEOMETRIC_CONTINUITY_DEMO_COMMANDS_H
#define GEOMETRIC_CONTINUITY_DEMO_COMMANDS_H

#include <optional>
#include <string>
#include <vector>

namespace CGAL {
namespace Geometric_continuity {
struct Edge_tolerance;
}
} // namespace CGAL

// Exit codes of the program.
enum Exit_code { requirement_met = 0, requirement_not_met = 1, bad_input = 2 };

typedef std::vector<std::string> Arguments;

// Each command reads its own arguments; errors are exceptions.
int blend_command(const Arguments& arguments);
int connect_command(const Arguments& arguments);
int extend_command(const Arguments& arguments);
int plot_command(const Arguments& arguments);
int tessellate_command(const Arguments& arguments);
int verify_command(const Arguments& arguments);

// The part of plot for models of surfaces.
int plot_surfaces(const Arguments& files, const std::string& output, const std::string& title, bool shaded,
                  const std::string& view);

// The part of verify for models of surfaces.
int verify_surfaces(const Arguments& files, bool json, const std::optional<int>& required,
                    const std::optional<CGAL::Geometric_continuity::Edge_tolerance>& tolerance);

#endif // GEOMETRIC_CONTINUITY_DEMO_COMMANDS_H
