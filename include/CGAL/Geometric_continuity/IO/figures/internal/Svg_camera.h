#include <CGAL/Geometric_continuity/IO/figures/internal/Svg_facets.h> // moved
