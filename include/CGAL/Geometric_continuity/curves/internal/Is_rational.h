#include <CGAL/Geometric_continuity/curves/internal/curve_pieces.h> // moved
