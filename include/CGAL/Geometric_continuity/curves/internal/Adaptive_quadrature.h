#include <CGAL/Geometric_continuity/curves/fairness.h> // moved
