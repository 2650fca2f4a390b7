#include <CGAL/Geometric_continuity/repairs/round_corners.h> // moved
