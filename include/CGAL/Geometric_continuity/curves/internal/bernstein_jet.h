#include <CGAL/Geometric_continuity/curves/internal/bezier_jet.h> // moved
