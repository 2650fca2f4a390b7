#include <CGAL/Geometric_continuity/algebra/internal/Bernstein_tensor.h> // moved
