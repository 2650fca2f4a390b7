#include <CGAL/Geometric_continuity/curves/Composite_bezier_curve.h> // moved
