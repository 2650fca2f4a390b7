#include <CGAL/Geometric_continuity/repairs/internal/Grid_alignment.h> // moved
