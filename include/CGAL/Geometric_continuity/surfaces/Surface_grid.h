#include <CGAL/Geometric_continuity/surfaces/evaluate_grid.h> // moved
