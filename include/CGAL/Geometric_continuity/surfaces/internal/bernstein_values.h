#include <CGAL/Geometric_continuity/surfaces/internal/patch_sums.h> // moved
