#include <CGAL/Geometric_continuity/edges/internal/Fixed_largest_measure.h> // moved
