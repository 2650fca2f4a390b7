#include <CGAL/Geometric_continuity/curves/internal/denominator.h> // moved
