#include <CGAL/Geometric_continuity/IO/figures/Svg_panel.h> // moved
