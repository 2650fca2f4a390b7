#include <CGAL/Geometric_continuity/IO/figures/internal/svg_text.h> // moved
